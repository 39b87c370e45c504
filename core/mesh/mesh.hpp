#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/point.hpp"

namespace parison::core {

/// What a unit of cross-section area represents: a ring of circumference 2 pi r, or a slab 1 m deep.
enum class Geometry { planar, axisymmetric };

/// What a part of a body's boundary does.
enum class BoundaryKind {
  contact,      ///< may touch other bodies; air and pressure of the stage where it does not
  symmetry,     ///< axis or symmetry plane: no normal motion, no heat
  fixed,        ///< zero velocity, no heat flux
  cooled,       ///< its own exchange in every stage
  insulated,    ///< free, no heat
  temperature,  ///< given temperature
  air           ///< never in contact; the stage's air acts on it
};

/// A named part of a mesh's boundary.
struct MeshBoundary {
  std::string name;
  BoundaryKind kind = BoundaryKind::contact;

  MeshBoundary(std::string its_name, BoundaryKind its_kind = BoundaryKind::contact)
      : name(std::move(its_name)), kind(its_kind) {}
  MeshBoundary(const char* its_name) : name(its_name) {}
  bool operator==(const MeshBoundary& other) const { return name == other.name && kind == other.kind; }
};

/// Boundary edge of a cell, the body on its left: nodes first, last, mid-side.
struct BoundaryEdge {
  std::array<Index, 3> nodes;
  Index cell;
  Index boundary_id;  ///< index into Topology::boundaries
};

/// How the nodes of a mesh are joined.
struct Topology {
  Index vertex_count = 0;                    ///< nodes [0, vertex_count) are vertices
  std::vector<std::array<Index, 6>> cells;   ///< vertices 0 1 2 counterclockwise, then mid-sides of 01, 12, 20
  std::vector<BoundaryEdge> boundary_edges;  ///< chained: edge i+1 starts where edge i ends, loop by loop
  std::vector<MeshBoundary> boundaries;
};

/// Quadratic isoparametric triangles: coordinates of its own, and a topology that copies of the mesh share. A copy of a
/// mesh costs its coordinates alone. The vertices are numbered before the mid-side nodes.
class Mesh {
 public:
  std::vector<Point> nodes;  ///< m

  const Topology& topology() const { return *topology_; }
  Index vertex_count() const { return topology_->vertex_count; }
  const std::vector<std::array<Index, 6>>& cells() const { return topology_->cells; }
  const std::vector<BoundaryEdge>& boundary_edges() const { return topology_->boundary_edges; }
  const std::vector<MeshBoundary>& boundaries() const { return topology_->boundaries; }
  /// What the boundary does to which an edge belongs.
  BoundaryKind kind_of(const BoundaryEdge& edge) const { return topology_->boundaries[edge.boundary_id].kind; }
  Index node_count() const { return static_cast<Index>(nodes.size()); }
  Index cell_count() const { return static_cast<Index>(cells().size()); }

  /// The topology to be changed; meshes that shared it until now keep the old one.
  Topology& edit();
  bool shares_topology(const Mesh& other) const { return topology_ == other.topology_; }

 private:
  std::shared_ptr<Topology> topology_ = std::make_shared<Topology>();
};

/// The boundary edges after and before each one in its loop, as indices.
struct BoundaryChain {
  std::vector<Index> next, previous;
  explicit BoundaryChain(const Mesh& mesh);
};

/// Flags of the boundaries of one kind.
std::vector<bool> boundaries_of_kind(const Mesh& mesh, BoundaryKind kind);

/// Index of a boundary by name, -1 when the mesh has none of that name.
Index find_boundary(const Mesh& mesh, const std::string& name);

/// A quadratic mesh from straight-sided triangles: adds mid-side nodes and the chained boundary (boundary 0,
/// "boundary"). Triangles must be counterclockwise.
Mesh make_quadratic_mesh(const std::vector<Point>& vertices, const std::vector<std::array<Index, 3>>& triangles);

/// Nodal field from values at the vertices: the value of a mid-side node is the mean of its ends.
Eigen::VectorXd from_vertices(const Mesh& mesh, const Eigen::VectorXd& vertex_values);

/// Size of the body, m: the diagonal of the box around its nodes.
double size(const Mesh& mesh);
/// Volume of the body, m3 (of the full revolution, or per metre of depth times 1 m).
double volume(const Mesh& mesh, Geometry geometry);
/// Section of the body over half its outline, m: the thickness of a wall, the radius of a drop.
double mean_wall(const Mesh& mesh);
/// Integral of a function of a P2 field over the volume by triangle_rule(4), the function's unit times m3.
double integral(const Mesh& mesh, Geometry geometry, const Eigen::VectorXd& nodal,
                const std::function<double(double)>& function);
/// The same of a function of two fields.
double integral(const Mesh& mesh, Geometry geometry, const Eigen::VectorXd& first, const Eigen::VectorXd& second,
                const std::function<double(double, double)>& function);
/// Volume mean of a nodal field.
double volume_mean(const Mesh& mesh, Geometry geometry, const Eigen::VectorXd& nodal);

}  // namespace parison::core
