#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

namespace parison::contact {

/// Root of f between a and b, where its values fa and fb have opposite signs, to 1e-15: regula falsi with the Illinois
/// modification (M. Dowell, P. Jarratt, BIT 11 (1971) 168-174). One step suffices where f is linear.
template <typename Function>
double find_root(const Function& f, double a, double fa, double b, double fb) {
  if (fa == 0) return a;
  if (fb == 0) return b;
  double previous = a, root = b;
  for (int iteration = 0; iteration < 100; ++iteration) {
    previous = root;
    root = (a * fb - b * fa) / (fb - fa);
    if (std::abs(root - previous) < 1e-15) break;
    const double value = f(root);
    if (value == 0) break;
    if ((value > 0) == (fb > 0)) {
      fa *= iteration > 0 ? 0.5 : 1.0;
    } else {
      a = b;
      fa = fb;
    }
    b = root;
    fb = value;
  }
  return root;
}

}  // namespace parison::contact
