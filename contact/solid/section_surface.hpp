#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "contact/solid/tool_surface.hpp"
#include "core/mesh/profile.hpp"
#include "core/solid/section_family.hpp"

namespace parison::contact {

/// Surface of a tool whose outline, drawn in the plane y = 0, is turned about the axis with the sections of a family:
/// where they are circles, a body of revolution. A point (x, y, z) lies on it where (half width of the section through
/// it, z) lies on the outline.
class SectionSurface : public ToolSurface {
 public:
  /// `offset`: of the tool along the axis, m. The profile must outlive this object.
  SectionSurface(const core::Profile& outline, const std::vector<bool>& contact_boundaries, core::SectionFamily family,
                 double offset = 0);
  /// By steps along the gradient to the surface: exact for bodies of revolution and on the surface, and off by the
  /// square of the distance over the radius of curvature elsewhere. Infinite where there is no contact boundary.
  SurfaceGap gap(const core::Vector3& at) const override;

 private:
  struct Level;
  Level level(const core::Vector3& at) const;

  const core::Profile* outline_;
  std::vector<const core::Segment*> segments_;  ///< that may touch the glass
  core::SectionFamily family_;
  core::Vector3 offset_;
};

}  // namespace parison::contact
