// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/solid/wall_straightening.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/solid/hex_geometry.hpp"
#include "core/solid/quad_face.hpp"
#include "remesh/solid/wall_mesh.hpp"

namespace parison::remesh {

namespace {

using core::Vector3;

/// The point of a face nearest to another.
Vector3 nearest_on_face(const std::vector<Vector3>& nodes, const core::QuadFace& face, const Vector3& to) {
  constexpr int iterations = 12;
  double a = 0.5, b = 0.5;
  for (int i = 0; i < iterations; ++i) {
    const core::FacePlace at = core::face_place(nodes, face, a, b);
    const Vector3 way = to - at.position;
    const double aa = at.along_a.squaredNorm(), bb = at.along_b.squaredNorm(), ab = at.along_a.dot(at.along_b);
    const double wa = way.dot(at.along_a), wb = way.dot(at.along_b), det = aa * bb - ab * ab;
    if (!(det > 0)) break;
    const double next_a = std::clamp(a + (wa * bb - wb * ab) / det, 0.0, 1.0);
    const double next_b = std::clamp(b + (wb * aa - wa * ab) / det, 0.0, 1.0);
    const bool rests = std::abs(next_a - a) + std::abs(next_b - b) < 1e-13;
    a = next_a;
    b = next_b;
    if (rests) break;
  }
  return core::face_place(nodes, face, a, b).position;
}

/// One side of the wall as it was: nodes slide on it.
class Side {
 public:
  Side(const core::HexMesh& mesh, const std::vector<core::HexFace>& faces)
      : nodes_(&mesh.nodes), faces_of_(mesh.nodes.size()) {
    for (const core::HexFace& face : faces) {
      for (const Index node : core::face_node_numbers(mesh, face)) faces_of_[node].push_back(faces_.size());
      faces_.push_back(core::quad_face(mesh, face));
    }
  }

  const std::vector<core::QuadFace>& faces() const { return faces_; }

  /// The point of the side nearest to one in its faces at a node or the next to those.
  Vector3 nearest(Index node, const Vector3& to) const {
    Vector3 best = (*nodes_)[node];
    for (const std::size_t face : about(node))
      if (const Vector3 at = nearest_on_face(*nodes_, faces_[face], to);
          (at - to).squaredNorm() < (best - to).squaredNorm())
        best = at;
    return best;
  }

