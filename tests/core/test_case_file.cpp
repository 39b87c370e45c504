// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/case/case_file.hpp"
#include "test_folder.hpp"

namespace parison::core {
namespace {

/// A case file of the given text in a folder of its own.
std::string write_case(const std::string& text) {
  const auto folder = tests::folder_of_test("case");
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "case.toml") << text;
  return (folder / "case.toml").string();
}

/// What an action complains about, without the file's name.
template <class Action>
std::string complaint(const std::string& file, Action action) {
  try {
    action();
  } catch (const CaseError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(file + ":", 0), 0u) << message;
    return message.substr(file.size() + 1);
  }
  return "";
}

TEST(CaseFile, a_folder_stands_for_its_case_toml) {
  const auto path = write_case("a = 1\n");
  const auto folder = std::filesystem::path(path).parent_path().string();
  EXPECT_EQ(read_case_file(folder).path, path);
  EXPECT_EQ(read_case_file(path).directory, folder);
}

TEST(CaseFile, what_cannot_be_opened_is_a_case_error_that_says_why) {
  const std::string folder = tests::new_folder();
  std::filesystem::create_symlink("loop_back", folder + "/loop");
  std::filesystem::create_symlink("loop", folder + "/loop_back");
  const auto said = [](const std::string& path) { return complaint(path, [&] { read_case_file(path); }); };
  EXPECT_EQ(said(folder + "/loop"), "1: cannot be read: Too many levels of symbolic links");
  EXPECT_EQ(said(folder + '/' + std::string(300, 'x')), "1: cannot be read: File name too long");
  EXPECT_EQ(said("/dev/null"), "1: is not a file with a content, allowed is a regular file");
  EXPECT_EQ(said(folder + "/none"), "1: no such file, allowed is a case file or a folder that holds a case.toml");
}

TEST(CaseFile, every_value_knows_its_line_and_its_keys) {
  const auto file =
      read_case_file(write_case("a = 1\n\n[b]\nlength = '2 mm'\nlist = [\n  'x',\n  'y']\n[[c]]\nd.e = true\n"));
  const CaseTable root(file.root, {"a", "b", "c"});
  const CaseTable b(root.get("b"), {"length", "list"});
  EXPECT_EQ(b.get("length").line, 4);
  EXPECT_EQ(b.get("length").key, "b.length");
  EXPECT_DOUBLE_EQ(quantity(b.get("length"), dimension::length), 2e-3);
  EXPECT_EQ(list(b.get("list"))[1].line, 7);
  const CaseTable c(*root.tables("c").at(0), {"d"});
  EXPECT_EQ(entries(c.get("d")).at(0).key, "c.d.e");
  EXPECT_TRUE(flag(entries(c.get("d")).at(0)));
  EXPECT_DOUBLE_EQ(quantity(root.get("a"), dimension::none), 1);
}

TEST(CaseFile, an_unknown_key_is_refused_with_the_nearest_known_one) {
  const auto path = write_case("[stage]\nname = 'press'\nduraton = '1 s'\n");
  const auto file = read_case_file(path);
  EXPECT_EQ(complaint(path,
                      [&] {
                        CaseTable(file.root.items[0], {"name", "duration", "tools"});
                      }),
            "3: stage.duraton: unknown key (did you mean \"duration\"?), allowed are name, duration, tools");
}

TEST(CaseFile, a_missing_key_is_named_at_its_table) {
  const auto path = write_case("\n[stage]\nname = 'press'\n");
  const auto file = read_case_file(path);
  const CaseTable stage(file.root.items[0], {"name", "duration"});
  EXPECT_EQ(stage.find("duration"), nullptr);
  EXPECT_EQ(complaint(path, [&] { stage.get("duration"); }),
            "2: stage.duration: missing, the table that starts here needs the key \"duration\"");
}

