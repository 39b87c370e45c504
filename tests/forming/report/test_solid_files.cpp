// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "../../test_folder.hpp"
#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/report/solid/solid_files.hpp"
#include "step_volume.hpp"

namespace parison::forming {
namespace {

constexpr double outer_radius = 30, inner_radius = 27;  // mm

/// A bowl: half a hollow sphere, open upwards, as a result folder has it.
std::string bowl() {
  std::string contour = "loop,side,arc_mm,r_mm,z_mm,height_mm,thickness_mm,T_degC\n", thickness;
  constexpr int points = 60;
  const auto add = [&](const char* side, double radius, double angle) {
    contour +=
        fmt::format("0,{},0,{:.9g},{:.9g},0,nan,500\n", side, radius * std::sin(angle), -radius * std::cos(angle));
  };
  for (int i = 0; i <= points; ++i) add("outer", outer_radius, M_PI / 2 * i / points);
  for (int i = points; i >= 0; --i) add("inner", inner_radius, M_PI / 2 * i / points);
  thickness = "arc_mm,r_outer_mm,z_outer_mm,thickness_mm,T_inner_degC,T_outer_degC,mark,r_inner_mm,z_inner_mm\n";
  for (int i = 0; i <= points; ++i) {
    const double s = std::sin(M_PI / 2 * i / points), c = std::cos(M_PI / 2 * i / points);
    thickness += fmt::format("0,{:.9g},{:.9g},3,500,500,wall,{:.9g},{:.9g}\n", outer_radius * s, -outer_radius * c,
                             inner_radius * s, -inner_radius * c);
  }
  thickness += "0,30,0,nan,nan,500,rim,nan,nan\n";
  const std::string folder = tests::new_folder();
  core::write_text(folder + "/contour.csv", contour);
  core::write_text(folder + "/thickness.csv", thickness);
  return folder;
}

const double exact = 2e-9 / 3 * M_PI * (std::pow(outer_radius, 3) - std::pow(inner_radius, 3));  // m3, of the bowl

TEST(SolidFiles, a_step_file_read_back_has_the_volume_of_the_glass_to_a_ten_thousandth) {
  const std::string folder = bowl(), path = folder + "/bowl.step";
  const ContainerShape shape = read_container_shape(folder);
  EXPECT_FALSE(shape.is_loop);
  EXPECT_NEAR(write_step(path, shape) / exact, 1, 1e-4);
  EXPECT_NEAR(volume_of_step(path) / exact, 1, 1e-4);
  EXPECT_NE(core::read_text(path).find("SI_UNIT(.MILLI.,.METRE.)"), std::string::npos);
}

TEST(SolidFiles, the_section_of_a_planar_case_is_not_turned_about_an_axis_that_it_does_not_have) {
  const std::string folder = bowl();
  core::write_text(folder + "/summary.json", "{ \"geometry\": \"axisymmetric\" }");
  EXPECT_GT(revolved_volume(read_container_shape(folder)), 0);
  core::write_text(folder + "/summary.json", "{ \"geometry\": \"planar\" }");
  try {
    read_container_shape(folder);
    ADD_FAILURE() << "a planar case was taken";
  } catch (const core::CaseError& error) {
    EXPECT_EQ(error.what(), folder +
                                ": a planar case was found, whose glass is no solid of revolution, allowed are "
                                "axisymmetric cases");
  }
}

TEST(SolidFiles, a_ring_off_the_axis_becomes_a_solid_too) {
  const ContainerShape ring{{{0.020, 0}, {0.025, 0}, {0.025, 0.01}, {0.0225, 0.012}, {0.020, 0.01}}, true, {}, 0};
  const std::string path = tests::new_folder() + "/ring.step";
  EXPECT_NEAR(write_step(path, ring) / revolved_volume(ring), 1, 1e-9);
  EXPECT_NEAR(volume_of_step(path) / revolved_volume(ring), 1, 1e-9);
}

TEST(SolidFiles, the_triangles_of_an_stl_file_enclose_the_glass_with_their_normals_outward) {
  const std::string folder = bowl(), path = folder + "/bowl.stl";
  const double volume = write_stl(path, read_container_shape(folder));
  EXPECT_NEAR(volume / exact, 1, 1e-3);
  const std::string bytes = core::read_text(path);
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  ASSERT_EQ(bytes.size(), 84 + 50 * std::size_t{count});
  double sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    float v[12];
    std::memcpy(v, bytes.data() + 84 + 50 * std::size_t{i}, sizeof v);
    const double ax = v[6] - v[3], ay = v[7] - v[4], az = v[8] - v[5], bx = v[9] - v[3], by = v[10] - v[4],
                 bz = v[11] - v[5];
    const double n[3] = {ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx};
    EXPECT_GT(n[0] * v[0] + n[1] * v[1] + n[2] * v[2], 0);
    sum += (v[3] * n[0] + v[4] * n[1] + v[5] * n[2]) / 6;
  }
  EXPECT_NEAR(1e-9 * sum / volume, 1, 1e-5);
}

/// Rows of numbers below a keyword of an input file, up to the next keyword.
std::vector<std::vector<double>> rows_below(const std::string& text, const std::string& keyword) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text.substr(text.find(keyword)));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line[0] != '*') {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

/// Some glass in a container that stands along the axis or against it.
ShellGlass glass_standing(int up) {
  return {70e9, 0.22, 2500, up, ""};
}

TEST(SolidFiles, a_shell_mesh_has_the_middle_surface_and_its_thickness_at_every_node) {
  const std::string folder = bowl(), path = folder + "/bowl.inp";
  const ShellMesh mesh = write_shell(path, read_container_shape(folder), glass_standing(1));
  const double middle = 0.5 * (outer_radius + inner_radius);
  EXPECT_NEAR(mesh.volume / (2e-9 * M_PI * middle * middle * 3), 1, 1e-3);
  EXPECT_NEAR(mesh.volume / exact, 1, 2e-3);
  const std::string text = core::read_text(path);
  const auto nodes = rows_below(text, "*NODE,"), eight = rows_below(text, "*ELEMENT, TYPE=S8R"),
             six = rows_below(text, "*ELEMENT, TYPE=S6"), thickness = rows_below(text, "*NODAL THICKNESS\n");
  ASSERT_EQ(static_cast<long>(nodes.size()), mesh.nodes);
  ASSERT_EQ(nodes.size(), thickness.size());
  EXPECT_EQ(static_cast<long>(eight.size() + six.size()), mesh.elements);
  EXPECT_EQ(six.size(), 48u);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    EXPECT_EQ(nodes[i][0], static_cast<double>(i) + 1);
    EXPECT_NEAR(std::hypot(nodes[i][1], nodes[i][2], nodes[i][3]), middle, 0.01);
    EXPECT_NEAR(thickness[i][1], 3, 1e-6);
  }
  // Mid-side nodes are between their ends: in an eight-node shell the fifth is between the first and the second.
  for (const auto& element : eight)
    for (int k = 0; k < 4; ++k) {
      const auto at = [&](int place) {
        return nodes[static_cast<std::size_t>(element[static_cast<std::size_t>(place)]) - 1];
      };
      const auto a = at(1 + k), b = at(1 + (k + 1) % 4), m = at(5 + k);
      const double chord = std::hypot(a[1] - b[1], a[2] - b[2], a[3] - b[3]);
      const double off = std::hypot(0.5 * (a[1] + b[1]) - m[1], 0.5 * (a[2] + b[2]) - m[2], 0.5 * (a[3] + b[3]) - m[3]);
      EXPECT_LT(off, 0.1 * chord);
    }
}

