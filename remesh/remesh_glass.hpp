#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "remesh/mesher/triangulate.hpp"
#include "remesh/surface/resample.hpp"

namespace parison::remesh {

struct Remeshed {
  core::Mesh mesh;
  bool ok = false;
  std::string reason;                          ///< why not, a sentence
  double volume_before = 0, volume_after = 0;  ///< m3
  int laps = 0;                                ///< small folds of the surface onto itself that were closed
  double lap_volume = 0;                       ///< of the air closed in there, which the glass elsewhere gave, m3
  int enclosed = 0;                            ///< places at which glass has joined around more air than in a fold
  double enclosed_volume = 0;                  ///< of that air, m3
  int torn = 0;                                ///< pieces that had torn off, whose glass was given to the rest
  double torn_volume = 0;                      ///< m3
  double coarsening_factor = 1;                ///< than the criteria ask for, for the sake of max_cells
};

/// A new mesh of the same body: the surface resampled, the inside meshed anew, the enclosed volume restored to
/// round-off by a common small shift of the free surface along its normal; of the whole surface, by a few micrometres
/// at the most, where all but a little of it touches tools.
Remeshed remesh_glass(const core::Mesh& old, const Criteria& criteria, const Mesher& mesher = triangulate);

/// A mesh, or a sentence that tells why there is none.
struct MeshedInside {
  core::Mesh mesh;
  std::string reason;
};
/// Triangles anew inside the surface of `mesh`, which keeps its nodes and edges, with the edge lengths of
/// `remesh_glass(old, criteria)`.
MeshedInside mesh_inside(const core::Mesh& mesh, const core::Mesh& old, const Criteria& criteria,
                         const Mesher& mesher = triangulate);

}  // namespace parison::remesh
