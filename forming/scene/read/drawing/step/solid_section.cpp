// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/step/solid_section.hpp"

#include <fmt/format.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Ax1.hxx>
#include <gp_Ax3.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>
#include <optional>
#include <vector>

namespace parison::forming {
namespace {

/// Surfaces of revolution about one line.
struct CommonAxis {
  gp_Ax1 axis;
  double area;  ///< mm2
};

std::optional<gp_Ax1> axis_of(const BRepAdaptor_Surface& surface) {
  switch (surface.GetType()) {
    case GeomAbs_Cylinder:
      return surface.Cylinder().Axis();
    case GeomAbs_Cone:
      return surface.Cone().Axis();
    case GeomAbs_Torus:
      return surface.Torus().Axis();
    case GeomAbs_SurfaceOfRevolution:
      return surface.AxeOfRevolution();
    default:
      return {};
  }
}

std::vector<CommonAxis> axes_of(const TopoDS_Shape& solids) {
  constexpr double same = 1e-4;  // mm; rad
  std::vector<CommonAxis> axes;
  for (TopExp_Explorer face(solids, TopAbs_FACE); face.More(); face.Next()) {
    const auto axis = axis_of(BRepAdaptor_Surface(TopoDS::Face(face.Current())));
    if (!axis) continue;
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face.Current(), properties);
    bool found = false;
    for (CommonAxis& common : axes)
      if (common.axis.IsParallel(*axis, same) && gp_Lin(common.axis).Distance(axis->Location()) < same) {
        common.area += properties.Mass();
        found = true;
        break;
      }
    if (!found) axes.push_back({*axis, properties.Mass()});
  }
  return axes;
}

/// The direction of "x", "-y" and so on; none for anything else.
std::optional<gp_Dir> direction_of(const std::string& axis) {
  const bool is_negative = !axis.empty() && axis.front() == '-';
  const std::string name = axis.substr(is_negative ? 1 : 0);
  if (name != "x" && name != "y" && name != "z") return {};
  const double sign = is_negative ? -1 : 1;
  return gp_Dir(name == "x" ? sign : 0, name == "y" ? sign : 0, name == "z" ? sign : 0);
}

/// The axis of revolution with the largest area, of those along the one asked for, its direction that one or positive;
/// without any, the axis asked for through the origin.
std::optional<gp_Ax1> find_axis(const TopoDS_Shape& solids, const std::string& asked) {
  constexpr double same = 1e-4;  // rad
  const auto direction = direction_of(asked);
  std::optional<CommonAxis> best;
  for (const CommonAxis& common : axes_of(solids))
    if ((!direction || common.axis.Direction().IsParallel(*direction, same)) && (!best || common.area > best->area))
      best = common;
  if (!best && direction) return gp_Ax1(gp_Pnt(0, 0, 0), *direction);
  if (!best) return {};
  gp_Dir along = direction.value_or(best->axis.Direction());
  if (!direction) {
    const double x = along.X(), y = along.Y(), z = along.Z();
    const double largest = std::abs(z) > 0.5 ? z : std::abs(y) > 0.5 ? y : x;
    if (largest < 0) along.Reverse();
  }
  return gp_Ax1(best->axis.Location(), along);
}

/// The frame of a section: its origin the foot of that of the file on the axis, z along the axis, x into the half
/// plane. A body around the whole axis is cut on the side of x (of y about x, of z about y); a part of one in its
/// middle.
gp_Ax3 frame_of(const TopoDS_Shape& solids, const gp_Ax1& axis, double turn) {
  GProp_GProps volume;
  BRepGProp::VolumeProperties(solids, volume);
  const gp_Dir z = axis.Direction();
  const gp_Pnt foot = axis.Location().Translated(gp_Vec(z) * gp_Vec(axis.Location(), gp_Pnt(0, 0, 0)).Dot(gp_Vec(z)));
  const gp_Vec to_centre(foot, volume.CentreOfMass());
  const gp_Vec across = to_centre - gp_Vec(z) * to_centre.Dot(gp_Vec(z));
  Bnd_Box box;
  BRepBndLib::Add(solids, box);
  constexpr double off_axis = 0.02;  // of the size: the half of a body has its centre of mass further out
  const double x = std::abs(z.X()), y = std::abs(z.Y());
  gp_Dir sideways = x > 0.5 ? gp_Dir(0, 1, 0) : y > 0.5 ? gp_Dir(0, 0, 1) : gp_Dir(1, 0, 0);
  if (across.Magnitude() > off_axis * std::sqrt(box.SquareExtent())) sideways = gp_Dir(across);
  gp_Ax3 frame(foot, z, sideways);
  frame.Rotate(gp_Ax1(foot, z), turn);
  return frame;
}

/// The common part of a shape and a face of a plane between radii; null where there is none.
TopoDS_Shape common_part(const TopoDS_Shape& shape, const gp_Pln& plane, double inner, double reach) {
  BRepAlgoAPI_Common common(shape, BRepBuilderAPI_MakeFace(plane, inner, reach, -reach, reach).Face());
  const bool has_faces =
      common.IsDone() && !common.Shape().IsNull() && TopExp_Explorer(common.Shape(), TopAbs_FACE).More();
  return has_faces ? common.Shape() : TopoDS_Shape();
}

/// The section of a solid by the half plane at positive radii: the kernel loses parts in which the axis runs on a half
/// plane that begins there, so the section by the whole plane is halved.
TopoDS_Shape half_section(const TopoDS_Shape& solids, const gp_Pln& plane, double reach) {
  const TopoDS_Shape whole = common_part(solids, plane, -reach, reach);
  return whole.IsNull() ? whole : common_part(whole, plane, 0, reach);
}

/// What bounds the parts of a section outside; `text` tells the holes that are left out, such as cooling bores.
TopoDS_Shape outside_of(const TopoDS_Shape& section, std::string& text) {
  TopoDS_Compound outside;
  BRep_Builder builder;
  builder.MakeCompound(outside);
  int holes = 0;
  for (TopExp_Explorer face(section, TopAbs_FACE); face.More(); face.Next()) {
    builder.Add(outside, BRepTools::OuterWire(TopoDS::Face(face.Current())));
    for (TopExp_Explorer wire(face.Current(), TopAbs_WIRE); wire.More(); wire.Next()) ++holes;
    --holes;
  }
  if (holes > 0) text += fmt::format("note holes in the section of the solid were left out, {} in all\n", holes);
  return outside;
}

}  // namespace

