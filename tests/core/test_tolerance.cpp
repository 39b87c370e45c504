// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/case/case_file.hpp"
#include "core/case/tolerance.hpp"

namespace parison::core {
namespace {

CaseFile file_of(const std::string& text) {
  return {"case.toml", ".", parse_case_text(text, "case.toml"), {}};
}

Tolerance only_one(const std::string& value) {
  CaseFile file = file_of("T = \"" + value + "\"");
  const auto found = take_tolerances(file);
  EXPECT_EQ(found.size(), 1u) << value;
  return found.empty() ? Tolerance{} : found.front();
}

std::string sentence(const std::string& value, const Dimension& dimension = dimension::temperature) {
  try {
    CaseFile file = file_of("T = " + value);
    take_tolerances(file);
    quantity(file.root.items.front(), dimension);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "";
}

void expect_in(const std::string& sentence, const std::string& part) {
  EXPECT_NE(sentence.find(part), std::string::npos) << "wanted \"" << part << "\" in: " << sentence;
}

TEST(Tolerance, IsANormalDeviationInTheUnitOfTheMean) {
  for (const char* text : {"460 +- 10 degC", "460 degC +- 10 K", "460+-10degC", "460 +- 10 degC normal",
                           "460 \u00b1 10 degC", "460 degC +- 10000 mK"}) {
    const Tolerance tolerance = only_one(text);
    EXPECT_EQ(tolerance.mean, 460) << text;
    EXPECT_NEAR(tolerance.spread, 10, 1e-12) << text;
    EXPECT_EQ(tolerance.unit, "degC") << text;
    EXPECT_EQ(tolerance.distribution, Distribution::normal) << text;
  }
  EXPECT_EQ(only_one("0.5 +- 20 %").unit, "%");
  EXPECT_NEAR(only_one("0.5 bar +- 2 kPa").spread, 0.02, 1e-15);
}

TEST(Tolerance, UniformIsHalfTheWidth) {
  const Tolerance tolerance = only_one("2.5 +- 0.3 mm uniform");
  EXPECT_EQ(tolerance.distribution, Distribution::uniform);
  EXPECT_EQ(tolerance.spread, 0.3);
  EXPECT_NEAR(tolerance.deviation(), 0.3 / std::sqrt(3.0), 1e-15);
}

TEST(Tolerance, LeavesTheMeanToTheLastBit) {
  CaseFile with = file_of("T = \"460.1 +- 10 degC\"\nh = \"0.3 +- 0.1\"\nL = \"2.7 mm +- 3 um\""),
           without = file_of("T = \"460.1 degC\"\nh = 0.3\nL = \"2.7 mm\"");
  EXPECT_EQ(take_tolerances(with).size(), 3u);
  const Dimension dimensions[] = {dimension::length, dimension::temperature, dimension::none};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(quantity(with.root.items[i], dimensions[i]), quantity(without.root.items[i], dimensions[i])) << i;
}

TEST(Tolerance, KeysAreThoseOfSet) {
  CaseFile file = file_of(R"(
tool = [{ name = "blank", temperature = "460 +- 10 degC" }]
interface = [{ tools = ["blank"], a = "1 +- 0.1" }, { tools = ["ring", "plate"], a = "1 +- 0.1" }]
pressure = [["0 s", "0 bar"], ["0.2 s", "0.4 +- 0.02 bar"]])");
  CaseFile set = file;
  const auto found = take_tolerances(file);
  ASSERT_EQ(found.size(), 4u);
  for (const Tolerance& tolerance : found)
    override_value(set, tolerance.key + "=" + tolerance.value_text(tolerance.mean));
  EXPECT_TRUE(take_tolerances(set).empty());
}

TEST(Tolerance, OfOtherTextsIsLeftAlone) {
  CaseFile file = file_of("about = \"measured, some +- 5 %\"\nT = \"2*h + 3 mm\"\nn = 3");
  EXPECT_TRUE(take_tolerances(file).empty());
  EXPECT_EQ(file.root.items.front().text, "2*h + 3 mm");
}

TEST(Tolerance, ThatIsWrongIsASentence) {
  expect_in(sentence("\"460 degC +- 10 mm\""),
            "case.toml:1: T: \"460 degC +- 10 mm\" has a length as the tolerance of a temperature difference, allowed");
  expect_in(sentence("\"460 +- 10 mm\""), "\"460 mm\" is a length, allowed is a temperature");
  expect_in(sentence("\"460 +- 0 degC\""), "has the tolerance 0 degC, allowed is one above zero");
  expect_in(sentence("\"460 +- -10 degC\""), "has the tolerance -10 degC, allowed is one above zero");
  expect_in(sentence("\"460 +- 10 furlong\""), "has the unknown unit \"furlong\"");
  expect_in(sentence("\"460 +- degC\""), "has no number as its tolerance, allowed is such as");
  expect_in(sentence("\"460 +- 10 degC triangular\""), "unknown unit \"degC triangular\"");
  expect_in(sentence("\"2*T_blank +- 10 degC\""), "allowed is one behind a single number");
}

TEST(Tolerance, OfWhatIsNoQuantityIsRefused) {
  CaseFile file = file_of("name = \"460 +- 10\"\ncount = \"5 +- 1\"\nflag = \"1 +- 1\"");
  take_tolerances(file);
  EXPECT_THROW(text(file.root.items[2]), CaseError);
  try {
    identifier(file.root.items[2]);
  } catch (const CaseError& error) {
    expect_in(error.what(), "name: the tolerance \"460 +- 10\" was found, allowed are tolerances of quantities");
  }
  try {
    count(file.root.items[0]);
    ADD_FAILURE();
  } catch (const CaseError& error) {
    expect_in(error.what(), "count: the tolerance \"5 +- 1\" was found, allowed is a whole number");
  }
  EXPECT_THROW(flag(file.root.items[1]), CaseError);
}

}  // namespace
}  // namespace parison::core