TEST(CaseFile, broken_toml_is_a_case_error_at_its_line) {
  for (const char* broken : {"[[[x", "[[[x]]]", "[", "[[", "[[x", "[]", "[x]]", "= 1", "a", "a =", "a = [", "a = {",
                             "a = '", "a = \"\"\"", "a = 1 b = 2", ".a = 1", "a. = 1", "a = 1\na = 2", "a = 0x"}) {
    const auto path = write_case(std::string("case = 'x'\n") + broken);
    const auto message = complaint(path, [&] { read_case_file(path); });
    EXPECT_TRUE(message.rfind("2: ", 0) == 0 || message.rfind("3: ", 0) == 0) << broken << ": " << message;
    EXPECT_NE(message.find(", allowed is TOML"), message.npos) << broken << ": " << message;
  }
}

TEST(CaseFile, bytes_that_are_no_text_are_a_case_error) {
  const auto path = write_case("case = 'x'\n\xff\xfe");
  EXPECT_NE(complaint(path, [&] { read_case_file(path); }).find(", allowed is TOML"), std::string::npos);
}

TEST(CaseFile, an_identifier_has_only_letters_digits_underscore_and_hyphen) {
  const auto path = write_case("a = 'blow_mould-2'\nb = 'blow mould'\nc = ''\nd = 'm\u00fcller'\ne = '../x'\n");
  const auto file = read_case_file(path);
  const CaseTable root(file.root, {"a", "b", "c", "d", "e"});
  EXPECT_EQ(identifier(root.get("a")), "blow_mould-2");
  EXPECT_EQ(complaint(path, [&] { identifier(root.get("b")); }),
            "2: b: \"blow mould\" was found, allowed are names of letters, digits, _ and -");
  for (const char* key : {"c", "d", "e"}) EXPECT_THROW(identifier(root.get(key)), CaseError) << key;
  const auto long_one = write_case("f = '" + std::string(101, 'x') + "'\ng = '" + std::string(100, 'x') + "'\n");
  const auto names = read_case_file(long_one);
  EXPECT_EQ(complaint(long_one,
                      [&] {
                        identifier(CaseTable(names.root, {"f", "g"}).get("f"));
                      }),
            "1: f: a name of 101 characters was found, allowed are up to 100");
  EXPECT_EQ(identifier(CaseTable(names.root, {"f", "g"}).get("g")).size(), 100u);
}

TEST(CaseFile, a_wrong_kind_of_value_is_named) {
  const auto path = write_case("a = 5\nb = [1]\nc = 'x'\nd = 2.5\n");
  const auto file = read_case_file(path);
  const CaseTable root(file.root, {"a", "b", "c", "d"});
  EXPECT_EQ(complaint(path, [&] { quantity(root.get("a"), dimension::length); }),
            "1: a: the number 5 was found, allowed is a length such as \"2.5 mm\"");
  EXPECT_EQ(complaint(path, [&] { text(root.get("b")); }), "2: b: a list was found, allowed is a text in quotes");
  EXPECT_EQ(complaint(path, [&] { list(root.get("c")); }),
            "3: c: the text \"x\" was found, allowed is a list in brackets");
  EXPECT_EQ(complaint(path, [&] { count(root.get("d")); }),
            "4: d: the number 2.5 was found, allowed is a whole number from 1 to 1000000");
  EXPECT_EQ(complaint(path, [&] { choice(root.get("c"), {"y", "z"}); }), "3: c: \"x\" was found, allowed are y, z");
}

TEST(CaseFile, signs_are_checked) {
  const auto path = write_case("a = '-5 mm'\nb = '-300 degC'\nc = 0\n");
  const auto file = read_case_file(path);
  const CaseTable root(file.root, {"a", "b", "c"});
  EXPECT_EQ(complaint(path, [&] { positive(root.get("a"), dimension::length); }),
            "1: a: \"-5 mm\" was found, allowed is a length such as \"2.5 mm\", above zero");
  EXPECT_EQ(complaint(path, [&] { not_negative(root.get("a"), dimension::length); }),
            "1: a: \"-5 mm\" was found, allowed is a length such as \"2.5 mm\", not below zero");
  EXPECT_EQ(complaint(path, [&] { quantity(root.get("b"), dimension::temperature); }),
            "2: b: \"-300 degC\" is not above absolute zero, allowed is a temperature such as \"1150 degC\"");
  EXPECT_EQ(not_negative(root.get("c"), dimension::none), 0);
  EXPECT_NE(complaint(path, [&] { positive(root.get("c"), dimension::none); }), "");
}

