// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Enumerators as words: what a sea file, a command line and a host spell is typed once, where the
// enum is. An enum with one enumerator more has one word more.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace ocean {

/// "tma" of SpectrumKind::tma; nothing for a number that no enumerator has.
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

/// How many enumerators an enum has whose values count from 0.
template <typename Enum, std::size_t First = 0>
constexpr std::size_t enum_count() {
    if constexpr (enumerator_word<static_cast<Enum>(First)>().empty()) {
        return First;
    } else {
        return enum_count<Enum, First + 1>();
    }
}

/// Their words, in their order.
template <typename Enum>
inline constexpr auto kEnumWords = []<std::size_t... Values>(std::index_sequence<Values...>) {
    return std::array{enumerator_word<static_cast<Enum>(Values)>()...};
}
(std::make_index_sequence<enum_count<Enum>()>());

template <typename Enum>
constexpr std::string_view word_of(Enum value) {
    return kEnumWords<Enum>[static_cast<std::size_t>(value)];
}

}  // namespace ocean
