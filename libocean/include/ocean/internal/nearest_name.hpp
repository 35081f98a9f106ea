// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// "Did you mean": the known names nearest to a mistyped one. Every message of the library and of
// its programs that suggests a name uses this one rule.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ocean {

/// A known name as it may be typed, and the name that a message shows for it: wind_speed for
/// waves.0.wind_speed.
struct KnownName {
    std::string_view typed;
    std::string_view shown;
};

/// Returns the names with the fewest edits from `word`: an edit inserts, deletes or replaces a
/// letter, or exchanges two neighbours; lower and upper case are equal. A name is near if it is at
/// most two edits away, and at most one edit per three letters of the longer name. If several are
/// equally near, returns the first kMaxNearestNames in the order of `names`; a name equal to `word`
/// was not mistyped and is left out. Names that begin with `word`, of at least four letters, are
/// nearer than names two edits away.
std::vector<std::string_view> nearest_names(std::string_view word,
                                            std::span<const KnownName> names);
inline constexpr std::size_t kMaxNearestNames = 10;

/// Returns the first of nearest_names(); "" if no name is near.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names);

/// Returns "; did you mean a, b or c?" with nearest_names(), for the end of a message; "" if no
/// name is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> names);
std::string did_you_mean(std::string_view word, std::span<const KnownName> names);
/// The names are what `name_of` returns of the elements of `range`.
template <typename Range, typename NameOf>
std::string did_you_mean(std::string_view word, const Range& range, const NameOf& name_of) {
    std::vector<std::string_view> names;
    for (const auto& element : range) names.push_back(std::invoke(name_of, element));
    return did_you_mean(word, names);
}

}  // namespace ocean
