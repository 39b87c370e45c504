// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/comparison/compare.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "core/case/case_error.hpp"
#include "forming/study/comparison/comparison.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::tools {
namespace {

/// The folder of a what-if or a cycle has a table of its own.
void refuse_folder_of_others(const std::string& output) {
  std::error_code unreadable;
  for (const char* run : {forming::base_name, "first_gob"})
    if (std::filesystem::exists(output + '/' + run, unreadable))
      throw core::CaseError(fmt::format(
          "--output: {} is the folder of a what-if or a cycle, whose table would be lost; allowed is another one",
          output));
}

}  // namespace

int compare(const CompareRequest& request) {
  if (!request.output.empty()) refuse_folder_of_others(request.output);
  const forming::Comparison comparison = forming::compare_folders(request.base, request.others);
  if (!request.quantity.empty()) forming::require_quantity(request.quantity, comparison.base.quantities.values);
  const std::string quantity = request.quantity.empty() ? forming::ranked_quantity(comparison) : request.quantity;
  fmt::print("{}{}", forming::comparison_tables(comparison), forming::ranking_table(comparison, quantity));
  if (!request.output.empty()) fmt::print("\n  {}\n", forming::write_comparison(comparison, request.output));
  return 0;
}

}  // namespace parison::tools
