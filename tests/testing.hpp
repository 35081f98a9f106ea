// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// GoogleTest, the standard library as most tests use it, and what tests of every folder share. The
// programs precompile it.
//
// A guard stands here in place of #pragma once: GCC tells a precompiled header from the same file
// by its time, and a compiler cache keeps the time of another clone.
#ifndef OCEAN_TESTS_TESTING_HPP
#define OCEAN_TESTS_TESTING_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ocean::test {

/// Returns whether a text has the words; a failed expectation shows the text.
inline testing::AssertionResult says(std::string_view text, std::string_view words) {
    const bool found = text.find(words) != std::string_view::npos;
    return (found ? testing::AssertionSuccess() : testing::AssertionFailure())
           << "'" << words << "' in: " << text;
}

/// Returns whether one of several texts has the words.
inline testing::AssertionResult says(const std::vector<std::string>& texts,
                                     std::string_view words) {
    std::string all;
    for (const std::string& text : texts) all += text + "\n";
    return says(all, words);
}

/// Returns whether a text or one of several has each of the words.
template <typename Texts>
testing::AssertionResult says(const Texts& texts, std::initializer_list<std::string_view> words) {
    for (const std::string_view one : words) {
        if (const testing::AssertionResult found = says(texts, one); !found) return found;
    }
    return testing::AssertionSuccess();
}

/// The numbers from `first` up to and without `end`.
template <typename Index>
struct Range {
    Index first, end;
};

template <typename Index>
struct Pair {
    Index i, j;
};
/// A sample of a map with its index in memory, where row follows on row.
template <typename Index>
struct Cell {
    Index i, j;
    std::size_t at;
};

/// All pairs of numbers of two ranges as values of type Item; i runs fastest.
template <typename Index, typename Item>
class Grid {
  public:
    Grid(Range<Index> i, Range<Index> j) : i_(i), j_(j) {}

    class Iterator {
      public:
        Iterator(Range<Index> range, Index j) : range_(range), i_(range.first), j_(j) {}
        Item operator*() const {
            if constexpr (std::is_same_v<Item, Cell<Index>>) {
                return {i_, j_, static_cast<std::size_t>(j_ * range_.end + i_)};
            } else {
                return {i_, j_};
            }
        }
        Iterator& operator++() {
            if (++i_ == range_.end) {
                i_ = range_.first;
                ++j_;
            }
            return *this;
        }
        bool operator!=(const Iterator& other) const { return j_ != other.j_; }

      private:
        Range<Index> range_;
        Index i_, j_;
    };
    Iterator begin() const { return {i_, i_.first < i_.end ? std::min(j_.first, j_.end) : j_.end}; }
    Iterator end() const { return {i_, j_.end}; }

  private:
    Range<Index> i_, j_;
};

/// Returns the samples of a map: for (const auto [i, j, at] : cells(columns, rows)).
template <typename Index = int>
Grid<Index, Cell<Index>> cells(std::type_identity_t<Index> columns,
                               std::type_identity_t<Index> rows) {
    return {{0, columns}, {0, rows}};
}

/// Returns pairs: for (const auto [n, m] : pairs({-31, 32}, {-31, 32})).
template <typename Index = int>
Grid<Index, Pair<Index>> pairs(Range<std::type_identity_t<Index>> i,
                               Range<std::type_identity_t<Index>> j) {
    return {i, j};
}
template <typename Index = int>
Grid<Index, Pair<Index>> pairs(std::type_identity_t<Index> columns,
                               std::type_identity_t<Index> rows) {
    return {{0, columns}, {0, rows}};
}

}  // namespace ocean::test

#endif
