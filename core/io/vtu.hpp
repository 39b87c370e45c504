#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "core/solid/hex_mesh.hpp"
#include "core/solid/prism_mesh.hpp"

namespace parison::core {

/// Values at the nodes of a mesh: one a node, or one for each coordinate for a vector (written with three).
struct NodalField {
  std::string name;
  Eigen::VectorXd values;
};
/// One value for all cells.
struct CellConstant {
  std::string name;
  double value;
};

struct VtuFields {
  double time = 0;                     ///< s, written as TimeValue
  Point displacement = Point::Zero();  ///< added to the nodes, m
  std::vector<NodalField> nodal;
  std::vector<CellConstant> cell;
};

/// Writes quadratic triangles to a .vtu file: binary, values in single precision, points in mm, which the file says in
/// its field data LengthUnit.
void write_vtu(const std::string& path, const Mesh& mesh, const VtuFields& fields);
/// The same of meshes in space: hexahedra with 27 nodes, prisms with 18.
void write_vtu(const std::string& path, const HexMesh& mesh, const VtuFields& fields);
void write_vtu(const std::string& path, const PrismMesh& mesh, const VtuFields& fields);

/// Of the 27 nodes of a hexahedron in a .vtu file, which of HexMesh::cells each is.
const std::array<int, HexMesh::nodes_per_cell>& vtu_order_of_hex();

/// A ParaView collection (.pvd): the files of a time series. It is written whole at each addition, so that it can be
/// opened during a run.
class PvdCollection {
 public:
  struct Entry {
    double time;  ///< s
    std::string file;
  };

  explicit PvdCollection(std::string path) : path_(std::move(path)) {}
  /// `file` is relative to the collection's folder; time in s.
  void add(double time, const std::string& file);
  /// Has these entries and no others.
  void set(const std::vector<Entry>& entries);

 private:
  void append(const Entry& entry);
  void write() const;

  std::string path_, lines_;
};

}  // namespace parison::core
