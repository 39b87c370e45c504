// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "forming/report/contour/contour.hpp"
#include "forming/report/files/history.hpp"
#include "forming/report/files/interface_rows.hpp"
#include "forming/report/files/result_files.hpp"
#include "forming/report/thickness_profile.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/heat/thermal_interface.hpp"
#include "output_text.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;
using tests::absent_folder;

TEST(ToolRows, a_row_has_mean_surface_and_hottest_place_in_the_frame_of_the_case) {
  const Scene scene = scene_of(small_scene);
  State state = initial_state(scene);
  ToolState& plunger = state.tools[1];  // a disc of 15 mm radius and 20 mm height, drawn with its face at z = 0
  for (Index n = 0; n < plunger.mesh.node_count(); ++n)
    plunger.temperature[n] = 273.15 + 600 + 10e3 * plunger.mesh.nodes[n][0] - 1e3 * plunger.mesh.nodes[n][1];
  plunger.heat_received = 12;
  auto field = named_fields(tool_header(scene), tool_line(scene, state, tool_surfaces(scene, state)));
  EXPECT_NEAR(std::stod(field["plunger_mean_degC"]), 600 + 100 - 10, 1e-4);
  EXPECT_NEAR(std::stod(field["plunger_surface_mean_degC"]), 600 + 100, 1e-4);
  EXPECT_NEAR(std::stod(field["plunger_surface_max_degC"]), 750, 1e-4);
  EXPECT_NEAR(std::stod(field["plunger_surface_max_r_mm"]), 15, 1e-6);
  EXPECT_NEAR(std::stod(field["plunger_surface_max_z_mm"]), 10, 1e-6);
  // Hotter than 645 degC beyond a radius of 4.5 mm.
  EXPECT_NEAR(std::stod(field["plunger_sticking_area_mm2"]), M_PI * (15 * 15 - 4.5 * 4.5), 3);
  EXPECT_EQ(field["plunger_heat_received_J"], "12");
  EXPECT_EQ(field["plate_sticking_area_mm2"], "0");
}

TEST(Csv, every_heading_has_a_unit_but_names_counts_and_shares) {
  const Scene scene = scene_of(small_scene);
  const std::set<std::string> units{"s", "mm", "mm2", "mm3", "mm_s", "degC", "N",
                                    "J", "g",  "kg",  "Pa",  "Pa_s", "W_m2", "W_m2K"};
  const std::set<std::string> without{"stage",
                                      "energy_imbalance",
                                      "coupling_iterations",
                                      "flow_solves",
                                      "contact_changes",
                                      "heat_substeps",
                                      "limited_by",
                                      "tool",
                                      "contact_weight",
                                      "mark",
                                      "side",
                                      "loop"};
  const State state = initial_state(scene);
  const std::string folder = tests::new_folder();
  write_thickness(folder + "/thickness.csv", {});
  for (const std::string& heading :
       {history_header(scene), tool_header(scene), interface_header(), core::read_text(folder + "/thickness.csv"),
        contour_text(scene, state, {}), heights_text({})})
    for (const std::string& name : fields_of(lines_of(heading)[0])) {
      bool has_unit = without.count(name) > 0;
      for (const std::string& unit : units)
        has_unit = has_unit || (name.size() > unit.size() && name.substr(name.size() - unit.size() - 1) == '_' + unit);
      EXPECT_TRUE(has_unit) << name;
    }
}

std::string refusal(const Scene& scene, const std::string& folder) {
  try {
    ResultFiles files(scene, folder);
  } catch (const core::CaseError& error) {
    return error.what();
  }
  return "";
}

