#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

/// Elements of SVG pictures as text; lengths in pixels, y downwards. A style is attributes, such as fill="none".
namespace parison::core::svg {

std::string text(double x, double y, const char* anchor, const std::string& words, int size = 12,
                 const std::string& style = "");
std::string line(double x1, double y1, double x2, double y2, const std::string& style);
std::string rectangle(double x, double y, double width, double height, const std::string& style);

/// The outline of a path, from point to point.
class Path {
 public:
  /// Starts a part of its own, or goes straight on; the first point always starts one.
  Path& move(double x, double y) { return add('M', x, y); }
  Path& to(double x, double y) { return add(points_.empty() ? 'M' : 'L', x, y); }
  Path& close();
  std::string drawn(const std::string& style) const;

 private:
  Path& add(char command, double x, double y);
  std::string points_;
};

/// A whole picture on white, of such elements.
std::string picture(double width, double height, const std::string& elements, const std::string& style = "");

}  // namespace parison::core::svg
