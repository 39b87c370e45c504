#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/solid/hex_element.hpp"
#include "forming/solid/flow/flow_matrix.hpp"

namespace parison::flow {

/// Contact of the glass with tools over a step. At the points of faces the gap that the step ends with is held by
/// p = -kappa (gap - tolerated)/dt, where that presses; kappa is so large that the gap is micrometres. Friction acts on
/// the velocity along the tool. Both are linear in the velocity while the points that touch stay the same.
class ToolContact {
 public:
  /// For a step `dt`, s, from `start` with the balance of forces at `middle`. `velocity` is expected, three for each
  /// node, m/s: by it the points that touch are chosen. `step_before`: length of the longer of the last two, s.
  ToolContact(const SolidProblem& problem, const FlowMatrix& matrix, const HexMesh& start, const HexMesh& middle,
              const Eigen::VectorXd& temperature, const Eigen::VectorXd& velocity,
              const std::vector<SolidContact>* before, double dt, double step_before);

  /// Looks at the end of the step with another velocity.
  void look(const Eigen::VectorXd& velocity);
  /// Chooses anew which points touch, and which slide at the limit of their friction, after `look`; returns how many
  /// changed, 0 where they are so few that they wait for the next step.
  Index choose();
  /// Adds to the matrix what was chosen since the last call.
  void add_changes(FlowMatrix& matrix);
  /// Forces on the nodes, N, three for each, at the velocity looked at; with what the matrix has for that velocity.
  Eigen::VectorXd forces() const;
  /// Contact at each point, and the force on each tool, N.
  std::vector<SolidContact> contact() const;
  std::vector<Vector3> tool_forces() const;
  /// From now on friction at its limit follows the velocity as the matrix does, not the pressure and the direction:
  /// where points turn to and fro it would not settle.
  void hold_friction() { is_held_ = true; }
  /// By how much the last `look` has changed the friction of points that slide at its limit, as a share of it all.
  double friction_change() const;

 private:
  struct Point {
    Index face = 0;
    Eigen::Matrix<double, 9, 1> shape;
    double area = 0, size = 0;               ///< m2, and the root of the face's
    double stiffness = 0, drag = 0;          ///< across and along the tool, Pa.s/m
    double start_gap = 0, tolerated = 0;     ///< m
    double temperature = 0;                  ///< K
    Vector3 slide_target = Vector3::Zero();  ///< velocity that friction pulls to, m/s
    bool tied = false, touches = false, was_released = false;
    std::optional<double> coulomb;             ///< most of the shear stress over the pressure
    double pressure_before = 0;                ///< at the end of the last step, Pa
    bool slides = false;                       ///< at that limit
    Vector3 slides_along = Vector3::Zero();    ///< unit vector in which it then does
    double secant = 0;                         ///< shear stress over slip there, Pa.s/m
    Vector3 limit_friction = Vector3::Zero();  ///< at the last two velocities looked at, Pa
    Vector3 limit_friction_before = Vector3::Zero();
    // At the velocity looked at: the nearest tool, and the gap to it at the end of the step.
    Index tool = -1;
    Vector3 velocity = Vector3::Zero(), normal = Vector3::Zero();
    double gap = 0;
    // In the matrix.
    bool is_added = false, is_added_sliding = false;
    Eigen::Matrix3d added = Eigen::Matrix3d::Zero();  ///< Pa.s/m
  };
  void nearest(const Vector3& at, double time, Point& point) const;
  void expect(Point& point) const;
  bool rests() const;
  bool has_passed(const Point& point) const;
  void slide(Point& point, double pressure) const;
  double pressure(const Point& point) const;
  Vector3 slip(const Point& point) const;
  Vector3 friction(const Point& point) const;
  Vector3 limit_friction(const Point& point) const;
  Eigen::Matrix3d slope_along(const Point& point) const;
  Vector3 traction(const Point& point) const;
  Eigen::Matrix3d slope(const Point& point) const;

  const SolidProblem* problem_;
  const HexMesh* start_;
  double dt_;
  bool is_held_ = false;           ///< friction at its limit
  double pace_;                    ///< of the step over those before, at most 1
  std::vector<Point> points_;      ///< that may touch
  std::vector<Index> place_;       ///< of each in contact()
  std::vector<SolidContact> all_;  ///< as at the start of the step
};

}  // namespace parison::flow
