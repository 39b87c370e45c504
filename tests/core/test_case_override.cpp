// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/case/case_file.hpp"
#include "test_folder.hpp"

namespace parison::core {
namespace {

const std::string text = R"(stage = [{ name = "press", tools = ["blank", "ring"] }]
[air]
h = "20 W/m2/K"
[[tool]]
name = "ring"
temperature = "460 degC"
[[tool]]
name = "blank"
temperature = "450 degC"
mesh.mapped = [20, 24]
[[interface]]
tools = ["ring", "blank"]
h = "2000 W/m2/K"
)";

CaseFile file_with(const std::vector<std::string>& overrides) {
  const auto path = std::filesystem::path(tests::new_folder()) / "case.toml";
  std::ofstream(path) << text;
  auto file = read_case_file(path.string());
  for (const auto& assignment : overrides) override_value(file, assignment);
  return file;
}

std::string complaint(const std::string& assignment) {
  try {
    file_with({assignment});
  } catch (const CaseError& error) {
    return error.what();
  }
  return "";
}

const CaseNode& item(const CaseNode& table, const std::string& name) {
  for (const auto& member : table.items)
    if (member.name == name) return member;
  throw std::runtime_error(name);
}

const CaseNode& entry(const CaseFile& file, const char* list, std::size_t at) {
  return item(file.root, list).items.at(at);
}

TEST(CaseOverride, an_entry_of_a_list_is_picked_by_its_name_or_its_number) {
  for (const char* path : {"tool.blank.temperature", "tool.1.temperature"}) {
    const auto file = file_with({std::string(path) + "=\"480 degC\""});
    EXPECT_DOUBLE_EQ(quantity(item(entry(file, "tool", 1), "temperature"), dimension::temperature), 753.15);
    EXPECT_DOUBLE_EQ(quantity(item(entry(file, "tool", 0), "temperature"), dimension::temperature), 733.15);
  }
}

TEST(CaseOverride, values_are_toml_or_plain_text) {
  const auto file = file_with({"air.h = 30 W/m2/K", "tool.blank.mesh.mapped.0=40", "stage.press.tools=['ring']",
                               "tool.ring.mesh={ mapped = [2, 3] }", "tool.ring.on=true"});
  EXPECT_EQ(item(item(file.root, "air"), "h").text, "30 W/m2/K");
  EXPECT_EQ(count(item(item(entry(file, "tool", 1), "mesh"), "mapped").items.at(0)), 40);
  EXPECT_EQ(item(entry(file, "stage", 0), "tools").items.at(0).text, "ring");
  EXPECT_EQ(count(item(item(entry(file, "tool", 0), "mesh"), "mapped").items.at(1)), 3);
  EXPECT_TRUE(flag(item(entry(file, "tool", 0), "on")));
}

TEST(CaseOverride, a_tool_among_others_gets_an_interface_of_its_own) {
  const auto file = file_with({"interface.blank.h=9 W/m2/K", "interface.blank.law=constant"});
  ASSERT_EQ(item(file.root, "interface").items.size(), 2u);
  const auto &shared = entry(file, "interface", 0), &own = entry(file, "interface", 1);
  EXPECT_EQ(item(shared, "h").text, "2000 W/m2/K");
  ASSERT_EQ(item(shared, "tools").items.size(), 1u);
  EXPECT_EQ(item(shared, "tools").items[0].text, "ring");
  EXPECT_EQ(item(own, "h").text, "9 W/m2/K");
  EXPECT_EQ(item(own, "law").text, "constant");
  ASSERT_EQ(item(own, "tools").items.size(), 1u);
  EXPECT_EQ(item(own, "tools").items[0].text, "blank");
}

TEST(CaseOverride, a_table_that_the_file_leaves_out_can_be_begun) {
  const auto file = file_with({"numerics.max_step=20 ms", "numerics.max_cells=2"});
  EXPECT_EQ(item(item(file.root, "numerics"), "max_step").text, "20 ms");
  EXPECT_EQ(item(item(file.root, "numerics"), "max_cells").number, 2);
}

TEST(CaseOverride, assignments_are_kept_as_given) {
  EXPECT_EQ(file_with({"air.h=1 W/m2/K", "air.h=2 W/m2/K"}).overrides,
            (std::vector<std::string>{"air.h=1 W/m2/K", "air.h=2 W/m2/K"}));
}

TEST(CaseOverride, what_leads_nowhere_is_refused_with_the_nearest_name) {
  EXPECT_EQ(
      complaint("tool.blnk.temperature=1"),
      "--set: tool.blnk.temperature: no entry \"blnk\" was found (did you mean \"blank\"?), allowed are numbers from 0 "
      "to 1, and the names ring, blank");
  EXPECT_EQ(
      complaint("interface.2.h=1"),
      "--set: interface.2.h: no entry \"2\" was found, allowed are numbers from 0 to 0, and the names ring, blank");
  EXPECT_EQ(complaint("air.h.x=1"),
            "--set: air.h.x: nothing below \"air.h\" was found, allowed is to set the value itself");
  for (const char* broken : {"air.h", "=1", "air..h=1", ""})
    EXPECT_NE(complaint(broken).find("allowed is KEY=VALUE such as"), std::string::npos) << broken;
  for (const char* broken : {"air.h=[1", "air.h={", "air.h=\"x", "air.h=", "air.h=[1]\nx = 2"})
    EXPECT_NE(complaint(broken).find("was found, allowed is a TOML value or a text"), std::string::npos) << broken;
}

TEST(CaseOverride, a_wrong_value_is_refused_in_the_words_of_the_case_file) {
  const auto file = file_with({"tool.ring.temperature=3 mm"});
  try {
    quantity(item(entry(file, "tool", 0), "temperature"), dimension::temperature);
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_STREQ(error.what(),
                 "--set: tool.ring.temperature: \"3 mm\" is a length, allowed is a temperature such as \"1150 degC\"");
  }
}

}  // namespace
}  // namespace parison::core
