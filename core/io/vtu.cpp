// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/vtu.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cassert>
#include <limits>
#include <mutex>
#include <vector>

#include "core/io/files.hpp"
#include "core/process/run_error.hpp"

namespace parison::core {

namespace {

constexpr int vtk_dim = 3;

/// A finite value that single precision cannot represent becomes the nearest that it can.
float single(double value) {
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(value > largest ? largest : value < -largest ? -largest : value);
}

vtkNew<vtkFloatArray> array(const std::string& name, int components, vtkIdType tuples) {
  vtkNew<vtkFloatArray> values;
  values->SetName(name.c_str());
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(tuples);
  values->Fill(0);
  return values;
}

/// A mesh as VTK takes it.
struct GridView {
  int components;       ///< of a node, 2 or 3
  const double* nodes;  ///< m
  Index node_count;
  VTKCellType type;
  std::vector<int> order;  ///< of VTK's nodes of a cell, which of ours each is
  const Index* cells;
  Index cell_count;
};

GridView view_of(const Mesh& mesh) {
  return {dim,
          mesh.nodes.front().data(),
          mesh.node_count(),
          VTK_QUADRATIC_TRIANGLE,
          {0, 1, 2, 3, 4, 5},
          mesh.cells().front().data(),
          mesh.cell_count()};
}

GridView view_of(const HexMesh& mesh) {
  return {vtk_dim,
          mesh.nodes.front().data(),
          mesh.node_count(),
          VTK_TRIQUADRATIC_HEXAHEDRON,
          {vtu_order_of_hex().begin(), vtu_order_of_hex().end()},
          mesh.cells.front().data(),
          mesh.cell_count()};
}

GridView view_of(const PrismMesh& mesh) {
  return {vtk_dim,
          mesh.nodes.front().data(),
          mesh.node_count(),
          VTK_BIQUADRATIC_QUADRATIC_WEDGE,
          {0, 1, 2, 12, 13, 14, 3, 4, 5, 15, 16, 17, 6, 7, 8, 9, 10, 11},
          mesh.cells.front().data(),
          mesh.cell_count()};
}

void set_points(const GridView& mesh, const Point& displacement, vtkUnstructuredGrid& grid) {
  const auto values = array("Points", vtk_dim, mesh.node_count);
  const int first = mesh.components == dim ? 0 : vtk_dim - dim;  // the displacement's last part is along the axis
  for (Index i = 0; i < mesh.node_count; ++i)
    for (int k = 0; k < mesh.components; ++k) {
      const double moved = k >= first ? displacement[k - first] : 0;
      values->SetTypedComponent(i, k, single(1e3 * (mesh.nodes[mesh.components * i + k] + moved)));
    }
  vtkNew<vtkPoints> points;
  points->SetData(values);
  grid.SetPoints(points);
}

void set_cells(const GridView& mesh, vtkUnstructuredGrid& grid) {
  const auto corners = static_cast<Index>(mesh.order.size());
  vtkNew<vtkTypeInt32Array> starts, nodes;
  starts->SetNumberOfValues(mesh.cell_count + 1);
  nodes->SetNumberOfValues(corners * mesh.cell_count);
  for (Index c = 0; c <= mesh.cell_count; ++c) starts->SetValue(c, corners * c);
  for (Index c = 0; c < mesh.cell_count; ++c)
    for (Index i = 0; i < corners; ++i) nodes->SetValue(corners * c + i, mesh.cells[corners * c + mesh.order[i]]);
  vtkNew<vtkCellArray> cells;
  cells->SetData(starts, nodes);
  grid.SetCells(mesh.type, cells);
}

void add_nodal(const GridView& mesh, const NodalField& field, vtkUnstructuredGrid& grid) {
  const bool is_vector = field.values.size() != mesh.node_count;
  assert(!is_vector || field.values.size() == mesh.components * mesh.node_count);
  const int components = is_vector ? mesh.components : 1;
  const auto values = array(field.name, is_vector ? vtk_dim : 1, mesh.node_count);
  for (Index i = 0; i < mesh.node_count; ++i)
    for (int k = 0; k < components; ++k) values->SetTypedComponent(i, k, single(field.values[components * i + k]));
  grid.GetPointData()->AddArray(values);
}

void add_fields(const GridView& mesh, const VtuFields& fields, vtkUnstructuredGrid& grid) {
  for (const NodalField& field : fields.nodal) add_nodal(mesh, field, grid);
  if (!fields.nodal.empty() && fields.nodal[0].values.size() == mesh.node_count)
    grid.GetPointData()->SetActiveScalars(fields.nodal[0].name.c_str());
  for (const CellConstant& field : fields.cell) {
    const auto values = array(field.name, 1, mesh.cell_count);
    values->Fill(single(field.value));
    grid.GetCellData()->AddArray(values);
  }
  vtkNew<vtkDoubleArray> time;
  time->SetName("TimeValue");
  time->InsertNextValue(fields.time);
  grid.GetFieldData()->AddArray(time);
  vtkNew<vtkStringArray> unit;
  unit->SetName("LengthUnit");
  unit->InsertNextValue("mm");
  grid.GetFieldData()->AddArray(unit);
}

}  // namespace

const std::array<int, HexMesh::nodes_per_cell>& vtu_order_of_hex() {
  static const std::array<int, HexMesh::nodes_per_cell> order{0,  2,  8, 6,  18, 20, 26, 24, 1,  5,  7, 3,  19, 23,
                                                              25, 21, 9, 11, 17, 15, 12, 14, 10, 16, 4, 22, 13};
  return order;
}

namespace {

/// The text of a VTU file; empty where VTK cannot make it.
std::string vtu_text(const GridView& mesh, const VtuFields& fields) {
  vtkNew<vtkUnstructuredGrid> grid;
  set_points(mesh, fields.displacement, *grid);
  set_cells(mesh, *grid);
  add_fields(mesh, fields, *grid);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt32();
  writer->SetIdTypeToInt32();
  writer->WriteToOutputStringOn();
  return writer->Write() == 1 ? writer->GetOutputString() : "";
}

void write_grid(const std::string& path, const GridView& mesh, const VtuFields& fields) {
  // VTK takes threads for the ranges of arrays, which cost more than they gain. The choice is one of the whole process:
  // one writer at a time, and the choice of before afterwards.
  static std::mutex mutex;
  std::string text;
  {
    const std::lock_guard<std::mutex> lock(mutex);
    vtkSMPTools::LocalScope({1, "Sequential", false}, [&] { text = vtu_text(mesh, fields); });
  }
  if (text.empty()) throw RunError(path + ": cannot be made");
  replace_file(path, text, Reach::system);
}

}  // namespace

void write_vtu(const std::string& path, const Mesh& mesh, const VtuFields& fields) {
  write_grid(path, view_of(mesh), fields);
}

void write_vtu(const std::string& path, const HexMesh& mesh, const VtuFields& fields) {
  write_grid(path, view_of(mesh), fields);
}

void write_vtu(const std::string& path, const PrismMesh& mesh, const VtuFields& fields) {
  write_grid(path, view_of(mesh), fields);
}

namespace {

std::string xml_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += c;
  }
  return escaped;
}

}  // namespace

void PvdCollection::append(const Entry& entry) {
  lines_ += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", entry.time,
                        xml_text(entry.file));
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
  replace_file(path_,
               "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n" + lines_ +
                   "  </Collection>\n</VTKFile>\n",
               Reach::system);
}

}  // namespace parison::core
