#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Results taken apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"

namespace parison::forming {

inline Scene case_of(const std::string& name) {
  return read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/" + name, "draft");
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

inline std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

/// Fields of a line by the names of a heading.
inline std::map<std::string, std::string> named_fields(const std::string& heading, const std::string& line) {
  const auto names = fields_of(lines_of(heading)[0]), fields = fields_of(lines_of(line)[0]);
  EXPECT_EQ(names.size(), fields.size());
  std::map<std::string, std::string> found;
  for (std::size_t i = 0; i < std::min(names.size(), fields.size()); ++i) found[names[i]] = fields[i];
  return found;
}

}  // namespace parison::forming
