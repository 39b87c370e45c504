// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vtu.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cassert>
#include <stdexcept>

#include "core/files.hpp"

namespace parison::core {
namespace {

constexpr int vtk_dim = 3;

void add_geometry(const Mesh& mesh, const Point& displacement, vtkUnstructuredGrid& grid) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.node_count());
  for (Index i = 0; i < mesh.node_count(); ++i) {
    std::array<double, vtk_dim> x{};
    for (int k = 0; k < dim; ++k) x[k] = mesh.nodes[i][k] + displacement[k];
    points->SetPoint(i, x.data());
  }
  grid.SetPoints(points);
  grid.Allocate(mesh.cell_count());
  for (const auto& cell : mesh.cells) {
    std::array<vtkIdType, 6> nodes;
    std::copy(cell.begin(), cell.end(), nodes.begin());
    grid.InsertNextCell(VTK_QUADRATIC_TRIANGLE, 6, nodes.data());
  }
}

void add_nodal(const Mesh& mesh, const NodalField& field, vtkUnstructuredGrid& grid) {
  const bool is_vector = field.values.size() != mesh.node_count();
  assert(!is_vector || field.values.size() == dim * mesh.node_count());
  vtkNew<vtkDoubleArray> array;
  array->SetName(field.name.c_str());
  array->SetNumberOfComponents(is_vector ? vtk_dim : 1);
  array->SetNumberOfTuples(mesh.node_count());
  for (Index i = 0; i < mesh.node_count(); ++i) {
    if (!is_vector) {
      array->SetValue(i, field.values[i]);
      continue;
    }
    std::array<double, vtk_dim> v{};
    for (int k = 0; k < dim; ++k) v[k] = field.values[dim * i + k];
    array->SetTuple(i, v.data());
  }
  grid.GetPointData()->AddArray(array);
}

vtkNew<vtkDoubleArray> filled(const std::string& name, vtkIdType count, double value) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfTuples(count);
  array->Fill(value);
  return array;
}

}  // namespace

void write_vtu(const std::string& path, const Mesh& mesh, const VtuFields& fields) {
  vtkNew<vtkUnstructuredGrid> grid;
  add_geometry(mesh, fields.displacement, *grid);
  for (const NodalField& field : fields.nodal) add_nodal(mesh, field, *grid);
  if (!fields.nodal.empty() && fields.nodal[0].values.size() == mesh.node_count())
    grid->GetPointData()->SetActiveScalars(fields.nodal[0].name.c_str());
  for (const CellConstant& field : fields.cell)
    grid->GetCellData()->AddArray(filled(field.name, mesh.cell_count(), field.value));
  grid->GetFieldData()->AddArray(filled("TimeValue", 1, fields.time));

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->WriteToOutputStringOn();
  writer->SetInputData(grid);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->SetCompressionLevel(1);
  if (writer->Write() != 1) throw std::runtime_error(path + ": cannot be made");
  write_text(path, writer->GetOutputString());
}

}  // namespace parison::core
