#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace parison::core {

/// Builds a JSON text with its keys in the order of addition; numbers keep every digit, NaN and infinity become null.
class JsonWriter {
 public:
  JsonWriter();
  ~JsonWriter();
  /// Objects and lists nest; the key is empty inside a list.
  void open_object(const std::string& key);
  void open_list(const std::string& key);
  void close();
  void add(const std::string& key, double value);
  void add(const std::string& key, long value);
  void add(const std::string& key, bool value);
  void add(const std::string& key, const std::string& value);
  void add(const std::string& key, const char* value) { add(key, std::string(value)); }  ///< never as a flag
  /// The text, whatever is still open.
  std::string finish() const;

 private:
  nlohmann::ordered_json& put(const std::string& key, nlohmann::ordered_json&& value);

  std::unique_ptr<nlohmann::ordered_json> whole_;
  std::vector<nlohmann::ordered_json*> open_;  ///< the innermost last
};

}  // namespace parison::core
