// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/film/vtu_file.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include "core/case/number.hpp"
#include "core/io/files.hpp"
#include "core/process/run_error.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

constexpr vtkIdType nodes_of_cell = 6;
constexpr vtkIdType most_nodes = 65536;

[[noreturn]] void refuse(const std::string& path, const char* why) {
  throw core::RunError(fmt::format("{}: {}", path, why));
}

std::vector<float> values_of(vtkDataArray& array) {
  std::vector<float> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>(array.GetTuple1(static_cast<vtkIdType>(i)));
  return values;
}

std::vector<std::uint16_t> cells_of(vtkUnstructuredGrid& grid, const std::string& path) {
  std::vector<std::uint16_t> cells;
  const vtkIdType points = grid.GetNumberOfPoints();
  vtkNew<vtkIdTypeArray> legacy;
  grid.GetCells()->ExportLegacyFormat(legacy);
  for (vtkIdType i = 0; i < legacy->GetNumberOfValues(); i += nodes_of_cell + 1) {
    if (legacy->GetValue(i) != nodes_of_cell) refuse(path, "does not hold quadratic triangles");
    for (vtkIdType k = 1; k <= nodes_of_cell; ++k) {
      const vtkIdType node = legacy->GetValue(i + k);
      if (node < 0 || node >= points) refuse(path, "has a cell with a node that is not there");
      cells.push_back(static_cast<std::uint16_t>(node));
    }
  }
  return cells;
}

std::string without_escapes(std::string text) {
  for (const auto& [escape, character] : {std::pair{"&lt;", "<"}, {"&quot;", "\""}, {"&amp;", "&"}})
    for (std::size_t at = 0; (at = text.find(escape, at)) != std::string::npos; ++at)
      text.replace(at, std::string(escape).size(), character);
  return text;
}

}  // namespace

VtuFile read_vtu(const std::string& path) {
  if (!fs::is_regular_file(path)) refuse(path, "no such file");
  vtkObject::GlobalWarningDisplayOff();  // what is wrong is said here
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkUnstructuredGrid& grid = *reader->GetOutput();
  const vtkIdType points = grid.GetNumberOfPoints();
  if (reader->GetErrorCode() != 0 || points == 0 || !grid.GetCells()) refuse(path, "is no complete VTU file");
  if (points > most_nodes) refuse(path, "has more than 65536 nodes");
  VtuFile file;
  for (vtkIdType i = 0; i < points; ++i) {
    const double* point = grid.GetPoint(i);
    file.points.push_back({static_cast<float>(point[0]), static_cast<float>(point[1])});
  }
  file.cells = cells_of(grid, path);
  vtkPointData& fields = *grid.GetPointData();
  for (int i = 0; i < fields.GetNumberOfArrays(); ++i)
    if (vtkDataArray* array = fields.GetArray(i);
        array && array->GetName() && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == points)
      file.nodal[array->GetName()] = values_of(*array);
  if (vtkDataArray* active = grid.GetCellData()->GetArray("active"); active && active->GetNumberOfTuples() > 0)
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
