// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/benchmarks/programs/mesh_figures.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/io/files.hpp"
#include "remesh/mesher/quality.hpp"

namespace parison::bench {

using core::Index;
using core::Point;

namespace {

double chord_area(const core::Mesh& mesh, Index cell) {
  const auto& nodes = mesh.cells()[cell];
  const Point u = mesh.nodes[nodes[1]] - mesh.nodes[nodes[0]], v = mesh.nodes[nodes[2]] - mesh.nodes[nodes[0]];
  return 0.5 * (u[0] * v[1] - u[1] * v[0]);
}

/// Smallest angle of a cell's chords, degrees.
double min_angle(const core::Mesh& mesh, Index cell) {
  double least = 180;
  for (int k = 0; k < 3; ++k) {
    const Point& x = mesh.nodes[mesh.cells()[cell][k]];
    const Point u = mesh.nodes[mesh.cells()[cell][(k + 1) % 3]] - x,
                v = mesh.nodes[mesh.cells()[cell][(k + 2) % 3]] - x;
    least = std::min(least, std::atan2(u[0] * v[1] - u[1] * v[0], u.dot(v)) * 180 / M_PI);
  }
  return least;
}

std::uint64_t bits_of(const core::Mesh& mesh) {
  std::string bytes(reinterpret_cast<const char*>(mesh.nodes.data()), mesh.nodes.size() * sizeof(Point));
  bytes.append(reinterpret_cast<const char*>(mesh.cells().data()), mesh.cells().size() * sizeof(mesh.cells()[0]));
  return core::fingerprint(bytes);
}

}  // namespace

MeshFigures mesh_figures(const core::Mesh& mesh, const remesh::SizeField& size) {
  const remesh::Quality quality = remesh::quality(mesh);
  MeshFigures result;
  result.min = quality.min;
  result.median = quality.median;
  result.bits = bits_of(mesh);
  std::vector<Index> first(mesh.nodes.size(), -1);  // of the two cells at a mid-side node
  int inner = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    result.min_angle = std::min(result.min_angle, min_angle(mesh, cell));
    for (int k = 0; k < 3; ++k) {
      const Index mid = mesh.cells()[cell][3 + k];
      if (first[mid] < 0) {
        first[mid] = cell;
        continue;
      }
      const double ratio = chord_area(mesh, cell) / chord_area(mesh, first[mid]);
      result.max_jump = std::max({result.max_jump, ratio, 1 / ratio});
      const Point &a = mesh.nodes[mesh.cells()[cell][k]], &b = mesh.nodes[mesh.cells()[cell][(k + 1) % 3]];
      const double off = std::abs(std::log2((b - a).norm() / size(0.5 * (a + b))));
      result.size_mean += off;
      result.size_max = std::max(result.size_max, off);
      ++inner;
    }
  }
  result.size_mean /= std::max(inner, 1);
  return result;
}

}  // namespace parison::bench
