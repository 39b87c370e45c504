// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/flow/tool_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/numbers.hpp"
#include "core/solid/hex_geometry.hpp"
#include "forming/flow/contact/grip.hpp"

namespace parison::flow {

namespace {

/// kappa in viscosities of the cell over the size of the face. It is larger where a step is so long that gas would
/// press glass into the tool by more than the tolerated share.
constexpr double stiffness_factor = 50;
/// A gap of glass that rests stays as it is up to this share of a face: no pressure irons out that a quadratic face and
/// the tool differ.
constexpr double tolerated_share = 1e-3;
/// A point that would pass through the tool by less than this share of a face lands in the next step.
constexpr double passed_share = 2e-2;
/// What a step leaves of the depth, beyond that share, to which glass has passed into a tool. One shorter than those
/// before leaves more: at once the way out would take a force that goes with one over the step.
constexpr double kept_depth = 0.5;
constexpr double bearable_tension = 2;  ///< share of the mean pressure of contact
/// So few changes, as a share of the points that touch, wait for the next step: a factor each would give the same
/// walls.
constexpr double few_share = 0.05;
/// Points further than this many times the largest way of the step do not touch.
constexpr double reach_of_ways = 4;
constexpr double grip_reach = 1e-3;  ///< m
/// Gap from which glass that cools may sink onto what it rests on, m.
constexpr double rest_reach = 2e-3;
/// Stiffness along the slip at Coulomb's limit over that of the secant: the tangent itself is zero.
constexpr double least_slope = 1e-3;

double largest(const Eigen::VectorXd& velocity) {
  double square = 0;
  for (Index n = 0; 3 * n < velocity.size(); ++n) square = std::max(square, velocity.segment<3>(3 * n).squaredNorm());
  return std::sqrt(square);
}

Vector3 at_point(const Eigen::VectorXd& space, const std::array<Index, 9>& nodes,
                 const Eigen::Matrix<double, 9, 1>& shape) {
  Vector3 sum = Vector3::Zero();
  for (int n = 0; n < 9; ++n) sum += shape[n] * space.segment<3>(3 * nodes[n]);
  return sum;
}

}  // namespace

/// The nearest tool, a time after the start of the step.
void ToolContact::nearest(const Vector3& at, double time, Point& point) const {
  point.gap = core::infinity;
  point.tool = -1;
  for (std::size_t k = 0; k < problem_->tools.size(); ++k) {
    const SolidTool& tool = problem_->tools[k];
    const contact::SurfaceGap gap = tool.surface->gap(at - tool.offset - time * tool.velocity);
    if (gap.distance >= point.gap) continue;
    point.gap = gap.distance;
    point.normal = gap.normal;
    point.tool = static_cast<Index>(k);
  }
}

ToolContact::ToolContact(const SolidProblem& problem, const FlowMatrix& matrix, const HexMesh& start,
                         const HexMesh& middle, const Eigen::VectorXd& temperature, const Eigen::VectorXd& velocity,
                         const std::vector<SolidContact>* before, double dt, double step_before)
    : problem_(&problem), start_(&start), dt_(dt), pace_(step_before > dt ? dt / step_before : 1) {
  double fastest = largest(velocity), highest = 0;
  for (const SolidTool& tool : problem.tools) fastest = std::max(fastest, tool.velocity.norm());
  for (const auto& [faces, pressure] : problem.pressures) highest = std::max(highest, std::abs(pressure));
  for (std::size_t f = 0; f < problem.contact_faces.size(); ++f) {
    const HexFace& face = problem.contact_faces[f];
    const auto nodes = core::face_node_numbers(start, face);
    const core::HexFaceNodes positions = core::face_nodes(start, face);
    const auto mapped = core::map_hex_face(core::face_nodes(middle, face), face, contact_points_along);
    double area = 0;
    for (const auto& at : mapped) area += at.area;
    Point point;
    point.face = static_cast<Index>(f);
    point.size = std::sqrt(area);
    point.stiffness =
        std::max(stiffness_factor * matrix.mean_viscosity(face.cell), highest * dt / tolerated_share) / point.size;
    if (problem.memory) point.stiffness = problem.memory->bedding * dt;
    const double reach = problem.memory ? rest_reach : reach_of_ways * dt * fastest + tolerated_share * point.size;
    for (const auto& at : mapped) {
      point.shape = at.shape;
      point.area = at.area;
      nearest(positions * at.shape, 0, point);
      all_.push_back({point.tool, point.gap, 0, false, false});
      if (point.tool < 0 || point.gap > reach) continue;
      point.start_gap = point.gap;
      point.was_released = before && (*before)[all_.size() - 1].released;
      point.pressure_before = before ? (*before)[all_.size() - 1].pressure : 0;
      point.temperature = 0;
      for (int n = 0; n < 9; ++n) point.temperature += at.shape[n] * temperature[nodes[n]];
      place_.push_back(static_cast<Index>(all_.size()) - 1);
      points_.push_back(point);
    }
  }
  look(velocity);
  for (Point& point : points_) expect(point);
}

/// By the velocity that is expected, until glass lands it slides by that.
void ToolContact::expect(Point& point) const {
  point.tied = point.tool >= 0 && problem_->tools[point.tool].friction.law == Friction::Law::grip &&
               point.start_gap <= grip_reach;
  point.tolerated = point.tied ? point.start_gap : rests() ? 0 : std::min(point.start_gap, 0.0);
  if (const double deeper = point.tolerated + tolerated_share * point.size; deeper < 0)
    point.tolerated -= (1 - kept_depth) * pace_ * deeper;
  if (point.tool < 0) return;
  const auto& [surface, offset, velocity, friction] = problem_->tools[point.tool];
  const double landed =
      point.start_gap > 0 && point.gap < 0 ? point.gap / (point.gap - point.start_gap) : 1;  // share of the step
  point.slide_target = point.tied ? velocity : velocity + (1 - landed) * (point.velocity - velocity);
  if (point.tied)
    point.drag = grip_drag;
  else if (friction.law == Friction::Law::navier) {
    point.drag = friction.coefficient_at(point.temperature) * landed;
    point.coulomb = friction.coulomb;
    slide(point, point.pressure_before);  // glass that lands sticks at first
  } else
    point.drag = friction.law == Friction::Law::slip ? 0 : point.stiffness;
  point.touches = point.tied || (!rests() && point.start_gap <= 0 && !point.was_released) || has_passed(point);
}

/// Glass that remembers its stress rests on tools by its weight alone.
bool ToolContact::rests() const {
  return problem_->memory;
}

bool ToolContact::has_passed(const Point& point) const {
  return point.gap < (rests() ? 0 : -passed_share * point.size);
}

void ToolContact::look(const Eigen::VectorXd& velocity) {
  Index face = -1;
  std::array<Index, 9> nodes{};
  core::HexFaceNodes positions;
  for (Point& point : points_) {
    if (point.face != face) {
      face = point.face;
      nodes = core::face_node_numbers(*start_, problem_->contact_faces[face]);
      positions = core::face_nodes(*start_, problem_->contact_faces[face]);
    }
    const Vector3 before = std::exchange(point.velocity, at_point(velocity, nodes, point.shape));
    nearest(positions * point.shape + dt_ * point.velocity, dt_, point);
    point.limit_friction_before = point.limit_friction;
    if (is_held_)
      point.limit_friction += slope_along(point) * (point.velocity - before);
    else
      point.limit_friction = limit_friction(point);
  }
}

double ToolContact::friction_change() const {
  if (is_held_) return 0;
  double change = 0, all = 0;
  for (const Point& point : points_) {
    change += point.area * (point.limit_friction - point.limit_friction_before).norm();
    all += point.area * point.limit_friction.norm();
  }
  return all > 0 ? change / all : 0;
}

/// Along the tool, m/s.
Vector3 ToolContact::slip(const Point& point) const {
  const Vector3 slip = point.velocity - point.slide_target;
  return slip - slip.dot(point.normal) * point.normal;
}

/// Whether the point slides at Coulomb's limit under a pressure, Pa: its drag would be larger. One that slid and would
/// turn back sticks.
void ToolContact::slide(Point& point, double pressure) const {
  const Vector3 along = slip(point);
  const double limit = point.coulomb.value_or(core::infinity) * std::max(pressure, 0.0), speed = along.norm();
  const bool turns_back = point.slides && along.dot(point.slides_along) <= 0;
  point.slides = limit > 0 && point.drag * speed > limit && !turns_back;
  if (!point.slides) return;
  point.slides_along = along / speed;
  point.secant = limit / speed;
}

/// Shear stress of the glass on the tool, Pa. A point slides or does not until it is chosen anew.
Vector3 ToolContact::friction(const Point& point) const {
  if (!point.slides) return point.drag * slip(point);
  return is_held_ ? point.limit_friction : limit_friction(point);
}

/// That of a point that slides, by its pressure; zero for others.
Vector3 ToolContact::limit_friction(const Point& point) const {
  if (!point.touches || !point.slides) return Vector3::Zero();
  const Vector3 along = slip(point);
  const double limit = *point.coulomb * std::max(pressure(point), 0.0);
  return limit * (along.dot(point.slides_along) > 0 ? along.normalized() : point.slides_along);
}

double ToolContact::pressure(const Point& point) const {
  if (point.tool < 0) return -core::infinity;  // beyond the edge of all tools
  return -point.stiffness * (point.gap - point.tolerated) / dt_;
}

Vector3 ToolContact::traction(const Point& point) const {
  if (point.tool < 0) return Vector3::Zero();
  return pressure(point) * point.normal - friction(point);
}

/// Minus the derivative of the traction.
Eigen::Matrix3d ToolContact::slope(const Point& point) const {
  return slope_along(point) + point.stiffness * point.normal * point.normal.transpose();
}

/// The part of friction.
Eigen::Matrix3d ToolContact::slope_along(const Point& point) const {
  const double drag = point.slides ? point.secant : point.drag;
  Eigen::Matrix3d slope = drag * (Eigen::Matrix3d::Identity() - point.normal * point.normal.transpose());
  if (point.slides) slope -= (1 - least_slope) * drag * point.slides_along * point.slides_along.transpose();
  return slope;
}

Index ToolContact::choose() {
  double force = 0, area = 0;
  for (const Point& point : points_)
    if (point.touches) {
      force += std::max(pressure(point), 0.0) * point.area;
      area += point.area;
    }
  const double bearable = area > 0 ? bearable_tension * force / area : 0;
  Index changed = 0, touching = 0;
  std::vector<Point> chosen = points_;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    Point& point = chosen[k];
    point.touches = point.tied || (point.touches && !rests() ? pressure(point) > -bearable : has_passed(point));
    if (point.touches) slide(point, pressure(point));
    changed += point.touches != points_[k].touches || point.slides != points_[k].slides;
    touching += point.touches;
  }
  if (changed <= few_share * static_cast<double>(touching)) return 0;
  points_ = std::move(chosen);
  return changed;
}

