// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/json.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "core/process/run_error.hpp"

namespace parison::core {
namespace {

using Json = nlohmann::ordered_json;

JsonValue value_of(const Json& json) {
  JsonValue value;
  if (json.is_number()) value.number = json.get<double>();
  if (json.is_boolean()) value.flag = json.get<bool>();
  if (json.is_string()) value.text = json.get<std::string>();
  if (json.is_array())
    for (const Json& item : json) value.items.push_back(value_of(item));
  if (json.is_object())
    for (const auto& [name, item] : json.items()) {
      value.items.push_back(value_of(item));
      value.items.back().name = name;
    }
  return value;
}

}  // namespace

JsonWriter::JsonWriter() : whole_(std::make_unique<Json>(Json::object())), open_{whole_.get()} {}
JsonWriter::~JsonWriter() = default;

Json& JsonWriter::put(const std::string& key, Json&& value) {
  Json& inside = *open_.back();
  return inside.is_array() ? inside.emplace_back(std::move(value)) : inside[key] = std::move(value);
}

void JsonWriter::open_object(const std::string& key) {
  open_.push_back(&put(key, Json::object()));
}
void JsonWriter::open_list(const std::string& key) {
  open_.push_back(&put(key, Json::array()));
}
void JsonWriter::close() {
  open_.pop_back();
}
void JsonWriter::add(const std::string& key, double value) {
  put(key, value);
}
void JsonWriter::add(const std::string& key, long value) {
  put(key, value);
}
void JsonWriter::add(const std::string& key, bool value) {
  put(key, value);
}
void JsonWriter::add(const std::string& key, const std::string& value) {
  put(key, value);
}

std::string JsonWriter::finish() const {
  constexpr int indent = 2;
  return whole_->dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

const JsonValue* JsonValue::find(const std::string& member) const {
  for (const JsonValue& item : items)
    if (item.name == member) return &item;
  return nullptr;
}

double JsonValue::number_of(const std::string& member) const {
  const JsonValue* item = find(member);
  return item ? item->number : std::numeric_limits<double>::quiet_NaN();
}

std::string JsonValue::text_of(const std::string& member) const {
  const JsonValue* item = find(member);
  return item ? item->text : "";
}

bool JsonValue::flag_of(const std::string& member) const {
  const JsonValue* item = find(member);
  return item && item->flag;
}

JsonValue read_json(const std::string& text, const std::string& what) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw RunError(fmt::format("{}: no JSON", what));
  return value_of(json);
}

std::optional<JsonValue> read_json_file(const std::string& path) {
  std::error_code unreadable;
  if (!std::filesystem::exists(path, unreadable) && !unreadable) return std::nullopt;
  const Json json = Json::parse(read_text(path), nullptr, false);
  return json.is_object() ? std::optional(value_of(json)) : std::nullopt;
}

}  // namespace parison::core
