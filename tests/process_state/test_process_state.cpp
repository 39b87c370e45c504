// SPDX-License-Identifier: GPL-3.0-or-later
// A program that has a gmsh model, random numbers, a locale, signals and threads of its own beside the runs.
#include <gmsh.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <clocale>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <thread>

#include "core/io/files.hpp"
#include "core/linear/indefinite.hpp"
#include "forming/pot_scene.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/scene_text.hpp"
#include "forming/state/fingerprint.hpp"
#include "remesh/mesher/mesh_profile.hpp"
#include "remesh/profiles.hpp"

/// Of OpenMP and OpenBLAS, where they are installed.
extern "C" __attribute__((weak)) int omp_get_max_threads();
extern "C" __attribute__((weak)) void omp_set_num_threads(int count);
extern "C" __attribute__((weak)) int openblas_get_num_threads();
extern "C" __attribute__((weak)) void openblas_set_num_threads(int count);

namespace parison {
namespace {

using core::Index;
using forming::RunOutcome;
using forming::Scene;

/// The pressed pot with the glass at a temperature in degC: some steps and remeshes.
Scene pot_at(const std::string& temperature) {
  std::string text = forming::replaced("temperature = \"1100 degC\"", "temperature = \"" + temperature + " degC\"",
                                       forming::pot + "quality_floor = 0.6\n");
  text = forming::replaced("duration = \"0.4 s\"", "duration = \"0.08 s\"", text);
  return forming::scene_of(forming::replaced("output.interval = \"0.2 s\"", "output.interval = \"0.02 s\"", text));
}

/// What a run leaves: the bits of its state and the text of its history.
struct Result {
  std::uint64_t state = 0;
  std::string history;
  Index remeshes = 0;
};

Result result_in(const std::string& folder, const Scene& scene) {
  const RunOutcome outcome = forming::run_in_folder(scene, folder);
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  return {fingerprint(outcome.state), core::read_text(folder + "/history.csv"), remeshes(outcome.state)};
}

/// Does both pieces of work at once.
void at_once(const std::function<void()>& one, const std::function<void()>& other) {
  std::thread first(one), second(other);
  first.join();
  second.join();
}

std::vector<int> random_numbers(int count) {
  std::vector<int> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(std::rand());
  return numbers;
}

/// A gmsh of the program's own: a model of three entities, and an option.
class HostOfGmsh {
 public:
  HostOfGmsh() {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("Mesh.Algorithm", 5);
    gmsh::model::add("host");
    gmsh::model::geo::addPoint(0, 0, 0, 0, 1);
    gmsh::model::geo::addPoint(1, 0, 0, 0, 2);
    gmsh::model::geo::addLine(1, 2, 1);
    gmsh::model::geo::synchronize();
  }
  ~HostOfGmsh() { gmsh::finalize(); }