/// The middle of a beaker with a flat bottom whose wall leans outwards, 2 mm thick; z points up or down.
ContainerShape beaker(int up) {
  ContainerShape shape{{}, false, {}, 0};
  for (int i = 0; i <= 40; ++i) shape.middle.push_back({{5e-4 * i, 0}, 2e-3, -1e-3 * up});
  for (int i = 1; i <= 80; ++i)
    shape.middle.push_back({{0.02 + 5e-5 * i, 1e-3 * i * up}, 2e-3, up * (1e-3 * i - 1e-3 * std::exp(-0.5 * i))});
  return shape;
}

TEST(SolidFiles, a_shell_stands_on_the_edge_of_its_base_and_bears_its_loads_on_the_rim_and_where_it_is_wide) {
  for (const int up : {1, -1}) {
    const std::string path = tests::new_folder() + "/beaker.inp";
    write_shell(path, beaker(up), glass_standing(up));
    const std::string text = core::read_text(path);
    const auto nodes = rows_below(text, "*NODE,");
    const auto radius = [&](double number) {
      const auto& node = nodes[static_cast<std::size_t>(number) - 1];
      return std::hypot(node[1], node[2]);
    };
    const auto base = rows_below(text, "*NSET, NSET=BASE"), finish = rows_below(text, "*NSET, NSET=FINISH");
    EXPECT_EQ(base.size(), 96u);
    EXPECT_EQ(finish.size(), 96u);
    for (const auto& node : base) EXPECT_NEAR(radius(node[0]), 20, 0.3);
    for (const auto& node : finish) EXPECT_NEAR(radius(node[0]), 24, 1e-6);
    for (const auto& node : rows_below(text, "*NSET, NSET=BODY")) {
      EXPECT_GE(radius(node[0]), 0.9 * 24 - 1e-6);
      EXPECT_NEAR(nodes[static_cast<std::size_t>(node[0]) - 1][2], 0, 1e-6);
    }
    double down = 0, from_right = 0, from_left = 0;
    for (const auto& force : rows_below(text, "*CLOAD, OP=NEW\n")) down += force[2];
    for (const auto& force : rows_below(text.substr(text.find("** Squeeze")), "*CLOAD, OP=NEW\n"))
      (force[2] < 0 ? from_right : from_left) += force[2];
    EXPECT_NEAR(down, -1000.0 * up, 1e-5);
    EXPECT_NEAR(from_right, -1000, 1e-5);
    EXPECT_NEAR(from_left, 1000, 1e-5);
  }
}

TEST(SolidFiles, what_is_no_container_of_a_result_folder_is_refused_with_a_sentence) {
  const auto complaint = [](const std::string& folder) {
    try {
      read_container_shape(folder);
    } catch (const core::CaseError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(complaint(tests::new_folder()).find("/contour.csv: no such file, allowed is the result folder"),
            std::string::npos);
  const std::string folder = bowl(), path = folder + "/contour.csv", text = core::read_text(path);
  core::write_text(path, text + "1,surface,0,1,1,0,nan,500\n");
  EXPECT_NE(complaint(folder).find("several surfaces (a bubble)"), std::string::npos);
  core::write_text(path, text + "0,surface,0,1,1,0,nan,500\n");
  EXPECT_NE(complaint(folder).find("begins or ends off the axis"), std::string::npos);
  core::write_text(path, text + "0,surface,0,x,1,0,nan,500\n");
  EXPECT_NE(complaint(folder).find("\"x\" was found, allowed is a number"), std::string::npos);
  core::write_text(path, text + "0,surface\n");
  EXPECT_NE(complaint(folder).find("2 cells were found, allowed are 8 as in the heading"), std::string::npos);
  core::write_text(path, "r_mm,z_mm\n");
  EXPECT_NE(complaint(folder).find("has no column \"loop\""), std::string::npos);
}

}  // namespace
}  // namespace parison::forming
