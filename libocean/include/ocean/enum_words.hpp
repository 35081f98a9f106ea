// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Enumerators as words. Sea files, command lines and hosts spell a word as the C++ enumerator, so
// that it is typed once, and a new enumerator has its word without further code.
//
//     std::string_view word = word_of(SpectrumKind::tma);  // "tma"
//     for (std::string_view each : kEnumWords<SpectrumKind>) menu.add(each);
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace ocean {

/// Returns "tma" for SpectrumKind::tma; "" for a number that no enumerator has.
template <auto Value>
constexpr std::string_view enumerator_word() {
    // gcc:   "... enumerator_word() [with auto Value = ocean::SpectrumKind::tma; std::..."
    // clang: "... enumerator_word() [Value = ocean::SpectrumKind::tma]"
    // No enumerator: a cast, "(ocean::SpectrumKind)5".
    constexpr std::string_view kBefore = "Value = ";
    std::string_view text = __PRETTY_FUNCTION__;
    text.remove_prefix(text.find(kBefore) + kBefore.size());
    text = text.substr(0, text.find_first_of(";]"));
    return text.starts_with('(') ? std::string_view() : text.substr(text.rfind(':') + 1);
}

/// Returns the number of enumerators of an enum whose values count from 0.
template <typename Enum, std::size_t First = 0>
constexpr std::size_t enum_count() {
    if constexpr (enumerator_word<static_cast<Enum>(First)>().empty()) {
        return First;
    } else {
        return enum_count<Enum, First + 1>();
    }
}

/// The words of all enumerators of an enum, in their order.
template <typename Enum>
inline constexpr auto kEnumWords = []<std::size_t... Values>(std::index_sequence<Values...>) {
    return std::array{enumerator_word<static_cast<Enum>(Values)>()...};
}
(std::make_index_sequence<enum_count<Enum>()>());

/// Returns the word of an enumerator.
template <typename Enum>
constexpr std::string_view word_of(Enum value) {
    return kEnumWords<Enum>[static_cast<std::size_t>(value)];
}

/// Returns the enumerator of a word; nothing for a word that no enumerator has.
template <typename Enum>
constexpr std::optional<Enum> enumerator_of(std::string_view word) {
    const auto& words = kEnumWords<Enum>;
    const auto found = std::ranges::find(words, word);
    if (found == words.end()) return std::nullopt;
    return static_cast<Enum>(found - words.begin());
}

}  // namespace ocean
