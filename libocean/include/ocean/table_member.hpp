// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Access from a row of a table to its member in a model: member<&Parameters::waves,
// &WaveSystem::fetch>() gives the type of the member and the functions that get and set it.
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

/// A typed value between text or TOML and a member. Words are texts; an unset optional number is
/// the empty text.
using ParameterValue = std::variant<double, std::int64_t, std::string, std::vector<std::int64_t>,
                                    bool, std::vector<double>, NumberPairs>;

/// The type of a member, independent of its model.
struct MemberType {
    /// "float", "int", "bool", "enum", "text", "list" (whole numbers), "numbers" or "pairs".
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

}  // namespace ocean
