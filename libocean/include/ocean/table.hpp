// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Table<Model>: the parameters of a model, a row for each, with its unit, range, help and access to
// its member: member<&Parameters::waves, &WaveSystem::fetch>(). Files, command lines, JSON and
// panels are loops over a table; their code exists once, here and in ocean::seafile, for every
// model. parameter_table.hpp is the table of a sea, terrain_table.hpp that of a terrain.
//
//     for (const TableRow<Parameters>& row : sea_table().rows) {
//         std::printf("%s [%s]: %s\n", row.path().c_str(), row.unit.data(), row.help.data());
//     }
//     const RefOf<Parameters> fetch = find_parameter(sea_table(), "waves.1.fetch");
//     assign(parameters, fetch, 50'000.0);  // throws Error that names the range
//     std::string now = to_text(value_of(parameters, fetch));
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "ocean/enum_words.hpp"

namespace ocean {

/// Pairs of numbers, such as a wavelength and an exponent.
using NumberPairs = std::vector<std::array<double, 2>>;

/// The height of a wave as a file gives it: 5.2 [m], or "1.3 Hs", a multiple of the sea's
/// significant wave height.
struct WaveHeight {
    double value = 1.0;
    bool is_relative = true;  // in units of the significant wave height; else metres
    bool operator==(const WaveHeight&) const = default;

    /// Returns the height in metres for a sea of that significant wave height [m].
    double metres(double significant_wave_height) const {
        return is_relative ? value * significant_wave_height : value;
    }
};

/// Returns the height that a text spells, "5.2" or "1.3 Hs"; nothing for any other text.
std::optional<WaveHeight> parse_wave_height(std::string_view text);
/// Returns "1.3 Hs" for a relative height, else the number alone. parse_wave_height reads it back
/// to the same bits.
std::string to_text(const WaveHeight& height);

/// A typed value between text or TOML and a member. Words are texts; an unset optional number is
/// the empty text.
using ParameterValue = std::variant<double, std::int64_t, std::string, std::vector<std::int64_t>,
                                    bool, std::vector<double>, NumberPairs>;

/// The type of a member, independent of its model.
struct MemberType {
    /// "float", "int", "bool", "enum", "text", "list" (whole numbers), "numbers", "pairs" or
    /// "wave_height" (a number, or a text such as "1.3 Hs").
    std::string_view word;
    std::span<const std::string_view> choices;  // the words of an enum, in its order
    bool optional = false;                      // may be unset
    bool in_list = false;                       // exists once for each item of a list
};

/// Access to one member of a model.
template <typename Model>
struct Member {
    MemberType type;
    const void* id;  // identifies the pointer to member, see TableRow::holds
    ParameterValue (*get)(const Model&, std::size_t item);
    /// Stores a value that checked_value has passed.
    void (*set)(Model&, std::size_t item, const ParameterValue& checked);
    /// Returns the number of items that the model has: 1 unless the section is a list.
    std::size_t (*items)(const Model&);
    /// Replaces the items of the list by `items` new ones with defaults. No effect without a list.
    void (*renew)(Model&, std::size_t items);
};

/// Its address identifies a pointer to member of any type.
template <auto Pointer>
inline constexpr char kMemberId = 0;

namespace table_detail {

template <typename Value>
inline constexpr bool is_vector = false;
template <typename Item>
inline constexpr bool is_vector<std::vector<Item>> = true;

/// Follows pointers to members. A vector on the way is a list, whose item `item` is chosen.
template <auto Pointer, auto... Rest, typename Owner>
auto& reach(Owner& owner, std::size_t item) {
    auto& found = owner.*Pointer;
    if constexpr (sizeof...(Rest) == 0) {
        return found;
    } else if constexpr (is_vector<std::remove_cvref_t<decltype(found)>>) {
        return reach<Rest...>(found[item], item);
    } else {
        return reach<Rest...>(found, item);
    }
}

/// Returns the list on the way, or nullptr without one.
template <auto Pointer, auto... Rest, typename Owner>
auto list_in(Owner& owner) {
    auto& found = owner.*Pointer;
    if constexpr (sizeof...(Rest) == 0) {
        return nullptr;
    } else if constexpr (is_vector<std::remove_cvref_t<decltype(found)>>) {
        return &found;
    } else {
        return list_in<Rest...>(found);
    }
}

template <typename Value>
ParameterValue to_value(const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
        return std::string(word_of(value));
    } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
        return value ? ParameterValue(*value) : ParameterValue(std::string());
    } else if constexpr (std::is_same_v<Value, WaveHeight>) {
        return value.is_relative ? ParameterValue(to_text(value)) : ParameterValue(value.value);
    } else if constexpr (std::is_same_v<Value, std::vector<int>>) {
        return std::vector<std::int64_t>(value.begin(), value.end());
    } else if constexpr (std::is_integral_v<Value> && !std::is_same_v<Value, bool>) {
        return static_cast<std::int64_t>(value);
    } else {
        return value;  // double, bool, text
    }
}