 private:
  std::vector<std::size_t> about(Index node) const {
    std::vector<std::size_t> result;
    for (const std::size_t face : faces_of_[node])
      for (const Index other : faces_[face].nodes)
        result.insert(result.end(), faces_of_[other].begin(), faces_of_[other].end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  const std::vector<Vector3>* nodes_;
  std::vector<core::QuadFace> faces_;
  std::vector<std::vector<std::size_t>> faces_of_;  ///< by node
};

class Straightening {
 public:
  explicit Straightening(const MovedWall& wall)
      : wall_(wall),
        sides_{Side(*wall.mesh, *wall.inner), Side(*wall.mesh, *wall.outer)},
        column_of_(wall.mesh->nodes.size()),
        is_fixed_(wall.columns->size(), false),
        planes_of_(wall.mesh->nodes.size()),
        mesh_(*wall.mesh) {
    for (std::size_t c = 0; c < wall.columns->size(); ++c)
      for (const Index node : (*wall.columns)[c]) column_of_[node] = c;
    for (const core::HexFace& face : *wall.rim)
      for (const Index node : core::face_node_numbers(mesh_, face)) is_fixed_[column_of_[node]] = true;
    for (const core::SymmetryPlane& plane : *wall.planes)
      for (const Index node : plane.nodes) planes_of_[node].push_back(plane.normal);
    const auto layers = static_cast<Index>(wall.columns->front().size() / 2);
    for (const double end : layer_ends(layers)) {
      if (!shares_.empty()) shares_.push_back(0.5 * (shares_.back() + end));
      shares_.push_back(end);
    }
  }

  std::vector<Vector3> run(double wanted) {
    constexpr int rounds = 40, before_sliding = 4;
    constexpr Reach beside{2, 0.5}, about{8, 0.8};
    std::vector<Vector3> best = mesh_.nodes;
    double least_lack = lack(mesh_, wanted);
    for (int round = 0; round < rounds && least_lack > 0; ++round) {
      if (round == before_sliding) mesh_.nodes = wall_.mesh->nodes;
      const std::vector<double> weight = weights(wanted, beside);
      if (round >= before_sliding) {
        const std::vector<double> far = weights(wanted, about);
        for (const int end : {0, 1}) {
          set_upright(end, far);
          slide(end, weight);
        }
        set_back(far);
      } else {
        set_back(weight);
      }
      core::HexMesh tried = without_harm(wanted);
      if (const double now = lack(tried, wanted); now < least_lack) {
        least_lack = now;
        best = std::move(tried.nodes);
      }
    }
    return best;
  }

 private:
  Index end_node(std::size_t column, int end) const {
    return end == 0 ? (*wall_.columns)[column].front() : (*wall_.columns)[column].back();
  }

  /// What all cells lack in their least Jacobians: one that cannot be mended does not keep others from it.
  static double lack(const core::HexMesh& mesh, double wanted) {
    constexpr double folded = -1;
    double sum = 0;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
      sum += std::max(0.0, wanted - std::max(folded, core::least_jacobian(mesh, cell)));
    return sum;
  }

  /// The mesh so far with columns as they were about cells that have become worse and are not good enough.
  core::HexMesh without_harm(double wanted) const {
    core::HexMesh tried = mesh_;
    for (bool is_harmed = true; is_harmed;) {
      is_harmed = false;
      for (Index cell = 0; cell < tried.cell_count(); ++cell) {
        const double own = core::least_jacobian(tried, cell);
        if (own >= wanted || own >= core::least_jacobian(*wall_.mesh, cell)) continue;
        is_harmed = true;
        for (const Index node : tried.cells[cell])
          for (const Index other : (*wall_.columns)[column_of_[node]]) tried.nodes[other] = wall_.mesh->nodes[other];
      }
    }
    return tried;
  }

  /// How far around bad cells columns move: so many cells, in each by so much less than in the one before.
  struct Reach {
    int rings;
    double fall;
  };

  /// By column how much it may move: wholly at bad cells, less around them, not at the rim.
  std::vector<double> weights(double wanted, const Reach& reach) const {
    std::vector<double> weight(wall_.columns->size(), 0);
    for (Index cell = 0; cell < mesh_.cell_count(); ++cell)
      if (core::least_jacobian(mesh_, cell) < wanted)
        for (const Index node : mesh_.cells[cell]) weight[column_of_[node]] = 1;
    for (int ring = 0; ring < reach.rings; ++ring) {
      const std::vector<double> before = weight;
      for (const core::QuadFace& face : sides_[1].faces()) {
        double most = 0;
        for (const Index node : face.nodes) most = std::max(most, before[column_of_[node]]);
        for (const Index node : face.nodes) {
          double& own = weight[column_of_[node]];
          own = std::max(own, reach.fall * most);
        }
      }
    }
    for (std::size_t c = 0; c < weight.size(); ++c)
      if (is_fixed_[c]) weight[c] = 0;
    return weight;
  }

  Vector3 on_planes(Index node, Vector3 at) const {
    for (const Vector3& normal : planes_of_[node]) at -= (at - wall_.mesh->nodes[node]).dot(normal) * normal;
    return at;
  }

  /// Normals of a side as it was, by node.
  std::vector<Vector3> normals(int end) const {
    std::vector<Vector3> normal(mesh_.nodes.size(), Vector3::Zero());
    for (const core::QuadFace& face : sides_[static_cast<std::size_t>(end)].faces())
      for (int n = 0; n < 9; ++n)
        normal[face.nodes[static_cast<std::size_t>(n)]] +=
            core::face_place(mesh_.nodes, face, 0.5 * (n % 3), 0.5 * (n / 3)).area();
    for (Vector3& one : normal)
      if (const double length = one.norm(); length > 0) one /= length;
    return normal;
  }

  /// Ends of columns that lean go towards each other along the wall, each on its side as it was.
  void set_upright(int end, const std::vector<double>& weight) {
    constexpr double share = 0.25;  // of the way; as much is for the other end
    const std::vector<Vector3> normal = normals(end);
    const auto& side = sides_[static_cast<std::size_t>(end)];
    for (std::size_t c = 0; c < weight.size(); ++c) {
      const Index node = end_node(c, end);
      if (weight[c] == 0 || planes_of_[node].size() > 1) continue;
      Vector3 lean = mesh_.nodes[end_node(c, 1 - end)] - mesh_.nodes[node];
      lean -= lean.dot(normal[node]) * normal[node];
      mesh_.nodes[node] =
          on_planes(node, side.nearest(node, on_planes(node, mesh_.nodes[node] + share * weight[c] * lean)));
    }
  }

  /// Ends of columns go towards the middle of their neighbours, on the side as it was.
  void slide(int end, const std::vector<double>& weight) {
    constexpr double share = 0.5;  // of the way
    constexpr std::array<std::array<int, 3>, 4> edges{{{0, 1, 2}, {6, 7, 8}, {0, 3, 6}, {2, 5, 8}}};
    std::vector<Vector3> sum(mesh_.nodes.size(), Vector3::Zero());
    std::vector<double> count(mesh_.nodes.size(), 0);
    const auto add = [&](Index node, const Vector3& at, double times) {
      sum[node] += times * at;
      count[node] += times;
    };
    for (const core::QuadFace& face : sides_[static_cast<std::size_t>(end)].faces()) {
      const auto at = [&](int n) { return mesh_.nodes[face.nodes[static_cast<std::size_t>(n)]]; };
      Vector3 middle = Vector3::Zero();
      for (const auto& edge : edges) {
        const Index first = face.nodes[edge[0]], second = face.nodes[edge[2]];
        // An edge in a plane has its other face beyond it.
        const bool is_in_plane = !planes_of_[face.nodes[edge[1]]].empty();
        const double times = is_in_plane ? 2 : 1;
        add(first, at(edge[2]), times);
        add(second, at(edge[0]), times);
        add(face.nodes[edge[1]], 0.5 * (at(edge[0]) + at(edge[2])), 1);
        middle += 0.5 * at(edge[1]) - 0.125 * (at(edge[0]) + at(edge[2]));
      }
      add(face.nodes[4], middle, 1);
    }
    const auto& side = sides_[static_cast<std::size_t>(end)];
    std::vector<Vector3> moved = mesh_.nodes;
    for (std::size_t c = 0; c < weight.size(); ++c) {
      const Index node = end_node(c, end);
      if (weight[c] == 0 || count[node] == 0 || planes_of_[node].size() > 1) continue;
      const Vector3 to =
          on_planes(node, mesh_.nodes[node] + share * weight[c] * (sum[node] / count[node] - mesh_.nodes[node]));
      moved[node] = on_planes(node, side.nearest(node, to));
    }
    mesh_.nodes = std::move(moved);
  }

  void set_back(const std::vector<double>& weight) {
    for (std::size_t c = 0; c < weight.size(); ++c) {
      if (weight[c] == 0) continue;
      const Vector3 inner = mesh_.nodes[end_node(c, 0)], outer = mesh_.nodes[end_node(c, 1)];
      for (std::size_t k = 1; k + 1 < shares_.size(); ++k) {
        Vector3& at = mesh_.nodes[(*wall_.columns)[c][k]];
        at += weight[c] * (inner + shares_[k] * (outer - inner) - at);
      }
    }
  }

  const MovedWall& wall_;
  std::array<Side, 2> sides_;
  std::vector<std::size_t> column_of_;
  std::vector<bool> is_fixed_;                   ///< by column
  std::vector<std::vector<Vector3>> planes_of_;  ///< by node: normals
  std::vector<double> shares_;                   ///< of the wall, by node of a column
  core::HexMesh mesh_;                           ///< so far
};

}  // namespace

double least_jacobian(const core::HexMesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) least = std::min(least, core::least_jacobian(mesh, cell));
  return least;
}

std::vector<Vector3> straightened_nodes(const MovedWall& wall, double wanted) {
  return Straightening(wall).run(wanted);
}

}  // namespace parison::remesh
