// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/new_container/tubing.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/case/case_error.hpp"
#include "core/math/numbers.hpp"

namespace parison::tools {

using core::millimetre;

namespace {

/// Length of the heated zone that is drawn, of the radius of the tube: with it runs of tubes of 10 to 19 mm and walls
/// of 0.5 to 1.1 mm had stems within 3 % of what was asked for.
constexpr double drawn_zone = 1.17;
/// Width of the stem over that of the tube: where none is asked for, as of the bundled vial, and what those runs had.
constexpr double usual_stem = 0.53, narrowest_stem = 0.4, widest_stem = 0.75;
/// Walls of tubing for ampoules and vials; assumed.
constexpr double thinnest = 0.3 * millimetre, thickest = 2 * millimetre;

struct Tube {
  double radius, wall, zone, stroke;
};

/// The tube that has mass and capacity below the middle of its zone.
Tube tube_with(const Ampoule& wish, double density, double zone) {
  const double inner = std::sqrt(wish.capacity / (M_PI * zone)),
               radius = std::sqrt(inner * inner + wish.mass / density / (M_PI * zone));
  const double share = wish.stem ? *wish.stem / (2 * radius) : usual_stem;
  return {radius, radius - inner, zone, drawn_zone * radius * (1 / (share * share) - 1)};
}

/// The glass keeps its volume, and the two halves of the zone are drawn alike: the middle rises by half of the stroke.
Tube tube_of_height(const Ampoule& wish, double density) {
  constexpr int most = 200;
  constexpr double damping = 0.5, close = 1e-7;
  double zone = wish.height;
  for (int i = 0; i < most && zone > 0; ++i) {
    const Tube tube = tube_with(wish, density, zone);
    const double next = wish.height - 0.5 * tube.stroke;
    if (std::abs(next - zone) < close * wish.height) return tube;
    zone += damping * (next - zone);
  }
  throw core::CaseError("no tube was found whose drawn stem ends at this height");
}

void check(const Ampoule& wish, const Tube& tube) {
  if (tube.wall < thinnest || tube.wall > thickest)
    throw core::CaseError(fmt::format("its tube has a wall of {:.2g} mm, usual are {:g} to {:g} mm",
                                      tube.wall / millimetre, thinnest / millimetre, thickest / millimetre));
  const double share = wish.stem ? *wish.stem / (2 * tube.radius) : usual_stem;
  if (share < narrowest_stem || share > widest_stem)
    throw core::CaseError(fmt::format("a stem of {:.3g} mm from a tube of {:.3g} mm, usual are {:g} to {:g} of it",
                                      *wish.stem / millimetre, 2 * tube.radius / millimetre, narrowest_stem,
                                      widest_stem));
}

}  // namespace

std::vector<std::string> fit_tubing(const Ampoule& wish, double density) {
  Tube tube{};
  try {
    tube = tube_of_height(wish, density);
    check(wish, tube);
  } catch (const core::CaseError& error) {
    throw core::CaseError(
        fmt::format("no ampoule of ordinary proportions has this weight, capacity and height: {}", error.what()));
  }
  const auto set = [](const char* name, double value) {
    return fmt::format("dimension.{}={:.3f} mm", name, value / millimetre);
  };
  return {set("tube_radius", tube.radius), set("wall", tube.wall), set("zone_middle", tube.zone),
          set("stroke", tube.stroke)};
}

}  // namespace parison::tools
