// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/io/json.hpp"
#include "core/io/json_read.hpp"

namespace parison::core {
namespace {

TEST(Json, text_is_escaped_numbers_keep_their_digits_and_nan_is_null) {
  JsonWriter json;
  json.add("quote \" and \\", std::string("line\nbreak \x01"));
  json.add("third", 1 / 3.0);
  json.add("nan", std::nan(""));
  json.add("infinity", -std::numeric_limits<double>::infinity());
  json.add("whole", 12345678901L);
  json.open_object("empty");
  json.close();
  json.open_list("list");
  json.add("", true);
  json.open_object("");
  json.add("a", 1e-300);
  EXPECT_EQ(json.finish(), R"({
  "quote \" and \\": "line\nbreak \u0001",
  "third": 0.3333333333333333,
  "nan": null,
  "infinity": null,
  "whole": 12345678901,
  "empty": {},
  "list": [
    true,
    {
      "a": 1e-300
    }
  ]
}
)");
}

TEST(Json, what_was_written_is_read_back_in_its_order_and_a_torn_text_is_refused) {
  JsonWriter json;
  json.add("third", 1 / 3.0);
  json.add("nan", std::nan(""));
  json.add("two", 2.0);
  json.add("text", std::string("a \"b\"\n\xc2\xb0"
                               "C \xff"));
  json.add("flag", true);
  json.open_list("list");
  json.add("", 5e-324);
  const std::string text = json.finish();
  const JsonValue read = read_json(text, "summary.json");
  ASSERT_EQ(read.items.size(), 6u);
  EXPECT_EQ(read.items[1].name, "nan");
  EXPECT_EQ(read.number_of("third"), 1 / 3.0);
  EXPECT_TRUE(std::isnan(read.number_of("nan")));
  EXPECT_TRUE(std::isnan(read.number_of("absent")));
  EXPECT_EQ(read.number_of("two"), 2);
  EXPECT_EQ(read.text_of("text"),
            "a \"b\"\n\xc2\xb0"
            "C \xef\xbf\xbd");
  EXPECT_TRUE(read.flag_of("flag"));
  EXPECT_EQ(read.find("list")->items.at(0).number, 5e-324);
  try {
    read_json(text.substr(0, text.size() / 2), "summary.json");
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "summary.json: no JSON");
  }
}

}  // namespace
}  // namespace parison::core
