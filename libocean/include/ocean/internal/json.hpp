// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// JSON writing: every JSON text that leaves the library or a tool is built here. Strings are
// escaped as they enter, and numbers that JSON cannot express are refused.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <ranges>
#include <string>
#include <string_view>

#include "ocean/internal/text.hpp"

namespace ocean {

/// Returns the text in quotes, with quotation marks, backslashes and control characters escaped and
/// bytes that are not UTF-8 replaced by '?'.
std::string json_string(std::string_view text);

class JsonItems;

/// One JSON value, as text.
class Json {
  public:
    Json(std::nullptr_t) : text_("null") {}
    Json(std::string_view text) : text_(json_string(text)) {}
    Json(const std::string& text) : text_(json_string(text)) {}
    Json(const char* text) : text_(json_string(text)) {}
    Json(const JsonItems& items);
    template <std::integral Whole>
    requires(sizeof(Whole) > 1)  // excludes bool and characters
        Json(Whole value)
        : text_(std::to_string(value)) {}
    template <std::same_as<bool> Truth>  // a pointer does not convert
    Json(Truth value) : text_(value ? "true" : "false") {}
    /// Spells a number by `spelling`. Throws Error invalid_value for a number that is not finite.
    Json(double value, std::string (*spelling)(double) = shortest_text);

    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// Returns the number, or null if it is not finite: unknown or unbounded.
Json json_number_or_null(double value, std::string (*spelling)(double) = shortest_text);

/// Layout: each item on its own line, indented by `indent` spaces; the closing bracket is indented
/// by two less.
struct JsonLines {
    int indent;
};

/// The common part of arrays and objects: brackets and separators. Without JsonLines all items
/// stand on one line.
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

/// Returns an array of all items of a range, on one line. `json_of` makes a value of an item.
template <std::ranges::input_range Items, typename JsonOf = std::identity>
JsonArray json_array(const Items& items, const JsonOf& json_of = {}) {
    JsonArray array;
    for (const auto& item : items) array.add(json_of(item));
    return array;
}

class JsonObject : public JsonItems {
  public:
    JsonObject() : JsonItems("{}") {}
    explicit JsonObject(JsonLines lines) : JsonItems("{}", lines) {}
    JsonObject& add(std::string_view key, const Json& value);
    /// Puts the following members on lines of their own, indented by `indent` spaces.
    JsonObject& then_lines(int indent);
};

}  // namespace ocean
