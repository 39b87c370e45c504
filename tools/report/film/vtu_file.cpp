// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/film/vtu_file.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkUnstructuredGrid.h>

#include <filesystem>
#include <regex>

#include "core/case/number.hpp"
#include "core/io/files.hpp"
#include "tools/report/film/vtu_grid.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

std::string without_escapes(std::string text) {
  for (const auto& [escape, character] : {std::pair{"&lt;", "<"}, {"&quot;", "\""}, {"&amp;", "&"}})
    for (std::size_t at = 0; (at = text.find(escape, at)) != std::string::npos; ++at)
      text.replace(at, std::string(escape).size(), character);
  return text;
}

}  // namespace

VtuFile read_vtu(const std::string& path) {
  const auto grid = read_grid(path);
  const vtkIdType points = grid->GetNumberOfPoints();
  if (points > most_nodes) refuse_vtu(path, "has more than 65536 nodes");
  VtuFile file;
  for (vtkIdType i = 0; i < points; ++i) {
    const double* point = grid->GetPoint(i);
    file.points.push_back({static_cast<float>(point[0]), static_cast<float>(point[1])});
  }
  const std::vector<int> cells = cells_of(*grid, nodes_of_cell, path);
  file.cells.assign(cells.begin(), cells.end());
  file.nodal = nodal_fields(*grid);
  if (vtkDataArray* active = grid->GetCellData()->GetArray("active"); active && active->GetNumberOfTuples() > 0)
    file.active = active->GetTuple1(0) > 0;
  return file;
}

std::vector<PvdEntry> read_pvd(const std::string& path) {
  std::vector<PvdEntry> entries;
  if (!fs::is_regular_file(path)) return entries;
  const std::string text = core::read_text(path);
  const fs::path folder = fs::path(path).parent_path();
  const std::regex wanted("<DataSet timestep=\"([^\"]*)\"[^>]*file=\"([^\"]*)\"");
  for (auto match = std::sregex_iterator(text.begin(), text.end(), wanted); match != std::sregex_iterator(); ++match) {
    const auto time = core::parse_number<double>((*match)[1].str());
    const fs::path file = fs::path(without_escapes((*match)[2].str())).lexically_normal();
    if (!time || file.empty() || file.is_absolute() || *file.begin() == "..") continue;
    entries.push_back({*time, (folder / file).string()});
  }
  return entries;
}

}  // namespace parison::tools
