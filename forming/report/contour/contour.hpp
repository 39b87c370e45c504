#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "forming/report/thickness_profile.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "remesh/wall/wall_sides.hpp"

namespace parison::forming {

/// Volume of a body beyond a coordinate along the axis, m3: above it where `up` is 1, below it where it is -1. Exact
/// for the quadratic edges of the mesh: by Green's theorem the volume is the integral of pi r^2 (planar: x times 1 m)
/// over the axial coordinate along the part of the outline that lies there.
double volume_beyond(const core::Mesh& mesh, core::Geometry geometry, double level, int up);

/// Where the outline crosses a coordinate along the axis: the other coordinate, rising, m.
std::vector<double> outline_crossings(const core::Mesh& mesh, double level);

/// A node of the glass surface.
struct ContourPoint {
  int loop;                  ///< number of the connected part of the surface
  remesh::SurfacePart side;  ///< none on glass that is no wall
  double arc;                ///< along the surface from where it begins, m
  Point position;            ///< m
  double thickness;          ///< of the wall along the inward normal, m; NaN on rims and where there is none
  double temperature;        ///< K; NaN without heat
};

/// The glass surface in the order of walking with the glass on the left, without symmetry boundaries: from one side
/// of the wall over a rim to the other. The outer side has the thickness of `profile`, the inner side that of its own
/// rays.
std::vector<ContourPoint> contour(const Scene& scene, const State& state, const ThicknessProfile& profile);

/// A horizontal slice of the glass as it stands.
struct HeightRow {
  double height;  ///< above its lowest point, m
  double axial;   ///< coordinate along the axis, m
  /// Of the outermost glass in the slice, m; x in planar scenes. The inner one is 0 where that glass reaches the axis;
  /// below the top of a push-up it is that of the push-up, not of the inside of the container.
  double outer_radius, inner_radius;
  double thickness;     ///< normal to the outer side there, m; NaN off the wall
  double weight_above;  ///< kg; in the first slice all of the glass
};

/// Slices from the lowest point to the highest, 50 to 500 at a distance of 1 mm or a power of ten of it.
std::vector<HeightRow> height_rows(const Scene& scene, const State& state, const std::vector<ContourPoint>& points);

/// contour.csv and heights.csv as texts.
std::string contour_text(const Scene& scene, const State& state, const std::vector<ContourPoint>& points);
std::string heights_text(const std::vector<HeightRow>& rows);

}  // namespace parison::forming
