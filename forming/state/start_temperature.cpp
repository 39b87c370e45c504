// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/start_temperature.hpp"

#include <cmath>
#include <limits>

#include "remesh/transfer/transfer.hpp"
#include "thermal/problem.hpp"

namespace parison::forming {

namespace {

/// Temperature of glass with a skin at a point, K.
double skin_temperature(const Glass& glass, const core::Point& x) {
  double distance = std::numeric_limits<double>::infinity();
  for (const core::Segment& segment : glass.profile.segments)
    if (glass.boundaries[segment.boundary_id].kind != BoundaryKind::symmetry)
      distance = core::distance(segment, x, distance);
  const double core_temperature = glass.initial_temperature;
  return core_temperature + (glass.skin->temperature - core_temperature) * std::exp(-distance / glass.skin->depth);
}

/// A projection of the field of a result whose heat in each kilogram is that of the result.
Eigen::VectorXd handed_over(const Scene& scene, const Body& body, const core::Mesh& mesh) {
  const StartField& field = *body.start_field;
  const auto mean_heat = [&](const core::Mesh& of, const Eigen::VectorXd& temperature) {
    const thermal::BodyView view{&of, &of, body.thermal->density, &*body.thermal, {}, {}};
    return thermal::heat_content(view, scene.geometry, temperature) / core::volume(of, scene.geometry);
  };
  const auto carried =
      remesh::project(field.mesh, mesh, scene.geometry, remesh::make_transfer(field.mesh, mesh), field.temperature);
  return remesh::restore_content(
      carried, [&](const Eigen::VectorXd& temperature) { return mean_heat(mesh, temperature); },
      mean_heat(field.mesh, field.temperature));
}

}  // namespace

PlacedTemperature start_function(const Scene& scene, Index body) {
  const Body& data = body_of(scene, body);
  if (data.start_field) return data.start_field->at;
  if (body == 0 && scene.glass.skin)
    return [&glass = scene.glass](const core::Point& x) { return skin_temperature(glass, x); };
  return {};
}

Eigen::VectorXd start_temperature(const Scene& scene, Index body, const core::Mesh& mesh) {
  const Body& data = body_of(scene, body);
  if (const PlacedTemperature function = start_function(scene, body)) {
    const auto fitted = [&](const std::function<double(double)>& heat) {
      return fitted_field(mesh, scene.geometry, function, heat);
    };
    if (!data.thermal) return fitted([](double T) { return T; });
    return fitted([enthalpy = thermal::Enthalpy(data.thermal->heat_capacity)](double T) { return enthalpy(T).h; });
  }
  if (data.start_field) return handed_over(scene, data, mesh);
  return Eigen::VectorXd::Constant(mesh.node_count(), data.initial_temperature);
}

}  // namespace parison::forming