template <typename Value>
void from_value(Value& target, const ParameterValue& checked) {
    if constexpr (std::is_enum_v<Value>) {
        const auto& words = kEnumWords<Value>;
        const auto found = std::ranges::find(words, std::get<std::string>(checked));
        target = static_cast<Value>(found - words.begin());
    } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
        const auto* number = std::get_if<double>(&checked);
        target = number != nullptr ? std::optional(*number) : std::nullopt;
    } else if constexpr (std::is_same_v<Value, WaveHeight>) {
        const auto* number = std::get_if<double>(&checked);
        target = number != nullptr ? WaveHeight{*number, false}
                                   : *parse_wave_height(std::get<std::string>(checked));
    } else if constexpr (std::is_same_v<Value, std::vector<int>>) {
        const auto& numbers = std::get<std::vector<std::int64_t>>(checked);
        target.clear();
        for (const std::int64_t number : numbers) target.push_back(static_cast<int>(number));
    } else if constexpr (std::is_integral_v<Value> && !std::is_same_v<Value, bool>) {
        target = static_cast<Value>(std::get<std::int64_t>(checked));
    } else {
        target = std::get<Value>(checked);
    }
}

template <typename Value>
constexpr MemberType type_of(bool in_list) {
    if constexpr (std::is_enum_v<Value>) return {"enum", kEnumWords<Value>, false, in_list};
    if constexpr (std::is_same_v<Value, bool>) return {"bool", {}, false, in_list};
    if constexpr (std::is_integral_v<Value>) return {"int", {}, false, in_list};
    if constexpr (std::is_same_v<Value, std::string>) return {"text", {}, false, in_list};
    if constexpr (std::is_same_v<Value, std::vector<int>>) return {"list", {}, false, in_list};
    if constexpr (std::is_same_v<Value, std::vector<double>>)
        return {"numbers", {}, false, in_list};
    if constexpr (std::is_same_v<Value, NumberPairs>) return {"pairs", {}, false, in_list};
    if constexpr (std::is_same_v<Value, WaveHeight>) return {"wave_height", {}, false, in_list};
    if constexpr (std::is_same_v<Value, double>) return {"float", {}, false, in_list};
    return {"float", {}, std::is_same_v<Value, std::optional<double>>, in_list};
}

template <typename Pointer>
struct OwnerOf;
template <typename Owner, typename Value>
struct OwnerOf<Value Owner::*> {
    using type = Owner;
    using value = Value;
};

template <auto... Path>
inline constexpr auto kLast = (Path, ...);

}  // namespace table_detail

