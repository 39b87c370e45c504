#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "core/case/case_file.hpp"
#include "core/mesh/profile.hpp"

// Outlines from drawings; private to the files that read a scene.

namespace parison::forming {

using Chain = std::vector<core::Segment>;

/// The same way back.
Chain turned(const Chain& chain);
/// "(31, 14) mm".
std::string in_mm(const core::Point& x);
/// Whether the last curve ends where the first one starts.
bool is_closed(const Chain& chain);

/// Refuses an open chain whose ends are so near each other that a closed outline is meant; `gap` is what would be
/// closed, m.
void refuse_nearly_closed(const core::CaseNode& file, const Chain& chain, double gap);

/// Gaps between the ends of curves that were closed.
struct ClosedGaps {
  std::size_t count = 0;
  double widest = 0;                        ///< m
  core::Point where = core::Point::Zero();  ///< of the widest
};

/// A chain of a drawing, and the curves of its other outlines.
struct Chained {
  Chain chain, rest;
  ClosedGaps closed;
  std::optional<core::Point> branch;  ///< where more than one curve follows, at which the chain ends
};

/// Brings the curve that is closest to a place and those that follow it at both ends into a chain, each end meeting the
/// next start; ends up to `gap` apart, m, are brought together: that of a line to that of an arc, else both to the
/// middle. Refuses wider gaps.
Chained chained(const core::CaseNode& file, Chain curves, const core::Point& from, double gap);

/// The part of a segment between two parameters, 0 to 1.
core::Segment part_of(const core::Segment& segment, double from, double to);

/// The ways from one place to another over curves, or parts of them, whose ends are up to `gap` apart, m; none passes a
/// place twice. Nothing where there are too many.
std::optional<std::vector<Chain>> ways_between(Chain curves, const core::Point& from, const core::Point& to,
                                               double gap);

/// The wanted one of several ways: that next to `via`; without it, from the axis to the axis, the only one at radii
/// from zero; else none.
std::optional<Chain> wanted_way(const core::CaseTable& table, const std::vector<Chain>& ways);

/// Refuses a drawing for the outlines that it has besides a chain.
[[noreturn]] void refuse_several(const core::CaseNode& file, const Chained& drawn, const std::string& why);

/// The most lines and arcs that an outline or a drawing may have: what follows takes their number squared.
inline constexpr std::size_t max_segments = 20'000;

/// Diagonal of the box around curves in any order, m.
double size_of(std::vector<core::Segment> curves);

/// The curves of a DXF file in the order of the file, m, those without length included: of the `layer` that the table
/// of the drawing names or of all that are shown, in its `unit` or that of the file. The boundary_id of a curve counts
/// its layer in `layers`. `notes` gets a sentence about what was left out.
std::vector<core::Segment> read_dxf(const core::CaseTable& table, const std::string& path,
                                    std::vector<std::string>& layers, std::vector<std::string>& notes);

/// The curves of a section in a STEP file, m: those in a coordinate plane, or the section of a solid by a half plane
/// from its axis, which `is_cut` tells. `notes` gets a sentence about the axis that was found.
std::vector<core::Segment> read_step(const core::CaseTable& table, const std::string& path, bool& is_cut,
                                     std::vector<std::string>& notes);

/// The curves of a file in its own frame.
struct DrawnCurves {
  Chain curves;
  std::vector<std::string> layers;  ///< of a DXF file, as the boundary_id of a curve counts them
  bool is_cut = false;              ///< the section of a solid, in the frame of its axis
};

/// Reads a DXF or STEP file { file, unit, layer, axis, turn }, by its ending. Refuses one without curves.
DrawnCurves read_drawing(const core::CaseTable& table, const std::string& directory, std::vector<std::string>& notes);

/// The part of a drawing that a table { file, from, via, to, unit, layer, origin, axis, turn, gap } selects. `notes`
/// gets a sentence for what was not taken just as it was drawn.
std::vector<core::Segment> read_section(const core::CaseNode& node, const std::string& directory,
                                        std::vector<std::string>& notes);

}  // namespace parison::forming