void ToolContact::add_changes(FlowMatrix& matrix) {
  HexMatrix sum;
  for (std::size_t first = 0, last = 0; first < points_.size(); first = last) {
    const HexFace& face = problem_->contact_faces[points_[first].face];
    const auto& local = core::hex_face_nodes(face.axis, face.end);
    bool is_changed = false;
    for (last = first; last < points_.size() && points_[last].face == points_[first].face; ++last) {
      Point& point = points_[last];
      if (point.touches == point.is_added && point.slides == point.is_added_sliding) continue;
      if (!std::exchange(is_changed, true)) sum.setZero();
      const Eigen::Matrix3d wanted = point.touches ? slope(point) : Eigen::Matrix3d::Zero();
      const Eigen::Matrix3d added = wanted - point.added;
      for (int a = 0; a < 9; ++a)
        for (int b = 0; b < 9; ++b)
          sum.block<3, 3>(3 * local[a], 3 * local[b]) += point.area * point.shape[a] * point.shape[b] * added;
      point.added = wanted;
      point.is_added = point.touches;
      point.is_added_sliding = point.slides;
    }
    if (is_changed) matrix.add(face.cell, sum);
  }
}

Eigen::VectorXd ToolContact::forces() const {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(3 * start_->node_count());
  for (const Point& point : points_) {
    if (!point.is_added) continue;
    const Vector3 force = point.area * (traction(point) + point.added * point.velocity);
    const auto nodes = core::face_node_numbers(*start_, problem_->contact_faces[point.face]);
    for (int n = 0; n < 9; ++n) forces.segment<3>(3 * nodes[n]) += point.shape[n] * force;
  }
  return forces;
}

std::vector<SolidContact> ToolContact::contact() const {
  std::vector<SolidContact> all = all_;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Point& point = points_[k];
    const double p = point.tied && point.tool >= 0 ? pressure(point) : std::max(pressure(point), 0.0);
    const bool presses = point.touches && p > 0;
    all[place_[k]] = {point.tool, point.gap, point.touches ? p : 0, presses || point.tied, point.touches && !presses};
  }
  return all;
}

std::vector<Vector3> ToolContact::tool_forces() const {
  std::vector<Vector3> forces(problem_->tools.size(), Vector3::Zero());
  for (const Point& point : points_)
    if (point.touches && point.tool >= 0) forces[point.tool] -= point.area * traction(point);
  return forces;
}

}  // namespace parison::flow