/// Returns access to the member that the pointers lead to, beginning at the model:
/// member<&Parameters::waves, &WaveSystem::fetch>().
template <auto First, auto... Rest>
constexpr auto member() {
    namespace detail = table_detail;
    using Model = typename detail::OwnerOf<decltype(First)>::type;
    constexpr auto kPointer = detail::kLast<First, Rest...>;
    using Value = typename detail::OwnerOf<std::remove_const_t<decltype(kPointer)>>::value;
    using List = decltype(detail::list_in<First, Rest...>(std::declval<Model&>()));
    constexpr bool kInList = !std::is_null_pointer_v<List>;
    return Member<Model>{detail::type_of<Value>(kInList),
                         &kMemberId<kPointer>,
                         [](const Model& model, std::size_t item) {
                             return detail::to_value(detail::reach<First, Rest...>(model, item));
                         },
                         [](Model& model, std::size_t item, const ParameterValue& checked) {
                             detail::from_value(detail::reach<First, Rest...>(model, item),
                                                checked);
                         },
                         [](const Model& model) -> std::size_t {
                             if constexpr (kInList)
                                 return detail::list_in<First, Rest...>(model)->size();
                             return 1;
                         },
                         [](Model& model, std::size_t items) {
                             if constexpr (kInList) {
                                 auto& list = *detail::list_in<First, Rest...>(model);
                                 list.clear();
                                 list.resize(items);
                             }
                         }};
}

enum class ParameterClass {
    live,     // changes amplitudes or the mapping: may glide, may be part of a take
    rebuild,  // changes the set of modes: cross-faded by live tools, refused in a take
};

/// A rule for whole numbers, in addition to their range.
enum class NumberRule { any, power_of_two, even };

/// A section of a model's files: [name], or a list [[name]] of items that all have the same keys. A
/// name with a dot lies within another section, as in TOML: "terrain.layer".
struct TableSection {
    std::string_view name;
    std::string_view item = "";  // the word for an item of a list, "wave system"; "": not a list
    std::size_t max_items = 1;
    bool has_bare_keys = true;  // a key alone names a parameter of the section

    constexpr bool is_list() const { return !item.empty(); }
};

/// Columns that only some rows need.
struct OptionalColumns {
    /// Words of another parameter of the section, "jonswap, tma": this parameter has an effect only
    /// while the other one has one of these words. Empty: always.
    std::string_view used_by = "";
    /// The min of nonzero values, where 0 means "none".
    double min_nonzero = 0.0;
    NumberRule rule = NumberRule::any;
    /// The max of numbers in a list, or of pairs.
    std::size_t max_length = 64;
    /// The range of the second numbers of pairs, inclusive; min and max bound the first numbers.
    double second_min = 0.0;
    double second_max = 0.0;
    /// The neutral value, as to_text spells it, of a key that was added after the first release of
    /// its table; it is also its default. Writers leave the key out at this value, so that a model
    /// without it keeps its text, and so its id and its files.
    std::optional<std::string_view> neutral = std::nullopt;
};

/// All columns of a row that do not depend on the model's type.
struct ParameterSpec : OptionalColumns {
    std::string_view section;
    std::string_view item;  // the section's item, see TableSection
    bool has_bare_key;
    std::string_view key;
    std::string_view unit;  // "" for a pure number or a word
    std::string_view label;
    std::string_view help;
    MemberType member_type;
    double min;  // hard range, inclusive; unused for words, texts and booleans
    double max;
    double soft_min;  // the range of a slider
    double soft_max;
    ParameterClass change;

    constexpr bool in_list() const { return !item.empty(); }
    /// Returns "water.depth", or "waves.N.wind_speed" with the item's number.
    std::string path(std::size_t item = 0) const;
    /// Returns the allowed words, in enum order; none for other types.
    std::span<const std::string_view> choices() const { return member_type.choices; }
    /// Returns MemberType::word: "float", "int", "bool", "enum" ...
    std::string_view type() const { return member_type.word; }
    /// Returns true if `value` means that an optional number is unset.
    bool is_unset(const ParameterValue& value) const;
    /// Returns true if writers leave the key out at `value`: it is unset or neutral.
    bool is_left_out(const ParameterValue& value) const;
};

