#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <optional>
#include <vector>

#include "core/mesh/profile.hpp"
#include "forming/scene/read/drawing/dxf/dxf_file.hpp"
#include "forming/scene/read/drawing/placement.hpp"

// The entities of a DXF file as lines and arcs; private to the reading of drawings.

namespace parison::forming {

/// How far a curve goes round from one angle to another, above zero and up to a `turn`, which is in the same unit:
/// whole turns do not count, but no way at all is a whole turn, as is one that rounded decimals make a hair longer.
/// Refuses more than ten turns.
double sweep_of(const DxfFile& file, const DxfEntity& entity, double from, double to, double turn);

/// The arcs that stand for an ELLIPSE or a SPLINE, m; `unit` of a drawing unit in m.
std::vector<core::Segment> dxf_ellipse(const DxfFile& file, const DxfEntity& entity, double unit);
std::vector<core::Segment> dxf_spline(const DxfFile& file, const DxfEntity& entity, double unit);

/// The curves of the wanted entities, one entity after the other.
class DxfCurves {
 public:
  explicit DxfCurves(const DxfFile& file) : file_(file) {}

  double unit = 1;        ///< of a drawing unit, m; to be set before the first entity
  core::Index layer = 0;  ///< of the curves that follow: their boundary_id

  void add(const DxfEntity& entity);
  /// Refuses what is not parallel to the plane of x and y: its shape would be that of its shadow.
  void require_flat(const DxfEntity& entity) const;
  /// Moves the curves from one on, as where a block is inserted.
  void place(std::size_t first, const Placement& placement);
  /// Refuses a polyline whose end has not been read.
  void require_end_of_polyline() const;
  std::size_t size() const { return curves_.size(); }
  /// All curves, those of the sides of polylines with their bulges.
  std::vector<core::Segment> all() const;

 private:
  struct Vertex {
    core::Point x;
    double bulge;
  };

  [[noreturn]] void refuse(const DxfEntity& entity, const std::string& message) const;
  double number(const DxfEntity& entity, int code, double otherwise = std::numeric_limits<double>::quiet_NaN()) const;
  /// The largest difference between the values of some groups of an entity, of one of them also from 0.
  double spread(const DxfEntity& entity, const std::vector<int>& codes, bool from_zero = false) const;
  core::Point point(const DxfEntity& entity, int x, int y) const;

  void add_curve(const core::Segment& curve, double bulge);
  void add_all(const std::vector<core::Segment>& arcs);
  void add_line(const core::Point& start, const core::Point& end, double bulge = 0);
  void add_arc(const DxfEntity& entity, double from, double sweep);
  void add_bulge(const DxfEntity& entity, const Vertex& from, const core::Point& end);
  void begin_polyline(const DxfEntity& entity);
  void add_light_vertices(const DxfEntity& entity);
  void end_polyline(const DxfEntity& entity);
  /// Reflects the curves from one on where their entity is drawn in a plane that is seen from behind.
  void turn_to_front(const DxfEntity& entity, std::size_t first);

  const DxfFile& file_;
  std::vector<core::Segment> curves_;
  std::vector<double> bulges_;     ///< of the curves: 0 but for bent sides of polylines, which are still lines
  std::vector<Vertex> vertices_;   ///< of the polyline being read
  std::optional<DxfEntity> open_;  ///< a polyline whose end has not been read
  bool closed_ = false;
};

}  // namespace parison::forming
