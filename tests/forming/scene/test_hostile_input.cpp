// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>

#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "forming/scene/read/drawing/path_text.hpp"

namespace parison::forming {
namespace {

const std::string surface = "path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"";

/// The disc of the small scene with its surface from a file beside the case.
std::string with_drawing(const std::string& name, const std::string& text) {
  core::write_text(write_scene(small_scene) + "/" + name, text);
  return replaced(surface,
                  "path = { file = \"" + name + "\", unit = \"mm\", from = \"(0, 0) mm\", to = \"(0, 10) mm\" }");
}

std::string with_csv(const std::string& text) {
  core::write_text(write_scene(small_scene) + "/outline.csv", text);
  return replaced(surface, "csv = \"outline.csv\"");
}

/// The outline of the disc as a polyline whose side up the mantle has a bulge, without the last lines of the file.
std::string polyline(const std::string& bulge) {
  return "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n90\n4\n70\n0\n10\n0\n20\n0\n10\n20\n20\n0\n42\n" + bulge +
         "\n10\n20\n20\n10\n10\n0\n20\n10\n";
}
const std::string end = "0\nENDSEC\n0\nEOF\n";

void expect_refused(const std::string& scene, const std::string& sentence) {
  const std::string said = complaint_about(scene);
  EXPECT_NE(said.find(sentence), said.npos) << said.substr(0, 500);
  EXPECT_EQ(said.find('\n'), said.npos) << said;
}

TEST(HostileInput, a_bulge_next_to_zero_is_a_straight_side) {
  for (const char* bulge : {"0", "1e-16", "-1e-15", "1e-12", "1e-7", "1e-300", "5e-324"}) {
    const core::Profile glass = scene_of(with_drawing("disc.dxf", polyline(bulge) + end)).glass.profile;
    EXPECT_FALSE(glass.segments[1].is_arc) << bulge;
    EXPECT_EQ(core::signed_area(glass), 0.02 * 0.01) << bulge;
  }
  const double bulge = 1e-4, flat = 0.02 * 0.01, angle = 4 * std::atan(bulge), radius = 0.005 / std::sin(angle / 2);
  const core::Profile bent = scene_of(with_drawing("disc.dxf", polyline("1e-4") + end)).glass.profile;
  EXPECT_TRUE(bent.segments[1].is_arc);
  EXPECT_NEAR(core::signed_area(bent) - flat, radius * radius / 2 * (angle - std::sin(angle)), 1e-13);
}

TEST(HostileInput, a_dxf_file_that_is_cut_off_anywhere_is_refused) {
  const std::string whole = polyline("0") + end;
  ASSERT_EQ(complaint_about(with_drawing("disc.dxf", whole)), "");
  for (std::size_t size = 0; size + 4 < whole.size(); ++size)  // without its last line "EOF"
    EXPECT_NE(complaint_about(with_drawing("disc.dxf", whole.substr(0, size))), "") << size;
  expect_refused(
      with_drawing("disc.dxf", polyline("0")),
      "disc.dxf:28: glass.boundary.path.file: the file ends without the ENDSEC of its entities, so a part of "
      "it is missing, allowed is a whole DXF file");
  expect_refused(with_drawing("disc.dxf", polyline("0") + "0\nENDSEC\n"), "the file ends without EOF");
  expect_refused(with_drawing("disc.dxf", polyline("0") + "10\n"), "the file ends within a group");
}

TEST(HostileInput, entities_that_contradict_themselves_are_refused) {
  const auto said = [&](const std::string& from, const std::string& to, const std::string& sentence) {
    expect_refused(with_drawing("disc.dxf", replaced(from, to, polyline("0") + end)), sentence);
  };
  for (const char* flags : {"111111111111111", "-1", "1.5", "8"})
    said("70\n0", std::string("70\n") + flags, "a curve-fitted or three-dimensional LWPOLYLINE was found");
  said("90\n4", "90\n5", "4 vertices were found, the entity says 5");
  said("\n20\n10\n10\n0\n", "\n10\n0\n", "a vertex without group 20 was found");
  said("42\n0", "42\n1e7", "a bulge of 1e+07 was found, allowed are bulges of up to 1e+06 in size");
  for (const char* number : {"nan", "inf", "1e400", "1e200", "0x1p-3", "", "1,5"})
    said("10\n20\n", std::string("10\n") + number + "\n", "was found, allowed is a number of up to 1e+15 in size");
  const std::string open = "0\nSECTION\n2\nENTITIES\n0\nPOLYLINE\n70\n0\n0\nVERTEX\n10\n0\n20\n0\n" + end;
  expect_refused(with_drawing("disc.dxf", open), "a POLYLINE without SEQEND was found");
  const std::string arc = "0\nSECTION\n2\nENTITIES\n0\nARC\n10\n0\n20\n0\n40\n";
  expect_refused(with_drawing("disc.dxf", arc + "5\n50\n0\n51\n1e9\n" + end), "allowed are up to ten turns");
  expect_refused(with_drawing("disc.dxf", arc + "1e14\n50\n0\n51\n1\n" + end), "allowed are up to 1e+06 m from");
  expect_refused(with_drawing("disc.dxf", arc + "1e8\n50\n0\n51\n1e-7\n" + end), "an arc with a radius of 1e+05 m");
}

TEST(HostileInput, a_dxf_drawing_in_another_unit_than_the_case_says_is_refused) {
  const auto in_units = [](const std::string& number) {
    return with_drawing("disc.dxf", "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + number +
                                        "\n9\n$MEASUREMENT\n70\n1\n0\nENDSEC\n" + polyline("0") + end);
  };
  for (const char* none_or_mm : {"0", "4", "     4", "15", "99"}) EXPECT_EQ(complaint_about(in_units(none_or_mm)), "");
  expect_refused(
      in_units("1"),
      "disc.dxf:8: glass.boundary.path.file: $INSUNITS 1 was found, a drawing in inches, where the case says "
      "that its unit is 0.001 m");
  for (const char* other : {"2", "5", "6", "13"}) expect_refused(in_units(other), "allowed is the same unit");
  expect_refused(in_units("mm"), "allowed is a number");
}

TEST(HostileInput, what_is_not_parallel_to_the_plane_of_a_dxf_drawing_is_refused) {
  const auto lines = [](const std::string& height) {
    const auto line = [](const std::string& from, const std::string& to) {
      return "0\nLINE\n10\n" + from + "\n11\n" + to + "\n";
    };
    return "0\nSECTION\n2\nENTITIES\n" + line("0\n20\n0\n30\n5", "20\n21\n0\n31\n5") +
           line("20\n20\n0\n30\n5", "20\n21\n10\n31\n" + height) + line("20\n20\n10", "0\n21\n10") + end;
  };
  EXPECT_EQ(complaint_about(with_drawing("disc.dxf", lines("5"))), "");
  EXPECT_EQ(complaint_about(with_drawing("disc.dxf", lines("5.00001"))), "");
  expect_refused(with_drawing("disc.dxf", lines("6")),
                 "disc.dxf:20: glass.boundary.path.file: a LINE that is not parallel to the plane of x and y");
  const auto seen_from = [](const std::string& direction) {
    return replaced("70\n0\n", "70\n0\n" + direction, polyline("0") + end);
  };
  EXPECT_EQ(complaint_about(with_drawing("disc.dxf", seen_from("210\n0\n220\n1e-17\n230\n1\n"))), "");
  for (const char* direction : {"210\n0\n220\n0.7\n230\n0.7\n", "220\n-1\n230\n0\n"})
    expect_refused(with_drawing("disc.dxf", seen_from(direction)), "a LWPOLYLINE that is not parallel to the plane");
  // Seen from behind it is its mirror image, as CAD programs show it.
  expect_refused(with_drawing("disc.dxf", seen_from("230\n-1\n")), "mm is on the wrong side of the axis");
}

TEST(HostileInput, a_block_of_a_dxf_drawing_that_is_seen_from_behind_is_its_mirror_image) {
  const auto inserted = [](const std::string& direction) {
    const std::string entities = "0\nSECTION\n2\nENTITIES\n", outline = polyline("0").substr(entities.size());
    return "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nDISC\n" + outline + "0\nENDBLK\n0\nENDSEC\n" + entities +
           "0\nINSERT\n2\nDISC\n10\n0\n20\n0\n" + direction + end;
  };
  EXPECT_EQ(complaint_about(with_drawing("disc.dxf", inserted("230\n1\n"))), "");
  expect_refused(with_drawing("disc.dxf", inserted("230\n-1\n")), "mm is on the wrong side of the axis");
  EXPECT_EQ(complaint_about(with_drawing("disc.dxf", inserted("41\n-1\n230\n-1\n"))), "");
}

TEST(HostileInput, a_path_of_ten_thousand_points_and_blanks_is_read_and_one_of_more_than_20000_refused) {
  const auto path = [](int points, const std::string& blanks) {
    std::string text;
    for (int i = 0; i <= points; ++i) text += "(" + std::to_string(20 - 20.0 * i / points) + blanks + ", 10) ";
    return replaced("(20, 10) (0, 10) mm", text + blanks + "mm");
  };
  EXPECT_EQ(scene_of(path(5'000, "")).glass.profile.segments.size(), 5'003u);
  EXPECT_EQ(complaint_about(path(3, std::string(100'000, ' '))), "");
  expect_refused(path(20'001, ""), "20004 points were found, allowed are up to 20000");
}

TEST(HostileInput, texts_of_paths_are_taken_apart_or_nothing_is) {
  const auto points = split_points(" (31, 14)(29.5,20)\t\n(0, 98)  mm ");
  ASSERT_TRUE(points);
  EXPECT_EQ(points->points, (std::vector<std::string_view>{"31, 14", "29.5,20", "0, 98"}));
  EXPECT_EQ(points->unit, "mm");
  for (const char* text : {"", " ", "mm", "(1, 2)", "(1, 2)mm", "(1, 2) mm mm", "(1, (2) mm", "(1, 2 mm", "1, 2) mm",
                           "(1, 2) (3, 4)", "(1, 2) x (3, 4) mm"})
    EXPECT_FALSE(split_points(text)) << text;
  const auto arc = split_arc(" arc  centre (13.5, 84)mm radius 14 mm from -1 deg to\n90 deg ");
  ASSERT_TRUE(arc);
  EXPECT_EQ(arc->centre, "13.5, 84");
  EXPECT_EQ(arc->unit, "mm");
  EXPECT_EQ(arc->radius, "14 mm");
  EXPECT_EQ(arc->from, "-1 deg");
  EXPECT_EQ(arc->to, "90 deg");
  for (const char* text :
       {"arc", "arc centre", "arc centre (1, 2) mm", "arc centre (1, 2) mm radius 3 mm from 0 deg",
        "arc centre (1, 2) mm radius from 0 deg to 1 deg", "arc centre 1, 2 mm radius 3 mm from 0 to 1",
        "arc centre (1, 2) mm radius 3 mm from 0 deg to", "arcs centre (1, 2) mm radius 3 mm from 0 to 1"})
    EXPECT_FALSE(split_arc(text)) << text;
}

TEST(HostileInput, rows_of_a_csv_file_are_points_within_range) {
  EXPECT_EQ(complaint_about(with_csv("r_mm,z_mm\r\n0,0\r\n20,0,\r\n\r\n20,10\r\n0,10")), "");
  for (const char* number : {"nan", "inf", "1e400", "1e-400", "1e12", "", "0x10", "1 2", "1;2"})
    EXPECT_NE(complaint_about(with_csv("r_mm,z_mm\n0,0\n20,0\n" + std::string(number) + ",10\n0,10\n")), "") << number;
  expect_refused(with_csv("r_mm,z_mm\n0,0\n20,0\n1e12,10\n"),
                 "outline.csv:4: glass.boundary.csv: \"1e12 mm\" is too large");
  expect_refused(with_csv("r_mm,z_mm\n0,0\n20,0,5\n"), "\"20,0,5\" has 3 columns, allowed are 2");
  std::string many = "r_mm,z_mm\n";
  for (int i = 0; i < 20'001; ++i) many += "1,1\n";
  expect_refused(with_csv(many), "outline.csv:20002: glass.boundary.csv: allowed are up to 20000 points");
}

TEST(HostileInput, pipes_folders_and_endless_files_are_refused_without_waiting) {
  for (const char* name : {"disc.dxf", "outline.csv"}) {
    const bool is_csv = std::string(name) == "outline.csv";
    const std::string scene = is_csv ? with_csv("") : with_drawing(name, ""), path = write_scene(scene) + "/" + name;
    std::filesystem::resize_file(path, 3'000'000'000);
    expect_refused(scene, "\" is too large, allowed are files of up to 100 MB");
    std::filesystem::remove(path);
    ASSERT_EQ(::mkfifo(path.c_str(), 0666), 0);
    expect_refused(scene, "\" is not a file with a content, allowed is a regular file");
    std::filesystem::remove(path);
    std::filesystem::create_symlink("/dev/zero", path);
    expect_refused(scene, "\" is not a file with a content, allowed is a regular file");
    std::filesystem::remove(path);
    std::filesystem::create_directory(path);
    expect_refused(scene, "\" is not a file with a content, allowed is a regular file");
  }
}

TEST(HostileInput, numbers_of_a_case_have_a_range) {
  const auto said = [&](const std::string& from, const std::string& to, const std::string& sentence) {
    expect_refused(replaced(from, to), sentence);
  };
  said("2400 kg/m3", "1e300 kg/m3", "is too large, allowed is a density");
  said("2400 kg/m3", "1e-300 kg/m3", "was found, allowed are values from 1e-30 in SI units");
  said("duration = \"1 s\"", "duration = \"1e300 s\"", "is too large, allowed is a time");
  said("1e4 Pa.s", "1e-300 Pa.s", "was found, allowed are values from 1e-30 in SI units");
  for (const char* A : {"-400", "400", "1e308"})
    said("{ law = \"constant\", value = \"1e4 Pa.s\" }",
         std::string("{ law = \"vft\", A = ") + A + ", B = \"3922 K\", T0 = \"291 degC\" }", "viscosity.A: ");
}

/// CPU time that an action takes, s.
template <class Action>
double seconds(const Action& action) {
  const std::clock_t start = std::clock();
  action();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif
/// Of CPU time; under sanitizers the reading takes several times as long.
constexpr double allowed_seconds = sanitized ? 40 : 10;

TEST(HostileInput, the_largest_case_files_are_read_or_refused_within_ten_seconds) {
  const auto repeated = [](int count, const std::function<std::string(std::string)>& part) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part(std::to_string(i));
    return text;
  };
  const auto stages = [](const std::string& i) {
    return "[[stage]]\nname = \"" + i + "\"\nduration = \"1 s\"\ntools = [\"plate\"]\n";
  };
  const auto probes = [](const std::string& i) {
    return "[[probe]]\nname = \"" + i + "\"\nbody = \"glass\"\npoint = \"(0, 5) mm\"\n";
  };
  const auto capacity = [&](int count) {
    const auto pair = [](const std::string& i) { return "[\"" + i + " degC\", \"1300 J/kg/K\"],"; };
    return replaced("\"1300 J/kg/K\"", "[" + repeated(count, pair) + "]");
  };
  const std::string unknown = repeated(300'000, [](const std::string& i) { return 'k' + i + " = 1\n"; });
  EXPECT_LT(seconds([&] { expect_refused(small_scene + unknown, "probe.k0: unknown key"); }), allowed_seconds);
  EXPECT_LT(seconds([&] { expect_refused(small_scene + repeated(40'000, stages), "allowed are up to 1000"); }),
            allowed_seconds);
  EXPECT_LT(seconds([&] { expect_refused(small_scene + repeated(50'000, probes), "allowed are up to 1000"); }),
            allowed_seconds);
  EXPECT_LT(seconds([&] { expect_refused(capacity(90'000), "90000 pairs were found, allowed are up to 1000"); }),
            allowed_seconds);
  EXPECT_LT(seconds([&] { EXPECT_EQ(complaint_about(small_scene + repeated(900, stages)), ""); }), allowed_seconds);
  EXPECT_LT(seconds([&] { EXPECT_EQ(complaint_about(capacity(1000)), ""); }), allowed_seconds);
  EXPECT_LT(seconds([&] { expect_refused(small_scene + std::string(5'000'000, '#'), "files of up to 4 MB"); }),
            allowed_seconds);
}

TEST(HostileInput, the_longest_drawings_and_tables_are_read_within_ten_seconds) {
  const int count = 19'000;
  std::string lines, rows = "r_mm,z_mm\n0,0\n20,0\n";
  const auto height = [&](int i) { return std::to_string(10.0 * i / count); };
  for (int i = 0; i < count; ++i) {
    lines += "0\nLINE\n10\n20\n20\n" + height(i) + "\n11\n20\n21\n" + height(i + 1) + "\n";
    rows += "20," + height(i + 1) + "\n";
  }
  const auto line = [](const char* x1, const char* y1, const char* x2, const char* y2) {
    return std::string("0\nLINE\n10\n") + x1 + "\n20\n" + y1 + "\n11\n" + x2 + "\n21\n" + y2 + "\n";
  };
  const std::string drawing =
      "0\nSECTION\n2\nENTITIES\n" + line("0", "0", "20", "0") + lines + line("20", "10", "0", "10") + end;
  for (const std::string& scene : {with_drawing("disc.dxf", drawing), with_csv(rows + "0,10\n")})
    EXPECT_LT(seconds([&] { EXPECT_EQ(complaint_about(scene), ""); }), allowed_seconds);
}

}  // namespace
}  // namespace parison::forming
