#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "../../scene_text.hpp"

namespace parison::forming {

/// Replaces a part of the small scene and expects the complaint to start at the changed line.
inline void expect_complaint(const std::string& from, const std::string& to, const std::string& rest) {
  EXPECT_EQ(complaint_about(replaced(from, to)), std::to_string(line_of(from)) + ": " + rest);
}

}  // namespace parison::forming
