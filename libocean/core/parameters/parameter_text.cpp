// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Names and values of parameters as text, without regard to the locale; and the table as Markdown
// and JSON.
#include "parameters/parameter_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/nearest_name.hpp"

namespace ocean {

namespace {

[[noreturn]] void unknown_name(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    const std::string_view key = dot == std::string_view::npos ? name : name.substr(dot + 1);
    std::vector<std::string_view> keys;
    for (const ParameterInfo& info : parameter_table()) keys.push_back(info.key);
    const auto nearest = std::find(keys.begin(), keys.end(), nearest_name(key, keys));
    std::string message = "unknown parameter '" + std::string(name.substr(0, 80)) + "'";
    if (nearest == keys.end()) {
        message += "; `ocean params` lists them";
    } else {
        const auto at = static_cast<std::size_t>(nearest - keys.begin());
        message += "; did you mean " + parameter_table()[at].path() + "?";
    }
    throw Error(ErrorKind::invalid_value, message,
                {.what = "unknown parameter", .parameter = std::string(name.substr(0, 80))});
}

/// A float that is not set is null; an infinite one a word, as the sea file writes it.
Json json_value(const ParameterInfo& info, const ParameterValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) {
        const bool unset = text->empty() && info.type() == "float";
        return unset ? Json(nullptr) : Json(*text);
    }
    if (const auto* number = std::get_if<double>(&value)) {
        return std::isfinite(*number) ? Json(*number, plain_text) : Json(plain_text(*number));
    }
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
    return json_array(std::get<std::vector<std::int64_t>>(value));
}

std::string joined(std::span<const std::string_view> words) {
    std::string result;
    for (const std::string_view word : words) {
        if (!result.empty()) result += ", ";
        result += word;
    }
    return result;
}

bool is_number(const ParameterInfo& info) {
    return info.choices().empty() && info.type() != "text";
}

}  // namespace

ParameterRef find_parameter(std::string_view name) {
    std::string_view section;
    std::string_view key = name;
    std::size_t wave = 0;
    if (const std::size_t dot = name.find('.'); dot != std::string_view::npos) {
        section = name.substr(0, dot);
        key = name.substr(dot + 1);
        if (section == "waves") {
            const std::size_t second = key.find('.');
            if (second == std::string_view::npos) unknown_name(name);
            const auto parsed = std::from_chars(key.data(), key.data() + second, wave);
            if (parsed.ec != std::errc() || parsed.ptr != key.data() + second) unknown_name(name);
            key = key.substr(second + 1);
        }
    }
    for (const ParameterInfo& info : parameter_table()) {
        if (info.key == key && (section.empty() || info.section == section)) return {&info, wave};
    }
    unknown_name(name);
}

ParameterValue parse_value(const ParameterRef& ref, std::string_view text) {
    const ParameterInfo& info = *ref.info;
    const std::string_view type = info.type();
    const bool optional = std::holds_alternative<std::optional<double> WaveSystem::*>(info.member);
    if (type == "enum" || type == "text" || (optional && text.empty())) return std::string(text);
    const auto fail = [&](const char* reason) {
        throw Error(ErrorKind::invalid_value,
                    {.what = reason,
                     .parameter = info.path(ref.wave),
                     .value = "\"" + std::string(text.substr(0, 80)) + "\"",
                     .allowed = allowed_values(info)});
    };
    if (type == "list") {
        std::vector<std::int64_t> numbers;
        std::size_t at = 0;
        while ((at = text.find_first_not_of("[], ", at)) != std::string_view::npos) {
            std::int64_t number = 0;
            const auto parsed =
                std::from_chars(text.data() + at, text.data() + text.size(), number);
            if (parsed.ec != std::errc()) fail("is not a list of whole numbers");
            numbers.push_back(number);
            at = static_cast<std::size_t>(parsed.ptr - text.data());
        }
        return numbers;
    }
    const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
    double number = 0.0;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (parsed.ec != std::errc() || parsed.ptr != digits.data() + digits.size()) {
        fail("is not a number");
    }
    return number;
}

std::string to_text(const ParameterValue& value) {
    if (const auto* real = std::get_if<double>(&value)) return plain_text(*real);
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    std::string result = "[";
    for (const std::int64_t number : std::get<std::vector<std::int64_t>>(value)) {
        if (result.size() > 1) result += ", ";
        result += std::to_string(number);
    }
    return result + "]";
}

std::string quoted_text(const ParameterValue& value) {
    const bool text = std::holds_alternative<std::string>(value);
    return text ? "\"" + to_text(value).substr(0, 80) + "\"" : to_text(value);
}

std::string allowed_values(const ParameterInfo& info) {
    if (info.type() == "text") return "any text";
    if (!info.choices().empty()) {
        return "one of " + joined(info.choices());
    }
    const bool or_none = info.least > 0.0;
    std::string range =
        or_none ? plain_text(info.min) + " or " + plain_text(info.least) : plain_text(info.min);
    range += " .. " + plain_text(info.max);
    if (!info.unit.empty() && info.unit != "samples") range += " " + std::string(info.unit);
    if (info.key == "resolution") return "a power of two, " + range;
    if (info.key == "alignment") return "an even number, " + range;
    if (info.type() == "int") return "a whole number, " + range;
    if (info.type() == "list") return "at most 5 whole numbers, " + range;
    return range;
}

std::string live_parameter_names() {
    std::string names;
    for (const ParameterInfo& info : parameter_table()) {
        if (info.change != ParameterClass::live) continue;
        names += (names.empty() ? "" : ", ") + std::string(info.key);
    }
    return names;
}

std::string parameters_markdown() {
    const Parameters defaults;
    std::string result =
        "| Parameter | Default | Allowed | Class | What it is |\n"
        "| --- | --- | --- | --- | --- |\n";
    for (const ParameterInfo& info : parameter_table()) {
        const std::string value = to_text(value_of(defaults, {&info, 0}));
        const std::string name =
            info.per_wave_system() ? "waves.N." + std::string(info.key) : info.path();
        result += "| `" + name + "` | " + (value.empty() ? "" : "`" + value + "`") + " | " +
                  allowed_values(info) + " | " + std::string(word_of(info.change)) + " | " +
                  std::string(info.help) + " |\n";
    }
    return result;
}

std::string parameters_json() {
    const Parameters defaults;
    JsonArray table(JsonLines{2});
    for (const ParameterInfo& info : parameter_table()) {
        JsonObject row;
        row.add("section", info.section).add("key", info.key).add("type", info.type());
        row.add("unit", info.unit).add("label", info.label).add("help", info.help);
        row.add("class", word_of(info.change)).add("allowed", allowed_values(info));
        if (is_number(info)) {
            // JSON has no infinity: such a bound is null.
            row.add("min", json_number_or_null(info.min, plain_text));
            row.add("max", json_number_or_null(info.max, plain_text));
            if (info.least > 0.0) row.add("least", json_number_or_null(info.least, plain_text));
            row.add("soft_min", json_number_or_null(info.soft_min, plain_text));
            row.add("soft_max", json_number_or_null(info.soft_max, plain_text));
        }
        if (!info.choices().empty()) row.add("choices", json_array(info.choices()));
        if (!info.used_by.empty()) row.add("used_by", json_array(split(info.used_by, ", ")));
        table.add(row.add("default", json_value(info, value_of(defaults, {&info, 0}))));
    }
    return table.text() + "\n";
}

}  // namespace ocean
