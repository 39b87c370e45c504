// SPDX-License-Identifier: GPL-3.0-or-later
// The glass slab in eight bands of E. W. Larsen, G. Thoemmes, A. Klar, M. Seaid, T. Goetz, J. Comput. Phys. 183 (2002)
// 652-675, against the temperatures by SP3 that MOOSE keeps for it (idaholab/moose, heat_transfer,
// sp3_radiation/adaptive1D_e1_coupled: absorption 0.5 1/m in the seventh band and 0.4 1/m in the last).
#include <gtest/gtest.h>

#include "figure.hpp"
#include "thermal/radiation/glass_on_tool.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::thermal::test {
namespace {

constexpr double light_speed = 299792458, width = 1, duration = 1e-4;  // m/s, m, s
constexpr int volumes = 51, parts = 3;                                 // of SP3's mesh; divisions of each

/// Mean temperatures of the finite volumes by SP3 from the surface inwards, K.
const std::vector<double> by_sp3{981.12998867145, 985.06658253111, 988.68273583811, 990.98960467338, 992.55286498844,
                                 993.64894451921, 994.43658798594, 995.01528279322, 995.44911766372, 995.78016926358,
                                 996.03664444989, 996.2378786205,  996.39742357432, 996.52497754368, 996.62761205197,
                                 996.71056818039, 996.77778372259, 996.83224963998, 996.87625521354, 996.91155969963,
                                 996.93951575399, 996.96115560442, 996.97725478185, 996.98837583051, 996.99490127218,
                                 996.99705206006};

std::vector<Band> bands() {
  const std::vector<std::pair<double, double>> from_frequency{{102.67e13, 0.4},  {6.84e13, 0.5},   {5.87e13, 7.7},
                                                              {5.13e13, 15.45},  {4.56e13, 27.98}, {3.73e13, 276.98},
                                                              {3.42e13, 576.32}, {2.93e13, 7136}};
  std::vector<Band> result;
  for (const auto& [frequency, absorption] : from_frequency) result.push_back({light_speed / frequency, absorption});
  return result;
}

/// Mean temperatures of the volumes after the given time.
std::vector<double> temperatures(Model model) {
  constexpr double height = 0.05;
  const core::Mesh mesh = rectangle(divide(0, width, volumes * parts), {0, height});
  Material material = glass_with(bands(), 1.46, 1, model);
  material.density = 1;
  material.heat_capacity = core::constant(1);
  Problem problem{Geometry::planar, {open_body(mesh, material, 300, 0.914)}, {}, {}};
  problem.bodies[0].light.surroundings[bottom].reset();
  problem.bodies[0].light.surroundings[top].reset();
  StepMatrix matrix;
  StepOptions options;
  options.tolerance = 0.01;
  const StepOutcome outcome =
      advance(problem, 0, {Eigen::VectorXd::Constant(mesh.node_count(), 1000)}, duration, options, matrix);
  EXPECT_TRUE(outcome.converged) << outcome.reason;
  std::vector<double> mean(volumes, 0), volume(volumes, 0);
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (const auto& at : core::triangle_rule(4)) {
      const core::CellPoint point = core::map_cell_point(mesh, c, Geometry::planar, at);
      const auto v = static_cast<std::size_t>(point.position[0] / width * volumes);
      for (int i = 0; i < 6; ++i) mean[v] += point.volume * point.shape[i] * outcome.temperature[0][mesh.cells()[c][i]];
      volume[v] += point.volume;
    }
  for (int v = 0; v < volumes; ++v) mean[v] /= volume[v];
  return mean;
}

/// The two volumes next to a surface, 20 mm each, resolve neither the free path of the bands that are nearly opaque,
/// 0.14 and 1.7 mm, nor the skin that conduction makes.
constexpr std::size_t unresolved = 2;

TEST(LarsenSlab, cools_as_by_sp3) {
  for (const auto& [name, model] :
       {std::pair{"P1", Model::p1}, {"P1 in cones", Model::p1_cones}, {"transfer", Model::transfer}}) {
    const std::vector<double> T = temperatures(model);
    tests::Figure inside(fmt::format("{}: glass slab of Larsen et al. 2002 in eight bands, temperatures from 40 mm "
                                     "below the surface against SP3's: off by",
                                     name),
                         "%"),
        outside(fmt::format("{}: the same of the 20 mm next to the surface, which SP3's volumes do not resolve", name),
                "%");
    for (std::size_t v = unresolved; v < by_sp3.size(); ++v) inside.add(100 * std::abs(T[v] / by_sp3[v] - 1));
    outside.add(100 * std::abs(T[0] / by_sp3[0] - 1));
    if (model == Model::transfer)
      inside.at_most(0.1);
    else
      inside.for_comparison();
    outside.for_comparison();
  }
}

}  // namespace
}  // namespace parison::thermal::test
