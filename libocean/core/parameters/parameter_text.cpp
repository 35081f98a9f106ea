// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Names and values of parameters as text, without regard to the locale; and the table as Markdown
// and JSON.
#include "parameters/parameter_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "ocean/error.hpp"
#include "ocean/nearest_name.hpp"

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
    throw Error(ErrorKind::invalid_value, message);
}

/// Shortest digits that read back to the same bits; 300000 rather than 3e+05.
std::string number_text(double value) {
    char buffer[32];
    const double size = std::abs(value);
    const bool plain = value == 0.0 || (size >= 1e-5 && size < 1e15);
    const auto format = plain ? std::chars_format::fixed : std::chars_format::general;
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value, format);
    return {buffer, end.ptr};
}

std::string escaped_json(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result;
}

/// JSON has no infinity: such a bound is null.
std::string json_number(double value) {
    return std::isfinite(value) ? number_text(value) : "null";
}

std::string json_value(const ParameterInfo& info, const ParameterValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) {
        const bool unset = text->empty() && info.type() == "float";
        return unset ? "null" : "\"" + escaped_json(*text) + "\"";
    }
    if (const auto* number = std::get_if<double>(&value)) {
        return std::isfinite(*number) ? number_text(*number) : "\"" + number_text(*number) + "\"";
    }
    return to_text(value);
}

std::string joined(std::span<const std::string_view> words) {
    std::string result;
    for (const std::string_view word : words) {
        if (!result.empty()) result += ", ";
        result += word;
    }
    return result;
}

constexpr std::string_view class_name(ParameterClass change) {
    return change == ParameterClass::live ? "live" : "rebuild";
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
                    info.path(ref.wave) + " = \"" + std::string(text.substr(0, 80)) +
                        "\": " + reason + "; allowed: " + allowed_values(info));
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
    if (const auto* real = std::get_if<double>(&value)) return number_text(*real);
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
    std::string range = number_text(info.min) + " .. " + number_text(info.max);
    if (!info.unit.empty() && info.unit != "samples") range += " " + std::string(info.unit);
    if (info.key == "resolution") return "a power of two, " + range;
    if (info.key == "alignment") return "an even number, " + range;
    if (info.type() == "int") return "a whole number, " + range;
    if (info.type() == "list") return "at most 5 whole numbers, " + range;
    return range;
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
                  allowed_values(info) + " | " + std::string(class_name(info.change)) + " | " +
                  std::string(info.help) + " |\n";
    }
    return result;
}

namespace {

std::vector<std::string_view> split(std::string_view text, std::string_view separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + separator.size());
    }
}

}  // namespace

std::string parameters_json() {
    const Parameters defaults;
    std::string result = "[\n";
    for (const ParameterInfo& info : parameter_table()) {
        if (result.size() > 2) result += ",\n";
        const auto text = [&result](std::string_view key, std::string_view value) {
            result += "\"" + std::string(key) + "\": \"" + escaped_json(value) + "\", ";
        };
        result += "  {";
        text("section", info.section);
        text("key", info.key);
        text("type", info.type());
        text("unit", info.unit);
        text("label", info.label);
        text("help", info.help);
        text("class", class_name(info.change));
        text("allowed", allowed_values(info));
        if (is_number(info)) {
            result += "\"min\": " + json_number(info.min) + ", \"max\": " + json_number(info.max) +
                      ", \"soft_min\": " + json_number(info.soft_min) +
                      ", \"soft_max\": " + json_number(info.soft_max) + ", ";
        }
        const auto words = [&result](std::string_view key, const auto& list) {
            result += "\"" + std::string(key) + "\": [";
            for (const std::string_view word : list) {
                result += (result.back() == '[' ? "\"" : ", \"") + std::string(word) + "\"";
            }
            result += "], ";
        };
        if (!info.choices().empty()) words("choices", info.choices());
        if (!info.used_by.empty()) words("used_by", split(info.used_by, ", "));
        result += "\"default\": " + json_value(info, value_of(defaults, {&info, 0})) + "}";
    }
    return result + "\n]\n";
}

}  // namespace ocean
