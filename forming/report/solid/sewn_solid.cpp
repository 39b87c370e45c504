// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>

#include "forming/report/solid/spline_patch.hpp"

namespace parison::forming {
namespace {

constexpr int degree = 3;
constexpr double meeting = 1e-5;  // mm: patches share the control points of their borders but for rounding

gp_Pnt point(const core::Vector3& x) {
  return {x[0], x[1], x[2]};
}

/// Whole numbers as knots: fourfold at the ends, double between them.
struct Knots {
  explicit Knots(int spans) : at(1, spans + 1), multiplicity(1, spans + 1) {
    for (int i = 0; i <= spans; ++i) {
      at(i + 1) = i;
      multiplicity(i + 1) = i == 0 || i == spans ? degree + 1 : 2;
    }
  }
  TColStd_Array1OfReal at;
  TColStd_Array1OfInteger multiplicity;
};

Handle(Geom_BSplineSurface) surface_of(const SplinePatch& patch) {
  const int rows = 2 * patch.spans_u + 2, columns = 2 * patch.spans_v + 2;
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  for (int k = 0; k < rows; ++k)
    for (int l = 0; l < columns; ++l) poles(k + 1, l + 1) = point(patch.control[std::size_t(k * columns + l)]);
  const Knots u(patch.spans_u), v(patch.spans_v);
  return new Geom_BSplineSurface(poles, u.at, v.at, u.multiplicity, v.multiplicity, degree, degree);
}

/// Largest distances of a surface from places, mm: from those at knots, and across it from those between them.
struct Distances {
  double nodes = 0, between = 0;
  void add(const Geom_BSplineSurface& surface, const std::vector<PatchPlace>& places) {
    for (const PatchPlace& place : places) {
      gp_Pnt at;
      gp_Vec along_u, along_v;
      surface.D1(place.u, place.v, at, along_u, along_v);
      const gp_Vec away(at, point(place.at)), normal = along_u.Crossed(along_v);
      if (place.u == std::floor(place.u) && place.v == std::floor(place.v))
        nodes = std::max(nodes, away.Magnitude());
      else if (normal.Magnitude() > 0)
        between = std::max(between, std::abs(away.Dot(normal)) / normal.Magnitude());
    }
  }
};

}  // namespace

extern "C" void parison_sew_solid(const std::string& path, const std::vector<SplinePatch>& patches, std::string& told) {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
  BRepBuilderAPI_Sewing sewing(meeting);
  Distances distances;
  for (const SplinePatch& patch : patches) {
    const Handle(Geom_BSplineSurface) surface = surface_of(patch);
    distances.add(*surface, patch.places);
    sewing.Add(BRepBuilderAPI_MakeFace(surface, meeting));
  }
  sewing.Perform();
  if (sewing.NbFreeEdges() > 0 || sewing.SewedShape().ShapeType() != TopAbs_SHELL) {
    told = fmt::format("refuse {} edges of the surface stay open", sewing.NbFreeEdges());
    return;
  }
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape()));
  GProp_GProps properties;
  BRepLib::OrientClosedSolid(solid);
  BRepGProp::VolumeProperties(solid, properties);
  if (!BRepCheck_Analyzer(solid).IsValid() || properties.Mass() <= 0) {
    told = "refuse its surface crosses itself";
    return;
  }
  STEPControl_Writer writer;
  if (writer.Transfer(solid, STEPControl_AsIs) != IFSelect_RetDone || writer.Write(path.c_str()) != IFSelect_RetDone)
    told = "refuse no file could be written";
  else
    told = fmt::format("{} {} {}", properties.Mass(), distances.nodes, distances.between);
}

}  // namespace parison::forming
