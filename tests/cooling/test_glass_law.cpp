// SPDX-License-Identifier: GPL-3.0-or-later
// The law of cooling glass at one point, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "cooling_body.hpp"
#include "figure.hpp"

namespace parison::cooling {
namespace {

/// Flint glass of the published plates whose viscosity, Pa.s, is one.
GlassLaw law_at(double viscosity) {
  GlassLaw law = reference_law();
  law.frozen_activation = 0;
  law.log_equilibrium = [=](double) { return std::log(viscosity); };
  return law;
}

TEST(GlassLaw, structure_after_a_jump_decays_by_its_spectrum) {
  const double viscosity = 1e11, jump = 10;
  const GlassLaw law = law_at(viscosity);
  Branches fictive = Branches::Constant(800 + jump);
  tests::Figure off("isothermal structural step: fictive temperature off by, of the jump");
  double time = 0;
  for (double dt = 1e-4; time < 200; dt *= 1.5) {
    fictive = relax(law, fictive, 800, 800, dt).fictive;
    time += dt;
    const double units = time * law.shear_modulus() / viscosity;
    const double exact = jump * (law.structure.weight * (-units / law.structure.time).exp()).sum();
    off.add(std::abs((law.structure.weight * fictive).sum() - 800 - exact) / jump);
  }
  off.at_most(1e-6);
}

TEST(GlassLaw, a_maxwell_bar_pulled_at_a_constant_rate_has_its_exact_stress) {
  const double viscosity = 1e11, rate = 1e-6;
  GlassLaw law = law_at(viscosity);
  law.poisson = 0.5;
  law.shear.weight << 1, 0, 0, 0, 0, 0;
  law.shear.time.setOnes();
  double stress = 0, time = 0;  // deviator along the bar
  tests::Figure off("Maxwell bar at a constant rate: stress off by, relative");
  for (double dt = 1e-3; time < 100; dt *= 1.7) {
    const Relaxation step = relax(law, Branches::Constant(800), 800, 800, dt);
    stress = stress * step.kept[0] + 2 * step.modulus[0] * rate * dt;
    time += dt;
    const double exact = 3 * viscosity * rate * (1 - std::exp(-law.young * time / (3 * viscosity)));
    off.add(std::abs(1.5 * stress / exact - 1));
  }
  off.at_most(1e-6);
}

TEST(GlassLaw, hot_glass_has_its_viscosity_and_cold_glass_its_shear_modulus) {
  const GlassLaw law = reference_law();
  const double dt = 1;
  const Relaxation hot = relax(law, Branches::Constant(1100), 1100, 1100, dt);
  EXPECT_NEAR(hot.modulus.sum() * dt / std::exp(law.log_viscosity(1100, 1100)), 1, 1e-6);
  EXPECT_LT(hot.kept.maxCoeff(), 1e-20);
  const Relaxation cold = relax(law, Branches::Constant(800), 300, 300, dt);
  EXPECT_NEAR(cold.modulus.sum() / law.shear_modulus(), 1, 1e-9);
  EXPECT_NEAR(cold.kept.minCoeff(), 1, 1e-9);
}

TEST(GlassLaw, slow_glass_expands_like_the_liquid_and_fast_glass_like_the_solid) {
  const GlassLaw law = reference_law();
  const Relaxation slow = relax(law, Branches::Constant(1000), 1000, 990, 10);
  EXPECT_NEAR(slow.strain, -10 * law.liquid_expansion, 1e-4 * 10 * law.liquid_expansion);
  const Relaxation fast = relax(law, Branches::Constant(800), 800, 300, 10);
  EXPECT_NEAR(fast.strain, -500 * law.solid_expansion, 0.02 * 500 * law.solid_expansion);
}

TEST(GlassLaw, one_step_through_the_transition_agrees_with_many) {
  const GlassLaw law = reference_law();
  const double from = 1150, to = 700, dt = 100;
  const Branches start = Branches::Constant(from);
  Branches fictive = start;
  const int many = 20000;
  for (int i = 0; i < many; ++i)
    fictive =
        relax(law, fictive, from + (to - from) * i / many, from + (to - from) * (i + 1) / many, dt / many).fictive;
  const double exact = (law.structure.weight * fictive).sum();
  tests::Figure off("one step from 1150 to 700 K: fictive temperature off by", "K");
  off.add(std::abs((law.structure.weight * relax(law, start, from, to, dt).fictive).sum() - exact));
  off.at_most(1);
  tests::Figure two("the same in two steps", "K");
  fictive = relax(law, start, from, 0.5 * (from + to), dt / 2).fictive;
  two.add(std::abs((law.structure.weight * relax(law, fictive, 0.5 * (from + to), to, dt / 2).fictive).sum() - exact));
  two.at_most(1);
}

}  // namespace
}  // namespace parison::cooling
