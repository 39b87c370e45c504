// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/process/build_id.hpp"

namespace parison::core {
namespace {

TEST(BuildId, is_the_hash_that_the_linker_gave_the_program) {
  const std::string& id = build_id();
  EXPECT_GE(id.size(), 16u);
  EXPECT_EQ(id.find_first_not_of("0123456789abcdef"), std::string::npos) << id;
}

}  // namespace
}  // namespace parison::core