TEST(CaseFile, a_table_of_quantities_interpolates_and_has_to_rise) {
  const auto path = write_case(
      "a = [['20 degC', '850 J/kg/K'],\n['120 degC', '950 J/kg/K']]\nb = [['20 degC', '1 m'],\n"
      "['10 degC', '1 m']]\nc = '3 m'\n");
  const auto file = read_case_file(path);
  const CaseTable root(file.root, {"a", "b", "c"});
  EXPECT_DOUBLE_EQ(quantity_table(root.get("a"), dimension::temperature, dimension::heat_capacity)(343.15), 900);
  EXPECT_DOUBLE_EQ(quantity_table(root.get("c"), dimension::temperature, dimension::length)(343.15), 3);
  EXPECT_EQ(complaint(path, [&] { quantity_table(root.get("b"), dimension::temperature, dimension::length); }),
            "4: b: \"10 degC\" does not lie above the entry before, allowed are rising entries");
}

TEST(CaseFile, a_quantity_over_time_is_a_constant_or_pairs) {
  const auto path = write_case("a = [['0 s', '2 m'],\n['2 s', '6 m'], ['4 s', '-1 m']]\nb = '3 m'\n");
  const auto file = read_case_file(path);
  const CaseTable root(file.root, {"a", "b"});
  const TimeFunction a = quantity_over_time(root.get("a"), dimension::length);
  EXPECT_DOUBLE_EQ(a(-1), 2);
  EXPECT_DOUBLE_EQ(a(1), 4);
  EXPECT_DOUBLE_EQ(a(9), -1);
  EXPECT_DOUBLE_EQ(a.derivative(1), 2);
  EXPECT_EQ(a.derivative(-1), 0);
  EXPECT_DOUBLE_EQ(a.min(), -1);
  EXPECT_DOUBLE_EQ(a.max(), 6);
  const TimeFunction b = not_negative_over_time(root.get("b"), dimension::length);
  EXPECT_DOUBLE_EQ(b(7), 3);
  EXPECT_EQ(b.derivative(7), 0);
  EXPECT_DOUBLE_EQ(b.min() + b.max(), 6);
  EXPECT_EQ(complaint(path, [&] { not_negative_over_time(root.get("a"), dimension::length); }),
            "2: a: \"-1 m\" was found, allowed is a length such as \"2.5 mm\", not below zero");
}

TEST(CaseFile, broken_toml_and_missing_files_are_case_errors) {
  const auto path = write_case("a = 1\nb = = 2\n");
  EXPECT_EQ(complaint(path, [&] { read_case_file(path); }).substr(0, 2), "2:");
  const auto absent = path + ".none";
  EXPECT_EQ(complaint(absent, [&] { read_case_file(absent); }),
            "1: no such file, allowed is a case file or a folder that holds a case.toml");
}

TEST(CaseFile, the_nearest_word_is_found_and_a_far_one_is_not) {
  const std::vector<std::string> words = {"density", "viscosity", "conductivity"};
  EXPECT_EQ(nearest("viscocity", words), "viscosity");
  EXPECT_EQ(nearest("densty", words), "density");
  EXPECT_EQ(nearest("colour", words), "");
}

TEST(CaseFile, a_word_with_a_known_one_as_a_whole_part_is_near_it) {
  const std::vector<std::string> words = {"grey_iron", "flint", "float"};
  EXPECT_EQ(nearest("flint_glass", words), "flint");
  EXPECT_EQ(nearest("iron", words), "grey_iron");
  EXPECT_EQ(nearest("flintstone_wall", words), "");
}

/// The words joined by dots.
std::string dotted(int count) {
  std::string key = "a";
  for (int i = 1; i < count; ++i) key += ".a";
  return key;
}

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