std::optional<gp_Ax3> frame_of_cut(const TopoDS_Shape& solids, const StepCut& cut, std::string& text) {
  if (const auto axis = find_axis(solids, cut.axis)) return frame_of(solids, *axis, cut.turn);
  text =
      "refuse a solid without any surface of revolution was found, allowed are solids around an axis, or axis with "
      "the direction of one through the origin";
  return {};
}

TopoDS_Shape section_of_solid(const TopoDS_Shape& solids, const StepCut& cut, std::string& text) {
  const auto asked = frame_of_cut(solids, cut, text);
  if (!asked) return {};
  // The kernel finds no section in a plane that a seam of the faces or a side of the solid lies in.
  constexpr double off_seam = 1e-5;  // rad
  const gp_Ax3 frame = asked->Rotated(asked->Axis(), off_seam);
  Bnd_Box box;
  BRepBndLib::Add(solids, box);
  const double reach = 2 * std::sqrt(box.SquareExtent()) + gp_Pnt(0, 0, 0).Distance(frame.Location());
  // A plane whose first direction is the radius and whose second one is the axis.
  const gp_Pln plane(gp_Ax3(frame.Location(), frame.YDirection().Reversed(), frame.XDirection()));
  const TopoDS_Shape section = half_section(solids, plane, reach);
  if (section.IsNull()) {
    text =
        "refuse the half plane from the axis of the solid meets no glass or metal, allowed is a turn about the axis at "
        "which it does";
    return {};
  }
  const gp_Dir z = frame.Direction(), x = asked->XDirection();
  const gp_Pnt o = frame.Location();
  text += fmt::format(
      "note a solid was cut from its axis along ({:.4g}, {:.4g}, {:.4g}) through ({:.6g}, {:.6g}, {:.6g}) mm "
      "to the side of ({:.4g}, {:.4g}, {:.4g})\n",
      z.X(), z.Y(), z.Z(), o.X(), o.Y(), o.Z(), x.X(), x.Y(), x.Z());
  gp_Trsf to_frame;
  to_frame.SetTransformation(frame);
  return BRepBuilderAPI_Transform(outside_of(section, text), to_frame, true).Shape();
}

}  // namespace parison::forming
