// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/dxf/dxf_layers.hpp"

#include <fmt/core.h>
#include <iconv.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cwctype>

#include "core/case/given_file.hpp"

namespace parison::forming {

namespace {

using core::Point;

double value_of(const DxfFile& file, const DxfEntity& entity, int code, double otherwise) {
  for (const DxfGroup& group : entity.groups)
    if (group.code == code) return file.number(group);
  return otherwise;
}

}  // namespace

std::string DxfBlocks::name_of(const DxfEntity& entity) const {
  return in_small_letters(decoded(text_of(entity, 2), header_));
}

void DxfBlocks::take(const DxfEntity& entity) {
  constexpr std::size_t most_groups = 2'000'000;
  if (entity.kind == "BLOCK") {
    open_ = &blocks_[name_of(entity)];
    *open_ = {Point(value_of(file_, entity, 10, 0), value_of(file_, entity, 20, 0)), {}};
  } else if (entity.kind == "ENDBLK") {
    open_ = nullptr;
  } else if (open_) {
    groups_ += entity.groups.size();
    if (groups_ > most_groups)
      file_.refuse(entity.line,
                   fmt::format("blocks with more than {} values were found, allowed are so many", most_groups));
    open_->entities.push_back(entity);
  }
}

const DxfBlock& DxfBlocks::inserted(const DxfEntity& insert) const {
  const auto found = blocks_.find(name_of(insert));
  if (found == blocks_.end())
    file_.refuse(insert.line,
                 fmt::format("an INSERT of the block \"{}\" was found, allowed are blocks of the same file",
                             text_of(insert, 2)));
  return found->second;
}

Placement placement_of(const DxfFile& file, const DxfEntity& insert, const DxfBlock& block, double unit) {
  const auto value = [&](int code, double otherwise) { return value_of(file, insert, code, otherwise); };
  const double x = value(41, 1), y = value(42, 1);
  if (!(std::abs(x) > 1e-9) || std::abs(std::abs(x) - std::abs(y)) > 1e-9 * std::abs(x))
    file.refuse(insert.line,
                fmt::format("an INSERT with the scales {:g} and {:g} was found, allowed is one scale in both "
                            "directions (explode the block in the CAD program)",
                            x, y));
  if (value(70, 1) > 1 || value(71, 1) > 1)
    file.refuse(insert.line, "an INSERT of rows or columns of a block was found, allowed is a single one");
  // A reflection of y alone is one of x and half a turn.
  Placement placement{unit * block.base, unit * Point(value(10, 0), value(20, 0)),
                      value(50, 0) * M_PI / 180 + (y < 0 ? M_PI : 0), std::abs(x), x * y < 0};
  if (value(230, 1) < 0) {
    placement.place[0] = -placement.place[0];
    placement.turn = -placement.turn;
    placement.mirrored = !placement.mirrored;
  }
  return placement;
}

namespace {

/// Text from one encoding to another by iconv(3); empty where that has no such encoding or the text is none of it.
std::string converted(std::string_view text, const char* to, const std::string& from) {
  const iconv_t work = iconv_open(to, from.c_str());
  if (work == iconv_t(-1)) return {};
  std::string input(text), output(8 * text.size() + 8, '\0');
  char *in = input.data(), *out = output.data();
  std::size_t in_left = input.size(), out_left = output.size();
  const bool ok = iconv(work, &in, &in_left, &out, &out_left) != std::size_t(-1);
  iconv_close(work);
  output.resize(ok ? output.size() - out_left : 0);
  return output;
}

/// "ANSI_1252", "DOS850", "ISO8859-1" as iconv calls them.
std::string encoding_of(std::string_view code_page) {
  const auto digits = code_page.find_first_of("0123456789");
  if (digits == code_page.npos) return "CP1252";
  const std::string number(code_page.substr(digits));
  return number.rfind("8859", 0) == 0 ? "ISO-" + number : "CP" + number;
}

std::string utf8(unsigned code) {
  const wchar_t sign[] = {static_cast<wchar_t>(code), 0};
  return converted({reinterpret_cast<const char*>(sign), sizeof(wchar_t)}, "UTF-8", "WCHAR_T");
}

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
}

/// Signs written as \U+00DC.
std::string without_escapes(std::string text) {
  constexpr std::size_t length = 7;  // of \U+XXXX
  for (std::size_t at = 0; (at = text.find("\\U+", at)) != text.npos; ++at) {
    const std::string digits = text.substr(at + 3, 4);
    if (digits.size() < 4 || digits.find_first_not_of("0123456789abcdefABCDEF") != digits.npos) continue;
    const std::string sign = utf8(static_cast<unsigned>(std::stoul(digits, nullptr, 16)));
    if (!sign.empty()) text.replace(at, length, sign);
  }
  return text;
}

}  // namespace

std::string decoded(std::string_view name, const DxfHeader& header) {
  std::string text(name);
  if (!is_ascii(name)) {
    const bool is_new = header.version >= "AC1021";  // of 2007: UTF-8
    text = is_new ? converted(name, "UTF-8", "UTF-8") : "";
    if (text.empty()) text = converted(name, "UTF-8", encoding_of(header.code_page));
    if (text.empty()) text = converted(name, "UTF-8", "CP1252");
    if (text.empty()) text = converted(name, "UTF-8", "ISO-8859-1");
  }
  return without_escapes(std::move(text));
}

std::string in_small_letters(const std::string& name) {
  static const locale_t unicode = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
  if (is_ascii(name)) return core::in_small_ascii(name);
  std::string wide = converted(name, "WCHAR_T", "UTF-8");
  if (!unicode || wide.empty()) return name;
  auto* letters = reinterpret_cast<wchar_t*>(wide.data());
  const std::size_t count = wide.size() / sizeof(wchar_t);
  std::transform(letters, letters + count, letters,
                 [](wchar_t c) { return static_cast<wchar_t>(towlower_l(static_cast<wint_t>(c), unicode)); });
  return converted(wide, "UTF-8", "WCHAR_T");
}

std::string_view text_of(const DxfEntity& entity, int code) {
  for (const DxfGroup& group : entity.groups)
    if (group.code == code) return group.value;
  return {};
}

void DxfLayers::take(const DxfEntity& entry) {
  if (entry.kind != "LAYER") return;
  const auto number = [&](int code) {
    for (const DxfGroup& group : entry.groups)
      if (group.code == code) return file_.number(group);
    return 0.0;
  };
  const bool is_frozen = std::fmod(std::abs(number(70)), 2) == 1;
  layers_[in_small_letters(decoded(text_of(entry, 2), header_))] = {is_frozen, number(62) < 0};
}

std::string DxfLayers::layer_of(const DxfEntity& entity) const {
  const auto name = text_of(entity, 8);
  return name.empty() ? "0" : decoded(name, header_);
}

bool DxfLayers::is_frozen(const std::string& layer) const {
  const auto found = layers_.find(in_small_letters(layer));
  return found != layers_.end() && found->second.frozen;
}

bool DxfLayers::is_hidden(const std::string& layer) const {
  const auto found = layers_.find(in_small_letters(layer));
  return found != layers_.end() && (found->second.frozen || found->second.off);
}

}  // namespace parison::forming
