// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/step_curves.hpp"

#include <fmt/core.h>
#include <gmsh.h>

#include <cmath>
#include <vector>

#include "forming/scene/read/drawing/read_section.hpp"

namespace parison::forming {
namespace {

constexpr double step_unit = 1e-3;  // what the reader of STEP files converts every file to, m

Space place(int tag, double parameter) {
  std::vector<double> x;
  gmsh::model::getValue(1, tag, {parameter}, x);
  return {step_unit * x[0], step_unit * x[1], step_unit * x[2]};
}

Space rate(int tag, double parameter, double scale) {
  std::vector<double> derivative;
  gmsh::model::getDerivative(1, tag, {parameter}, derivative);
  return {scale * step_unit * derivative[0], scale * step_unit * derivative[1], scale * step_unit * derivative[2]};
}

/// A circle comes as two halves, so that every arc has two ends; splines and other curves come in parts so short that
/// cubics stand for them.
void add_curve(int tag, const std::string& type, std::vector<StepCurve>& curves) {
  constexpr int cubics = 64;
  const auto kind = type == "Line"     ? StepCurve::Kind::line
                    : type == "Circle" ? StepCurve::Kind::arc
                                       : StepCurve::Kind::part;
  std::vector<double> low, high;
  gmsh::model::getParametrizationBounds(1, tag, low, high);
  const double range = high[0] - low[0];
  const int parts = kind == StepCurve::Kind::part ? cubics : kind == StepCurve::Kind::arc && range > M_PI ? 2 : 1;
  for (int i = 0; i < parts; ++i) {
    const auto at = [&](double fraction) { return low[0] + (i + fraction) / parts * range; };
    curves.push_back({kind, place(tag, at(0)), place(tag, at(0.5)), place(tag, at(1))});
    if (kind != StepCurve::Kind::part) continue;
    curves.back().start_rate = rate(tag, at(0), range / parts);
    curves.back().end_rate = rate(tag, at(1), range / parts);
  }
}

/// Why the curves of a file are no section; empty where they may be one.
std::string refusal(const std::string& path, std::size_t solids, std::size_t curves) {
  if (solids > 0)
    return fmt::format("refuse \"{}\" contains a solid, allowed is a section: curves or a plane face", path);
  if (curves == 0)
    return fmt::format("refuse no curves were found in \"{}\", allowed is a STEP file with a section", path);
  if (curves > max_segments)
    return fmt::format("refuse {} curves were found in \"{}\", allowed are up to {}", curves, path, max_segments);
  return {};
}

}  // namespace

extern "C" void parison_find_curves(const std::string& path, std::string& text) {
  gmsh::vectorpair found, solids;
  gmsh::model::occ::importShapes(path, found, false, "step");
  gmsh::model::occ::synchronize();
  gmsh::model::getEntities(solids, 3);
  gmsh::model::getEntities(found, 1);
  text = refusal(path, solids.size(), found.size());
  if (!text.empty()) return;
  std::vector<StepCurve> curves;
  for (const auto& [dimension, tag] : found) {
    std::string kind;
    gmsh::model::getType(dimension, tag, kind);
    add_curve(tag, kind, curves);
  }
  for (const StepCurve& curve : curves) {
    text += step_curve_kinds[static_cast<std::size_t>(curve.kind)];
    for (const Space& x : {curve.start, curve.mid, curve.end, curve.start_rate, curve.end_rate})
      text += fmt::format(" {} {} {}", x[0], x[1], x[2]);
    text += '\n';
  }
}

}  // namespace parison::forming