TEST(CaseFile, what_is_nested_too_deeply_is_refused_before_it_is_parsed) {
  const std::string sentence =
      "2: keys or values within each other were found, deeper than 16 levels, allowed are so many";
  for (const std::string& deep :
       {dotted(200'000) + " = 1", "[" + dotted(200'000) + "]", "b = " + repeated("[", 200'000),
        "b = " + repeated("{ c = ", 200'000), "b = {" + dotted(200'000) + " = 1 }", repeated("\"a\" . ", 200'000)}) {
    const std::string path = write_case("a = 1\n" + deep + "\n");
    EXPECT_EQ(complaint(path, [&] { read_case_file(path); }), sentence) << deep.substr(0, 20);
  }
  CaseNode place;
  place.file = "--set";
  EXPECT_THROW(parse_value("{" + dotted(200'000) + " = 1 }", place), CaseError);
}

TEST(CaseFile, dots_and_brackets_in_texts_and_comments_are_not_nested) {
  const std::string many = repeated(".[{", 100);
  EXPECT_EQ(read_case_file(write_case("a = \"" + many + "\\\"" + many + "\"\nb = '" + many + "'\n# " + many +
                                      "\nc = \"\"\"" + many + "\n\"" + many + "\"\"\"\nd.e.f.g = 1.5\n"))
                .root.items.size(),
            4u);
}

TEST(CaseFile, a_text_of_several_lines_may_end_with_two_more_quotes_and_hides_nothing_behind_it) {
  const auto file = read_case_file(write_case("a = \"\"\"x\"\"\"\"\"\nb = \'\'\'y\'\'\'\'\nc = 1\n"));
  EXPECT_EQ(file.root.items.at(0).text, "x\"\"");
  EXPECT_EQ(file.root.items.at(1).text, "y\'");
  const std::string path = write_case("a = [\"\"\"x\"\"\"\", {" + dotted(200'000) + " = 1 }]\n");
  EXPECT_NE(complaint(path, [&] { read_case_file(path); }).find("deeper than 16 levels"), std::string::npos);
}

TEST(CaseFile, signs_that_are_not_ascii_are_for_texts_and_comments) {
  EXPECT_EQ(read_case_file(write_case("\xEF\xBB\xBF"
                                      "a = \"\u00fc\" # \u00fc\n"))
                .root.items.at(0)
                .text,
            "\u00fc");
  for (const char* sign : {"\u00fc", "\u1b20", "\u3000", "\u2028"}) {
    const std::string path = write_case(std::string("a = 1\n") + sign + " = 2\n");
    EXPECT_EQ(complaint(path, [&] { read_case_file(path); }),
              "2: a sign that is not ASCII was found outside texts and comments, allowed is TOML");
  }
  // A plain text of --set is no TOML and may have any sign.
  EXPECT_EQ(parse_value("\u00fcber", CaseNode{}).text, "\u00fcber");
}

TEST(CaseFile, a_file_of_more_than_four_megabytes_is_refused) {
  const std::string path = write_case("a = 1\n");
  std::filesystem::resize_file(path, 3'000'000'000);
  EXPECT_EQ(complaint(path, [&] { read_case_file(path); }), "1: is too large, allowed are files of up to 4 MB");
}

TEST(CaseFile, a_text_with_line_breaks_or_signs_for_the_terminal_is_quoted_on_one_line) {
  const std::string path = write_case("a = \"one\\ntwo\\u001B[31m\"\n");
  const CaseFile file = read_case_file(path);
  const CaseTable root(file.root, {"a"});
  EXPECT_EQ(complaint(path, [&] { quantity(root.get("a"), dimension::none); }),
            "1: a: \"one two [31m\" does not start with a number, allowed is a plain number such as \"0.5\"");
}

TEST(CaseFile, a_long_text_is_cut_in_the_sentence_about_it) {
  const std::string path = write_case("a = \"" + std::string(1'000'000, 'x') + "\"\n");
  const CaseFile file = read_case_file(path);
  const CaseTable root(file.root, {"a"});
  EXPECT_LT(complaint(path, [&] { quantity(root.get("a"), dimension::length); }).size(), 2000u);
}

}  // namespace
}  // namespace parison::core
