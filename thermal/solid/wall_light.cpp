// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/solid/wall_light.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <unordered_map>

#include "core/mesh/element.hpp"
#include "thermal/solid/solid_system.hpp"

namespace parison::thermal {

namespace {

using Eigen::ArrayXd;
using Eigen::VectorXd;

/// The laws of all directions together, as rays have them.
LightLaws laws_of(Radiation radiation) {
  radiation.model = Radiation::Model::transfer;
  return LightLaws(radiation);
}

/// Temperatures at the points of the cells of a body, K.
VectorXd at_points(const SolidLaws& body, const VectorXd& temperature) {
  const core::CellTable& table = *body.cells.table;
  Eigen::MatrixXd local(table.nodes(), body.cells.count);
  for (Index c = 0; c < body.cells.count; ++c)
    for (Index n = 0; n < table.nodes(); ++n) local(n, c) = temperature[body.first_unknown + body.cells.cell(c)[n]];
  const Eigen::MatrixXd at = table.shape * local;
  return Eigen::Map<const VectorXd>(at.data(), at.size());
}

/// Of the points of the cells of a body, m.
using Positions = Eigen::Matrix3Xd;
Positions positions_of(const SolidSystem& system, Index body) {
  const SolidBodyView& view = system.problem->bodies[body];
  const core::CellTable& table = *view.cells.table;
  Positions positions(3, view.cells.point_count()), local(3, table.nodes());
  for (Index c = 0; c < view.cells.count; ++c) {
    for (Index n = 0; n < table.nodes(); ++n) local.col(n) = (*view.nodes)[view.cells.cell(c)[n]];
    positions.middleCols(c * table.points(), table.points()).noalias() = local * table.shape.transpose();
  }
  return positions;
}

template <std::size_t size>
double interpolated(const VectorXd& temperature, const Index* unknowns, const std::array<double, size>& shape) {
  double T = 0;
  for (std::size_t i = 0; i < size; ++i) T += shape[i] * temperature[unknowns[i]];
  return T;
}

// --- Preparation ---

void add_sides(WallLight& light, const SolidSystem& system) {
  const SolidBodyView& view = system.problem->bodies[light.body];
  const auto& rule = core::edge_rule(3);
  for (const core::QuadFace& face : *view.faces)
    for (int q = 0; q < 9; ++q) {
      const auto id = static_cast<std::size_t>(face.boundary_id);
      const bool sees = id < view.light.surroundings.size() && view.light.surroundings[id];
      const auto &a = rule[q % 3], &b = rule[q / 3];
      LightSide& side = light.sides.emplace_back();
      for (int i = 0; i < 9; ++i) side.unknowns[i] = system.first_unknown[light.body] + face.nodes[i];
      side.point = q;
      side.boundary = system.first_boundary[light.body] + face.boundary_id;
      side.surrounded_by = sees ? face.boundary_id : -1;
      side.own_view = !sees ? 1 : id < view.own_view.size() ? view.own_view[id] : 0;
      side.area = a.weight * b.weight * core::face_place(*view.nodes, face, a.s, b.s).area().norm();
    }
}

/// Which of three parts of an edge, as long as the weights of its Gauss points, a place is in.
int third_of(double s) {
  const double outer = core::edge_rule(3)[0].weight;
  return s < outer ? 0 : s < 1 - outer ? 1 : 2;
}

double covered_area(const WallLight& light, const LightSide& side) {
  double covered = 0;
  for (const Index t : side.contacts) covered += light.contacts[t].area;
  return covered;
}

/// The points of the interface lie unevenly: what covers a side more than once goes to the sides of the same face that
/// are covered in part, to each by as much as it has.
void even_out(WallLight& light, std::size_t first) {
  std::array<double, 9> covered;
  std::array<char, 9> is_full{};
  double all = 0, scale = 1;
  for (int s = 0; s < 9; ++s) all += covered[s] = covered_area(light, light.sides[first + s]);
  for (bool changed = all > 0; changed;) {
    changed = false;
    double left = all, partly = 0;
    for (int s = 0; s < 9; ++s) (is_full[s] ? left : partly) += is_full[s] ? -light.sides[first + s].area : covered[s];
    if (partly > 0) scale = left / partly;
    for (int s = 0; s < 9; ++s)
      if (!is_full[s] && scale * covered[s] > light.sides[first + s].area) {
        is_full[s] = 1;
        changed = true;
      }
  }
  for (int s = 0; s < 9; ++s) {
    LightSide& side = light.sides[first + s];
    const double share = std::min(1.0, scale * covered[s] / side.area);
    side.free = is_full[s] ? 0 : 1 - share;
    for (const Index t : side.contacts) light.contacts[t].area *= (is_full[s] ? 1 : share) * side.area / covered[s];
  }
}

/// Tools cover the sides at which the points of the interface lie.
void add_touches(WallLight& light, const SolidSystem& system) {
  const core::SolidInterface& interface = system.problem->interface;
  for (std::size_t p = 0; p < system.contacts.size(); ++p) {
    const SolidHeatPair& contact = system.contacts[p];
    const core::FacePair& faces = interface.pairs[contact.pair];
    if (faces.slave_body != light.body) continue;
    const double emissivity = system.problem->bodies[faces.master_body].light.emissivity;
    for (Index i = contact.first_point; i < contact.last_point; ++i) {
      const auto& point = interface.points[static_cast<std::size_t>(i)];
      if (!(point.contact_weight > 0)) continue;
      const int q = third_of(point.slave_place[0]) + 3 * third_of(point.slave_place[1]);
      light.sides[9 * faces.slave_face + q].contacts.push_back(static_cast<Index>(light.contacts.size()));
      light.contacts.push_back({static_cast<Index>(p), i, point.contact_weight * point.area, emissivity,
                                grey_exchange(light.emissivity, emissivity)});
    }
  }
  for (std::size_t first = 0; first < light.sides.size(); first += 9) even_out(light, first);
}

/// A wall with the volumes of the points of a line: by their roots, which keeps it symmetric. The diagonal gets what
/// its row then misses in equilibrium.
void fit(SlabExchange& slab, const VectorXd& emitting, const VectorXd& of_slab, const Eigen::Vector2d& area,
         double square) {
  const VectorXd scale = emitting.cwiseQuotient(of_slab).cwiseSqrt();
  slab.between = scale.asDiagonal() * slab.between * scale.asDiagonal();
  slab.through = scale.asDiagonal() * slab.through;
  for (Eigen::Index i = 0; i < emitting.size(); ++i)
    slab.between(i, i) += emitting[i] - slab.between.row(i).sum() - slab.through.row(i).sum();
  for (int b = 0; b < 2; ++b) slab.sides(b, b) = area[b] / (4 * square) - slab.through.col(b).sum() - slab.sides(0, 1);
}

/// Where three points are between both ends of their layer, 0 to 1; the way through it is a parabola.
std::array<double, 3> places_of(const std::array<core::Vector3, 3>& at) {
  const auto& rule = core::edge_rule(3);
  const auto end = [&](double s) {
    core::Vector3 x = core::Vector3::Zero();
    for (int i = 0; i < 3; ++i) {
      double value = 1;
      for (int j = 0; j < 3; ++j)
        if (j != i) value *= (s - rule[j].s) / (rule[i].s - rule[j].s);
      x += value * at[i];
    }
    return x;
  };
  const core::Vector3 start = end(0), way = end(1) - start;
  std::array<double, 3> places;
  for (int i = 0; i < 3; ++i) places[i] = (at[i] - start).dot(way) / way.squaredNorm();
  return places;
}

/// A layer whose points lie where they do; as in an even one where the way through it is so bent that the parabola
/// through them would give a point no share of the layer.
SlabLayer layer_of(double thickness, const std::array<core::Vector3, SlabLayer::places>& at) {
  constexpr double least_share = 0.05;
  SlabLayer layer(thickness, places_of(at));
  if (*std::min_element(layer.weight.begin(), layer.weight.end()) >= least_share) return layer;
  const auto& rule = core::edge_rule(SlabLayer::places);
  return {thickness, {rule[0].s, rule[1].s, rule[2].s}};
}

/// The layers along a line, as thick as their volume over their mean area.
std::vector<SlabLayer> layers_of(const LightLine& line, const Positions& positions,
                                 const std::vector<double>& layer_volume, const std::vector<double>& radii) {
  constexpr int places = SlabLayer::places;
  std::vector<SlabLayer> layers;
  for (std::size_t c = 0; c < layer_volume.size(); ++c) {
    std::array<core::Vector3, places> at;
    for (int i = 0; i < places; ++i) at[i] = positions.col(line.points[places * c + i]);
    layers.push_back(layer_of(layer_volume[c] / mean_area(radii[c], radii[c + 1]), at));
  }
  return layers;
}

std::vector<double> layer_volumes(const LightLine& line, const VectorXd& volume) {
  std::vector<double> of_layer(line.points.size() / SlabLayer::places);
  for (std::size_t i = 0; i < line.points.size(); ++i) of_layer[i / SlabLayer::places] += volume[line.points[i]];
  return of_layer;
}

/// Absorption of each layer of a line in a band, 1/m: that at the mean of its temperatures.
std::vector<double> absorption_of(const LightLine& line, const Band& band, const VectorXd& temperature) {
  constexpr int places = SlabLayer::places;
  std::vector<double> absorption;
  for (std::size_t first = 0; first < line.points.size(); first += places) {
    double mean = 0;
    for (int i = 0; i < places; ++i) mean += temperature[line.points[first + i]] / places;
    absorption.push_back(band.absorption * (band.relative.x.empty() ? 1 : band.relative(mean)));
  }
  return absorption;
}

void add_bands(LightLine& line, const SlabLight& slabs, const std::vector<Band>& bands, const VectorXd& volume,
               const Positions& positions, const VectorXd& temperature, WallLight& light) {
  constexpr int places = SlabLayer::places;
  const Eigen::Vector2d area(light.sides[line.sides[0]].area, light.sides[line.sides[1]].area);
  const std::vector<double> of_layer = layer_volumes(line, volume), radii = shell_radii(of_layer, area);
  const std::vector<SlabLayer> layers = layers_of(line, positions, of_layer, radii);
  VectorXd emitting(line.points.size()), of_slab(line.points.size());
  for (std::size_t k = 0; k < bands.size(); ++k) {
    const std::vector<double> absorption = absorption_of(line, bands[k], temperature);
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const double a = absorption[i / places];
      const auto at = static_cast<Index>(i);
      emitting[at] = light.emitting[k][line.points[i]] = a * volume[line.points[i]];
      of_slab[at] = a * of_layer[i / places] * layers[i / places].weight[i % places];
    }
    line.bands.push_back(slabs.exchange(layers, absorption, area));
    fit(line.bands.back(), emitting, of_slab, area, light.square);
  }
}

/// A line for each point of a face of a stack. A face's a and b are those of its cell on the outer side, and the other
/// way round on the inner.
void add_lines(WallLight& light, const SolidSystem& system) {
  const SolidBodyView& view = system.problem->bodies[light.body];
  constexpr int low = 4, high = 22;  // nodes in the middle of a cell's sides
  std::unordered_map<Index, Index> face_at;
  for (std::size_t f = 0; f < view.faces->size(); ++f) face_at[(*view.faces)[f].nodes[4]] = static_cast<Index>(f);
  for (const auto& stack : *view.stacks) {
    const Index inner = face_at.at(view.cells.cell(stack.front())[low]);
    const Index outer = face_at.at(view.cells.cell(stack.back())[high]);
    for (int q = 0; q < 9; ++q) {
      LightLine& line = light.lines.emplace_back();
      line.sides = {9 * inner + q / 3 + 3 * (q % 3), 9 * outer + q};
      for (const Index cell : stack)
        for (int c = 0; c < SlabLayer::places; ++c)
          line.points.push_back(cell * view.cells.table->points() + q + 9 * c);
    }
  }
}

// --- Heat ---

/// What the outside of all sides has in one band, or beyond the last.
struct Outside {
  std::vector<double> surroundings;  ///< emissive power by boundary of the body, W/m2
  ArrayXd tool;                      ///< by touch
};

template <typename EmissivePower>
Outside outside_of(const WallLight& light, double time, const ArrayXd& tool_temperature, const EmissivePower& power) {
  Outside outside{{}, ArrayXd(tool_temperature.size())};
  for (const core::TimeFunction* at : light.surroundings) outside.surroundings.push_back(at ? power((*at)(time)) : 0);
  for (Eigen::Index t = 0; t < tool_temperature.size(); ++t) outside.tool[t] = power(tool_temperature[t]);
  return outside;
}

/// What of a side sees the surroundings, m2.
double open_area(const LightSide& side) {
  return side.free * (1 - side.own_view) * side.area;
}

/// The light that comes to a side from outside, J = given + returned H, of what arrives there, H.
struct Radiosity {
  double given = 0, returned = 0;
};
Radiosity radiosity(const WallLight& light, const LightSide& side, const Outside& outside) {
  Radiosity J;
  for (const Index t : side.contacts) {
    const LightTouch& touch = light.contacts[t];
    const double share = touch.area / side.area;
    J.given += share * touch.emissivity * outside.tool[t];
    J.returned += share * (1 - touch.emissivity);
  }
  J.returned += side.free * side.own_view;
  if (side.surrounded_by >= 0) J.given += open_area(side) / side.area * outside.surroundings[side.surrounded_by];
  return J;
}

/// Heat of light so far.
struct Gains {
  VectorXd points;    ///< into the points of the body, W
  ArrayXd touches;    ///< into tools, W
  double to_air = 0;  ///< W
};

void book_air(const WallLight& light, const LightSide& side, double heat, Gains& gains, Response& response) {
  gains.to_air += heat;
  response.flows.exchanged[side.boundary] += heat;
  response.flows.to_air[light.body] += heat;
  response.flows.light_to_air[light.body] += heat;
}

/// Adds the light of a band along a line; `emitted` is 4 n^2 E at the points of the body.
void add_line(const WallLight& light, const LightLine& line, std::size_t band, const VectorXd& emitted,
              const Outside& outside, Gains& gains, Response& response) {
  const SlabExchange& slab = line.bands[band];
  const auto size = static_cast<Index>(line.points.size());
  VectorXd e(size);
  for (Index i = 0; i < size; ++i) e[i] = emitted[line.points[i]];
  Eigen::Matrix2d matrix;
  Eigen::Vector2d arriving = slab.through.transpose() * e, given;
  std::array<Radiosity, 2> J;
  const double scale = 4 * light.square;
  for (int b = 0; b < 2; ++b) {
    const LightSide& side = light.sides[line.sides[b]];
    J[b] = radiosity(light, side, outside);
    given[b] = scale * J[b].given;
    matrix.col(b) = -scale * J[b].returned * slab.sides.col(b);
    matrix(b, b) += side.area;
  }
  arriving += slab.sides * given;
  const Eigen::Vector2d H = matrix.inverse() * arriving;
  for (int b = 0; b < 2; ++b) given[b] += scale * J[b].returned * H[b];
  e = slab.between * e + slab.through * given;
  for (Index i = 0; i < size; ++i)
    gains.points[line.points[i]] += e[i] - light.emitting[band][line.points[i]] * emitted[line.points[i]];
  for (int b = 0; b < 2; ++b) {
    const LightSide& side = light.sides[line.sides[b]];
    if (side.surrounded_by >= 0)
      book_air(light, side, open_area(side) * (H[b] - outside.surroundings[side.surrounded_by]), gains, response);
    for (const Index t : side.contacts)
      gains.touches[t] += light.contacts[t].emissivity * light.contacts[t].area * (H[b] - outside.tool[t]);
  }
}

/// Adds what the opaque bands give off at the surface.
void add_opaque(const WallLight& light, const Outside& outside, const VectorXd& temperature, Gains& gains,
                Response& response) {
  for (const LightSide& side : light.sides) {
    const auto& shape = face_shapes()[side.point];
    const double own = light.laws.opaque_emission(interpolated(temperature, side.unknowns.data(), shape)).value;
    double lost = 0;
    if (side.surrounded_by >= 0) {
      lost = light.emissivity * open_area(side) * (own - outside.surroundings[side.surrounded_by]);
      book_air(light, side, lost, gains, response);
    }
    for (const Index t : side.contacts) {
      const double across = light.contacts[t].opaque * light.contacts[t].area * (own - outside.tool[t]);
      gains.touches[t] += across;
      lost += across;
    }
    for (int i = 0; i < 9; ++i) response.power[side.unknowns[i]] -= shape[i] * lost;
  }
}

void scatter(const WallLight& light, const SolidSystem& system, const Gains& gains, Response& response) {
  const SolidLaws& body = system.bodies[light.body];
  const core::CellTable& table = *body.cells.table;
  const Eigen::Map<const Eigen::MatrixXd> points(gains.points.data(), table.points(), body.cells.count);
  const Eigen::MatrixXd into = table.shape.transpose() * points;
  for (Index c = 0; c < body.cells.count; ++c)
    for (Index n = 0; n < table.nodes(); ++n) response.power[body.first_unknown + body.cells.cell(c)[n]] += into(n, c);
  for (std::size_t t = 0; t < light.contacts.size(); ++t) {
    const LightTouch& touch = light.contacts[t];
    const SolidHeatPair& contact = system.contacts[touch.pair];
    const double heat = gains.touches[static_cast<Index>(t)];
    response.flows.across[contact.body_pair] += heat;
    response.flows.radiated[contact.body_pair] += heat;
    const auto& shape = system.problem->interface.points[static_cast<std::size_t>(touch.point)].master_shape;
    for (int i = 0; i < 9; ++i) {
      response.flows.received[contact.body_pair] += shape[i] * heat;
      response.power[contact.unknowns[9 + i]] += shape[i] * heat;
    }
  }
}

}  // namespace

