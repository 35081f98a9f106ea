// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Names of a table's rows, and its rows as Markdown and JSON. This code knows no model.
#include <charconv>
#include <cmath>
#include <deque>

#include "ocean/error.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/table.hpp"

namespace ocean {

namespace {

/// Returns the number of an item if all of `digits` spells it.
std::optional<std::size_t> item_number(std::string_view digits) {
    std::size_t number = 0;
    const char* end = digits.data() + digits.size();
    const auto parsed = std::from_chars(digits.data(), end, number);
    if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
    return number;
}

/// Returns null for an unset float, and a word for an infinite one, as in a sea file.
Json json_value(const ParameterSpec& spec, const ParameterValue& value) {
    if (spec.is_unset(value)) return nullptr;
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* truth = std::get_if<bool>(&value)) return *truth;
    if (const auto* number = std::get_if<double>(&value)) {
        return std::isfinite(*number) ? Json(*number, plain_text) : Json(plain_text(*number));
    }
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
    if (const auto* numbers = std::get_if<std::vector<double>>(&value)) return json_array(*numbers);
    if (const auto* pairs = std::get_if<NumberPairs>(&value)) {
        return json_array(*pairs, [](const auto& pair) { return json_array(pair); });
    }
    return json_array(std::get<std::vector<std::int64_t>>(value));
}

bool has_range(const ParameterSpec& spec) {
    return spec.type() != "enum" && spec.type() != "text" && spec.type() != "bool";
}

/// Returns "waves.fetch" for "waves.1.fetch".
std::string without_item(std::string_view name) {
    const std::size_t key = name.rfind('.');
    const std::size_t item = key == 0 ? key : name.rfind('.', key - 1);
    if (key == std::string_view::npos || item == std::string_view::npos) return std::string(name);
    if (!item_number(name.substr(item + 1, key - item - 1))) return std::string(name);
    return std::string(name.substr(0, item)) + std::string(name.substr(key));
}

}  // namespace

std::string ParameterSpec::path(std::size_t number) const {
    std::string result(section);
    if (in_list()) result += "." + std::to_string(number);
    return result + "." + std::string(key);
}

std::optional<std::size_t> item_named(const ParameterSpec& spec, std::string_view name) {
    if (name == spec.key && spec.has_bare_key) return 0;
    if (!name.ends_with(spec.key)) return std::nullopt;
    name.remove_suffix(spec.key.size());
    if (!name.ends_with('.')) return std::nullopt;
    name.remove_suffix(1);
    if (!spec.in_list()) return name == spec.section ? std::optional<std::size_t>(0) : std::nullopt;
    if (!name.starts_with(spec.section)) return std::nullopt;
    name.remove_prefix(spec.section.size());
    if (!name.starts_with('.')) return std::nullopt;
    return item_number(name.substr(1));
}

void refuse_name(std::string_view name, std::span<const ParameterSpec* const> specs) {
    std::deque<std::string> texts;  // its elements never move
    std::vector<KnownName> known;
    for (const ParameterSpec* spec : specs) {
        const std::string_view path = texts.emplace_back(spec->path());
        known.push_back({path, path});
        if (spec->has_bare_key) known.push_back({spec->key, path});
        known.push_back({texts.emplace_back(without_item(path)), path});
    }
    std::string meant = did_you_mean(without_item(name), known);
    if (meant.empty()) meant = did_you_mean(name, known);
    throw Error(ErrorKind::invalid_value,
                "unknown parameter '" + std::string(name.substr(0, 80)) + "'" +
                    (meant.empty() ? "; `ocean params` lists them" : meant),
                {.what = "unknown parameter", .parameter = std::string(name.substr(0, 80))});
}

std::string parameters_markdown(std::span<const ListedParameter> parameters) {
    std::string result =
        "| Parameter | Default | Allowed | Class | What it is |\n"
        "| --- | --- | --- | --- | --- |\n";
    for (const auto& [spec, default_value] : parameters) {
        const std::string value = to_text(default_value);
        const std::string list = spec->in_list() ? ".N" : "";
        result += "| `" + std::string(spec->section) + list + "." + std::string(spec->key) +
                  "` | " + (value.empty() ? "" : "`" + value + "`") + " | " +
                  allowed_values(*spec) + " | " + std::string(word_of(spec->change)) + " | " +
                  std::string(spec->help) + " |\n";
    }
    return result;
}

std::string parameters_json(std::span<const ListedParameter> parameters) {
    JsonArray table(JsonLines{2});
    for (const auto& [spec, default_value] : parameters) {
        JsonObject row;
        row.add("section", spec->section).add("key", spec->key).add("type", spec->type());
        row.add("unit", spec->unit).add("label", spec->label).add("help", spec->help);
        row.add("class", word_of(spec->change)).add("allowed", allowed_values(*spec));
        if (has_range(*spec)) {
            // JSON has no infinity: such a bound is null.
            row.add("min", json_number_or_null(spec->min, plain_text));
            row.add("max", json_number_or_null(spec->max, plain_text));
            if (spec->min_nonzero > 0.0)
                row.add("least", json_number_or_null(spec->min_nonzero, plain_text));
            row.add("soft_min", json_number_or_null(spec->soft_min, plain_text));
            row.add("soft_max", json_number_or_null(spec->soft_max, plain_text));
        }
        if (!spec->choices().empty()) row.add("choices", json_array(spec->choices()));
        if (!spec->used_by.empty()) row.add("used_by", json_array(split(spec->used_by, ", ")));
        if (spec->neutral) row.add("neutral", *spec->neutral);
        table.add(row.add("default", json_value(*spec, default_value)));
    }
    return table.text() + "\n";
}

}  // namespace ocean
