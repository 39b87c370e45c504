// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/svg.hpp"

#include <fmt/format.h>

namespace parison::core::svg {

std::string text(double x, double y, const char* anchor, const std::string& words, int size, const std::string& style) {
  std::string safe;
  for (const char c : words) safe += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" text-anchor=\"{}\" {}>{}</text>\n", x, y, size,
                     anchor, style, safe);
}

std::string line(double x1, double y1, double x2, double y2, const std::string& style) {
  return fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n", x1, y1, x2, y2, style);
}

std::string rectangle(double x, double y, double width, double height, const std::string& style) {
  return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" {}/>\n", x, y, width, height,
                     style);
}

Path& Path::add(char command, double x, double y) {
  points_ += fmt::format("{}{:.2f} {:.2f}", command, x, y);
  return *this;
}

Path& Path::close() {
  points_ += 'Z';
  return *this;
}

std::string Path::drawn(const std::string& style) const {
  return fmt::format("<path d=\"{}\" {}/>\n", points_, style);
}

std::string picture(double width, double height, const std::string& elements, const std::string& style) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"sans-serif\" {2}>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{3}</svg>\n",
      width, height, style, elements);
}

}  // namespace parison::core::svg
