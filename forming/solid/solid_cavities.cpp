// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/solid_cavities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "core/mesh/tolerances.hpp"
#include "core/solid/hex_geometry.hpp"
#include "forming/step/cavities/shared_air.hpp"

namespace parison::forming {

namespace {

using core::Vector3;

constexpr double closed = 1e-6;  ///< m: a nearer tool is met

double gap_of(const CavityTool& tool, bool at_end, const Vector3& at) {
  return tool.surface->gap(at - (at_end ? tool.to : tool.from) * Vector3::UnitZ()).distance;
}

/// Where a ray first meets a tool; nothing where it meets none within `reach`, m.
std::optional<Vector3> meets_tool(const std::vector<CavityTool>& tools, bool at_end, const Vector3& from,
                                  const Vector3& direction, double reach) {
  constexpr int most_steps = 200;  // each as long as the distance to the nearest tool
  Vector3 at = from;
  for (int step = 0; step < most_steps && (at - from).norm() < reach; ++step) {
    double gap = HUGE_VAL;
    for (const CavityTool& tool : tools) gap = std::min(gap, gap_of(tool, at_end, at));
    if (gap < closed) return at;
    if (!std::isfinite(gap)) return std::nullopt;
    at += gap * direction;
  }
  return std::nullopt;
}

/// Directions out of the glass at the nodes of some faces, unit vectors.
std::vector<Vector3> outward(const SolidState& solid, const std::vector<bool>& wanted) {
  std::vector<Vector3> normal(solid.glass.mesh.nodes.size(), Vector3::Zero());
  for (std::size_t f = 0; f < wanted.size(); ++f)
    for (int n = 0; wanted[f] && n < 9; ++n) {
      const core::QuadFace& face = solid.heat_faces[f];
      normal[face.nodes[static_cast<std::size_t>(n)]] +=
          core::face_place(solid.glass.mesh.nodes, face, 0.5 * (n % 3), 0.5 * (n / 3)).area().normalized();
    }
  for (const core::SymmetryPlane& plane : solid.planes)
    for (const Index node : plane.nodes) normal[node] -= normal[node].dot(plane.normal) * plane.normal;
  for (Vector3& n : normal) n.normalize();
  return normal;
}

/// Where the normals of the glass meet the tools, by node; false for nodes that face none.
struct Feet {
  std::vector<Vector3> at;
  std::vector<bool> found;
};
Feet feet_on_tools(const SolidState& solid, const std::vector<CavityTool>& tools, bool at_end,
                   const std::vector<bool>& wanted, const std::vector<Vector3>& normal, double reach) {
  Feet feet{solid.glass.mesh.nodes, std::vector<bool>(solid.glass.mesh.nodes.size(), true)};
  std::vector<bool> done(feet.at.size(), false);
  for (std::size_t f = 0; f < wanted.size(); ++f)
    for (const Index node : solid.heat_faces[f].nodes) {
      if (!wanted[f] || done[node]) continue;
      done[node] = true;
      const auto met = meets_tool(tools, at_end, solid.glass.mesh.nodes[node], normal[node], reach);
      feet.found[node] = met.has_value();
      if (met) feet.at[node] = *met;
    }
  return feet;
}

/// Volume of the air between faces and the feet of their nodes, m3.
double air_volume(const SolidState& solid, const std::vector<std::size_t>& faces, const Feet& feet) {
  core::HexMesh air;
  for (const std::size_t f : faces) {
    auto& cell = air.cells.emplace_back();
    for (int n = 0; n < 27; ++n) {
      const Index node = solid.heat_faces[f].nodes[static_cast<std::size_t>(n % 9)];
      const double way = 0.5 * (n / 9);
      cell[static_cast<std::size_t>(n)] = air.node_count();
      air.nodes.push_back((1 - way) * solid.glass.mesh.nodes[node] + way * feet.at[node]);
    }
  }
  return core::cell_volumes(air).sum();
}

double area_of(const SolidState& solid, const std::vector<std::size_t>& faces) {
  double area = 0;
  for (const std::size_t f : faces)
    for (const auto& at : core::map_hex_face(core::face_nodes(solid.glass.mesh, solid.faces[f]), solid.faces[f],
                                             flow::contact_points_along))
      area += at.area;
  return area;
}

/// Which share of a cavity is in the sector: one that meets both planes of symmetry goes all around, one that meets one
/// of them has its mirror image beyond it.
double share_in_sector(const SolidState& solid, const std::vector<std::size_t>& faces) {
  std::set<Index> nodes;
  for (const std::size_t f : faces) nodes.insert(solid.heat_faces[f].nodes.begin(), solid.heat_faces[f].nodes.end());
  const auto met = std::count_if(solid.planes.begin(), solid.planes.end(), [&](const core::SymmetryPlane& plane) {
    return std::any_of(plane.nodes.begin(), plane.nodes.end(), [&](Index node) { return nodes.count(node) > 0; });
  });
  return met == 0 ? 1 : met == 1 ? std::max(0.5, solid.share) : solid.share;
}

AirOrigin origin_of(const std::vector<std::size_t>& faces, const SolidState& solid) {
  AirOrigin origin{std::vector<double>(solid.air.volume.size(), 0.0), 0};
  for (const std::size_t f : faces) {
    const Index before = solid.face_air.empty() ? flow::open_air : solid.face_air[f];
    const double share = 1.0 / static_cast<double>(faces.size());
    if (before == flow::open_air) origin.open += share;
    if (before >= 0) origin.cavity[static_cast<std::size_t>(before)] += share;
  }
  return origin;
}

/// Faces of regions that may be sealed.
std::vector<bool> faces_of(const AirRegions& regions) {
  std::vector<bool> wanted;
  for (const Index region : regions.of_face)
    wanted.push_back(region >= 0 && !regions.open[static_cast<std::size_t>(region)]);
  return wanted;
}

/// Opens the regions with a node that faces no tool.
void open_where_none_is_met(const SolidState& solid, const Feet& feet, AirRegions& regions) {
  for (std::size_t f = 0; f < regions.of_face.size(); ++f)
    for (const Index node : solid.heat_faces[f].nodes)
      if (regions.of_face[f] >= 0 && !feet.found[node])
        regions.open[static_cast<std::size_t>(regions.of_face[f])] = true;
}

/// A cavity that holds its air.
struct Cavity {
  std::vector<std::size_t> faces;
  double volume, rate;  ///< m3, and by the motion of tools, m3/s
  AirOrigin origin;
};

/// The sealed cavities: `feet` at the start and the end of the step, which differ where tools move.
std::vector<Cavity> cavities_of(const SolidState& solid, const AirRegions& regions, const std::array<Feet, 2>& feet,
                                double dt, double size) {
  std::vector<Cavity> cavities;
  for (std::size_t r = 0; r < regions.faces.size(); ++r) {
    if (regions.open[r]) continue;
    Cavity cavity{regions.faces[r], air_volume(solid, regions.faces[r], feet[0]), 0,
                  origin_of(regions.faces[r], solid)};
    const double thin = core::tolerance::junction * size * area_of(solid, cavity.faces);
    if (cavity.volume < thin && !is_void(cavity.origin, solid.air)) continue;
    cavity.rate = (air_volume(solid, cavity.faces, feet[1]) - cavity.volume) / dt;
    cavity.volume = std::max(cavity.volume, 1e-6 * thin);
    cavities.push_back(std::move(cavity));
  }
  return cavities;
}

/// What is behind each face, and would enter where one that touches comes off: the air of a face beside it.
std::vector<Index> air_behind(const SolidState& solid, const std::vector<bool>& exposed,
                              const std::vector<std::vector<std::size_t>>& beside,
                              const std::vector<Cavity>& cavities) {
  std::vector<Index> behind(exposed.size(), flow::no_air);
  for (std::size_t f = 0; f < behind.size(); ++f)
    if (exposed[f] || is_inner(solid, f)) behind[f] = flow::open_air;
  for (std::size_t i = 0; i < cavities.size(); ++i)
    for (const std::size_t f : cavities[i].faces) behind[f] = static_cast<Index>(i);
  const std::vector<Index> of_exposed = behind;
  for (std::size_t f = 0; f < behind.size(); ++f)
    for (const std::size_t next : beside[f])
      if (behind[f] == flow::no_air && exposed[next]) behind[f] = of_exposed[next];
  return behind;
}

/// Pressure of contact below which glass comes off a tool, by what would enter, Pa. Glass that rests on the air of a
/// cavity is not lifted off by it.
std::vector<double> opening_pressures(const flow::SolidAir& air, double resting) {
  std::vector<double> opens;
  for (const Index behind : air.behind) {
    if (behind == flow::open_air) {
      opens.push_back(0);
    } else if (behind == flow::no_air) {
      opens.push_back(-air.ambient);
    } else {
      const flow::AirPocket& pocket = air.pockets[static_cast<std::size_t>(behind)];
      opens.push_back(pocket.energy / pocket.volume - air.ambient - resting);
    }
  }
  return opens;
}

}  // namespace

SealedCavities seal_air(const TrappedAirLaw& law, const std::vector<CavityTool>& tools, double dt,
                        const SolidState& solid, double size, double resting) {
  const auto exposed = exposed_faces(solid);
  const auto beside = face_neighbours(solid);
  AirRegions regions = exposed_regions(solid, exposed, beside, tools, law.seal_gap);
  const auto wanted = faces_of(regions);
  const auto normal = outward(solid, wanted);
  std::array<Feet, 2> feet{feet_on_tools(solid, tools, false, wanted, normal, 2 * size), {}};
  const bool moves = std::any_of(tools.begin(), tools.end(), [](const auto& tool) { return tool.from != tool.to; });
  feet[1] = moves ? feet_on_tools(solid, tools, true, wanted, normal, 2 * size) : feet[0];
  open_where_none_is_met(solid, feet[0], regions);
  const auto cavities = cavities_of(solid, regions, feet, dt, size);

  SealedCavities sealed;
  sealed.air.ambient = law.ambient;
  sealed.air.dt = dt;
  sealed.air.behind = air_behind(solid, exposed, beside, cavities);
  std::vector<AirOrigin> origins;
  std::vector<double> volumes;
  for (const Cavity& cavity : cavities) {
    origins.push_back(cavity.origin);
    volumes.push_back(cavity.volume);
    sealed.air.tool_rate.push_back(cavity.rate);
    sealed.share.push_back(share_in_sector(solid, cavity.faces));
  }
  const AirShares shares = share_air(origins, volumes, solid.air, law);
  const double vent = law.vent_area * std::sqrt(gas_constant_of_air * law.temperature);
  for (std::size_t i = 0; i < volumes.size(); ++i)
    sealed.air.pockets.push_back(
        {volumes[i], shares.energy[i], law.exponent, shares.energy[i] > 0 ? sealed.share[i] * vent : 0, {}});
  sealed.air.opens_below = opening_pressures(sealed.air, resting);
  sealed.amount = shares.amount;
  return sealed;
}

void store_air(const SealedCavities& sealed, const flow::SolidStep& step, SolidState& solid) {
  solid.air = {};
  for (std::size_t i = 0; i < step.air.size(); ++i)
    add_cavity(sealed.air.pockets[i], sealed.amount[i], step.air[i].volume, step.air[i].outflow, solid.air);
  solid.air_share = sealed.share;
  solid.face_air = sealed.air.behind;
  const auto exposed = exposed_faces(solid);
  for (std::size_t f = 0; f < exposed.size(); ++f)
    if (!exposed[f]) solid.face_air[f] = flow::no_air;
}

CavityAir whole_cavities(const SolidState& solid) {
  CavityAir whole = solid.air;
  for (std::size_t i = 0; i < whole.volume.size(); ++i) {
    whole.volume[i] /= solid.air_share[i];
    whole.energy[i] /= solid.air_share[i];
    whole.amount[i] /= solid.air_share[i];
  }
  return whole;
}

}  // namespace parison::forming
