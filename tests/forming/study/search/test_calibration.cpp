// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "../../../test_folder.hpp"
#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/report/files/history.hpp"
#include "forming/run/run.hpp"
#include "forming/study/search/calibration/calibration.hpp"
#include "forming/study/search/minimum/least_squares.hpp"

namespace parison::forming {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A slab of glass on one of iron with a thermocouple 1 mm below the contact; no flow.
const char* const slab = R"(
case = "slab"
geometry = "planar"
stage = [{ name = "contact", duration = "4 s", tools = ["iron"] }]
probe = [{ name = "couple", body = "iron", point = "(1, -1) mm" }]
interface = [{ tools = ["iron"], law = "gap", touch_gap = "0.25 um", closing = 1, accommodation = 0.9, opening_time = "0.5 s", open_gap = "60 um" }]
[material.glass]
density = "2500 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "2 W/m/K"
[material.iron]
density = "7200 kg/m3"
heat_capacity = "490 J/kg/K"
conductivity = "46 W/m/K"
[glass]
material = "glass"
temperature = "1100 degC"
mesh = { mapped = [1, 8], ratio = [1, 12] }
boundary = [{ name = "contact", path = "(0, 0) (2, 0) mm", condition = "contact" },
            { name = "side", path = "(2, 8) mm", condition = "insulated" },
            { name = "top", path = "(0, 8) mm", condition = "insulated" },
            { name = "left", path = "(0, 0) mm", condition = "insulated" }]
[[tool]]
name = "iron"
material = "iron"
temperature = "450 degC"
mesh = { mapped = [1, 8], ratio = [1, 12] }
boundary = [{ name = "contact", path = "(2, 0) (0, 0) mm", condition = "contact" },
            { name = "left", path = "(0, -20) mm", condition = "insulated" },
            { name = "bottom", path = "(2, -20) mm", condition = "insulated" },
            { name = "side", path = "(2, 0) mm", condition = "insulated" }]
)";

class ProbeHistory : public RunObserver {
 public:
  std::vector<double> time, temperature;
  void step_taken(const RunView& view, const State&, const StepReport& report) override {
    const HistoryRow row = history_row(view.scene, view.state, report);
    time.push_back(row.time);
    temperature.push_back(row.probe.at(0) - 273.15);
  }
};

