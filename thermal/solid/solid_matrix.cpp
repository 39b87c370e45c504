// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/solid/solid_matrix.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "thermal/solid/solid_cells.hpp"
#include "thermal/solid/solid_exchange.hpp"

namespace parison::thermal {

namespace {

/// All numbers that the cliques of cells and faces depend on.
std::vector<Index> signature_of(const SolidSystem& system) {
  std::vector<Index> signature = system.first_unknown;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const core::CellList& cells = system.bodies[b].cells;
    signature.insert(signature.end(), cells.first, cells.first + cells.count * cells.table->nodes());
    for (const core::QuadFace& face : *system.problem->bodies[b].faces)
      signature.insert(signature.end(), face.nodes.begin(), face.nodes.end());
  }
  return signature;
}

bool has_all_pairs(const SolidStepMatrix& matrix, const SolidSystem& system) {
  for (const SolidHeatPair& contact : system.contacts)
    if (!matrix.pair_clique.count(system.problem->interface.pairs[contact.pair].key())) return false;
  return true;
}

/// Whether the pattern is that of the pairs of the interface, no more and no less.
bool has_these_pairs(const SolidStepMatrix& matrix, const SolidSystem& system) {
  std::set<std::array<Index, 4>> keys;
  for (const core::FacePair& pair : system.problem->interface.pairs) {
    if (!matrix.pair_clique.count(pair.key())) return false;
    keys.insert(pair.key());
  }
  return keys.size() == matrix.pair_clique.size();
}

std::vector<std::array<int, 2>> repeats_of(const std::vector<Index>& unknowns) {
  std::vector<std::array<int, 2>> repeats;
  for (int i = 0; i < static_cast<int>(unknowns.size()); ++i)
    for (int j = 0; j < i; ++j)
      if (unknowns[i] == unknowns[j]) repeats.push_back({i, j});
  return repeats;
}

std::vector<Index> face_unknowns(const SolidSystem& system, Index body, Index face) {
  std::vector<Index> unknowns;
  for (const Index node : (*system.problem->bodies[body].faces)[face].nodes)
    unknowns.push_back(system.first_unknown[body] + node);
  return unknowns;
}

/// Of a matrix with new pairs the order of elimination serves again, until the fill has grown by half.
void analyse(SolidStepMatrix& matrix, bool same_mesh) {
  constexpr double most_growth = 1.5;
  ++matrix.analyses;
  if (same_mesh) {
    matrix.is_dissected = false;
    matrix.cholesky.analyse_in_same_order(matrix.assembly.matrix);
    if (matrix.cholesky.operations() <= most_growth * matrix.ordered_operations) return;
  }
  matrix.is_dissected = true;
  matrix.cholesky.analyse_dissected(matrix.assembly.matrix);
  matrix.ordered_operations = matrix.cholesky.operations();
}

void make_pattern(SolidStepMatrix& matrix, const SolidSystem& system) {
  core::Cliques cliques;
  matrix.repeats.clear();
  matrix.pair_clique.clear();
  const auto add = [&](const std::vector<Index>& unknowns) {
    cliques.add(unknowns.data(), static_cast<Index>(unknowns.size()));
    matrix.repeats.push_back(repeats_of(unknowns));
  };
  for (const SolidLaws& body : system.bodies)
    for (Index c = 0; c < body.cells.count; ++c) {
      const Index* cell = body.cells.cell(c);
      std::vector<Index> unknowns(cell, cell + body.cells.table->nodes());
      for (Index& unknown : unknowns) unknown += body.first_unknown;
      add(unknowns);
    }
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    for (std::size_t f = 0; f < system.problem->bodies[b].faces->size(); ++f)
      add(face_unknowns(system, static_cast<Index>(b), static_cast<Index>(f)));
  for (const core::FacePair& pair : system.problem->interface.pairs) {
    if (!matrix.pair_clique.emplace(pair.key(), cliques.count()).second) continue;
    std::vector<Index> unknowns = face_unknowns(system, pair.slave_body, pair.slave_face);
    const std::vector<Index> master = face_unknowns(system, pair.master_body, pair.master_face);
    unknowns.insert(unknowns.end(), master.begin(), master.end());
    add(unknowns);
  }
  matrix.assembly = core::make_assembly(system.size(), cliques);
}

/// Adds a dense matrix, row-major, of a clique. Prescribed unknowns have no equation. An entry between two places with
/// the same unknown stands for both triangles.
void add_local(SolidStepMatrix& matrix, const SolidSystem& system, Index clique, const Index* unknowns, Index count,
               double* local) {
  for (const auto& [i, j] : matrix.repeats[clique]) local[i * count + j] *= 2;
  if (!system.prescribed.empty())
    for (Index i = 0; i < count; ++i)
      for (Index j = 0; j <= i; ++j)
        if (system.is_prescribed[unknowns[i]] || system.is_prescribed[unknowns[j]]) local[i * count + j] = 0;
  core::add_clique(matrix.assembly.matrix, matrix.assembly.scatter, clique, count, local);
}

void assemble(SolidStepMatrix& matrix, const SolidSystem& system, double time, const Eigen::VectorXd& temperature,
              double step) {
  std::fill(matrix.assembly.matrix.value.begin(), matrix.assembly.matrix.value.end(), 0.0);
  Index first = 0;
  std::vector<Index> unknowns;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const SolidLaws& body = system.bodies[b];
    Eigen::VectorXd slopes;
    for (const WallLight& light : system.lights)
      if (light.body == static_cast<Index>(b)) slopes = light_slopes(light, system, temperature);
    for_each_cell_matrix(body, temperature, step, slopes, [&](Index cell, CellMatrix& local) {
      const Index* nodes = body.cells.cell(cell);
      unknowns.assign(nodes, nodes + local.rows());
      for (Index& unknown : unknowns) unknown += body.first_unknown;
      add_local(matrix, system, first + cell, unknowns.data(), static_cast<Index>(local.rows()), local.data());
    });
    first += body.cells.count;
  }
  const ExchangeMatrices exchange{[&](Index clique, const std::array<Index, 9>& face, std::array<double, 81>& local) {
                                    add_local(matrix, system, first + clique, face.data(), 9, local.data());
                                  },
                                  [&](Index pair, const std::array<Index, 18>& both, std::array<double, 324>& local) {
                                    const Index clique =
                                        matrix.pair_clique.at(system.problem->interface.pairs[pair].key());
                                    add_local(matrix, system, clique, both.data(), 18, local.data());
                                  }};
  for_each_exchange_matrix(system, time, temperature, step, exchange);
}

