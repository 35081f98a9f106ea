// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The output of the JSON writer can be read by every reader of JSON.
#include "ocean/internal/json.hpp"

#include <cstdint>

#include "ocean/error.hpp"
#include "testing.hpp"

namespace {

using ocean::Json;
using ocean::JsonArray;
using ocean::JsonLines;
using ocean::JsonObject;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Nothing in a text can end its string or break its line; the rest stays as it is.
TEST(Json, EscapesText) {
    EXPECT_EQ(ocean::json_string("a \"b\" \\ c"), R"("a \"b\" \\ c")");
    EXPECT_EQ(ocean::json_string(std::string_view("\n\x1b\x7f\0", 4)),
              R"("\u000A\u001B\u007F\u0000")");
    EXPECT_EQ(ocean::json_string("\xc3\xbc \xe2\x82\xac"), "\"\xc3\xbc \xe2\x82\xac\"");
    EXPECT_EQ(ocean::json_string("\xff|\xc3|\xed\xa0\x80|\xc0\xaf"), R"("?|?|???|??")");
    const std::vector<std::string> files = {"a", "b\"c"};
    EXPECT_EQ(ocean::json_array(files).text(), R"(["a", "b\"c"])");
    EXPECT_EQ(JsonArray().text(), "[]");
    EXPECT_EQ(JsonObject().add("a\"b", "c\"d").text(), R"({"a\"b": "c\"d"})");
}

// JSON has neither infinity nor NaN: no number is written rather than a wrong file.
TEST(Json, RefusesWhatIsNotFinite) {
    EXPECT_THROW(Json{kInfinity}, ocean::Error);
    EXPECT_THROW(Json{-kInfinity}, ocean::Error);
    EXPECT_THROW(Json{std::numeric_limits<double>::quiet_NaN()}, ocean::Error);
    EXPECT_EQ(ocean::json_number_or_null(kInfinity).text(), "null");
    EXPECT_EQ(ocean::json_number_or_null(0.1).text(), "0.1");
}

// The caller chooses the digits; other numbers read back to the same bits.
TEST(Json, SpellsNumbersAsAsked) {
    EXPECT_EQ(Json(0.1).text(), "0.1");
    EXPECT_EQ(Json(3e5).text(), "3e+05");
    EXPECT_EQ(Json(3e5, ocean::plain_text).text(), "300000");
    EXPECT_EQ(Json(1e-6, ocean::plain_text).text(), "1e-06");
    EXPECT_EQ(Json(0.5, [](double x) { return ocean::format_text("%.3f", x); }).text(), "0.500");
    EXPECT_EQ(Json(std::numeric_limits<std::uint64_t>::max()).text(), "18446744073709551615");
    EXPECT_EQ(Json(-1).text(), "-1");
}

// Objects and arrays nest; lines break only where requested.
TEST(Json, LaysOutObjectsAndArrays) {
    const JsonObject line = JsonObject().add("a", 1).add("b", nullptr);
    EXPECT_EQ(line.text(), R"({"a": 1, "b": null})");
    EXPECT_EQ(JsonArray().add(line).add(2).add("c").text(), R"([{"a": 1, "b": null}, 2, "c"])");
    EXPECT_EQ(JsonArray(JsonLines{2}).add(1).add(line).text(),
              "[\n  1,\n  {\"a\": 1, \"b\": null}\n]");
    EXPECT_EQ(JsonObject(JsonLines{2}).add("a", JsonArray(JsonLines{4}).add(1)).text(),
              "{\n  \"a\": [\n    1\n  ]\n}");
    EXPECT_EQ(JsonObject().add("a", 1).then_lines(2).add("b", 2).text(), "{\"a\": 1,\n  \"b\": 2}");
    EXPECT_EQ(JsonArray(JsonLines{1}).text(), "[\n]");
    EXPECT_EQ(ocean::json_array(std::vector<double>{1.5, 2.0}).text(), "[1.5, 2]");
}

}  // namespace