class CalibrationTest : public ::testing::Test {
 protected:
  const std::string folder = tests::absent_folder(), case_path = folder + "/slab.toml";
  void SetUp() override {
    std::filesystem::create_directories(folder);
    core::write_text(case_path, slab);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::string data(const std::string& text) const {
    core::write_text(folder + "/data.csv", text);
    return folder + "/data.csv";
  }
  std::string refusal(const std::string& text) const {
    try {
      read_measurements(data(text), read_scene(case_path, "draft"), {});
      return "";
    } catch (const core::CaseError& error) {
      return error.what();
    }
  }
  std::vector<SearchVariable> vary(const std::vector<std::string>& texts) const {
    return varied_constants(texts, case_path, {}, false);
  }

  /// The thermocouple every 0.05 s with constants at a place of the search.
  VectorXd couple(const std::vector<SearchVariable>& variables, const VectorXd& at) const {
    ProbeHistory history;
    run(read_scene(case_path, "draft", settings_at(variables, at)), {&history});
    VectorXd found(80);
    std::size_t k = 1;
    for (Eigen::Index i = 0; i < found.size(); ++i) {
      const double t = 0.05 * double(i + 1);
      while (k + 1 < history.time.size() && history.time[k] < t) ++k;
      const double share = (t - history.time[k - 1]) / (history.time[k] - history.time[k - 1]);
      found[i] = history.temperature[k - 1] + share * (history.temperature[k] - history.temperature[k - 1]);
    }
    return found;
  }

  struct Fitted {
    VectorXd at;
    FitIntervals intervals;
  };
  Fitted fit(const std::vector<SearchVariable>& variables, const VectorXd& measured, double noise) const {
    const auto count = Eigen::Index(variables.size());
    VectorXd start(count), low(count), high(count), step(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const SearchVariable& one = variables[std::size_t(i)];
      start[i] = one.start, low[i] = one.low(), high[i] = one.high(), step[i] = one.step;
    }
    const auto residual = [&](const VectorXd& at) -> VectorXd { return (couple(variables, at) - measured) / noise; };
    const auto found =
        least_squares(start, {low, high, step, 60, 0, 0, 1e-6}, [&](const std::vector<VectorXd>& places) {
          std::vector<std::optional<VectorXd>> all;
          for (const VectorXd& at : places) all.push_back(residual(at));
          return all;
        });
    MatrixXd jacobian(measured.size(), count);
    for (Eigen::Index i = 0; i < count; ++i) {
      VectorXd beside = found.at;
      beside[i] += beside[i] + step[i] <= high[i] ? step[i] : -step[i];
      jacobian.col(i) = (residual(beside) - found.residual) / (beside[i] - found.at[i]);
    }
    return {found.at, fit_intervals(variables, found.at, found.residual, jacobian)};
  }
};

TEST_F(CalibrationTest, what_is_wrong_in_the_data_is_told_with_its_line) {
  EXPECT_NE(refusal("time_s,cuple_degC\n1,450\n2,460\n").find("no probe \"cuple\" (did you mean \"couple\"?)"),
            std::string::npos);
  EXPECT_NE(refusal("time_s,irn_force_N\n1,450\n").find("no tool \"irn\" (did you mean \"iron\"?)"), std::string::npos);
  EXPECT_NE(refusal("time_s,couple_degC,couple_K\n1,450,723\n").find("column \"couple_K\": allowed are PROBE_degC"),
            std::string::npos);
  EXPECT_NE(refusal("time_s,couple_degC\n1,warm\n").find("data.csv:2: couple_degC: \"warm\" was found"),
            std::string::npos);
  EXPECT_NE(refusal("time_s,couple_degC\n1,450\n9,460\n").find("data.csv:3: the time 9 s was found"),
            std::string::npos);
  EXPECT_NE(refusal("time_s,couple_degC\n1\n").find("1 cells were found, allowed are 2"), std::string::npos);
  EXPECT_NE(refusal("a,b\n1,2\n").find("no measurements were found"), std::string::npos);
  EXPECT_NE(refusal("z_mm,thickness_mm\n1,2\n2,2\n").find("the glass of the case does not flow"), std::string::npos);
  EXPECT_EQ(refusal("time_s,couple_degC\n1,450\n2,460\n"), "");
  EXPECT_EQ(refusal("time_s,couple_degC,remark\n1,450,\n1.5,nan,lost\n2,460,\n"), "");
}

TEST_F(CalibrationTest, strokes_and_forces_are_read_beside_temperatures_each_with_its_noise) {
  const auto curves =
      read_measurements(data("time_s,iron_force_N,couple_degC,iron_position_mm\n1,40,450,0\n2,41,,0.1\n"),
                        read_scene(case_path, "draft"), {2, 0.05, 0.3, 7});
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_EQ(curves[0].column, "iron_force_N");
  EXPECT_EQ(curves[0].noise, 7);
  EXPECT_EQ(curves[1].at, std::vector<double>{1});
  EXPECT_EQ(curves[1].noise, 2);
  EXPECT_EQ(curves[2].value, (std::vector<double>{0, 0.1}));
  EXPECT_EQ(curves[2].noise, 0.3);
}

TEST_F(CalibrationTest, a_wall_over_the_height_is_compared_however_the_outline_runs) {
  const std::string model = folder + "/thickness.csv";
  const MeasuredCurve curve{"wall.csv", "", false, {5, 15}, {2, 3}, 1};
  core::write_text(model, "arc_mm,z_outer_mm,thickness_mm\n0,0,1\n10,10,2\n20,20,3\n25,18,9\n");
  EXPECT_EQ(model_at(curve, folder), (std::vector<double>{1.5, 2.5}));
  core::write_text(model, "arc_mm,z_outer_mm,thickness_mm\n0,20,3\n10,10,2\n20,0,1\n");
  EXPECT_EQ(model_at(curve, folder), (std::vector<double>{1.5, 2.5}));
}

TEST_F(CalibrationTest, the_wall_of_a_container_in_space_is_compared_in_its_own_plane) {
  std::filesystem::create_directories(folder + "/solid");
  core::write_text(folder + "/solid/meridians.csv",
                   "angle_deg,arc_mm,r_mm,z_mm,thickness_mm\n0,0,0,20,1\n0,20,9,0,3\n45,21,0,20,5\n45,41,9,0,7\n");
  const Scene scene = read_scene(PARISON_SOURCE_DIR "/tests/sweeps/tiny_square.toml", "draft");
  const auto over_arc =
      read_measurements(data("angle_deg,arc_mm,thickness_mm\n225,5,2\n-180,5,2\n225,15,3\n-180,15,2\n"), scene, {});
  ASSERT_EQ(over_arc.size(), 2u);
  EXPECT_EQ(over_arc[0].name(), "wall at 45 deg");
  EXPECT_EQ(over_arc[0].at, (std::vector<double>{5, 15}));
  EXPECT_EQ(model_at(over_arc[0], folder), (std::vector<double>{5.5, 6.5}));
  EXPECT_EQ(model_at(over_arc[1], folder), (std::vector<double>{1.5, 2.5}));
  const auto over_height = read_measurements(data("angle_deg,z_mm,thickness_mm\n45,5,2\n45,15,2\n"), scene, {});
  ASSERT_EQ(over_height.size(), 1u);
  EXPECT_EQ(model_at(over_height[0], folder), (std::vector<double>{6.5, 5.5}));
  EXPECT_THROW(read_measurements(data("angle_deg,z_mm,thickness_mm\n30,5,2\n30,15,2\n"), scene, {}), core::CaseError);
  EXPECT_THROW(read_measurements(data("z_mm,thickness_mm\n5,2\n15,2\n"), scene, {}), core::CaseError);
  EXPECT_THROW(read_measurements(data("time_s,mould_force_N\n0.1,2\n"), scene, {}), core::CaseError);
}

TEST_F(CalibrationTest, a_wall_table_with_a_decimal_comma_or_a_falling_arc_is_refused) {
  const auto refused = [&](const std::string& text) {
    try {
      read_wall_table(data(text));
      return std::string();
    } catch (const core::CaseError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_NE(refused("arc_mm,thickness_mm\n0,2,4\n1,2,5\n").find("csv:2: 3 cells were found"), std::string::npos);
  EXPECT_NE(refused("arc_mm,thickness_mm\n0,2\n4,2\n3,2\n").find("csv:4: the arc 3 was found after 4"),
            std::string::npos);
}

TEST_F(CalibrationTest, constants_are_searched_by_their_logarithms_and_temperatures_are_not) {
  const auto variables = vary({"interface.0.open_gap=20 um to 200 um", "tool.iron.temperature=400 degC to 500 degC"});
  EXPECT_TRUE(variables[0].logarithmic);
  EXPECT_NEAR(variables[0].value(variables[0].start), 60, 1e-9);
  EXPECT_FALSE(variables[1].logarithmic);
  EXPECT_NEAR(variables[1].start, 450, 1e-12);
}

TEST_F(CalibrationTest, a_unit_behind_the_last_bound_holds_for_both) {
  const auto once = vary({"interface.0.open_gap=20 to 200 um"}), twice = vary({"interface.0.open_gap=20 um to 200 um"});
  EXPECT_EQ(once[0].bounds.unit, "um");
  EXPECT_EQ(once[0].low(), twice[0].low());
  EXPECT_EQ(once[0].high(), twice[0].high());
}

TEST_F(CalibrationTest, two_constants_that_do_the_same_are_named_together) {
  const auto variables = vary({"interface.0.open_gap=20 um to 200 um", "interface.0.opening_time=0.1 s to 2 s"});
  const VectorXd at = (VectorXd(2) << variables[0].start, variables[1].start).finished();
  MatrixXd jacobian(30, 2);
  for (Eigen::Index i = 0; i < 30; ++i) jacobian.row(i) << 1 + double(i), 1 + double(i);
  const FitIntervals found = fit_intervals(variables, at, VectorXd::Ones(30), jacobian);
  ASSERT_EQ(found.cannot.size(), 1u);
  EXPECT_NE(found.cannot[0].find("interface.0.open_gap times"), std::string::npos) << found.cannot[0];
  EXPECT_NE(found.cannot[0].find("interface.0.opening_time times"), std::string::npos) << found.cannot[0];
  EXPECT_TRUE(std::isnan(found.constants[0].low));
  jacobian(3, 0) += 50;
  EXPECT_TRUE(fit_intervals(variables, at, VectorXd::Ones(30), jacobian).cannot.empty());
}

TEST_F(CalibrationTest, a_thermocouple_with_1_K_noise_gives_the_constants_of_the_contact_in_95_percent_intervals) {
  const auto variables = vary({"interface.0.open_gap=20 um to 200 um", "interface.0.opening_time=0.1 s to 2 s"});
  const VectorXd truth = (VectorXd(2) << std::log(85.0), std::log(0.8)).finished();
  const VectorXd exact = couple(variables, truth);
  int inside[2] = {0, 0};
  constexpr int histories = 100;
  for (unsigned seed = 0; seed < histories; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 1);
    VectorXd measured = exact;
    for (double& value : measured) value += noise(random);
    const auto constants = fit(variables, measured, 1).intervals.constants;
    for (std::size_t i = 0; i < 2; ++i) {
      const double value = variables[i].value(truth[Eigen::Index(i)]);
      if (constants[i].low <= value && value <= constants[i].high) ++inside[i];
    }
  }
  RecordProperty("open_gap", inside[0]);
  RecordProperty("opening_time", inside[1]);
  EXPECT_GE(inside[0], 90);
  EXPECT_GE(inside[1], 90);
}

}  // namespace
}  // namespace parison::forming
