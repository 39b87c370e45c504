#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <set>
#include <string>

#include "forming/report/solid/shell_file.hpp"

namespace parison::forming {

/// Numbers of nodes with the share that each has in a force.
using Shares = std::map<long, double>;
/// Nodes of a shell that loads and supports act on.
struct ShellPlaces {
  Shares finish;  ///< the open edge in the upper half; a force that is even along it
  Shares body;    ///< two lines in y = 0, where |x| is at least 90 % of its largest; such forces, inwards, along +x
  std::set<long> base;  ///< the line on which it stands: the outermost sides of elements within 0.02 mm of a plate
};
ShellPlaces shell_places(const Shell& shell, int up);

/// Steps of an input file, none for what has no finish, each for itself and with the unit of its load: 1 kN on the
/// finish over a plate, 1 bar inside, 1 kN between the sides. The tests of the trade: A. W. Bitting, J. Am. Ceram. Soc.
/// 5 (1922), end crushing, hydrostatic and transverse pressure.
/// Of a shell that begins with stress a step without a load goes before.
std::string shell_steps(const Shell& shell, const ShellPlaces& places, int up, bool has_stress);

}  // namespace parison::forming
