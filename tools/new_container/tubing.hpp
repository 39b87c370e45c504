#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

namespace parison::tools {

inline constexpr const char* tubing_process = "tubing";

/// An ampoule that is drawn from tubing and cut in the middle of its stem: mass, kg, inner volume and height up to
/// there, m3 and m, and outer diameter of the stem there, m.
struct Ampoule {
  double mass, capacity, height;
  std::optional<double> stem;
};

/// The tube, where it is heated and how far it is drawn, as values of the template. Throws core::CaseError where there
/// is no such tube.
std::vector<std::string> fit_tubing(const Ampoule& wish, double density);

}  // namespace parison::tools
