// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The distance of Damerau and Levenshtein over a handful of names.
#include "ocean/internal/nearest_name.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

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

}  // namespace

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names) {
    word = word.substr(0, 64);
    std::string_view best;
    std::size_t fewest = word.size() + 1;
    for (std::string_view name : names) {
        const std::size_t edits = edit_distance(word, name);
        // A word with more than a third of its letters changed is another word: x is no mistyped y.
        if (edits < fewest && 3 * edits <= std::max(word.size(), name.size())) {
            fewest = edits;
            best = name;
        }
    }
    return best;
}

}  // namespace ocean
