#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later

/// All tolerances on lengths, as shares of the size of a body (core::size), so that a scene and its scaled copy give
/// the same result. Each was found on containers whose gob measures 66 mm; the length there is given with it.
namespace parison::core::tolerance {

/// Coincident points: gaps that count as closed (1 nm, far above round-off and far below any gap that matters).
inline constexpr double coincident = 1.5e-8;
/// Ends of two tools that form a junction, and corners that count as one (10 um: what drawings leave open).
inline constexpr double junction = 1.5e-4;
/// Penetration that one step may add before it is iterated again (1 um), and before it is rejected (4 um): the deepest
/// node of the bundled containers stays below 5 um.
inline constexpr double penetration = 1.5e-5, rejected_penetration = 6e-5;
/// Gap below which a surface node is at a tool when the volume is restored (2 um: twice what a step may leave).
inline constexpr double at_tool = 3e-5;
/// Gap below which a new node next to an old one in contact is in contact (20 um: the sagitta of an edge on an arc).
inline constexpr double contact_after_remesh = 3e-4;
/// Depth below which a point of a surface to be meshed is left inside a tool (10 um; the finished mesh is projected
/// out).
inline constexpr double outline_penetration = 1.5e-4;
/// Distance within which nodes are contact candidates and get the edge length of the thermal boundary layer (1 mm:
/// farther than a node moves in a step).
inline constexpr double contact_proximity = 1.5e-2;
/// Distance from the surface of the glass that the end of a boundary named by a stage may have (5 mm).
inline constexpr double named_end = 7.5e-2;
/// Thickness of a free neck of glass below which what hangs on it has torn off (5 um: it would take for ever to get to
/// nothing).
inline constexpr double torn_neck = 7.5e-5;
/// Shift of the free surface in one round of restoring the volume (50 um), and the shifts of the free part (20 um) and
/// of the whole surface (1 um, what a step may leave) that decide which of them moves.
inline constexpr double shift = 7.5e-4, free_shift = 3e-4, whole_shift = 1.5e-5;
/// Overlap of a tool with the glass that makes a stage impossible (0.5 mm), and distance of a tool from the start of
/// its motion (1 um: what decimals in a case file leave).
inline constexpr double stage_overlap = 7.5e-3, motion_start = 1.5e-5;
/// Largest edge inside a tool (8 mm: a quarter of a wall).
inline constexpr double tool_edge = 0.12;
/// Speeds, per second: into a tool, that count as round-off (10 nm/s: nanometres in a run); of tools that do not move
/// (1 um/s).
inline constexpr double round_off_speed = 1.5e-7, standing_speed = 1.5e-5;

}  // namespace parison::core::tolerance