  void expect_untouched() const {
    std::string current;
    gmsh::model::getCurrent(current);
    EXPECT_EQ(current, "host");
    gmsh::vectorpair entities;
    gmsh::model::getEntities(entities);
    EXPECT_EQ(entities.size(), 3u);
    std::vector<std::string> models;
    gmsh::model::list(models);
    EXPECT_EQ(models.size(), 2u);  // the empty one of gmsh::initialize too
    double algorithm = 0, smoothing = 0, terminal = 1;
    gmsh::option::getNumber("Mesh.Algorithm", algorithm);
    gmsh::option::getNumber("Mesh.Smoothing", smoothing);
    gmsh::option::getNumber("General.Terminal", terminal);
    EXPECT_EQ(algorithm, 5);
    EXPECT_EQ(smoothing, 1);
    EXPECT_EQ(terminal, 0);
    gmsh::model::mesh::generate(1);  // it still works
    std::vector<std::size_t> nodes;
    std::vector<double> coordinates, parameters;
    gmsh::model::mesh::getNodes(nodes, coordinates, parameters);
    EXPECT_GT(nodes.size(), 2u);
  }
};

TEST(ProcessState, two_runs_in_two_threads_of_a_program_with_a_gmsh_model_are_two_single_runs_to_the_last_bit) {
  const std::string folder = tests::new_folder() + '/';
  const Scene hot = pot_at("1100"), cold = pot_at("1050");
  const Result hot_alone = result_in(folder + "hot_alone", hot), cold_alone = result_in(folder + "cold_alone", cold);
  ASSERT_NE(hot_alone.state, cold_alone.state);
  ASSERT_GE(hot_alone.remeshes, 2);
  const HostOfGmsh host;
  Result hot_beside, cold_beside;
  at_once([&] { hot_beside = result_in(folder + "hot", hot); },
          [&] { cold_beside = result_in(folder + "cold", cold); });
  EXPECT_EQ(hot_beside.state, hot_alone.state);
  EXPECT_EQ(cold_beside.state, cold_alone.state);
  EXPECT_EQ(hot_beside.history, hot_alone.history);
  EXPECT_EQ(cold_beside.history, cold_alone.history);
  host.expect_untouched();
}

TEST(ProcessState, a_run_leaves_random_numbers_locale_signals_and_numbers_of_threads_as_they_were) {
  std::srand(17);
  const std::vector<int> before = random_numbers(5), expected = random_numbers(20);
  std::srand(17);
  ASSERT_EQ(random_numbers(5), before);
  const std::string locale = std::setlocale(LC_ALL, nullptr);
  struct sigaction interrupt_before {
  }, interrupt_after{};
  sigaction(SIGINT, nullptr, &interrupt_before);
  if (omp_set_num_threads) omp_set_num_threads(3);
  if (openblas_set_num_threads) openblas_set_num_threads(2);
  EXPECT_TRUE(forming::run(pot_at("1100"), {}, {}).facts.completed);
  if (openblas_get_num_threads) EXPECT_EQ(openblas_get_num_threads(), 2);
  if (omp_get_max_threads) EXPECT_EQ(omp_get_max_threads(), 3);
  if (openblas_set_num_threads) openblas_set_num_threads(1);
  sigaction(SIGINT, nullptr, &interrupt_after);
  EXPECT_EQ(interrupt_after.sa_handler, interrupt_before.sa_handler);
  EXPECT_EQ(std::setlocale(LC_ALL, nullptr), locale);
  EXPECT_EQ(random_numbers(20), expected);
}

/// Mesh of the bundled blank's outline.
core::Mesh mesh_of_blank() {
  const core::Profile profile = remesh::blank();
  return remesh::mesh_profile(profile, {4e-3, 1e-3, 0.3, std::vector<bool>(profile.boundary_names.size(), true)});
}

TEST(ProcessState, meshing_works_after_the_program_has_finalised_gmsh_and_before_it_initialises_it_again) {
  const core::Mesh reference = mesh_of_blank();
  gmsh::initialize(0, nullptr, false);
  gmsh::finalize();
  EXPECT_EQ(mesh_of_blank().nodes, reference.nodes);
  const HostOfGmsh host;
  EXPECT_EQ(mesh_of_blank().nodes, reference.nodes);
  host.expect_untouched();
}

TEST(ProcessState, threads_that_mesh_at_once_get_the_bits_of_one) {
  const core::Mesh reference = mesh_of_blank();
  const auto mesh_often = [&] {
    for (int i = 0; i < 10; ++i) EXPECT_EQ(mesh_of_blank().nodes, reference.nodes);
  };
  at_once(mesh_often, mesh_often);
}

/// A saddle point with a chain of `size` couplings, in the order of elimination from end to end.
core::SymmetricMatrix chain(Index size, double diagonal) {
  core::Cliques cliques;
  for (Index i = 0; i + 1 < size; ++i) {
    const std::array<Index, 2> pair{i, i + 1};
    cliques.add(pair.data(), 2);
  }
  core::Assembly assembly = core::make_assembly(size, cliques, core::Triangle::upper);
  for (Index i = 0; i + 1 < size; ++i) {
    const std::array<double, 4> local{diagonal, 1, 1, i % 3 == 0 ? -diagonal : diagonal};
    core::add_clique(assembly.matrix, assembly.scatter, i, 2, local.data());
  }
  return assembly.matrix;
}

Eigen::MatrixXd solve_by_mumps(const core::SymmetricMatrix& matrix) {
  core::IndefiniteSolver solver;
  std::vector<Index> order(matrix.size);
  std::iota(order.begin(), order.end(), 0);
  solver.analyse_ordered(matrix, order, core::IndefiniteSolver::Library::mumps);
  EXPECT_TRUE(solver.factorise(matrix));
  return solver.solve(Eigen::VectorXd::LinSpaced(matrix.size, -1, 1));
}

TEST(ProcessState, threads_that_factorise_with_mumps_at_once_get_the_bits_of_one) {
  const auto small = chain(400, 3), large = chain(1500, 5);
  const Eigen::MatrixXd small_alone = solve_by_mumps(small), large_alone = solve_by_mumps(large);
  EXPECT_LT((core::multiply(large, large_alone) - Eigen::VectorXd::LinSpaced(1500, -1, 1)).norm(), 1e-9);
  const auto often = [](const core::SymmetricMatrix& matrix, const Eigen::MatrixXd& alone) {
    for (int i = 0; i < 50; ++i) EXPECT_TRUE(solve_by_mumps(matrix) == alone);
  };
  at_once([&] { often(small, small_alone); }, [&] { often(large, large_alone); });
}

}  // namespace
}  // namespace parison
