#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Emission of isothermal slabs, cylinders and spheres, computed and by the integral over the chords that solves the
// radiative transfer equation.
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "thermal/bodies.hpp"
#include "thermal/radiation/light_error.hpp"
#include "thermal/system.hpp"

namespace parison::thermal::test {

using core::Geometry;
using Model = Radiation::Model;

inline constexpr double size = 0.01, hot = 1300;  ///< m, K: thickness or diameter; temperature
enum class Shape { slab, cylinder, sphere };
inline constexpr const char* name_of(Shape shape) {
  return shape == Shape::slab ? "slabs" : shape == Shape::cylinder ? "cylinders" : "spheres";
}

/// A body whose right and, of the sphere, top sides are its surface.
inline core::Mesh mesh_of(Shape shape, int cells) {
  if (shape == Shape::slab) return rectangle(divide(0, size, cells), {0, size / cells});
  if (shape == Shape::cylinder) return rectangle(divide(0, size / 2, cells), {0, size / cells});
  core::Mesh mesh = rectangle(divide(0, 1, cells), divide(0, 1, cells));
  for (Point& x : mesh.nodes)
    x = 0.5 * size * Point(x[0] * std::sqrt(1 - x[1] * x[1] / 2), x[1] * std::sqrt(1 - x[0] * x[0] / 2));
  return mesh;
}

inline double surface_of(Shape shape, int cells) {
  return shape == Shape::slab       ? 2 * size / cells
         : shape == Shape::cylinder ? M_PI * size * size / cells
                                    : M_PI * size * size / 2;
}

/// A body of one temperature in cold surroundings, which some of its sides see; not to be copied.
struct IsothermalBody {
  Material material;
  core::Mesh mesh;
  double surface;  ///< m2
  Problem problem;

  IsothermalBody(core::Mesh its_mesh, Geometry geometry, const Radiation& radiation, const std::vector<Index>& open,
                 double its_surface)
      : material{2400, core::constant(1300), core::constant(1.3), radiation},
        mesh(std::move(its_mesh)),
        surface(its_surface),
        problem{geometry, {body(mesh, material)}, {}, {}} {
    problem.bodies[0].light.surroundings.resize(4);
    for (const Index side : open) problem.bodies[0].light.surroundings[side] = core::TimeFunction(0);
  }
  IsothermalBody(const IsothermalBody&) = delete;
  IsothermalBody& operator=(const IsothermalBody&) = delete;

  /// Light out of it over that of a black surface.
  double emissivity() const {
    const HeatSystem system = make_heat_system(problem);
    return evaluate_flows(system, 0, Eigen::VectorXd::Constant(system.size(), hot)).to_air[0] / black();
  }
  /// How wrong that is by parts of the rays.
  double uncertainty() const {
    return light_error(problem, 0, {Eigen::VectorXd::Constant(mesh.node_count(), hot)}).power / black();
  }

 private:
  double black() const { return surface * stefan_boltzmann * std::pow(hot, 4); }
};

/// A body whose optical size is that of its thickness or diameter.
inline IsothermalBody isothermal(Shape shape, Model model, double optical, double index, int cells) {
  const std::vector<Index> open = shape == Shape::slab     ? std::vector<Index>{right, left}
                                  : shape == Shape::sphere ? std::vector<Index>{right, top}
                                                           : std::vector<Index>{right};
  return {mesh_of(shape, cells),
          shape == Shape::slab ? Geometry::planar : Geometry::axisymmetric,
          {index, 0, false, model, {{std::numeric_limits<double>::infinity(), optical / size}}},
          open,
          surface_of(shape, cells)};
}

inline double emissivity(Shape shape, Model model, double optical, double index, int cells) {
  return isothermal(shape, model, optical, index, cells).emissivity();
}

/// int_0^1 f, f smooth over s^2 from `start` on and zero below.
inline double integrate(const std::function<double(double)>& f, double start) {
  constexpr int panels = 300;
  double sum = 0;
  for (int i = 0; i < panels; ++i)
    for (const auto& at : core::edge_rule(5)) {
      const double s = (i + at.s) / panels;
      sum += at.weight / panels * 2 * (1 - start) * s * f(start + (1 - start) * s * s);
    }
  return sum;
}

/// n^2 times the mean over the directions of (1 - R)(1 - e)/(1 - R e), e the transmission of the chord, on which a ray
/// meets the surface at the same angle again and again.
inline double exact(Shape shape, double optical, double index) {
  const double critical = critical_cosine(index);
  const auto leaving = [&](double mu, double chord) {
    const double R = fresnel_reflectivity(index, mu), passed = std::exp(-optical * chord);
    return (1 - R) * (1 - passed) / (1 - R * passed);
  };
  if (shape == Shape::slab)
    return 2 * index * index * integrate([&](double mu) { return mu * leaving(mu, 1 / mu); }, critical);
  if (shape == Shape::sphere)
    return 2 * index * index * integrate([&](double mu) { return mu * leaving(mu, mu); }, critical);
  // mu = sin b cos p, b from the axis, p from the normal in the plane across it; the chord is cos p/sin b. For each
  // mu the angle b runs from where sin b = mu.
  return 2 * index * index *
         integrate(
             [&](double mu) {
               constexpr int parts = 200;
               double sum = 0;
               for (int i = 0; i < parts; ++i) {
                 // Azimuth around the normal: sin^2 b = 1 - (1 - mu^2) cos^2 a.
                 const double a = M_PI / 2 * (i + 0.5) / parts;
                 const double square = 1 - (1 - mu * mu) * std::pow(std::cos(a), 2);
                 sum += leaving(mu, mu / square) / parts;
               }
               return mu * sum;
             },
             critical);
}

}  // namespace parison::thermal::test
