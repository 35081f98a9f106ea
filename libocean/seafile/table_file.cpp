// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The errors of a reader of parameters; see table_file.hpp.
#include "table_file.hpp"

#include <algorithm>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrain_table.hpp"
#include "take.hpp"

namespace ocean {
namespace {

std::string brackets(const ParameterSpec& spec) {
    const std::string name(spec.section);
    return spec.in_list() ? "[[" + name + "]]" : "[" + name + "]";
}

/// Returns "system" for "wave system".
std::string last_word(std::string_view words) {
    return std::string(words.substr(words.rfind(' ') + 1));
}

/// Returns the pairs of [[a, b], [c, d]]; nothing if the array contains anything else.
std::optional<NumberPairs> pairs_of(const toml::node& node) {
    const toml::array* list = node.as_array();
    if (list == nullptr) return std::nullopt;
    NumberPairs pairs;
    for (const toml::node& item : *list) {
        const auto numbers = numbers_of(item);
        if (!numbers || numbers->size() != 2) return std::nullopt;
        pairs.push_back({(*numbers)[0], (*numbers)[1]});
    }
    return pairs;
}

}  // namespace

std::span<const FileKind> file_kinds() {
    static const std::vector<FileKind> kKinds = [] {
        FileKind sea{sea_table().kind, root_names(sea_table().sections)};
        sea.roots.push_back(kTakeSection);
        return std::vector<FileKind>{sea,
                                     {terrain_table().kind, root_names(terrain_table().sections)}};
    }();
    return kKinds;
}

std::string kind_of_file_text(std::string_view toml) {
    try {
        const toml::table root = parse_toml(toml, "");
        for (const TomlEntry& entry : in_file_order(root)) {
            for (const FileKind& kind : file_kinds()) {
                if (std::ranges::find(kind.roots, entry.key) != kind.roots.end()) {
                    return std::string(kind.kind);
                }
            }
        }
    } catch (const Error&) {
        // The reader of the value reports the fault.
    }
    return "";
}

std::vector<std::string_view> root_names(std::span<const TableSection> sections) {
    std::vector<std::string_view> names;
    for (const TableSection& section : sections) {
        const std::string_view root = section.name.substr(0, section.name.find('.'));
        if (std::ranges::find(names, root) == names.end()) names.push_back(root);
    }
    return names;
}

Error TableFile::fail(std::size_t line, const ErrorFields& fields, ErrorKind kind) const {
    return text::error_at(Error(kind, fields), name_, line);
}

Error TableFile::in_front(const Error& error, std::size_t line, const std::string& prefix) const {
    return text::error_at(error, name_, line, prefix);
}

Error TableFile::in_front(const Error& error) const {
    return in_front(error, line_of_parameter(error.fields().parameter));
}

Error TableFile::in_line_of_parameter(const Error& error) const {
    const ErrorFields& fields = error.fields();
    return in_front(error, line_of_parameter(fields.parameter),
                    fields.parameter + " = " + fields.value + ": ");
}

std::size_t TableFile::line_of_parameter(std::string_view path) const {
    while (true) {
        if (const auto found = lines_.find(path); found != lines_.end()) return found->second;
        const std::size_t dot = path.rfind('.');
        if (dot == std::string_view::npos) return 0;
        path = path.substr(0, dot);
    }
}

void TableFile::require_version(const toml::table& root, std::string_view kind) const {
    const toml::node* version = root.get(kVersionKey);
    const std::string wanted = "libocean = " + std::to_string(kSeaFileVersion);
    if (version == nullptr) {
        throw fail(0,
                   {.what = "is not a " + std::string(kind) + " file: the line '" + wanted +
                            "' is missing"},
                   ErrorKind::bad_file);
    }
    const auto* number = version->as_integer();
    if (number == nullptr || number->get() != kSeaFileVersion) {
        throw fail(line_of(*version),
                   {.what = "this version of libocean does not read that format",
                    .parameter = std::string(kVersionKey),
                    .value = shown(*version),
                    .allowed = wanted},
                   ErrorKind::bad_file);
    }
}

ParameterValue TableFile::value_for(const ParameterSpec& spec, std::size_t item,
                                    const toml::node& node) const {
    const std::string_view type = spec.type();
    const auto wrong = [&](const std::string& what) {
        return fail(line_of(node), {.what = what,
                                    .parameter = spec.path(item),
                                    .value = shown(node),
                                    .allowed = allowed_values(spec)});
    };
    if (type == "float") {
        const std::optional<double> number = number_of(node);
        if (!number) throw wrong(no_number_reason(spec, node.value_or(std::string())));
        return *number;
    }
    if (type == "int") {
        if (!node.is_integer()) throw wrong("is not a whole number");
        return node.as_integer()->get();
    }
    if (type == "bool") {
        if (!node.is_boolean()) throw wrong("is neither true nor false");
        return node.as_boolean()->get();
    }
    if (type == "list") {
        const toml::array* list = node.as_array();
        if (list == nullptr || list->size() > 64) throw wrong("is not a short list");
        std::vector<std::int64_t> items;
        for (const toml::node& number : *list) {
            if (!number.is_integer()) {
                throw wrong("holds " + shown(number) + ", not a whole number");
            }
            items.push_back(number.as_integer()->get());
        }
        return items;
    }
    if (type == "numbers") {
        if (auto numbers = numbers_of(node)) return *std::move(numbers);
        throw wrong("is not a list of numbers, [a, b]");
    }
    if (type == "pairs") {
        if (auto pairs = pairs_of(node)) return *std::move(pairs);
        throw wrong("is not a list of pairs, [[a, b], [c, d]]");
    }
    if (type == "wave_height") {
        if (const std::optional<double> number = number_of(node)) return *number;
        if (!node.is_string()) throw wrong("is not a height");
    }
    if (!node.is_string()) throw wrong("is not a text in quotes");
    return node.as_string()->get();
}

void TableFile::require_kind(const TomlEntry& entry, std::string_view kind) const {
    if (!entry.node->is_table() && !entry.node->is_array_of_tables()) return;
    for (const FileKind& other : file_kinds()) {
        if (other.kind == kind || std::ranges::find(other.roots, entry.key) == other.roots.end()) {
            continue;
        }
        throw fail(entry.line,
                   {.what = "is a " + std::string(other.kind) + " file, not a " +
                            std::string(kind) + " file"},
                   ErrorKind::bad_file);
    }
}

void TableFile::refuse_root(const TomlEntry& entry, std::span<const ParameterSpec* const> specs,
                            std::span<const std::string_view> sections,
                            std::span<const std::string_view> roots) const {
    const std::string key = text::printable(entry.key);
    const auto same_key = [&](const ParameterSpec* spec) { return spec->key == entry.key; };
    const auto outside = std::ranges::find_if(specs, same_key);
    if (outside != specs.end() && !entry.node->is_table()) {
        throw fail(entry.line, {.what = "is outside its section",
                                .parameter = key,
                                .value = shown(*entry.node),
                                .allowed = "below " + brackets(**outside)});
    }
    std::vector<std::string_view> known(sections.begin(), sections.end());
    known.insert(known.end(), roots.begin(), roots.end());
    const std::string guess = did_you_mean(entry.key, known);
    throw fail(
        entry.line,
        {.what = "no such section" + guess, .parameter = key, .allowed = joined(known, ", ")});
}

const toml::table& TableFile::section_of(const TomlEntry& entry, std::string_view section) const {
    if (const toml::table* table = entry.node->as_table()) return *table;
    const std::string name(section);
    throw fail(entry.line, {.what = "is a section",
                            .parameter = name,
                            .value = shown(*entry.node),
                            .allowed = "one [" + name + "] with keys"});
}

const toml::array& TableFile::list_of(const TomlEntry& entry, const TableSection& section) const {
    const std::string name(section.name), items = std::string(section.item) + "s";
    const toml::array* list = entry.node->as_array();
    if (list == nullptr || list->empty() || !list->is_array_of_tables()) {
        throw fail(entry.line, {.what = "is not a list of " + items,
                                .parameter = name,
                                .value = shown(*entry.node),
                                .allowed = "[[" + name + "]], in double brackets, once for each " +
                                           last_word(section.item)});
    }
    if (list->size() > section.max_items) {
        throw fail(line_of((*list)[section.max_items]),
                   {.what = std::to_string(list->size()) + " " + items,
                    .parameter = name,
                    .allowed = "1 .. " + std::to_string(section.max_items)});
    }
    return *list;
}

}  // namespace ocean
