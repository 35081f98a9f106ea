// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// JSON, written; see json.hpp.
#include "ocean/internal/json.hpp"

#include <algorithm>
#include <cmath>

#include "ocean/error.hpp"

namespace ocean {
namespace {

std::string line_break(int indent) {
    return "\n" + std::string(static_cast<std::size_t>(std::max(indent, 0)), ' ');
}

}  // namespace

std::string json_string(std::string_view text) {
    std::string out = "\"";
    while (!text.empty()) {
        const std::size_t length = utf8_character(text);
        const auto first = static_cast<unsigned char>(text.front());
        if (length == 0) {
            out += '?';
        } else if (first == '"' || first == '\\') {
            out += {'\\', text.front()};
        } else if (first < 0x20 || first == 0x7F) {
            out += format_text("\\u%04X", static_cast<unsigned>(first));
        } else {
            out += text.substr(0, length);
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return out + '"';
}

Json::Json(const JsonItems& items) : text_(items.text()) {}

Json::Json(double value, std::string (*spelling)(double)) : text_(spelling(value)) {
    if (!std::isfinite(value)) {
        throw Error(ErrorKind::invalid_value, "JSON has no number " + shortest_text(value));
    }
}

Json json_number_or_null(double value, std::string (*spelling)(double)) {
    return std::isfinite(value) ? Json(value, spelling) : Json(nullptr);
}

JsonItems::JsonItems(std::string_view brackets)
    : text_(brackets.substr(0, 1)), closing_(brackets.substr(1)) {}

JsonItems::JsonItems(std::string_view brackets, JsonLines lines) : JsonItems(brackets) {
    before_first_ = line_break(lines.indent);
    between_ = "," + before_first_;
    closing_.insert(0, line_break(lines.indent - 2));
}

void JsonItems::add_item(std::string_view item) {
    text_ += empty_ ? before_first_ : between_;
    text_ += item;
    empty_ = false;
}

void JsonItems::break_lines(int indent) {
    between_ = "," + line_break(indent);
}

JsonArray& JsonArray::add(const Json& value) {
    add_item(value.text());
    return *this;
}

JsonObject& JsonObject::add(std::string_view key, const Json& value) {
    add_item(json_string(key) + ": " + value.text());
    return *this;
}

JsonObject& JsonObject::then_lines(int indent) {
    break_lines(indent);
    return *this;
}

}  // namespace ocean
