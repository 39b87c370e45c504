// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/support.hpp"

#include <Eigen/Eigenvalues>

#include "core/element.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// Held weaker than this, as the square of a speed, counts as free.
constexpr double weakest = 1e-8;

/// Rigid motions of a plane body: along both axes, and around its middle scaled to its size.
constexpr int motions = dim + 1;
using Motion = Eigen::Matrix<double, motions, 1>;

/// The plane body seen from its middle.
struct Frame {
  Point middle = Point::Zero();
  double size = 0;

  explicit Frame(const core::Mesh& mesh) {
    for (const auto& x : mesh.nodes) middle += x / double(mesh.nodes.size());
    for (const auto& x : mesh.nodes) size = std::max(size, (x - middle).norm());
  }
  /// Speed at x along a direction under each motion.
  Motion speeds(const Point& x, const Point& direction) const {
    const Point arm = (x - middle) / size;
    Motion row;
    row << direction, arm[0] * direction[1] - arm[1] * direction[0];
    return row;
  }
};

Eigen::Matrix<double, motions, motions> holding(const Problem& problem) {
  const core::Mesh& mesh = *problem.mesh;
  const Frame frame(mesh);
  Eigen::Matrix<double, motions, motions> sum = Eigen::Matrix<double, motions, motions>::Zero();
  const auto hold = [&](Index node, const Point& direction) {
    const Motion row = frame.speeds(mesh.nodes[node], direction);
    sum += row * row.transpose();
  };
  for (const auto& edge : mesh.boundary) {
    const auto kind = problem.pieces[edge.piece].kind;
    if (kind == PieceCondition::Kind::free) continue;
    const auto at = core::map_edge_point(mesh, edge.nodes, core::Geometry::planar, {0.5, 1.0});
    for (const Index node : edge.nodes) {
      hold(node, at.normal);
      if (kind == PieceCondition::Kind::fixed) hold(node, at.tangent);
    }
  }
  for (const auto& candidate : problem.candidates) {
    hold(candidate.node, candidate.normal);
    if (problem.tools[candidate.tool].friction.law != Friction::Law::slip)
      hold(candidate.node, Point(-candidate.normal[1], candidate.normal[0]));
  }
  return sum;
}

}  // namespace

std::string free_motion(const Problem& problem) {
  const auto sentence = [](const char* motion) {
    return std::string("the glass is not held: it is free to ") + motion +
           ", which no tool, symmetry plane or fixed piece prevents";
  };
  const auto held = holding(problem);
  if (core::hoop(problem.geometry, Point::Ones()) != 0)  // rings only move along the axis
    return held(dim - 1, dim - 1) > weakest ? "" : sentence("move along the axis");
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, motions, motions>> modes(held);
  if (modes.eigenvalues()[0] > weakest * std::max(1.0, modes.eigenvalues()[motions - 1])) return "";
  Index axis = 0;
  modes.eigenvectors().col(0).cwiseAbs().maxCoeff(&axis);
  return sentence(axis == dim ? "turn" : axis == dim - 1 ? "move along the axis" : "move sideways");
}

}  // namespace parison::flow
