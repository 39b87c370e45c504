// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pvd.hpp"

#include <fmt/format.h>

#include <utility>

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

void PvdCollection::add(double time, const std::string& file) {
  entries_.push_back({time, file});
  write();
}

void PvdCollection::set(std::vector<Entry> entries) {
  entries_ = std::move(entries);
  write();
}

void PvdCollection::write() const {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
  for (const Entry& entry : entries_)
    text += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", entry.time, xml_text(entry.file));
  replace_file(path_, text + "  </Collection>\n</VTKFile>\n");
}

}  // namespace parison::core
