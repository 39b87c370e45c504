// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "figure.hpp"
#include "thermal/bodies.hpp"
#include "thermal/system.hpp"
#include "thermal/radiation/exact_emission.hpp"

namespace parison::thermal::test {
namespace {

using core::Geometry;
using Model = Radiation::Model;

TEST(TransferEmission, isothermal_bodies_emit_as_the_integral_over_their_chords_says) {
  for (const Shape shape : {Shape::slab, Shape::cylinder, Shape::sphere})
    for (const double index : {1.0, 1.518}) {
      tests::Figure off(fmt::format("transfer: emission of isothermal {} of optical size 0.1 to 10, n = {}: off by",
                                    name_of(shape), index),
                        "%");
      for (const double optical : {0.1, 0.45, 1.2, 5.0, 10.0}) {
        const double found = emissivity(shape, Model::transfer, optical, index, shape == Shape::sphere ? 16 : 40),
                     wanted = exact(shape, optical, index);
        off.add(100 * std::abs(found / wanted - 1));
        std::printf("n = %g, %s of optical size %g: %.5f, exact %.5f\n", index, name_of(shape), optical, found, wanted);
      }
      off.at_most(1);
    }
}

}  // namespace
}  // namespace parison::thermal::test
