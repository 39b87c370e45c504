// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pvd.hpp"

#include <fmt/format.h>

#include "core/files.hpp"

namespace parison::core {
namespace {

std::string xml_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&') escaped += "&amp;";
    else if (c == '<') escaped += "&lt;";
    else if (c == '"') escaped += "&quot;";
    else escaped += c;
  }
  return escaped;
}

}  // namespace

void PvdCollection::append(const Entry& entry) {
  lines_ += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", entry.time, xml_text(entry.file));
}

void PvdCollection::add(double time, const std::string& file) {
  append({time, file});
  write();
}

void PvdCollection::set(const std::vector<Entry>& entries) {
  lines_.clear();
  for (const Entry& entry : entries) append(entry);
  write();
}

void PvdCollection::write() const {
  replace_file(path_, "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n" + lines_ +
                          "  </Collection>\n</VTKFile>\n");
}

}  // namespace parison::core
