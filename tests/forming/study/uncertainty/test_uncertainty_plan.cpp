// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "../../pot_scene.hpp"
#include "../../scene_text.hpp"
#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/run/run.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/state/fingerprint.hpp"
#include "forming/study/uncertainty/uncertainty_plan.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

class UncertaintyPlanTest : public ::testing::Test {
 protected:
  const std::string folder = tests::absent_folder();
  void SetUp() override {
    fs::create_directories(folder);
    core::write_text(folder + "/case.toml", replaced("duration = \"0.4 s\"", "duration = \"0.1 s\"", pot));
  }
  void TearDown() override { fs::remove_all(folder); }

  UncertaintyPlan plan(const std::vector<std::string>& settings, std::size_t runs = 0) const {
    return plan_uncertainty({folder, "draft coarser 2", settings, folder + "/out", runs, 1});
  }
  std::string refusal(const std::vector<std::string>& settings, std::size_t runs = 0) const {
    try {
      plan(settings, runs);
    } catch (const core::CaseError& error) {
      return error.what();
    }
    return "";
  }
  void expect_refused(const std::vector<std::string>& settings, const std::string& sentence,
                      std::size_t runs = 0) const {
    const std::string said = refusal(settings, runs);
    EXPECT_NE(said.find(sentence), std::string::npos) << "wanted \"" << sentence << "\" in: " << said;
  }
};

TEST_F(UncertaintyPlanTest, RunsTheMeanToTheSameBits) {
  const std::string plain = "tool.pot.temperature=470 degC", tolerant = "tool.pot.temperature=470 +- 10 degC";
  const auto state_of_run = [&](const std::string& setting) {
    const Scene scene = read_scene(folder, "draft coarser 2", {setting});
    return fingerprint(run(scene).state);
  };
  EXPECT_EQ(state_of_run(plain), state_of_run(tolerant));
  EXPECT_NE(state_of_run(plain), state_of_run("tool.pot.temperature=471 degC"));
}

TEST_F(UncertaintyPlanTest, IsListedByCheck) {
  const Scene scene = read_scene(folder, "draft", {"tool.pot.temperature=470 +- 10 degC uniform"});
  EXPECT_NE(describe_scene(scene).find("tool.pot.temperature = 470 +- 10 degC uniform"), std::string::npos);
}

TEST_F(UncertaintyPlanTest, DrawsAllTolerancesWithinTheirRange) {
  const UncertaintyPlan drawn =
      plan({"tool.pot.temperature=470 +- 10 degC uniform", "glass.temperature=1000 +- 5 degC"});
  ASSERT_EQ(drawn.tolerances.size(), 2u);
  EXPECT_EQ(drawn.drawn.runs.size(), 32u);
  EXPECT_EQ(drawn.noise.runs.size(), 6u);
  EXPECT_EQ(drawn.mean.runs.size(), 1u);
  std::set<std::string> texts;
  for (const SweepRun& run : drawn.drawn.runs)
    for (const std::string& value : run.values) texts.insert(value);
  EXPECT_EQ(texts.size(), 64u);
  EXPECT_LT(std::abs(drawn.places.mean()), 0.1);
  EXPECT_NEAR(drawn.places.array().square().mean(), 1, 0.1);
}

TEST_F(UncertaintyPlanTest, EndsWhereTheKeysRangeEnds) {
  const UncertaintyPlan drawn = plan({"glass.temperature=1000 +- 5 degC", "air.h=20 +- 15 W/m2/K"});
  const std::size_t air = drawn.tolerances[0].key == "air.h" ? 0 : 1;
  EXPECT_NEAR(value_at(drawn.tolerances[air], drawn.ranges[air].scatter.low), 0, 1e-2);
  EXPECT_NE(drawn.ranges[air].below.find("not below zero"), std::string::npos) << drawn.ranges[air].below;
  EXPECT_TRUE(drawn.ranges[air].above.empty());
}

TEST_F(UncertaintyPlanTest, WithoutAToleranceIsASentence) {
  expect_refused({}, "case.toml: no tolerance was found, allowed is at least one value such as \"460 +- 10 degC\"");
}

TEST_F(UncertaintyPlanTest, OfWrongTolerancesIsASentence) {
  expect_refused({"tool.pot.temperature=470 degC +- 10 mm"},
                 "--set: tool.pot.temperature: \"470 degC +- 10 mm\" has a length as the tolerance of");
  expect_refused({"tool.pot.temperature=470 +- 0 degC"}, "has the tolerance 0 degC, allowed is one above zero");
  expect_refused({"tool.pot.temperature=470 +- -3 degC"}, "has the tolerance -3 degC, allowed is one above zero");
  expect_refused({"tool.pot.friction=1 +- 0.1"}, "the tolerance \"1 +- 0.1\" was found, allowed");
  expect_refused({"tool.pot.temperature=470 +- 10 degC"}, "--runs: 5 runs were found, allowed are 11 to", 5);
}

}  // namespace
}  // namespace parison::forming