/// The stages that are computed from a model: a row names the first stage that a change of its
/// parameter dirties. Models with such a chain specialise this.
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
        : ParameterSpec{more,     of.name,    of.item,    of.has_bare_keys, row_key,
                        row_unit, row_label,  row_help,   way.type,         hard_min,
                        hard_max, slider_min, slider_max, row_class},
          member(way),
          dirties(first_stage) {}

    /// Returns true if this is the row of a member: row.holds<&WaveSystem::fetch>().
    template <auto Pointer>
    constexpr bool holds() const {
        return member.id == &kMemberId<Pointer>;
    }
};

/// A parameter of a model; `item` counts only for rows of a list.
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
    std::string_view kind;                   // kind of the model and its files: "sea"
    std::span<const TableSection> sections;  // in the order of the file
    std::span<const TableRow<Model>> rows;   // section after section
};

/// Returns true if the rows follow the sections, members of list items belong to lists and no key
/// appears twice in a section: for a static_assert beside each table.
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

/// Returns the value converted to the type of the row. Throws Error invalid_value, with its fields,
/// for another type, a number out of its range or against its rule, or an unknown word.
ParameterValue checked_value(const ParameterSpec& spec, std::size_t item,
                             const ParameterValue& value);
/// Returns text converted to the type of the row, not yet checked against its range. Throws Error
/// invalid_value for text that is not a value of the type.
ParameterValue parse_value(const ParameterSpec& spec, std::size_t item, std::string_view text);
/// Returns text that parse_value reads back to the same bits; "" for an unset number.
std::string to_text(const ParameterValue& value);
/// Returns the text of a value for messages, with texts in quotes and shortened.
std::string quoted_text(const ParameterValue& value);
/// Returns the reason why a text is not a number for a row: "is not a number", or, for "12kn", "is
/// not a number: write it in m/s, without a unit".
std::string no_number_reason(const ParameterSpec& spec, std::string_view text);
/// Returns "0.01 .. inf m", "one of monahan, threshold", "a power of two, 32 .. 8192".
std::string allowed_values(const ParameterSpec& spec);

/// Returns the number of items of a section: 1 unless it is a list, 0 without rows.
template <typename Model>
std::size_t items_of(const Table<Model>& table, std::string_view section, const Model& model) {
    for (const TableRow<Model>& row : table.rows) {
        if (row.section == section) return row.member.items(model);
    }
    return 0;
}

/// Throws Error invalid_value: the list has only `items` items.
[[noreturn]] void refuse_item(const ParameterSpec& spec, std::size_t item, std::size_t items);

/// Throws Error invalid_value if the model does not have the item of `ref`.
template <typename Model>
void require_item(const Model& model, const RefOf<Model>& ref) {
    const std::size_t items = ref.info->member.items(model);
    if (ref.info->in_list() && ref.item >= items) refuse_item(*ref.info, ref.item, items);
}

/// Checks type, hard range and rule of the value, and stores it. Throws Error invalid_value with
/// name, value and allowed range, also for an item that the list does not have: items are never
/// added.
template <typename Model>
void assign(Model& model, const RefOf<Model>& ref, const ParameterValue& value) {
    require_item(model, ref);
    ref.info->member.set(model, ref.item, checked_value(*ref.info, ref.item, value));
}

/// Returns a parameter's value as the type of the row; an unset optional number is an empty text.
/// Throws as require_item.
template <typename Model>
ParameterValue value_of(const Model& model, const RefOf<Model>& ref) {
    require_item(model, ref);
    return ref.info->member.get(model, ref.item);
}

// ---- Names

/// Returns the item's number if `name` names the parameter: "water.depth", "waves.1.fetch", or the
/// bare key, which means item 0; sections whose keys are common words have no bare keys.
std::optional<std::size_t> item_named(const ParameterSpec& spec, std::string_view name);
/// Throws Error invalid_value with the nearest of the parameters' names.
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

/// A row for printing, with its value in a new model.
struct ListedParameter {
    const ParameterSpec* spec;
    ParameterValue default_value;
};

/// Returns all rows with their defaults; rows of a list have the defaults of a new item.
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
