// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/wall/meridian.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/solid/hex_geometry.hpp"

namespace parison::forming {

namespace {

using Edge = std::pair<Index, Index>;  // of two nodes, the lower first

/// Triangles between the nodes of the outer side.
std::vector<std::array<Index, 3>> outer_triangles(const SolidState& solid) {
  std::vector<std::array<Index, 3>> triangles;
  for (const core::HexFace& face : faces_of(solid, SolidSide::outer)) {
    const auto nodes = core::face_node_numbers(solid.glass.mesh, face);
    for (std::size_t b = 0; b < 2; ++b)
      for (std::size_t a = 0; a < 2; ++a) {
        const std::size_t first = a + 3 * b;
        triangles.push_back({nodes[first], nodes[first + 1], nodes[first + 4]});
        triangles.push_back({nodes[first], nodes[first + 4], nodes[first + 3]});
      }
  }
  return triangles;
}

/// Chains edges that the plane cuts, each shared by two triangles, from the end that is nearest to the axis.
std::vector<Edge> chain(const std::map<Edge, std::vector<Edge>>& next, const std::map<Edge, MeridianPoint>& places) {
  const Edge* start = nullptr;
  for (const auto& [edge, neighbours] : next)
    if (neighbours.size() == 1 && (!start || places.at(edge).r < places.at(*start).r)) start = &edge;
  std::vector<Edge> chained;
  if (!start) return chained;
  chained.push_back(*start);
  for (Edge before = *start, here = next.at(*start).front();;) {
    chained.push_back(here);
    const auto& neighbours = next.at(here);
    const Edge* onward = nullptr;
    for (const Edge& edge : neighbours)
      if (edge != before) onward = &edge;
    if (!onward) return chained;
    before = std::exchange(here, *onward);
  }
}

}  // namespace

std::vector<MeridianPoint> outer_meridian(const SolidState& solid, const SolidWall& wall, double angle) {
  const auto& nodes = solid.glass.mesh.nodes;
  std::map<Index, double> thickness;
  for (const SolidWallPoint& point : wall.points) thickness[point.outer] = point.thickness;
  // Off a node in the plane itself, and inside the sector at its ends.
  constexpr double aside = 1e-6;
  const double end = 2 * M_PI * solid.share;
  const double turned = std::min(std::max(angle, aside), end - aside) + 0.1 * aside;
  const core::Vector3 along(std::cos(turned), std::sin(turned), 0), across(-along[1], along[0], 0);
  std::map<Edge, MeridianPoint> places;
  std::map<Edge, std::vector<Edge>> next;
  for (const auto& triangle : outer_triangles(solid)) {
    std::vector<Edge> cut;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index first = std::min(triangle[i], triangle[(i + 1) % 3]),
                  last = std::max(triangle[i], triangle[(i + 1) % 3]);
      const double from = across.dot(nodes[first]), to = across.dot(nodes[last]);
      if ((from < 0) == (to < 0)) continue;
      const double t = from / (from - to);
      const core::Vector3 at = (1 - t) * nodes[first] + t * nodes[last];
      if (along.dot(at) < -aside) continue;
      places[{first, last}] = {0, along.dot(at), at[2], (1 - t) * thickness.at(first) + t * thickness.at(last)};
      cut.emplace_back(first, last);
    }
    if (cut.size() != 2) continue;
    next[cut[0]].push_back(cut[1]);
    next[cut[1]].push_back(cut[0]);
  }
  std::vector<MeridianPoint> meridian;
  for (const Edge& edge : chain(next, places)) {
    MeridianPoint point = places.at(edge);
    if (!meridian.empty())
      point.arc = meridian.back().arc + std::hypot(point.r - meridian.back().r, point.z - meridian.back().z);
    meridian.push_back(point);
  }
  return meridian;
}

std::vector<EvenMeridian> even_meridians(const SolidState& solid, const SolidWall& wall, std::size_t places) {
  constexpr int count = 3;
  std::vector<EvenMeridian> result;
  for (int m = 0; m < count; ++m) {
    result.push_back({2 * M_PI * solid.share * m / (count - 1), {}});
    const auto meridian = outer_meridian(solid, wall, result.back().angle);
    std::size_t after = 1;
    for (std::size_t i = 0; meridian.size() > 1 && i < places; ++i) {
      const double arc = meridian.back().arc * double(i) / double(places - 1);
      while (after + 1 < meridian.size() && meridian[after].arc < arc) ++after;
      const MeridianPoint &a = meridian[after - 1], &b = meridian[after];
      const double t = b.arc > a.arc ? (arc - a.arc) / (b.arc - a.arc) : 0;
      result.back().points.push_back(
          {arc, (1 - t) * a.r + t * b.r, (1 - t) * a.z + t * b.z, (1 - t) * a.thickness + t * b.thickness});
    }
  }
  return result;
}

std::string meridians_csv(const SolidState& solid, const SolidWall& wall) {
  constexpr std::size_t places = 101;
  std::string text = "angle_deg,arc_mm,r_mm,z_mm,thickness_mm\n";
  double before = 0;  // m
  for (const EvenMeridian& meridian : even_meridians(solid, wall, places)) {
    for (const MeridianPoint& point : meridian.points)
      text += fmt::format("{:.3f},{:.4f},{:.4f},{:.4f},{:.4f}\n", meridian.angle * 180 / M_PI,
                          1e3 * (before + point.arc), 1e3 * point.r, 1e3 * point.z, 1e3 * point.thickness);
    constexpr double apart = 1e-3;  // m
    if (!meridian.points.empty()) before += meridian.points.back().arc + apart;
  }
  return text;
}

}  // namespace parison::forming