WallLight make_wall_light(const SolidSystem& system, Index body, const VectorXd& temperature) {
  const SolidBodyView& view = system.problem->bodies[body];
  const Radiation& radiation = *view.material->radiation;
  const double n = radiation.refractive_index;
  WallLight light{body, laws_of(radiation), n * n, view.light.emissivity, {}, {}, {}, {}, {}};
  for (Index id = 0; id < system.first_boundary[body + 1] - system.first_boundary[body]; ++id) {
    const auto at = static_cast<std::size_t>(id);
    const bool sees = at < view.light.surroundings.size() && view.light.surroundings[at];
    light.surroundings.push_back(sees ? &*view.light.surroundings[at] : nullptr);
  }
  add_sides(light, system);
  add_touches(light, system);
  add_lines(light, system);
  const VectorXd at = at_points(system.bodies[body], temperature);
  light.emitting.assign(radiation.bands.size(), VectorXd::Zero(at.size()));
  const Positions positions = positions_of(system, body);
  const SlabLight slabs(n);
  for (LightLine& line : light.lines)
    add_bands(line, slabs, radiation.bands, system.bodies[body].metric.volume, positions, at, light);
  return light;
}

void add_wall_light(const WallLight& light, const SolidSystem& system, double time, const VectorXd& temperature,
                    Response& response) {
  const VectorXd at = at_points(system.bodies[light.body], temperature);
  ArrayXd tool(light.contacts.size());
  for (std::size_t t = 0; t < light.contacts.size(); ++t) {
    const LightTouch& touch = light.contacts[t];
    tool[static_cast<Index>(t)] =
        interpolated(temperature, system.contacts[touch.pair].unknowns.data() + 9,
                     system.problem->interface.points[static_cast<std::size_t>(touch.point)].master_shape);
  }
  Gains gains{VectorXd::Zero(at.size()), ArrayXd::Zero(tool.size())};
  VectorXd emitted(at.size());
  for (int g = 0; g < light.laws.group_count(); ++g) {
    for (Index q = 0; q < at.size(); ++q) emitted[q] = light.laws.irradiation(g, at[q]).value;
    const Outside outside =
        outside_of(light, time, tool, [&](double T) { return light.laws.emissive_power(g, T).value; });
    for (const LightLine& line : light.lines)
      add_line(light, line, static_cast<std::size_t>(light.laws.group(g).band), emitted, outside, gains, response);
  }
  if (light.laws.has_opaque())
    add_opaque(light, outside_of(light, time, tool, [&](double T) { return light.laws.opaque_emission(T).value; }),
               temperature, gains, response);
  scatter(light, system, gains, response);
}

VectorXd light_slopes(const WallLight& light, const SolidSystem& system, const VectorXd& temperature) {
  const VectorXd at = at_points(system.bodies[light.body], temperature);
  VectorXd slopes = VectorXd::Zero(at.size());
  for (int g = 0; g < light.laws.group_count(); ++g)
    for (Index q = 0; q < at.size(); ++q)
      slopes[q] += 0.5 * light.emitting[light.laws.group(g).band][q] * light.laws.irradiation(g, at[q]).derivative;
  return slopes;
}

}  // namespace parison::thermal
