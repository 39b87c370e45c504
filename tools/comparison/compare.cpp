// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/comparison/compare.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "core/case/case_error.hpp"
#include "forming/study/comparison/comparison.hpp"

namespace parison::tools {

int compare(const CompareRequest& request) {
  const forming::Comparison comparison = forming::compare_folders(request.base, request.others);
  if (!request.quantity.empty()) forming::require_quantity(request.quantity, comparison.base.quantities.values);
  const std::string quantity = request.quantity.empty() ? forming::ranked_quantity(comparison) : request.quantity;
  fmt::print("{}{}", forming::comparison_tables(comparison), forming::ranking_table(comparison, quantity));
  if (!request.output.empty()) fmt::print("\n  {}\n", forming::write_comparison(comparison, request.output));
  return 0;
}

}  // namespace parison::tools
