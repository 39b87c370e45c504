#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::core {

/// Writes JSON text in order; numbers keep every digit, NaN and infinity become null.
class JsonWriter {
 public:
  JsonWriter();
  /// Objects and lists nest; the key is empty inside a list.
  void open_object(const std::string& key);
  void open_list(const std::string& key);
  void close();
  void add(const std::string& key, double value);
  void add(const std::string& key, long value);
  void add(const std::string& key, bool value);
  void add(const std::string& key, const std::string& value);
  /// Closes what is open and returns the text.
  std::string finish();

 private:
  void begin(const std::string& key);
  void open(const std::string& key, char bracket, char closing);

  std::string text_, closing_;
  bool first_ = true;
};

/// A text in quotes with JSON's escapes.
std::string json_text(const std::string& text);

}  // namespace parison::core
