#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::tools {

/// The processes that have a template.
inline constexpr const char* processes = "nnpb, press_and_blow, blow_and_blow, pressed and tubing";

/// What a new container is to be, as given.
struct ContainerWish {
  std::string process;   ///< "nnpb"
  std::string weight;    ///< "180 g"
  std::string capacity;  ///< to the rim, "330 ml"
  std::string height;    ///< "220 mm"
  std::string finish;    ///< outer diameter, of pressed ware that of the rim, of an ampoule from
                         ///< tubing that of the stem, "28 mm"; empty: as in the template
};

/// The text of a case for it: the template of its process, whose formulas are the proportions, as plain dimensions. The
/// mould is as wide as the capacity wants, the blank as the weight wants where the plunger stops. What it says of
/// weight and capacity is within 0.5 % of the wish as `parison check` has it; of an ampoule the tube has them, below
/// the middle of what is drawn. Throws core::CaseError where that cannot be.
std::string container_text(const ContainerWish& wish, const std::string& name);

}  // namespace parison::tools
