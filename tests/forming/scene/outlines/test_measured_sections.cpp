// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmsh.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../../scene_text.hpp"
#include "contact/solid/section_surface.hpp"
#include "core/io/files.hpp"
#include "figure.hpp"

namespace parison::forming {
namespace {

constexpr double mm = 1e-3;
constexpr double deflection = 2e-3 / 30;  // of the triangles of a solid, over the half width of the hole
namespace occ = gmsh::model::occ;

/// The face of a square of 60 mm with round corners at a height, mm.
int rounded_square(double z, double corner) {
  constexpr double half = 30;
  const double side = half - corner;
  std::vector<int> curves;
  for (int i = 0; i < 4; ++i) {
    const auto turned = [&](double x, double y) {
      const double c = std::round(std::cos(i * M_PI_2)), s = std::round(std::sin(i * M_PI_2));
      return occ::addPoint(c * x - s * y, s * x + c * y, z);
    };
    curves.push_back(occ::addLine(turned(half, -side), turned(half, side)));
    curves.push_back(occ::addCircleArc(turned(half, side), turned(side, side), turned(side, half)));
  }
  return occ::addPlaneSurface({occ::addCurveLoop(curves)});
}

/// A half of a mould on the side of x, of 60 mm radius and 100 mm height, with a square hole of 70 mm depth that is off
/// the axis by `aside`, mm.
std::string mould_half(const std::string& name, double aside = 0, double width = 200, double corner = 12) {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::model::add(name);
  gmsh::vectorpair hole, half, map_to;
  std::vector<gmsh::vectorpair> map;
  occ::extrude({{2, rounded_square(0, corner)}}, 0, 0, 70, hole);
  occ::translate({hole[1]}, 0, aside, 0);
  occ::cut({{3, occ::addCylinder(0, 0, 0, 0, 0, 100, 60)}}, {hole[1]}, half, map);
  occ::intersect(half, {{3, occ::addBox(0, -width / 2, -10, 200, width, 200)}}, map_to, map);
  occ::remove(gmsh::vectorpair(), true);
  occ::synchronize();
  core::write_text(write_scene(small_scene) + "/" + name, "");
  gmsh::write(write_scene(small_scene) + "/" + name);
  gmsh::clear();
  return name;
}

/// The small scene with a mould of the hole's outline and the sections of a file.
std::string with_mould(const std::string& section) {
  return replaced("[[interface]]\n",
                  "[[tool]]\nname = \"mould\"\nmaterial = \"iron\"\ntemperature = \"400 degC\"\nfriction = \"slip\"\n"
                  "position = \"200 mm\"\nsection = " +
                      section +
                      "\nboundary = [\n"
                      "{ name = \"inner\", condition = \"contact\", path = \"(30, 0) (30, 70) (0, 70) mm\" },\n"
                      "{ name = \"axis\", condition = \"symmetry\", path = \"(0, 100) mm\" },\n"
                      "{ name = \"outer\", condition = \"insulated\", path = \"(60, 100) (60, 0) (30, 0) mm\" } ]\n"
                      "[[interface]]\n");
}

std::string of_file(const std::string& name, const std::string& more = "") {
  return "{ file = \"" + name + "\", axis = \"z\"" + more + " }";
}

Tool mould_of(const std::string& section) {
  return scene_of(with_mould(section)).tools.back();
}

void expect_refused(const std::string& text, const std::string& sentence) {
  const std::string said = complaint_about(text);
  EXPECT_NE(said.find(sentence), said.npos) << said;
}

TEST(MeasuredSections, a_mould_half_has_the_sections_it_was_made_with) {
  const Tool measured = mould_of(of_file(mould_half("mould.step")));
  core::SectionFamily drawn;
  drawn.corner = core::constant(12.0 / 30);
  const contact::SectionSurface found(measured.profile, contact_boundaries(measured), measured.section),
      exact(measured.profile, contact_boundaries(measured), drawn);
  tests::Figure gap("gap to the sections of a solid against those it was made with, m");
  tests::Figure normal("normal of these sections against the exact one");
  for (double angle = 0.013; angle < 2 * M_PI; angle += 0.029)
    for (const double height : {3.0, 33.3, 66.0}) {
      const double far = (core::reach(drawn, {1, 0}, angle) * 30 - 1) * mm;
      const core::Vector3 at(far * std::cos(angle), far * std::sin(angle), height * mm);
      const auto a = found.gap(at), b = exact.gap(at);
      gap.add(std::abs(a.distance - b.distance));
      normal.add((a.normal - b.normal).norm());
    }
  gap.at_most(2e-6);
  normal.at_most(0.02);
  EXPECT_NEAR(core::area_factor(measured.section, 0.02), core::area_factor(drawn, 0.02), 2 * deflection);
  ASSERT_EQ(measured.drawing_notes.size(), 1u);
}

TEST(MeasuredSections, the_place_along_the_axis_is_that_of_the_origin) {
  const Tool measured =
      mould_of("{ file = \"" + mould_half("mould.step") + "\", axis = \"-z\", origin = \"(0, -70) mm\" }");
  EXPECT_NEAR(core::reach(measured.section, {0.03, 0.035}, M_PI_4), (18 * std::sqrt(2.0) + 12) / 30, deflection);
}

TEST(MeasuredSections, a_solid_with_other_corners_makes_another_case) {
  const auto fingerprint = [](double corner) {
    return scene_of(with_mould(of_file(mould_half("mould.step", 0, 200, corner)))).fingerprint;
  };
  EXPECT_EQ(fingerprint(12), fingerprint(12));
  EXPECT_NE(fingerprint(12), fingerprint(11.9));
}

TEST(MeasuredSections, cavities_that_are_none_are_refused) {
  expect_refused(with_mould(of_file(mould_half("aside.step", 0.2))), "two planes of symmetry");
  expect_refused(with_mould(of_file(mould_half("narrow.step", 0, 40))), "no wall of the cavity was found at z = ");
  expect_refused(with_mould(of_file(mould_half("mould.step"), ", turn = \"45 deg\"")), "away from its outline");
  expect_refused(with_mould(of_file(mould_half("mould.step"), ", half_depth = \"20 mm\"")), "half_depth");
  expect_refused(with_mould("{ origin = \"(0, 0) mm\" }"), "origin");
  expect_refused(with_mould(of_file("missing.step")), "missing.step");
}

}  // namespace
}  // namespace parison::forming
