// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>

#include "core/files.hpp"

namespace parison::core {
namespace {

constexpr int vtk_dim = 3;
constexpr std::uint8_t quadratic_triangle = 22;  // VTK_QUADRATIC_TRIANGLE

/// A finite value that single precision cannot hold becomes the nearest that it can.
float single(double value) {
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(value > largest ? largest : value < -largest ? -largest : value);
}

/// The arrays of a file, each after its length in bytes, and the elements that say where they are.
class Arrays {
 public:
  template <typename Value>
  std::string add(const char* type, const std::string& name, const std::vector<Value>& values, int components = 1) {
    const auto size = static_cast<std::uint32_t>(values.size() * sizeof(Value));
    const std::size_t offset = data_.size();
    data_.append(reinterpret_cast<const char*>(&size), sizeof size);
    data_.append(reinterpret_cast<const char*>(values.data()), size);
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" NumberOfTuples=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type, name, components, values.size() / components, offset);
  }
  const std::string& data() const { return data_; }

 private:
  std::string data_;
};

std::string add_points(const Mesh& mesh, const Point& displacement, Arrays& arrays) {
  std::vector<float> points(vtk_dim * mesh.nodes.size(), 0);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    for (int k = 0; k < dim; ++k) points[vtk_dim * i + k] = single(mesh.nodes[i][k] + displacement[k]);
  return "<Points>\n" + arrays.add("Float32", "Points", points, vtk_dim) + "</Points>\n";
}

std::string add_cells(const Mesh& mesh, Arrays& arrays) {
  std::vector<std::int32_t> nodes, ends;
  nodes.reserve(6 * mesh.cells.size());
  ends.reserve(mesh.cells.size());
  for (const auto& cell : mesh.cells) {
    nodes.insert(nodes.end(), cell.begin(), cell.end());
    ends.push_back(static_cast<std::int32_t>(nodes.size()));
  }
  const std::vector<std::uint8_t> kinds(mesh.cells.size(), quadratic_triangle);
  return "<Cells>\n" + arrays.add("Int32", "connectivity", nodes) + arrays.add("Int32", "offsets", ends) +
         arrays.add("UInt8", "types", kinds) + "</Cells>\n";
}

std::string add_nodal(const Mesh& mesh, const NodalField& field, Arrays& arrays) {
  const bool is_vector = field.values.size() != mesh.node_count();
  assert(!is_vector || field.values.size() == dim * mesh.node_count());
  const int from = is_vector ? dim : 1, to = is_vector ? vtk_dim : 1;
  std::vector<float> values(static_cast<std::size_t>(to) * mesh.node_count(), 0);
  for (Index i = 0; i < mesh.node_count(); ++i)
    for (int k = 0; k < from; ++k) values[to * i + k] = single(field.values[from * i + k]);
  return arrays.add("Float32", field.name, values, to);
}

std::string add_fields(const Mesh& mesh, const VtuFields& fields, Arrays& arrays) {
  const bool has_scalar = !fields.nodal.empty() && fields.nodal[0].values.size() == mesh.node_count();
  std::string text = has_scalar ? fmt::format("<PointData Scalars=\"{}\">\n", fields.nodal[0].name) : "<PointData>\n";
  for (const NodalField& field : fields.nodal) text += add_nodal(mesh, field, arrays);
  text += "</PointData>\n<CellData>\n";
  for (const CellConstant& field : fields.cell)
    text += arrays.add("Float32", field.name, std::vector<float>(mesh.cells.size(), single(field.value)));
  return text + "</CellData>\n";
}

}  // namespace

void write_vtu(const std::string& path, const Mesh& mesh, const VtuFields& fields) {
  constexpr bool little = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__;
  Arrays arrays;
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" "
      "header_type=\"UInt32\">\n<UnstructuredGrid>\n<FieldData>\n",
      little ? "LittleEndian" : "BigEndian");
  text += arrays.add("Float64", "TimeValue", std::vector<double>{fields.time});
  text += fmt::format("</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", mesh.nodes.size(),
                      mesh.cells.size());
  text += add_fields(mesh, fields, arrays) + add_points(mesh, fields.displacement, arrays) + add_cells(mesh, arrays);
  text += "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  write_text(path, text + arrays.data() + "\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace parison::core
