// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/step/step_curves.hpp"

#include <fmt/format.h>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <gp_Trsf.hxx>
#include <optional>
#include <utility>

#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/drawing/step/solid_section.hpp"

namespace parison::forming {
namespace {

constexpr double step_unit = 1e-3;  // what the reader of STEP files converts every file to, m

std::string text_of(const gp_Pnt& x) {
  return fmt::format(" {} {} {}", step_unit * x.X(), step_unit * x.Y(), step_unit * x.Z());
}

/// A circle comes as two halves, so that every arc has two ends.
std::string arcs_text(const GeomAdaptor_Curve& curve) {
  const double first = curve.FirstParameter(), range = curve.LastParameter() - first;
  const int parts = range > M_PI ? 2 : 1;
  std::string text;
  for (int i = 0; i < parts; ++i) {
    text += "arc";
    for (const double t : {0.0, 0.5, 1.0}) text += text_of(curve.Value(first + (i + t) / parts * range));
    text += '\n';
  }
  return text;
}

/// A curve of any other kind as the rational B-spline that it is.
std::string spline_text(const Handle(Geom_Curve) & curve, double first, double last) {
  const Handle(Geom_BSplineCurve) spline =
      GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, first, last), Convert_QuasiAngular);
  if (spline->IsPeriodic()) spline->SetNotPeriodic();
  std::string text = fmt::format("spline {} {}", spline->Degree(), spline->NbPoles());
  for (int i = 1; i <= spline->NbPoles(); ++i)
    text += fmt::format("{} {}", text_of(spline->Pole(i)), spline->Weight(i));
  for (int i = 1; i <= spline->NbKnots(); ++i)
    for (int k = 0; k < spline->Multiplicity(i); ++k) text += fmt::format(" {}", spline->Knot(i));
  return text + '\n';
}

std::string text_of(const TopoDS_Edge& edge) {
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  if (curve.IsNull() || BRep_Tool::Degenerated(edge)) return "";
  const GeomAdaptor_Curve known(curve, first, last);
  if (known.GetType() == GeomAbs_Line)
    return fmt::format("line{}{}\n", text_of(known.Value(first)), text_of(known.Value(last)));
  if (known.GetType() == GeomAbs_Circle) return arcs_text(known);
  return spline_text(curve, first, last);
}

/// A face of a solid as triangles, in another frame.
std::string triangles_text(const TopoDS_Face& face, const gp_Trsf& to_frame) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, location);
  if (triangulation.IsNull()) return "";
  const gp_Trsf placed = to_frame * location.Transformation();
  std::string text;
  for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    triangulation->Triangle(i).Get(a, b, c);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
    text += "triangle";
    for (const int corner : {a, b, c}) text += text_of(triangulation->Node(corner).Transformed(placed));
    text += '\n';
  }
  return text;
}

/// The shapes of a file; null where it has none.
TopoDS_Shape read_shape(const std::string& path) {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) return {};
  reader.TransferRoots();
  return reader.OneShape();
}

}  // namespace

extern "C" void parison_find_curves(const std::string& path, const StepCut& cut, std::string& text) {
  TopoDS_Shape shape = read_shape(path);
  text.clear();
  if (!shape.IsNull() && TopExp_Explorer(shape, TopAbs_SOLID).More()) shape = section_of_solid(shape, cut, text);
  if (text.rfind("refuse", 0) == 0) return;
  TopTools_IndexedMapOfShape edges;
  if (!shape.IsNull()) TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  if (edges.IsEmpty())
    text = fmt::format("refuse no curves were found in \"{}\", allowed is a STEP file with a section or a solid", path);
  else if (edges.Extent() > static_cast<int>(max_segments))
    text =
        fmt::format("refuse {} curves were found in \"{}\", allowed are up to {}", edges.Extent(), path, max_segments);
  else
    for (int i = 1; i <= edges.Extent(); ++i) text += text_of(TopoDS::Edge(edges(i)));
}

extern "C" void parison_find_triangles(const std::string& path, const StepCut& cut, std::string& text) {
  constexpr double deflection = 0.002, angle = 0.05;  // mm; rad: far below what a run resolves
  const TopoDS_Shape shape = read_shape(path);
  text.clear();
  if (shape.IsNull() || !TopExp_Explorer(shape, TopAbs_SOLID).More())
    text = fmt::format("refuse no solid was found in \"{}\", allowed is a STEP file with that of a mould", path);
  const auto frame = text.empty() ? frame_of_cut(shape, cut, text) : std::nullopt;
  if (!frame) return;
  BRepMesh_IncrementalMesh(shape, deflection, false, angle);
  gp_Trsf to_frame;
  to_frame.SetTransformation(*frame);
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    text += triangles_text(TopoDS::Face(face.Current()), to_frame);
}

}  // namespace parison::forming
