// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/camera/hot_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/case/case_error.hpp"
#include "core/case/units.hpp"
#include "tools/report/film/vtu_file.hpp"

namespace parison::tools {

namespace {

constexpr double millimetre = 1e-3;
constexpr int nodes_of_cell = 6, corners_of_cell = 3;

/// The mesh of a file, its nodes renumbered with the corners first; `node` becomes the file's number of each.
core::Mesh mesh_of(const VtuFile& file, std::vector<std::size_t>& node) {
  const auto place = [&](std::size_t n) {
    return core::Point(millimetre * file.points[n][0], millimetre * file.points[n][1]);
  };
  std::map<std::size_t, core::Index> corner;
  std::vector<core::Point> vertices;
  std::vector<std::array<core::Index, 3>> triangles(file.cells.size() / nodes_of_cell);
  for (std::size_t c = 0; c < triangles.size(); ++c)
    for (int k = 0; k < corners_of_cell; ++k) {
      const std::size_t n = file.cells[nodes_of_cell * c + k];
      const auto [at, is_new] = corner.try_emplace(n, static_cast<core::Index>(vertices.size()));
      if (is_new) vertices.push_back(place(n));
      triangles[c][k] = at->second;
    }
  core::Mesh mesh = core::make_quadratic_mesh(vertices, triangles);
  node.resize(mesh.nodes.size());
  for (std::size_t c = 0; c < triangles.size(); ++c)
    for (int k = 0; k < nodes_of_cell; ++k) node[mesh.cells()[c][k]] = file.cells[nodes_of_cell * c + k];
  for (std::size_t n = 0; n < node.size(); ++n) mesh.nodes[n] = place(node[n]);
  return mesh;
}

}  // namespace

HotSection read_hot_section(const std::string& folder, std::optional<double> time) {
  const auto entries = read_pvd(folder + "/glass.pvd");
  if (entries.empty())
    throw core::CaseError(
        fmt::format("{}: no glass.pvd with outputs was found, allowed is the folder of a run", folder));
  const double wanted = time.value_or(entries.back().time);
  const auto nearest = std::min_element(entries.begin(), entries.end(), [&](const PvdEntry& a, const PvdEntry& b) {
    return std::abs(a.time - wanted) < std::abs(b.time - wanted);
  });
  const VtuFile file = read_vtu(nearest->path);
  const auto field = file.nodal.find("temperature_degC");
  if (field == file.nodal.end())
    throw core::CaseError(
        fmt::format("{}: the glass has no temperatures, allowed is a run of glass that carries heat", folder));
  std::vector<std::size_t> node;
  HotSection section{nearest->time, mesh_of(file, node), {}};
  section.temperature.resize(section.mesh.node_count());
  for (std::size_t n = 0; n < node.size(); ++n)
    section.temperature[static_cast<core::Index>(n)] = field->second[node[n]] + core::zero_celsius;
  return section;
}

}  // namespace parison::tools
