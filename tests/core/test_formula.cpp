// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/case/arithmetic/named_dimensions.hpp"
#include "test_folder.hpp"

namespace parison::core {
namespace {

const NamedQuantities known{[](std::string_view name) -> std::optional<Measure> {
                              if (name == "r") return Measure{0.024, dimension::length};
                              if (name == "h") return Measure{0.1, dimension::length};
                              if (name == "T") return Measure{1373.15, dimension::temperature};
                              return std::nullopt;
                            },
                            {"T", "h", "r"}};

double length(const std::string& text) {
  const auto parsed = parse_formula_as(text, dimension::length, known);
  EXPECT_EQ(parsed.problem, "") << text;
  return parsed.value;
}

std::string problem(const std::string& text, const Dimension& expected = dimension::length) {
  return parse_formula_as(text, expected, known).problem;
}

CaseFile case_with(const std::string& text) {
  const auto folder = tests::folder_of_test("formula");
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "case.toml") << text;
  return read_case_file(folder.string());
}

std::string complaint(const std::string& text) {
  try {
    CaseFile file = case_with(text);
    read_dimensions(file);
  } catch (const CaseError& error) {
    const std::string message = error.what();
    return message.substr(message.find("case.toml:") + 10);
  }
  return "";
}

TEST(Formula, products_come_before_sums_and_brackets_before_both) {
  EXPECT_DOUBLE_EQ(length("2*h + 3 mm"), 0.203);
  EXPECT_DOUBLE_EQ(length("2*(h + 3 mm)"), 0.206);
  EXPECT_DOUBLE_EQ(length("h - r - 1 mm"), 0.075);
  EXPECT_DOUBLE_EQ(length("h/2/5"), 0.01);
  EXPECT_DOUBLE_EQ(length("-h*-2"), 0.2);
  EXPECT_DOUBLE_EQ(length("r*r/h"), 0.00576);
}

TEST(Formula, functions_are_those_of_mathematics_with_units) {
  EXPECT_DOUBLE_EQ(length("sqrt(r*r + h*h)"), std::hypot(0.024, 0.1));
  EXPECT_DOUBLE_EQ(length("min(r, h) + max(r, h)"), 0.124);
  EXPECT_DOUBLE_EQ(length("h*sin(30 deg)"), 0.05);
  EXPECT_DOUBLE_EQ(length("h*cos(pi/3)"), 0.05);
  EXPECT_DOUBLE_EQ(length("h*tan(45 deg)"), 0.1);
}

TEST(Formula, whole_powers_bind_closer_than_products_and_signs) {
  EXPECT_DOUBLE_EQ(length("h*(r/h)^2"), 0.00576);
  EXPECT_DOUBLE_EQ(length("h - h*2^-3"), 0.0875);
  EXPECT_DOUBLE_EQ(length("-h^2/(1 m)"), -0.01);
  EXPECT_DOUBLE_EQ(length("(2 mm)^0*h"), 0.1);
  EXPECT_DOUBLE_EQ(length("h*exp(-r/h)"), 0.1 * std::exp(-0.24));
  for (const char* power : {"r^2.5", "r^r", "r^11", "r^-11", "r^2^2", "r^"})
    EXPECT_EQ(problem(power),
              fmt::format("\"{}\" is no quantity: allowed behind ^ is a whole number, -10 to 10", power));
  EXPECT_EQ(problem("(2 mm ^2)/h"),
            "\"(2 mm ^2)/h\" is no quantity: ^ follows a number with a unit, allowed are brackets around the two");
}

TEST(Formula, a_name_wins_over_the_unit_of_the_same_letter_but_not_behind_a_number) {
  EXPECT_DOUBLE_EQ(length("h"), 0.1);
  EXPECT_DOUBLE_EQ(parse_formula_as("2 h + 1 min", dimension::time, known).value, 7260);
  EXPECT_DOUBLE_EQ(parse_formula_as("50 mm/h", dimension::none, known).value, 0.5);
  EXPECT_EQ(problem("2 r"), "\"2 r\" is no quantity: \"r\" follows a number, allowed is a * between them");
}

TEST(Formula, plain_numbers_count_in_the_unit_of_their_points) {
  EXPECT_DOUBLE_EQ(parse_formula_as("2*(3 + 4)", dimension::length, known, "mm").value, 0.014);
  EXPECT_DOUBLE_EQ(parse_formula_as("r + 1 mm", dimension::length, known, "mm").value, 0.025);
  EXPECT_EQ(problem("3"), "\"3\" is a plain number, allowed is a length such as \"2.5 mm\"");
}

TEST(Formula, temperatures_on_a_scale_take_differences_only) {
  EXPECT_DOUBLE_EQ(parse_formula_as("T - 20 K", dimension::temperature, known).value, 1353.15);
  EXPECT_DOUBLE_EQ(parse_formula_as("20 K + 100 degC", dimension::temperature, known).value, 393.15);
  EXPECT_DOUBLE_EQ(parse_formula_as("T - 1000 degC", dimension::temperature_difference, known).value, 100);
  const std::string start = "\"T + 20 degC\" is no quantity: ";
  EXPECT_EQ(problem("T + 20 degC", dimension::temperature),
            start + "temperatures in degC are added, allowed is a difference in K");
  EXPECT_EQ(problem("2*T"), "\"2*T\" is no quantity: a temperature in degC is multiplied, allowed is one in K");
  EXPECT_EQ(problem("-T"),
            "\"-T\" is no quantity: a temperature in degC is negated, allowed is \"-10 degC\" by itself");
}

TEST(Formula, mistakes_have_their_sentences) {
  EXPECT_EQ(problem("r + 1 s"), "\"r + 1 s\" is no quantity: a length and a time are added");
  EXPECT_EQ(problem("r - 1"), "\"r - 1\" is no quantity: a length and a plain number are subtracted");
  EXPECT_EQ(problem("rr"), "\"rr\" is no quantity: there is no dimension \"rr\", allowed are T, h, r");
  EXPECT_EQ(problem("r +"), "\"r +\" is no quantity: it ends where a value is allowed");
  EXPECT_EQ(problem("(r"), "\"(r\" is no quantity: a closing bracket is missing");
  EXPECT_EQ(problem("r)"), "\"r)\" is no quantity: \")\" follows where an operator is allowed");
  EXPECT_EQ(problem("r & h"), "\"r & h\" is no quantity: \"& h\" follows where an operator is allowed");
  EXPECT_EQ(problem("r/0"), "\"r/0\" is no quantity: it divides by zero");
  EXPECT_EQ(problem("3 furlong + r"), "\"3 furlong + r\" is no quantity: it has the unknown unit \"furlong\"");
  EXPECT_EQ(problem("cosh(r)"),
            "\"cosh(r)\" is no quantity: there is no function \"cosh\", allowed are min, max, sqrt, exp, sin, cos, "
            "tan");
  EXPECT_EQ(problem("sin(r)"),
            "\"sin(r)\" is no quantity: sin of a length was found, allowed is that of a plain number or an angle");
  EXPECT_EQ(problem("sqrt(r)"),
            "\"sqrt(r)\" is no quantity: the square root of a length was found, allowed is that of an "
            "area or a plain number");
  EXPECT_EQ(problem("min(r)"), "\"min(r)\" is no quantity: min has one value, allowed are two");
  EXPECT_EQ(problem("r*h"), "\"r*h\" is an area, allowed is a length such as \"2.5 mm\"");
  EXPECT_EQ(problem("1e9 m + r"),
            "\"1e9 m + r\" is too large, allowed is a length such as \"2.5 mm\" of up to 1e+06 in SI "
            "units");
}

TEST(Formula, hostile_texts_are_refused_in_bounded_depth_length_and_power) {
  EXPECT_NE(problem(std::string(400, '(')).find("brackets deeper than 32 levels"), std::string::npos);
  EXPECT_EQ(problem(std::string(400, '-') + "r"), "");
  EXPECT_EQ(problem(std::string(501, '1')), "a formula of 501 signs was found, allowed are up to 500");
  std::string power = "r";
  while (power.size() < 400) power += "*r";
  EXPECT_NE(problem(power).find("powers of units beyond 30"), std::string::npos);
  EXPECT_NE(problem("1e300*1e300*r").find("its value is not finite"), std::string::npos);
  EXPECT_NE(problem("1e999*r").find("a number is too large"), std::string::npos);
}

TEST(NamedDimensions, entries_use_each_other_in_any_order_and_every_text_uses_them) {
  CaseFile file = case_with("length = \"b + a\"\n[dimension]\na = \"2*z\"\nb = 3\nz = \"5 mm\"\n");
  override_value(file, "dimension.b=1 mm");
  const auto dimensions = read_dimensions(file);
  ASSERT_EQ(dimensions.size(), 3u);
  EXPECT_EQ(dimensions[0].given, "2*z");
  EXPECT_DOUBLE_EQ(dimensions[0].measure.value, 0.01);
  const CaseTable root(file.root, {"length", "dimension"});
  EXPECT_DOUBLE_EQ(quantity(root.get("length"), dimension::length), 0.011);
}

TEST(NamedDimensions, mistakes_have_file_and_line) {
  EXPECT_EQ(complaint("[dimension]\na = \"b\"\nb = \"2*a\"\n"),
            "2: dimension.a: it is used by itself (a -> b -> a), allowed are entries without circles");
  EXPECT_EQ(complaint("[dimension]\na = \"1 mm\"\nb = \"2*c\"\n"),
            "3: dimension.b: \"2*c\" is no quantity: there is no dimension \"c\", allowed are a, b");
  EXPECT_EQ(complaint("[dimension]\n2a = \"1 mm\"\n"),
            "2: dimension.2a: the name \"2a\" was found, allowed are names of letters, digits and _ that begin with a "
            "letter, other than pi");
  EXPECT_EQ(complaint("[dimension]\na = [1]\n"),
            "2: dimension.a: a list was found, allowed are quantities such as \"24 mm\"; keys that follow [dimension] "
            "belong to it up to the next heading");
  EXPECT_EQ(complaint("dimension = 3\n"), "1: dimension: the number 3 was found, allowed is a table");
}

TEST(NamedDimensions, a_chain_or_a_table_without_end_is_refused) {
  std::string chain = "[dimension]\nd200 = \"1 mm\"\n", many = "[dimension]\n";
  for (int i = 100; i < 200; ++i) chain += "d" + std::to_string(i) + " = \"d" + std::to_string(i + 1) + "\"\n";
  for (int i = 0; i < 501; ++i) many += "d" + std::to_string(i) + " = 1\n";
  EXPECT_NE(complaint(chain).find("over more than 32 steps"), std::string::npos) << complaint(chain);
  EXPECT_EQ(complaint(many), "1: dimension: 501 entries were found, allowed are up to 500");
}

TEST(NamedDimensions, set_changes_those_that_exist_only) {
  CaseFile file = case_with("[dimension]\nr_neck = \"1 mm\"\n");
  try {
    override_value(file, "dimension.r_nek=2 mm");
    ADD_FAILURE();
  } catch (const CaseError& error) {
    EXPECT_EQ(std::string(error.what()),
              "--set: dimension.r_nek: no \"r_nek\" was found (did you mean \"r_neck\"?), allowed are r_neck");
  }
}

}  // namespace
}  // namespace parison::core
