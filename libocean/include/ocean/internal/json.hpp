// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// JSON, written: every text in this form that leaves the library or a tool is built here.
// Strings are escaped as they enter, and a number that JSON does not have is refused.
#pragma once

#include <concepts>
#include <cstddef>
#include <ranges>
#include <span>
#include <string>
#include <string_view>

#include "ocean/text.hpp"

namespace ocean {

/// In quotes; quotation marks, backslashes and control characters escaped, bytes that are not UTF-8
/// replaced by '?'.
std::string json_string(std::string_view text);
/// An array of strings.
std::string json_list(std::span<const std::string> texts);

class JsonItems;

/// One value, as text.
class Json {
  public:
    Json(std::nullptr_t) : text_("null") {}
    Json(std::string_view text) : text_(json_string(text)) {}
    Json(const std::string& text) : text_(json_string(text)) {}
    Json(const char* text) : text_(json_string(text)) {}
    Json(const JsonItems& items);
    template <std::integral Whole>
    requires(sizeof(Whole) > 1)  // neither a truth nor a character
        Json(Whole value)
        : text_(std::to_string(value)) {}
    template <std::same_as<bool> Truth>  // no pointer becomes one
    Json(Truth value) : text_(value ? "true" : "false") {}
    /// Spelled as `spelling` does it. Throws Error invalid_value for what is not finite.
    Json(double value, std::string (*spelling)(double) = shortest_text);

    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// The same with null for a number that is not finite: not known, or without bound.
Json json_number_or_null(double value, std::string (*spelling)(double) = shortest_text);

/// Each item on a line of its own, `indent` spaces in; the closing bracket stands two less far in.
struct JsonLines {
    int indent;
};

/// What arrays and objects share: brackets and what stands between the items. Without JsonLines
/// all is one line.
class JsonItems {
  public:
    std::string text() const { return text_ + closing_; }

  protected:
    explicit JsonItems(std::string_view brackets);
    JsonItems(std::string_view brackets, JsonLines lines);
    void add_item(std::string_view item);
    void break_lines(int indent);

  private:
    std::string text_;
    std::string before_first_;
    std::string between_ = ", ";
    std::string closing_;
    bool empty_ = true;
};

class JsonArray : public JsonItems {
  public:
    JsonArray() : JsonItems("[]") {}
    explicit JsonArray(JsonLines lines) : JsonItems("[]", lines) {}
    JsonArray& add(const Json& value);
};

/// All items of a range, on one line.
template <std::ranges::input_range Items>
JsonArray json_array(const Items& items) {
    JsonArray array;
    for (const auto& item : items) array.add(item);
    return array;
}

class JsonObject : public JsonItems {
  public:
    JsonObject() : JsonItems("{}") {}
    explicit JsonObject(JsonLines lines) : JsonItems("{}", lines) {}
    JsonObject& add(std::string_view key, const Json& value);
    /// The members that follow stand on lines of their own, `indent` spaces in.
    JsonObject& then_lines(int indent);
};

}  // namespace ocean
