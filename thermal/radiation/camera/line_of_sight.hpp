#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/mesh/cell_map.hpp"
#include "thermal/properties.hpp"
#include "thermal/radiation/planck.hpp"
#include "thermal/radiation/rays/section.hpp"

namespace parison::thermal {

/// A nodal field at many points of a mesh: the cells are sorted into a grid of bins.
class FieldAtPoints {
 public:
  FieldAtPoints(const core::Mesh& mesh, Eigen::VectorXd field);
  /// The field at a point; just outside the mesh that of the nearest cell in the point's bin.
  double operator()(const core::Point& x) const;

 private:
  std::array<long, 2> bin(const core::Point& x) const;

  const core::Mesh& mesh_;
  Eigen::VectorXd field_;
  std::vector<core::CellMap> maps_;
  core::Point low_;
  double width_ = 0;  ///< of a bin, m
  std::array<long, 2> count_{};
  std::vector<std::vector<core::Index>> cells_;  ///< of each bin
};

/// Wavelengths in vacuum that a camera is sensitive to, m.
struct CameraBand {
  double from, to;
};

/// Optics of the glass that a camera looks at; opaque beyond the last band.
struct Optics {
  double refractive_index;
  std::vector<Band> bands;
};
/// Of a material: its bands where it has any, else the mean absorption at all wavelengths; without radiation it is
/// opaque with the index 1.5.
Optics optics_of(const Material& material);

/// Glass as a camera sees it. Lines of sight are followed backwards: refracted and reflected at each surface by Snell
/// and Fresnel, with the emission of the glass along the way and that of black surroundings where they leave. The mesh
/// has to live as long.
class LineOfSight {
 public:
  LineOfSight(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& temperature, const Optics& optics,
              CameraBand band, double surroundings);

  /// Radiance that comes back along a ray which begins outside, W/m2/sr.
  double radiance(const Ray& ray) const;
  /// Temperature of a black body of that radiance, K.
  double apparent_temperature(double radiance) const;
  /// Temperature, K, of the surface that a ray meets first; not a number where it meets none.
  double surface_temperature(const Ray& ray) const;
  /// Whether a ray that begins outside meets the glass.
  bool meets(const Ray& ray) const { return section_.enter(ray, -1).has_value(); }

 private:
  /// A part of the camera's band in which the glass absorbs alike.
  struct Part {
    BandEmission emission;
    double absorption;     ///< 1/m; infinite where the glass is opaque
    core::Table relative;  ///< factor on it by temperature, K; empty: 1

    double absorption_at(double temperature) const {
      return relative.x.empty() ? absorption : absorption * relative(temperature);
    }
  };
  /// A ray that still has to be followed, with the share of its radiance, by part, that reaches the camera.
  struct Beam {
    Ray ray;
    Index facet;
    bool inside;
    int surfaces;  ///< met so far
    double temperature;
    Eigen::ArrayXd share;
  };
  Eigen::ArrayXd emission(double temperature) const;
  void follow_outside(Beam beam, double& sum, std::vector<Beam>& beams) const;
  void follow_inside(Beam beam, double& sum, std::vector<Beam>& beams) const;
  double emitted_along(const Ray& ray, double length, Eigen::ArrayXd& share) const;

  double index_, surroundings_;
  std::vector<Part> parts_;
  BandEmission whole_;
  Section section_;
  FieldAtPoints temperature_;
};

}  // namespace parison::thermal