TEST(ResultFiles, a_folder_that_holds_something_is_refused_with_the_name_of_a_foreign_file_and_left_as_it_is) {
  const Scene scene = scene_of(small_scene);
  const std::string folder = absent_folder();
  { ResultFiles files(scene, folder); }
  EXPECT_EQ(refusal(scene, folder),
            folder + ": an earlier result was found, allowed is a new or an empty folder for the results");
  core::write_text(folder + "/notes.txt", "precious");
  EXPECT_EQ(refusal(scene, folder).rfind(folder + "/notes.txt: this was not written by parison", 0), 0u);
  EXPECT_EQ(core::read_text(folder + "/notes.txt"), "precious");
  EXPECT_EQ(refusal(scene, folder + "/notes.txt").rfind(folder + "/notes.txt: this was not written by parison", 0), 0u);
}

TEST(ResultFiles, every_output_has_a_file_for_each_body_and_repeats_are_left_out) {
  const Scene scene = scene_of(small_scene);
  State state = initial_state(scene);
  const std::string folder = absent_folder();
  ResultFiles files(scene, folder);
  for (const double time : {0.0, 0.5, 0.5, 1.0}) {
    state.time = time;
    files.fields(state, {});
  }
  for (const char* body : {"glass", "plate", "plunger"}) {
    EXPECT_TRUE(fs::exists(folder + "/vtu/" + body + "_0002.vtu")) << body;
    EXPECT_FALSE(fs::exists(folder + "/vtu/" + body + "_0003.vtu")) << body;
    const std::string pvd = core::read_text(folder + '/' + body + ".pvd");
    EXPECT_NE(pvd.find(std::string("timestep=\"1\" group=\"\" part=\"0\" file=\"vtu/") + body + "_0002.vtu\""),
              pvd.npos);
  }
}

TEST(ResultFiles, history_rows_are_on_the_disk_at_once) {
  const Scene scene = scene_of(small_scene);
  const State state = initial_state(scene);
  const std::string folder = absent_folder();
  ResultFiles files(scene, folder);
  files.row(history_row(scene, state, {}), tool_line(scene, state, tool_surfaces(scene, state)));
  for (const char* name : {"/history.csv", "/tools.csv"})
    EXPECT_EQ(lines_of(core::read_text(folder + name)).size(), 2u) << name;
}

TEST(InterfaceRows, they_run_along_the_contact_with_both_temperatures_and_the_flux) {
  const Scene scene = scene_of(small_scene);
  const State state = initial_state(scene);
  const auto lines = lines_of(interface_lines(scene, state, thermal_interface(scene, state)));
  ASSERT_GT(lines.size(), 10u);
  double last = 0;
  for (const std::string& line : lines) {
    const auto fields = fields_of(line);
    ASSERT_EQ(fields.size(), fields_of(interface_header()).size());
    EXPECT_EQ(fields[1], "plate");
    const double arc = std::stod(fields[2]), contact_weight = std::stod(fields[12]);
    EXPECT_GT(arc, last);
    last = arc;
    // The glass surface starts on the axis and first runs along the plate.
    EXPECT_NEAR(arc, std::stod(fields[3]), 1e-6);
    EXPECT_NEAR(std::stod(fields[5]), 1000, 1e-5);
    EXPECT_NEAR(std::stod(fields[6]), 400, 1e-5);
    EXPECT_NEAR(std::stod(fields[8]), 1e4, 1e-3);
    EXPECT_NEAR(std::stod(fields[9]), 2000, 1e-3);
    EXPECT_NEAR(contact_weight, 1, 1e-6);
    EXPECT_NEAR(std::stod(fields[10]), 2000 * 600, 2);
  }
  EXPECT_GT(last, 19);
  const core::Mesh& glass = state.glass.mesh;
  const auto on_plate =
      std::count_if(glass.boundary_edges().begin(), glass.boundary_edges().end(),
                    [&](const core::BoundaryEdge& edge) { return std::abs(glass.nodes[edge.nodes[2]][1]) < 1e-9; });
  EXPECT_GT(static_cast<long>(lines.size()), 2 * on_plate);
  EXPECT_LE(static_cast<long>(lines.size()), 4 * on_plate);
}

}  // namespace
}  // namespace parison::forming
