// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The distance of Damerau and Levenshtein over a handful of names.
#include "ocean/internal/nearest_name.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

/// Counts insertions, deletions, replacements and exchanges of neighbours,
/// in the restricted form, where no part of the word is edited twice.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before;  // the row of i - 1
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::vector<std::size_t> next(b.size() + 1, i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = row[j] + (a[i] == b[j] ? 0 : 1);
            next[j + 1] = std::min({replaced, row[j + 1] + 1, next[j] + 1});
            if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j]) {
                next[j + 1] = std::min(next[j + 1], before[j - 1] + 1);
            }
        }
        before = std::exchange(row, std::move(next));
    }
    return row.back();
}

/// Returns the word in lower case (A to Z), cut after 64 letters.
std::string folded(std::string_view word) {
    return lower_case(word.substr(0, 64));
}

std::vector<KnownName> as_known(std::span<const std::string_view> names) {
    std::vector<KnownName> known;
    for (const std::string_view name : names) known.push_back({name, name});
    return known;
}

}  // namespace

std::vector<std::string_view> nearest_names(std::string_view word,
                                            std::span<const KnownName> names) {
    constexpr std::size_t kMaxEdits = 2;
    constexpr std::size_t kMinBeginning = 4;
    const std::string wanted = folded(word);
    std::vector<std::string_view> nearest, begun;
    const auto add = [](std::string_view shown, std::vector<std::string_view>& list) {
        const bool is_listed = std::ranges::find(list, shown) != list.end();
        if (!is_listed && list.size() < kMaxNearestNames) list.push_back(shown);
    };
    std::size_t fewest = kMaxEdits;
    for (const KnownName& name : names) {
        if (name.typed == word) continue;
        const std::string known = folded(name.typed);
        if (wanted.size() >= kMinBeginning && known.starts_with(wanted)) add(name.shown, begun);
        const std::size_t longer = std::max(wanted.size(), known.size());
        const std::size_t shorter = std::min(wanted.size(), known.size());
        if (longer - shorter > fewest) continue;
        const std::size_t edits = edit_distance(wanted, known);
        // A word with more than a third of its letters changed is a different word: x is not a
        // mistyped y.
        if (edits > fewest || 3 * edits > longer) continue;
        if (edits < fewest) nearest.clear();
        fewest = edits;
        add(name.shown, nearest);
    }
    return fewest < kMaxEdits || begun.empty() ? nearest : begun;
}

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names) {
    const auto nearest = nearest_names(word, as_known(names));
    return nearest.empty() ? std::string_view() : nearest.front();
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> names) {
    return did_you_mean(word, as_known(names));
}

std::string did_you_mean(std::string_view word, std::span<const KnownName> names) {
    const auto nearest = nearest_names(word, names);
    std::string text;
    for (const std::string_view& name : nearest) {
        const bool is_last = &name == &nearest.back();
        text += text.empty() ? "; did you mean " : is_last ? " or " : ", ";
        text += name;
    }
    return text.empty() ? text : text + "?";
}

}  // namespace ocean
