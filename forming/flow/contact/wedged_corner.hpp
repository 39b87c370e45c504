#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/flow/contact/constraints.hpp"

namespace parison::flow {

/// Where two tools meet at a node of the glass and one of them, on which the glass would stick, is wedged along by the
/// other, no velocity fits both beside the corner: the stress would grow with every finer mesh, as that of two plates
/// in a scraped corner does (G. I. Taylor 1962; for contact lines C. Huh, L. E. Scriven, J. Colloid Interface Sci. 35
/// (1971) 85-101). The glass gives way there along the tool, freely at the corner and ever less up to this share of the
/// size of the glass: of a gob of 66 mm 3 mm, the depth to which it chills in one or two seconds of contact, so that no
/// skin is held nearer than it is thick.
inline constexpr double give_way_share = 0.045;

/// A corner of two tools in which the glass is wedged along one of them.
struct WedgedCorner {
  Point at;
  Index tool;     ///< along which, index into Problem::tools
  double length;  ///< up to which the glass gives way, m
};

/// Adds the tools along which a node with these equalities is wedged though it sticks to them.
void add_wedged_corners(const Problem& problem, Index node, const NodeEqualities& equalities,
                        std::vector<WedgedCorner>& corners);

/// Shear stress over viscosity and slip, 1/m, with which a node that sticks to a tool gives way beside the corners;
/// infinite where it does not.
double give_way(const Problem& problem, Index node, Index tool, const std::vector<WedgedCorner>& corners);

/// Viscosity of the glass at a node without shear thinning, Pa.s.
double viscosity_at(const Problem& problem, Index node);

}  // namespace parison::flow
