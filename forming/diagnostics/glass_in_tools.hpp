#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Where and when the glass was deepest in a tool.
struct PenetrationPlace {
  Index tool = -1;                ///< none: no glass was in a tool
  double r = 0, z = 0, time = 0;  ///< of the glass, m; s
};

/// How deep nodes or edges of the glass came into tools.
struct Penetrated {
  double depth = 0;  ///< at any step, m
  double share = 0;  ///< of the mean wall of the glass at that step
  PenetrationPlace place;
};

/// How deep glass came into tools, and the first face without contact through which it came.
struct GlassInTools {
  Penetrated node;
  Penetrated edge;  ///< a point on an edge in contact
  Index entered_tool = -1, entered_boundary = -1;
};

/// A boundary of a tool.
struct ToolFace {
  Index tool, boundary;
};
/// The face without contact, but no symmetry, through which a node of the glass has come into an active tool: that face
/// is the closest, a contact face at least twice as far, and the node deeper than 1 % of the mean wall or, in thick
/// glass, than steps leave it behind a contact face.
std::optional<ToolFace> entered_face(const Scene& scene, const State& state);

/// Raises the depths to those of a state.
void follow_glass_in_tools(const Scene& scene, const State& state, GlassInTools& seen);

/// "the deepest, 0.02 mm, in plunger at (r, z) = (3, 41.2) mm after 0.31 s"; empty where nothing was in a tool.
std::string place_of_penetration(const Scene& scene, const Penetrated& seen);

/// That glass has come into a tool through a face without contact, and what to do; empty where it has not.
std::string entered_face_sentence(const Scene& scene, const GlassInTools& seen);

template <typename Visitor, typename Seen>
void visit_penetrated(Visitor visit, Seen& seen) {
  visit("depth", seen.depth);
  visit("share", seen.share);
  visit("tool", seen.place.tool);
  visit("r", seen.place.r);
  visit("z", seen.place.z);
  visit("time", seen.place.time);
}

template <typename Visitor, typename Seen>
void visit_glass_in_tools(Visitor visit, Seen& seen) {
  visit_penetrated(visit.part("node"), seen.node);
  visit_penetrated(visit.part("edge"), seen.edge);
  visit("entered_tool", seen.entered_tool);
  visit("entered_boundary", seen.entered_boundary);
}

}  // namespace parison::forming
