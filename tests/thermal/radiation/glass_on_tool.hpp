#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <random>

#include "thermal/bodies.hpp"
#include "thermal/system.hpp"

namespace parison::thermal::test {

using core::Geometry;
using Model = Radiation::Model;

inline constexpr double everything = std::numeric_limits<double>::infinity();

inline Material glass_with(std::vector<Band> bands, double index = 1.518, double conductivity = 1.3,
                           Model model = Model::p1) {
  return {2400, core::constant(1300), core::constant(conductivity),
          Radiation{index, 0, false, model, std::move(bands)}};
}

/// Body whose every boundary sees black surroundings.
inline BodyView open_body(const core::Mesh& mesh, const Material& material, double surroundings,
                          double emissivity = 0.9) {
  BodyView view = body(mesh, material);
  view.light.surroundings.assign(mesh.boundaries().size(), core::TimeFunction(surroundings));
  view.light.emissivity = emissivity;
  return view;
}

/// Glass on a grey tool, both with air; part of the contact is closed.
struct GlassOnTool {
  Material glass, iron{7200, core::constant(500), core::constant(40), {}};
  core::Mesh upper = rectangle(divide(0, 0.02, 5), divide(0, 0.006, 6, 1.2)), lower;
  Problem problem;
  std::vector<Eigen::VectorXd> start;

  GlassOnTool(Geometry geometry, std::vector<Band> bands, double surroundings = 320, double opaque = 0.9,
              Model model = Model::p1_cones)
      : glass(glass_with(std::move(bands), 1.518, 1.3, model)) {
    std::vector<double> below = divide(0, -0.01, 5, 1.3);
    std::reverse(below.begin(), below.end());
    lower = rectangle(divide(0, 0.02, 5), below);
    problem = {geometry, {open_body(upper, glass, surroundings, opaque), body(lower, iron)}, {}, {}};
    problem.bodies[0].light.surroundings[left].reset();
    problem.bodies[0].exchange = {SurfaceExchange{40, 320, 0, 320}, {}, SurfaceExchange{40, 320, 0, 320}, {}};
    problem.bodies[1].exchange[top] = SurfaceExchange{40, 320, 0.8, 320};
    problem.bodies[1].light.emissivity = 0.8;
    problem.interface = stack(upper, lower, geometry);
    for (auto& point : problem.interface) point.contact_weight = 0.7;
    problem.law = constant_conductance(2000);
    start = {Eigen::VectorXd::Constant(upper.node_count(), 1400), Eigen::VectorXd::Constant(lower.node_count(), 740)};
  }
  GlassOnTool(const GlassOnTool&) = delete;
};

/// Temperatures that scatter around those.
inline Eigen::VectorXd scattered(const HeatSystem& system, const std::vector<Eigen::VectorXd>& start) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  Eigen::VectorXd T = join(system, start);
  for (Index i = 0; i < system.size(); ++i) T[i] += 150 * unit(random);
  return T;
}

inline const std::vector<Band> flint{{2.75e-6, 30}, {4.3e-6, 450}};

}  // namespace parison::thermal::test
