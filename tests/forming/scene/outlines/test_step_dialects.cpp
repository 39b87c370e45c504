// SPDX-License-Identifier: GPL-3.0-or-later
// STEP files: B-splines of any degree with weights and knots, and sections of solids.
#include <gmsh.h>
#include <gtest/gtest.h>

#include "drawn_outline.hpp"

namespace parison::tests {
namespace {

namespace occ = gmsh::model::occ;

/// The area in a STEP file with what `draw` adds to an empty model, in mm.
Taken take_step(const std::function<void()>& draw, const std::string& keys) {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::model::add("drawing");
  draw();
  occ::synchronize();
  const auto folder = folder_of_test("drawing");
  std::filesystem::create_directories(folder);
  gmsh::write((folder / "a.step").string());
  gmsh::clear();
  return take("a.step", "", keys);
}

struct SplineDrawn {
  int degree;
  std::vector<Point> points;
  std::vector<double> weights, knots;
  std::vector<int> multiplicities;

  std::vector<double> all_knots() const {
    std::vector<double> all;
    for (std::size_t i = 0; i < knots.size(); ++i)
      all.insert(all.end(), static_cast<std::size_t>(multiplicities[i]), knots[i]);
    return all;
  }
};

/// A basis function by the recursion of M. G. Cox and C. de Boor.
double basis(const std::vector<double>& u, std::size_t i, int degree, double t) {
  if (degree == 0) return t >= u[i] && t < u[i + 1] ? 1 : 0;
  const auto n = static_cast<std::size_t>(degree);
  const double left = u[i + n] - u[i], right = u[i + n + 1] - u[i + 1];
  return (left > 0 ? (t - u[i]) / left * basis(u, i, degree - 1, t) : 0) +
         (right > 0 ? (u[i + n + 1] - t) / right * basis(u, i + 1, degree - 1, t) : 0);
}

Point place_on(const SplineDrawn& spline, double share) {
  const auto u = spline.all_knots();
  const double t = std::min(u.front() + share * (u.back() - u.front()), std::nextafter(u.back(), u.front()));
  Point sum = Point::Zero();
  double weight = 0;
  for (std::size_t i = 0; i < spline.points.size(); ++i) {
    const double b = spline.weights[i] * basis(u, i, spline.degree, t);
    sum += b * spline.points[i], weight += b;
  }
  return sum / weight;
}

/// From (20, 0) to (20, 60) mm, about half of it away from the chord to the right, over uneven knots, some of them
/// double.
SplineDrawn random_spline(int degree, int count, std::mt19937& random) {
  std::uniform_real_distribution<double> part(0, 1);
  SplineDrawn spline{degree, {}, {}, {0}, {degree + 1}};
  for (int i = 0; i < count; ++i) {
    const bool is_end = i == 0 || i == count - 1;
    spline.points.emplace_back(is_end ? 20 : 25 + 15 * part(random), 60.0 * i / (count - 1));
    spline.weights.push_back(is_end ? 1 : 0.5 + part(random));
  }
  for (int inner = count - degree - 1; inner > 0;) {
    const int multiplicity = std::min({inner, degree, 1 + static_cast<int>(random() % 2)});
    spline.knots.push_back(spline.knots.back() + 0.1 + part(random));
    spline.multiplicities.push_back(multiplicity);
    inner -= multiplicity;
  }
  spline.knots.push_back(spline.knots.back() + 1);
  spline.multiplicities.push_back(degree + 1);
  return spline;
}

int add_spline(const SplineDrawn& spline, bool with_weights) {
  std::vector<int> points;
  for (const Point& x : spline.points) points.push_back(occ::addPoint(x[0], x[1], 0));
  return occ::addBSpline(points, -1, spline.degree, with_weights ? spline.weights : std::vector<double>(), spline.knots,
                         spline.multiplicities);
}

TEST(StepDialects, b_splines_of_any_degree_with_knots_and_weights) {
  std::mt19937 random(7);
  for (int degree = 1; degree <= 5; ++degree)
    for (const int count : {degree + 1, 40})
      for (const bool with_weights : {count == 40}) {
        SplineDrawn spline = random_spline(degree, count, random);
        if (!with_weights) spline.weights.assign(spline.weights.size(), 1);
        const Taken taken = take_step(
            [&] {
              add_spline(spline, with_weights);
              const int a = occ::addPoint(20, 60, 0), b = occ::addPoint(5, 60, 0), c = occ::addPoint(5, 0, 0),
                        d = occ::addPoint(20, 0, 0);
              occ::addLine(a, b), occ::addLine(b, c), occ::addLine(c, d);
            },
            from({5, 0}));
        ASSERT_EQ(taken.refusal, "");
        const double area = 15 * 60 + area_of_curve([&](double t) { return place_on(spline, t); });
        EXPECT_NEAR(taken.area / area, 1, 1e-5) << degree << " " << count << " " << with_weights;
        if (degree == 1) {
          EXPECT_EQ(taken.curves, spline.points.size() + 2);
        }
      }
}

/// The outline of a bottle mould's half section in x and z: lines, an arc and a spline; its area without the spline's
/// part is 20 by 60 mm and half a circle less.
struct Section {
  SplineDrawn spline;
  double area;  ///< mm2
};

Section random_section(std::mt19937& random, bool with_spline) {
  Section section{random_spline(3, 9, random), 15 * 60 - 0.5 * M_PI * 25};
  section.spline.weights.assign(section.spline.weights.size(), 1);
  if (with_spline) section.area += area_of_curve([&](double t) { return place_on(section.spline, t); });
  return section;
}

/// Draws it at radii from 5 mm on, with an arc of 5 mm radius cut out above, and turns it by an angle about z.
void draw_solid(const Section& section, bool with_spline, double angle, double start) {
  const auto point = [](double x, double y) { return occ::addPoint(x, y, 0); };
  const int low = point(20, 0), high = point(20, 60), a = point(17, 60), b = point(7, 60), m = point(12, 60),
            bottom = point(12, 55), c = point(5, 60), d = point(5, 0);
  std::vector<int> curves;
  if (with_spline) {
    std::vector<int> points{low};
    for (std::size_t i = 1; i + 1 < section.spline.points.size(); ++i)
      points.push_back(point(section.spline.points[i][0], section.spline.points[i][1]));
    points.push_back(high);
    curves.push_back(occ::addBSpline(points, -1, 3, {}, section.spline.knots, section.spline.multiplicities));
  } else {
    curves.push_back(occ::addLine(low, high));
  }
  curves.push_back(occ::addLine(high, a));
  curves.push_back(occ::addCircleArc(a, m, bottom));
  curves.push_back(occ::addCircleArc(bottom, m, b));
  curves.push_back(occ::addLine(b, c));
  curves.push_back(occ::addLine(c, d));
  curves.push_back(occ::addLine(d, low));
  const int face = occ::addPlaneSurface({occ::addCurveLoop(curves)});
  occ::rotate({{2, face}}, 0, 0, 0, 1, 0, 0, M_PI / 2);  // y becomes z
  occ::rotate({{2, face}}, 0, 0, 0, 0, 0, 1, start);
  gmsh::vectorpair made;
  occ::revolve({{2, face}}, 0, 0, 0, 0, 0, 1, angle, made);
  occ::remove({{2, face}});
}

TEST(StepDialects, the_section_of_a_solid_of_revolution_whole_or_half) {
  std::mt19937 random(11);
  for (const bool with_spline : {false, true})
    for (const double angle : {2 * M_PI, M_PI})
      for (const double start : {angle > 4 ? 0.0 : 0.3}) {
        const Section section = random_section(random, with_spline);
        const Taken taken = take_step([&] { draw_solid(section, with_spline, angle, start); }, from({5, 0}));
        ASSERT_EQ(taken.refusal, "") << with_spline << " " << angle << " " << start;
        EXPECT_NEAR(taken.area / section.area, 1, 1e-5) << with_spline << " " << angle << " " << start;
        ASSERT_EQ(taken.notes.size(), 1) << taken.notes.back();
        EXPECT_NE(taken.notes[0].find("axis along (0, 0, 1)"), std::string::npos) << taken.notes[0];
      }
}

/// A blank with its baffle, turned about z by an angle: a cup of 40 mm with a bore of 20 mm and a round bottom.
void draw_cup(double angle) {
  const auto point = [](double r, double z) { return occ::addPoint(r, 0, z); };
  const int low = point(20, 0), side = point(20, 30), middle = point(0, 30), pole = point(0, 50), top = point(0, 60),
            edge = point(40, 60), foot = point(40, 0);
  const int wire =
      occ::addWire({occ::addLine(low, side), occ::addCircleArc(side, middle, pole), occ::addLine(pole, top),
                    occ::addLine(top, edge), occ::addLine(edge, foot), occ::addLine(foot, low)});
  const int face = occ::addPlaneSurface({wire});
  gmsh::vectorpair made;
  occ::revolve({{2, face}}, 0, 0, 0, 0, 0, 1, angle, made);
  occ::remove({{2, face}});
}

TEST(StepDialects, a_solid_that_closes_around_its_axis) {
  for (const double angle : {2 * M_PI, M_PI}) {
    const Taken taken = take_step([&] { draw_cup(angle); }, from({40, 0}));
    ASSERT_EQ(taken.refusal, "") << angle;
    EXPECT_NEAR(taken.area, 40 * 60 - 20 * 30 - M_PI * 400 / 4, 2e-2) << angle;
  }
}

/// A cup of 40 by 60 mm with a hollow of 20 by 40 mm, turned out of the plane of x and z; with a hole through its wall.
void draw_flat_cup(bool with_hole) {
  std::vector<int> points, lines;
  for (const auto& [r, z] : {std::pair{0, 20}, {20, 20}, {20, 60}, {40, 60}, {40, 0}, {0, 0}})
    points.push_back(occ::addPoint(r, 0, z));
  for (std::size_t i = 0; i < points.size(); ++i)
    lines.push_back(occ::addLine(points[i], points[(i + 1) % points.size()]));
  const int face = occ::addPlaneSurface({occ::addWire(lines)});
  gmsh::vectorpair made, solids, cut;
  std::vector<gmsh::vectorpair> parents;
  occ::revolve({{2, face}}, 0, 0, 0, 0, 0, 1, 2 * M_PI, made);
  occ::remove({{2, face}});
  occ::getEntities(solids, 3);
  if (with_hole) occ::cut(solids, {{3, occ::addCylinder(32, 0, -10, 0, 0, 100, 3)}}, cut, parents);
}

TEST(StepDialects, a_cut_through_the_seam_of_a_solid_or_a_hole_beside_its_axis) {
  for (const auto& [with_hole, turn, wall] : {std::tuple{false, "0", 40}, {false, "180 deg", 40}, {true, "0", 29}}) {
    const std::string keys = fmt::format("turn = \"{}\", ", turn) + from({0, 20});
    const Taken taken = take_step([with_hole = with_hole] { draw_flat_cup(with_hole); }, keys);
    EXPECT_NEAR(taken.area, wall * 60 - 20 * 40, 1e-5) << with_hole << turn << taken.refusal;
  }
}

TEST(StepDialects, a_solid_about_another_axis_away_from_the_origin) {
  std::mt19937 random(13);
  const Section section = random_section(random, true);
  const auto draw = [&](double x, double y, double z) {
    return [&, x, y, z] {
      draw_solid(section, true, 2 * M_PI, 0);
      gmsh::vectorpair all;
      occ::getEntities(all, 3);
      occ::rotate(all, 0, 0, 0, 1, 0, 0, -M_PI / 2);  // z becomes y
      occ::translate(all, x, y, z);
    };
  };
  const Taken found = take_step(draw(100, 40, -30), from({5, 40}));
  EXPECT_NEAR(found.area / section.area, 1, 1e-5) << found.refusal;
  const Taken shifted = take_step(draw(100, 40, -30), "origin = \"(0, 40) mm\", " + from({5, 0}));
  EXPECT_NEAR(shifted.area / section.area, 1, 1e-5) << shifted.refusal;
  const Taken down = take_step(draw(100, 40, -30), "axis = \"-y\", turn = \"70 deg\", " + from({5, -40}));
  EXPECT_NEAR(down.area / section.area, 1, 1e-5) << down.refusal;
}

TEST(StepDialects, bores_in_the_wall_of_a_solid_are_left_out_with_a_note) {
  const Taken taken = take_step(
      [] {
        const int wall = occ::addCylinder(0, 0, 0, 0, 0, 60, 40), inside = occ::addCylinder(0, 0, 0, 0, 0, 60, 20);
        gmsh::vectorpair cut, bored;
        std::vector<gmsh::vectorpair> parents;
        occ::cut({{3, wall}}, {{3, inside}}, cut, parents);
        occ::cut(cut, {{3, occ::addCylinder(30, -50, 30, 0, 100, 0, 4)}}, bored, parents);
      },
      from({20, 0}));
  EXPECT_NEAR(taken.area, 1200, 1e-6) << taken.refusal;
  ASSERT_EQ(taken.notes.size(), 2);
  EXPECT_NE((taken.notes[0] + taken.notes[1]).find("holes in the section of the solid were left out, 1 in all"),
            std::string::npos);
}

}  // namespace
}  // namespace parison::tests
