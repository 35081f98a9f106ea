// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Table<Model>: what can be set in a model, one row for each parameter, with its unit, range, help
// and the way to its member. Files, command lines, JSON and panels are loops over a table; the code
// of these loops stands once, here and in ocean::seafile, for every model. parameter_table.hpp is
// the table of a sea.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/table_member.hpp"

namespace ocean {

enum class ParameterClass {
    live,     // changes amplitudes or the mapping: may glide, may stand in a take
    rebuild,  // changes the set of modes: cross-faded by live tools, refused in a take
};

/// A rule for whole numbers beside their range.
enum class NumberRule { any, power_of_two, even };

/// A section of a model's files: [name], or a list [[name]] of items that all have the same keys.
/// A name with a dot stands inside another section, as TOML has it: "terrain.layer".
struct TableSection {
    std::string_view name;
    std::string_view item = "";  // one item of a list in words, "wave system"; "": not a list
    std::size_t max_items = 1;

    constexpr bool is_list() const { return !item.empty(); }
};

/// Columns that few rows need.
struct OptionalColumns {
    /// Words of another parameter of the section, "jonswap, tma": while that has another word,
    /// this one does nothing. Empty: it always counts.
    std::string_view used_by = "";
    /// The smallest value that is not 0, where 0 is a word for "none".
    double least = 0.0;
    NumberRule rule = NumberRule::any;
    /// Numbers that a list may have.
    std::size_t max_length = 64;
    /// The default, as to_text spells it, of a key that came later than others of its table:
    /// writers leave the key out while it has this value, so that a model that does not use it
    /// keeps its text, and with it its id and its files.
    std::optional<std::string_view> neutral = std::nullopt;
};

/// All that a row says of a parameter, whatever model holds it.
struct ParameterSpec : OptionalColumns {
    std::string_view section;
    std::string_view item;  // of a list, see TableSection
    std::string_view key;
    std::string_view unit;  // "" for a pure number or a word
    std::string_view label;
    std::string_view help;
    MemberType member_type;
    double min;  // hard range, inclusive; unused for words, texts and booleans
    double max;
    double soft_min;  // what a slider offers
    double soft_max;
    ParameterClass change;

    constexpr bool in_list() const { return !item.empty(); }
    /// Returns "water.depth", or "waves.N.wind_speed" with the item's number.
    std::string path(std::size_t item = 0) const;
    /// Returns the words allowed, in enum order; none for other types.
    std::span<const std::string_view> choices() const { return member_type.choices; }
    /// Returns "float", "int", "bool", "enum", "text" or "list".
    std::string_view type() const { return member_type.word; }
    /// Whether `value` says that an optional number has no value.
    bool is_unset(const ParameterValue& value) const;
    /// Whether writers leave the key out at `value`: it is unset, or neutral.
    bool is_left_out(const ParameterValue& value) const;
};

/// The chain of stages that begins with a model: a row names the first that its change makes
/// anew. Models with a chain specialise this.
template <typename Model>
struct StagesOf {
    enum class type { all };
};

template <typename Model>
struct TableRow : ParameterSpec {
    using Stage = typename StagesOf<Model>::type;

    Member<Model> member;
    Stage dirties;

    constexpr TableRow(const TableSection& of, std::string_view row_key, std::string_view row_unit,
                       std::string_view row_label, std::string_view row_help,
                       const Member<Model>& way, double hard_min, double hard_max,
                       double slider_min, double slider_max, ParameterClass row_class,
                       Stage first_stage, const OptionalColumns& more = {})
        : ParameterSpec{more,     of.name,  of.item,  row_key,    row_unit,   row_label, row_help,
                        way.type, hard_min, hard_max, slider_min, slider_max, row_class},
          member(way),
          dirties(first_stage) {}

    /// Whether this is the row of a member: row.holds<&WaveSystem::fetch>().
    template <auto Pointer>
    constexpr bool holds() const {
        return member.id == &kMemberId<Pointer>;
    }
};

/// A parameter of a model; `item` counts only for those of a list.
template <typename Model>
struct RefOf {
    const TableRow<Model>* info = nullptr;
    std::size_t item = 0;

