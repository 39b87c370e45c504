#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of a `path`, taken apart in a time that grows with their length; nothing is interpreted here.
#include <optional>
#include <string_view>
#include <vector>

namespace parison::forming {

/// "(31, 14) (29.5, 20) mm": what stands between the brackets of each point, and the unit, which may be missing where a
/// point has units or names of its own.
struct PointsText {
  std::vector<std::string_view> points;
  std::string_view unit;
};
/// Nothing where the text has another form.
std::optional<PointsText> split_points(std::string_view text);

/// "arc centre (13.5, 84) mm radius 14 mm from 0 deg to 90 deg" in its parts.
struct ArcText {
  std::string_view centre, unit, radius, from, to;
};
/// The parts of a point between its commas; those inside brackets do not part. The last has the rest where there are
/// more than a thousand.
std::vector<std::string_view> split_coordinates(std::string_view inside);
/// Nothing where the text has another form.
std::optional<ArcText> split_arc(std::string_view text);

}  // namespace parison::forming
