// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/path_text.hpp"

#include <algorithm>

#include "core/case/given_file.hpp"

namespace parison::forming {
namespace {

using core::trimmed;

bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

void skip_blanks(std::string_view& text) {
  std::size_t count = 0;
  while (count < text.size() && is_blank(text[count])) ++count;
  text.remove_prefix(count);
}

/// Takes a word that ends at a blank, with the blanks behind it.
std::string_view take_word(std::string_view& text) {
  std::size_t size = 0;
  while (size < text.size() && !is_blank(text[size])) ++size;
  const auto word = text.substr(0, size);
  text.remove_prefix(size);
  skip_blanks(text);
  return word;
}

/// Takes "(...)" and gives what is between the brackets; nothing where the text does not begin so.
std::optional<std::string_view> take_brackets(std::string_view& text) {
  if (text.empty() || text.front() != '(') return {};
  std::size_t end = 0;
  for (int depth = 0; end < text.size(); ++end) {
    depth += (text[end] == '(') - (text[end] == ')');
    if (depth == 0) break;
  }
  if (end == text.size()) return {};
  const auto inside = text.substr(1, end - 1);
  text.remove_prefix(end + 1);
  return inside;
}

/// Whether a text has a name in it or a unit of its own.
bool has_letter(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; });
}

/// Whether coordinates without a unit behind them have one of their own or need none, as zeros do.
bool need_no_unit(const std::vector<std::string_view>& points) {
  const auto is_zero = [](std::string_view text) { return text.find_first_of("123456789") == text.npos; };
  return std::any_of(points.begin(), points.end(), has_letter) || std::all_of(points.begin(), points.end(), is_zero);
}

/// Takes everything before the next word that is `end`, and that word; nothing where there is none.
std::optional<std::string_view> take_until(std::string_view& text, std::string_view end) {
  const char* const first = text.data();
  while (!text.empty()) {
    const auto before = static_cast<std::size_t>(text.data() - first);
    if (take_word(text) == end) return trimmed({first, before});
  }
  return {};
}

}  // namespace

std::optional<PointsText> split_points(std::string_view text) {
  PointsText result;
  bool apart = false;
  skip_blanks(text);
  while (const auto inside = take_brackets(text)) {
    result.points.push_back(*inside);
    apart = !text.empty() && is_blank(text.front());
    skip_blanks(text);
  }
  result.unit = take_word(text);
  if (result.points.empty() || !text.empty()) return {};
  if (result.unit.empty() ? !need_no_unit(result.points) : !apart) return {};
  return result;
}

std::vector<std::string_view> split_coordinates(std::string_view inside) {
  constexpr std::size_t most = 1000;
  std::vector<std::string_view> parts;
  std::size_t from = 0;
  int depth = 0;
  for (std::size_t i = 0; i < inside.size() && parts.size() < most; ++i) {
    depth += (inside[i] == '(') - (inside[i] == ')');
    if (inside[i] != ',' || depth != 0) continue;
    parts.push_back(inside.substr(from, i - from));
    from = i + 1;
  }
  parts.push_back(inside.substr(from));
  return parts;
}

std::optional<ArcText> split_arc(std::string_view text) {
  skip_blanks(text);
  if (take_word(text) != "arc" || take_word(text) != "centre") return {};
  const auto centre = take_brackets(text);
  skip_blanks(text);
  const auto word = take_word(text);
  const auto unit = word == "radius" ? std::string_view{} : word;
  if (!centre || (unit.empty() && !has_letter(*centre))) return {};
  if (!unit.empty() && take_word(text) != "radius") return {};
  const auto radius = take_until(text, "from"), from = take_until(text, "to");
  const auto to = trimmed(text);
  if (!radius || !from || radius->empty() || from->empty() || to.empty()) return {};
  return ArcText{*centre, unit, *radius, *from, to};
}

}  // namespace parison::forming
