// SPDX-License-Identifier: GPL-3.0-or-later
// Light by rays at each accuracy against exact solutions: emission of isothermal bodies and tubes, and what a disc in a
// can sends through a hole. With --gtest_filter=LightLevels.* this prints one table.
#include <gtest/gtest.h>

#include <cstdio>

#include "figure.hpp"
#include "forming/scene/accuracy.hpp"
#include "thermal/radiation/exact_tube.hpp"
#include "thermal/radiation/view_sections.hpp"

namespace parison::thermal::test {
namespace {

constexpr std::array presets{"draft", "standard", "fine"};
constexpr std::array wanted{1.0, 0.3, 0.1};  ///< %, root mean square

LightResolution resolution_at(std::size_t level) {
  LightResolution resolution;
  resolution.rays = forming::accuracy_preset(presets[level]).light_rays;
  return resolution;
}

/// Errors of a kind of scene at one accuracy.
struct Errors {
  double squares = 0, most = 0;  ///< of their relative errors
  int count = 0, told = 0;       ///< how many of them within what parts of the rays differ by

  void add(double found, double exact, double uncertainty) {
    const double off = std::abs(found / exact - 1);
    squares += off * off;
    most = std::max(most, off);
    told += off * exact <= uncertainty ? 1 : 0;
    ++count;
  }
  void add(const Errors& other) {
    squares += other.squares;
    most = std::max(most, other.most);
    told += other.told;
    count += other.count;
  }
  double percent() const { return 100 * std::sqrt(squares / count); }
};

void add(Errors& errors, IsothermalBody&& body, const LightResolution& resolution, double exact) {
  body.problem.light_resolution = resolution;
  errors.add(body.emissivity(), exact, body.uncertainty());
}

Errors of_shape(Shape shape, const LightResolution& resolution) {
  Errors errors;
  for (const double index : {1.0, 1.518})
    for (const double optical : {0.1, 0.45, 1.2, 5.0, 10.0})
      add(errors, isothermal(shape, Model::transfer, optical, index, shape == Shape::sphere ? 16 : 40), resolution,
          exact(shape, optical, index));
  return errors;
}

Errors of_tubes(const LightResolution& resolution) {
  Errors errors;
  for (const double inner : {0.003, 0.03})
    for (const double absorption : {30.0, 150.0, 450.0, 700.0})
      add(errors, isothermal_tube(Model::transfer, inner, absorption), resolution, exact_tube(inner, absorption));
  return errors;
}

/// Light of a disc that leaves a can of radius 1 through a hole in its lid, over what it sends, as a run divides and
/// traces the can.
double through_hole(double hole, double height, const LightResolution& resolution) {
  const std::vector<Surface> walls{{{0, 0}, {1, 0}}, {{1, 0}, {1, height}}, {{1, height}, {hole, height}}};
  const double patch = (2 + height - hole) / resolution.patches();
  std::vector<Surface> surfaces;
  Eigen::Index of_disc = 0;
  for (const Surface& side : walls) {
    const int count = std::max(1, static_cast<int>(std::lround((side.to - side.from).norm() / patch)));
    for (int i = 0; i < count; ++i)
      surfaces.push_back({side.from + double(i) / count * (side.to - side.from),
                          side.from + double(i + 1) / count * (side.to - side.from)});
    if (of_disc == 0) of_disc = static_cast<Eigen::Index>(surfaces.size());
  }
  const auto edges = view_edges(surfaces, Geometry::axisymmetric, 4);
  const Eigen::ArrayXd area = areas(edges, surfaces.size());
  const Views views = closed(trace_views(edges, Geometry::axisymmetric, static_cast<Index>(surfaces.size()),
                                         resolution.view_rays(), resolution.part),
                             area);
  return views.open.head(of_disc).sum() / area.head(of_disc).sum();
}

/// Standard deviation between four parts of the rays.
double spread_through_hole(double hole, double height, LightResolution resolution) {
  Eigen::Array4d found;
  for (int part = 0; part < 4; ++part) {
    resolution.part = {4, part};
    found[part] = through_hole(hole, height, resolution);
  }
  return std::sqrt((found - found.mean()).square().sum() / 3);
}

Errors of_holes(const LightResolution& resolution) {
  Errors errors;
  for (const double hole : {0.15, 0.3, 0.45, 0.6})
    for (const double height : {0.35, 0.8, 1.4})
      errors.add(through_hole(hole, height, resolution), disc_to_disc(1, hole, height),
                 spread_through_hole(hole, height, resolution));
  return errors;
}

/// A kind of scene and its errors at a resolution.
struct Kind {
  const char* name;
  Errors (*errors_of)(const LightResolution&);
};

/// Each accuracy has the error wanted of it and less than the coarser one.
void expect_levels(const std::vector<Kind>& kinds, const char* told) {
  Errors all;
  for (const Kind& kind : kinds) {
    double coarser = std::numeric_limits<double>::infinity();
    for (std::size_t level = 0; level < presets.size(); ++level) {
      const Errors errors = kind.errors_of(resolution_at(level));
      std::printf("%-58s %-8s %6.3f %%, most %6.3f %%, told %d of %d\n", kind.name, presets[level], errors.percent(),
                  100 * errors.most, errors.told, errors.count);
      tests::expect_at_most(
          fmt::format("{} at {}: off by, root mean square of {}", kind.name, presets[level], errors.count),
          errors.percent(), wanted[level], "%");
      EXPECT_LT(errors.percent(), coarser) << kind.name << " at " << presets[level];
      coarser = errors.percent();
      all.add(errors);
    }
  }
  tests::expect_at_least(told, 100.0 * all.told / all.count, 95, "%");
}

TEST(LightLevels, bodies_emit_as_the_exact_solutions_say_the_finer_the_better_and_parts_of_the_rays_tell_how_well) {
  expect_levels(
      {{"transfer: emission of isothermal slabs", [](const auto& at) { return of_shape(Shape::slab, at); }},
       {"transfer: emission of isothermal cylinders", [](const auto& at) { return of_shape(Shape::cylinder, at); }},
       {"transfer: emission of isothermal spheres", [](const auto& at) { return of_shape(Shape::sphere, at); }},
       {"transfer: emission of isothermal tubes", of_tubes}},
      "transfer: the same: error inside what parts of the rays differ by");
}

TEST(LightLevels, a_disc_is_seen_through_a_hole_the_finer_the_better_and_parts_of_the_rays_tell_how_well) {
  expect_levels({{"enclosure: light of a disc through a hole in front of it", of_holes}},
                "enclosure: the same: error inside what parts of the rays differ by");
}

}  // namespace
}  // namespace parison::thermal::test