    bool same_as(const RefOf& other) const {
        return info == other.info && (item == other.item || !info->in_list());
    }
};

template <typename Model>
struct Table {
    std::string_view kind;                   // of the model and its files: "sea"
    std::span<const TableSection> sections;  // in the order of the file
    std::span<const TableRow<Model>> rows;   // section after section
};

/// Whether the rows follow the sections, a list's members lie in a list and no key stands twice
/// in a section: for a static_assert beside each table.
template <typename Model>
constexpr bool is_consistent(const Table<Model>& table) {
    std::size_t at = 0;
    for (const TableSection& section : table.sections) {
        const std::size_t first = at;
        for (; at < table.rows.size() && table.rows[at].section == section.name; ++at) {
            const TableRow<Model>& row = table.rows[at];
            if (row.member_type.in_list != section.is_list()) return false;
            for (std::size_t other = first; other < at; ++other) {
                if (table.rows[other].key == row.key) return false;
            }
        }
    }
    return at == table.rows.size();
}

// ---- Values

/// Returns the value as the type of the row. Throws Error invalid_value, with its fields, for
/// another type, a number out of its range or against its rule, an unknown word.
ParameterValue checked_value(const ParameterSpec& spec, std::size_t item,
                             const ParameterValue& value);
/// Returns text as the type of the row, not yet checked against its range. Throws Error
/// invalid_value for text that spells no value of the type.
ParameterValue parse_value(const ParameterSpec& spec, std::size_t item, std::string_view text);
/// Returns text that parse_value reads back to the same bits; "" for an unset number.
std::string to_text(const ParameterValue& value);
/// Returns the same text, with texts in quotes and shortened: for messages.
std::string quoted_text(const ParameterValue& value);
/// Returns "0.01 .. inf m", "one of monahan, threshold", "a power of two, 32 .. 8192".
std::string allowed_values(const ParameterSpec& spec);

/// Throws Error invalid_value: the list has only `items` items.
[[noreturn]] void refuse_item(const ParameterSpec& spec, std::size_t item, std::size_t items);

template <typename Model>
void require_item(const Model& model, const RefOf<Model>& ref) {
    const std::size_t items = ref.info->member.items(model);
    if (ref.info->in_list() && ref.item >= items) refuse_item(*ref.info, ref.item, items);
}

/// Checks type, hard range and rule, and stores. Throws Error invalid_value with name, value and
/// allowed range; also for an item that the list does not have: none is made on the fly.
template <typename Model>
void assign(Model& model, const RefOf<Model>& ref, const ParameterValue& value) {
    require_item(model, ref);
    ref.info->member.set(model, ref.item, checked_value(*ref.info, ref.item, value));
}

/// Returns the value as the type of the row; an unset optional gives an empty text.
template <typename Model>
ParameterValue value_of(const Model& model, const RefOf<Model>& ref) {
    require_item(model, ref);
    return ref.info->member.get(model, ref.item);
}

// ---- Names

/// Returns the item's number if `name` names the parameter: "water.depth", "waves.1.fetch", or the
/// bare key, which means item 0.
std::optional<std::size_t> item_named(const ParameterSpec& spec, std::string_view name);
/// Throws Error invalid_value naming the nearest of the parameters.
[[noreturn]] void refuse_name(std::string_view name, std::span<const ParameterSpec* const> specs);

template <typename Model>
std::vector<const ParameterSpec*> specs_of(const Table<Model>& table) {
    std::vector<const ParameterSpec*> specs;
    for (const TableRow<Model>& row : table.rows) specs.push_back(&row);
    return specs;
}

/// Finds "grid.resolution", "waves.1.wind_speed", or a bare key; a bare key of a list means its
/// item 0. Throws Error invalid_value naming the nearest known name.
template <typename Model>
RefOf<Model> find_parameter(const Table<Model>& table, std::string_view name) {
    for (const TableRow<Model>& row : table.rows) {
        if (const auto item = item_named(row, name)) return {&row, *item};
    }
    refuse_name(name, specs_of(table));
}

// ---- Listings

/// A row for a reader's eye, with the value that a new model has.
struct ListedParameter {
    const ParameterSpec* spec;
    ParameterValue default_value;
};

/// Returns all rows; a list's defaults are those of a new item.
template <typename Model>
std::vector<ListedParameter> listed(const Table<Model>& table) {
    Model defaults;
    std::vector<ListedParameter> list;
    for (const TableRow<Model>& row : table.rows) {
        if (row.member.items(defaults) == 0) row.member.renew(defaults, 1);
        list.push_back({&row, row.member.get(defaults, 0)});
    }
    return list;
}

/// Returns the rows as a Markdown table (the README's).
std::string parameters_markdown(std::span<const ListedParameter> parameters);
/// Returns the rows as JSON, an array of objects.
std::string parameters_json(std::span<const ListedParameter> parameters);

}  // namespace ocean
