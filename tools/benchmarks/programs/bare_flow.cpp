// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/benchmarks/programs/bare_flow.hpp"

#include <algorithm>
#include <ctime>
#include <stdexcept>

#include "core/linear/indefinite.hpp"
#include "forming/flow/cells/cell_product.hpp"
#include "forming/flow/linear/saddle_system.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::bench {

using core::dim;
using core::Index;

namespace {

/// Penalty stiffness that fixes a velocity, in diagonal entries of its node.
constexpr double penalty = 1e6;
constexpr double max_residual = 1e-6;

/// Holds velocities, the unknowns `unknown` and the next one, in the directions that `directions` spans (its columns).
void constrain_node(core::SymmetricMatrix& matrix, Index unknown, const core::Tensor& directions) {
  const Index first = matrix.column_start[unknown + 1] - 1, second = matrix.column_start[unknown + 2] - 1;
  const double size = penalty * std::max(matrix.value[first], matrix.value[second]);
  const core::Tensor added = size * directions * directions.transpose();
  matrix.value[first] += added(0, 0);
  matrix.value[second - 1] += added(1, 0);
  matrix.value[second] += added(1, 1);
}

/// Holds the normal velocity on symmetry and contact, the whole velocity where the tool sticks or the boundary is
/// fixed. `rank`: place of each unknown in the matrix.
void constrain_boundary(const forming::Scene& scene, const forming::State& state, const std::vector<Index>& rank,
                        core::SymmetricMatrix& matrix) {
  const core::Mesh& mesh = state.glass.mesh;
  std::vector<bool> done(mesh.nodes.size(), false);
  for (const auto& edge : mesh.boundary_edges()) {
    const auto kind = mesh.boundaries()[edge.boundary_id].kind;
    const core::Point along = (mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]]).normalized();
    core::Tensor normal = core::Tensor::Zero();
    normal.col(0) = core::Point(along[1], -along[0]);
    for (const Index node : edge.nodes) {
      const Index tool = state.glass.contact_tool[node];
      if (done[node] || (tool < 0 && kind != core::BoundaryKind::symmetry && kind != core::BoundaryKind::fixed))
        continue;
      done[node] = true;
      using Law = flow::Friction::Law;
      const Law law = tool >= 0 ? scene.tools[tool].friction.law : Law::slip;
      const bool sticks = kind == core::BoundaryKind::fixed || law == Law::stick || law == Law::grip;
      constrain_node(matrix, rank[dim * node], sticks ? core::Tensor(core::Tensor::Identity()) : normal);
    }
  }
}

}  // namespace

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct BareFlow::Data {
  std::vector<std::array<Index, 6>> cells;
  std::vector<Index> order, rank;
  core::Assembly assembly;
  std::unique_ptr<core::IndefiniteSolver> solver;

  void assemble(const forming::Scene& scene, const forming::State& state);
};

BareFlow::BareFlow() : data_(std::make_unique<Data>()) {}
BareFlow::~BareFlow() = default;

void BareFlow::Data::assemble(const forming::Scene& scene, const forming::State& state) {
  const core::Mesh& mesh = state.glass.mesh;
  const bool known = cells == mesh.cells();
  if (!known) {
    order = flow::elimination_order(mesh);
    rank.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) rank[order[k]] = static_cast<Index>(k);
    core::Cliques cliques;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
      auto unknowns = flow::unknowns_of(mesh, c);
      for (Index& unknown : unknowns) unknown = rank[unknown];
      cliques.add(unknowns.data(), flow::cell_unknowns);
    }
    assembly = core::make_assembly(static_cast<Index>(order.size()), cliques, core::Triangle::upper);
    cells = mesh.cells();
  }
  flow::Problem problem{};
  problem.mesh = &mesh;
  problem.geometry = scene.geometry;
  problem.material = &*scene.glass.flow;
  problem.temperature = &state.glass.temperature;
  problem.boundary_conditions.resize(mesh.boundaries().size());
  const auto geometry = flow::cell_geometry(mesh, scene.geometry);
  const auto local = flow::cell_matrices(problem, geometry, flow::viscosity_field(problem, geometry, {}));
  auto& matrix = assembly.matrix;
  std::fill(matrix.value.begin(), matrix.value.end(), 0.0);
  for (Index c = 0; c < mesh.cell_count(); ++c)
    core::add_clique(matrix, assembly.scatter, c, flow::cell_unknowns, local.of(c).data());
  constrain_boundary(scene, state, rank, matrix);
  if (known) return;
  solver = std::make_unique<core::IndefiniteSolver>();
  solver->analyse_ordered(matrix, order);
}

double BareFlow::seconds(const forming::Scene& scene, const forming::State& state) {
  data_->assemble(scene, state);
  const auto& matrix = data_->assembly.matrix;
  Eigen::VectorXd expected(matrix.size);
  for (Index i = 0; i < matrix.size; ++i) expected[i] = 1 + i % 7;
  expected.tail(state.glass.mesh.vertex_count()) *= matrix.value[0];  // pressures weigh as the viscous forces do
  const auto& order = data_->order;
  const auto multiply = [&](const Eigen::VectorXd& x) {  // in the numbers of the unknowns
    Eigen::VectorXd product(x.size());
    product(order) = core::multiply(matrix, x(order));
    return product;
  };
  const Eigen::VectorXd rhs = multiply(expected);
  std::array<double, 3> times;
  Eigen::VectorXd solution;
  for (double& seconds : times) {
    const double start = cpu_seconds();
    if (!data_->solver->factorise(matrix)) throw std::runtime_error("the bare flow matrix is singular");
    solution = data_->solver->solve(rhs);
    seconds = cpu_seconds() - start;
  }
  const double residual = (multiply(solution) - rhs).norm() / rhs.norm();
  if (!(residual < max_residual)) throw std::runtime_error("the bare flow matrix was not solved");
  std::sort(times.begin(), times.end());
  return times[1];
}

}  // namespace parison::bench
