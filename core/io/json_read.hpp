#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace parison::core {

/// A value of a JSON text; what it is not is empty, false or NaN.
struct JsonValue {
  std::string name;  ///< of a member of an object
  bool flag = false;
  double number = std::numeric_limits<double>::quiet_NaN();
  std::string text;
  std::vector<JsonValue> items;  ///< of a list or an object, in their order

  /// The member with a name, null without one.
  const JsonValue* find(const std::string& member) const;
  /// A member's number; NaN where it is absent or no number.
  double number_of(const std::string& member) const;
  std::string text_of(const std::string& member) const;
  bool flag_of(const std::string& member) const;
};

/// Parses a whole text; throws RunError with `what`, the name of its source, where it is no JSON.
JsonValue read_json(const std::string& text, const std::string& what);

/// The object in a file that this program has written; nothing where it is not there, or not whole, as after a loss of
/// power: it is then made anew.
std::optional<JsonValue> read_json_file(const std::string& path);

}  // namespace parison::core
