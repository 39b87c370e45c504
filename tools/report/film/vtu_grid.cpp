// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/film/vtu_grid.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <filesystem>

#include "core/process/run_error.hpp"

namespace parison::tools {
namespace {

std::vector<float> values_of(vtkDataArray& array) {
  std::vector<float> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>(array.GetTuple1(static_cast<vtkIdType>(i)));
  return values;
}

}  // namespace

void refuse_vtu(const std::string& path, const char* why) {
  throw core::RunError(fmt::format("{}: {}", path, why));
}

vtkSmartPointer<vtkUnstructuredGrid> read_grid(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) refuse_vtu(path, "no such file");
  vtkObject::GlobalWarningDisplayOff();  // what is wrong is said here
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkSmartPointer<vtkUnstructuredGrid> grid = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || grid->GetNumberOfPoints() == 0 || !grid->GetCells())
    refuse_vtu(path, "is no complete VTU file");
  return grid;
}

std::vector<int> cells_of(vtkUnstructuredGrid& grid, int nodes_of_cell, const std::string& path) {
  std::vector<int> cells;
  const vtkIdType points = grid.GetNumberOfPoints();
  vtkNew<vtkIdTypeArray> legacy;
  grid.GetCells()->ExportLegacyFormat(legacy);
  for (vtkIdType i = 0; i < legacy->GetNumberOfValues(); i += nodes_of_cell + 1) {
    if (legacy->GetValue(i) != nodes_of_cell) refuse_vtu(path, "does not hold the cells of a run");
    for (vtkIdType k = 1; k <= nodes_of_cell; ++k) {
      const vtkIdType node = legacy->GetValue(i + k);
      if (node < 0 || node >= points) refuse_vtu(path, "has a cell with a node that is not there");
      cells.push_back(static_cast<int>(node));
    }
  }
  return cells;
}

std::map<std::string, std::vector<float>> nodal_fields(vtkUnstructuredGrid& grid) {
  std::map<std::string, std::vector<float>> nodal;
  vtkPointData& fields = *grid.GetPointData();
  for (int i = 0; i < fields.GetNumberOfArrays(); ++i)
    if (vtkDataArray* array = fields.GetArray(i); array && array->GetName() && array->GetNumberOfComponents() == 1 &&
                                                  array->GetNumberOfTuples() == grid.GetNumberOfPoints())
      nodal[array->GetName()] = values_of(*array);
  return nodal;
}

}  // namespace parison::tools