/// Sets the diagonal; those of prescribed unknowns in the matrix too, to one.
void set_diagonal(SolidStepMatrix& matrix, const SolidSystem& system) {
  core::SymmetricMatrix& sparse = matrix.assembly.matrix;
  matrix.diagonal.resize(sparse.size);
  for (Index column = 0; column < sparse.size; ++column) {
    double& entry = sparse.value[sparse.column_start[column]];
    if (system.is_prescribed[column]) entry = 1;
    matrix.diagonal[column] = entry;
  }
}

}  // namespace

void prepare(SolidStepMatrix& matrix, const SolidSystem& system) {
  if (matrix.is_prescribed != system.is_prescribed) matrix.factored_step = 0;
  std::vector<Index> signature = signature_of(system);
  const bool anew = std::exchange(matrix.begins_anew, false), same_mesh = signature == matrix.mesh_signature;
  if (same_mesh && (anew ? matrix.is_dissected && has_these_pairs(matrix, system) : has_all_pairs(matrix, system)))
    return;
  matrix.factored_step = 0;
  matrix.mesh_signature = std::move(signature);
  make_pattern(matrix, system);
  analyse(matrix, same_mesh && !anew);
}

bool factorise(SolidStepMatrix& matrix, const SolidSystem& system, double time, const Eigen::VectorXd& temperature,
               double step) {
  assemble(matrix, system, time, temperature, step);
  set_diagonal(matrix, system);
  ++matrix.factorisations;
  const bool done = matrix.cholesky.factorise(matrix.assembly.matrix);
  matrix.factored_step = done ? step : 0;
  matrix.is_prescribed = system.is_prescribed;
  return done;
}

}  // namespace parison::thermal
