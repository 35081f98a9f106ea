// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The ground that a shore has shaped: see shore_ground.hpp.
#include "land/function/shore_ground.hpp"

#include <algorithm>

namespace ocean {
namespace {

using Marks = PageVector<std::uint8_t>;

std::size_t index_of(const Domain& domain, int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(domain.samples[0]) +
           static_cast<std::size_t>(i);
}

/// Returns the marks of every other sample: 1 if a sample that contributes to it, up to `reach`
/// away on each side, has a 1.
Marks halved_marks(const Domain& domain, const Marks& marks, int reach) {
    const Domain half = halved(domain);
    Marks result(half.count());
    const auto any = [&](int i, int j) {
        const int right = std::min(2 * i + reach, domain.samples[0] - 1);
        const int top = std::min(2 * j + reach, domain.samples[1] - 1);
        for (int y = std::max(2 * j - reach, 0); y <= top; ++y) {
            for (int x = std::max(2 * i - reach, 0); x <= right; ++x) {
                if (marks[index_of(domain, x, y)] != 0) return true;
            }
        }
        return false;
    };
    for (int j = 0; j < half.samples[1]; ++j) {
        for (int i = 0; i < half.samples[0]; ++i) result[index_of(half, i, j)] = any(i, j) ? 1 : 0;
    }
    return result;
}

}  // namespace

ShoreGround::ShoreGround(const Domain& domain, std::span<const float> before,
                         std::span<const float> after, int levels, ThreadPool& pool)
    : heights_(domain, after, pool, levels) {
    Marks marks(domain.count());
    std::ranges::transform(before, after, marks.begin(),
                           [](float a, float b) { return std::uint8_t{a != b}; });
    changed_.push_back(std::move(marks));
    for (std::size_t l = 0; l + 1 < heights_.size(); ++l) {
        const int reach = l < static_cast<std::size_t>(levels) ? 0 : kHalvingReach;
        changed_.push_back(halved_marks(heights_.at(l).domain(), changed_.back(), reach));
    }
}

ShoreGround::Level ShoreGround::level(double cell) const {
    const std::size_t l = heights_.index(cell);
    return {heights_.at(l), changed_[l]};
}

bool ShoreGround::Level::reaches(double x, double y) const {
    const auto [left, right] = around(x, 0);
    const auto [below, above] = around(y, 1);
    const auto columns = static_cast<std::size_t>(heights_.domain().samples[0]);
    const auto has_changed = [&](std::size_t i, std::size_t j) {
        return changed_[j * columns + i] != 0;
    };
    return has_changed(left, below) || has_changed(right, below) || has_changed(left, above) ||
           has_changed(right, above);
}

std::pair<std::size_t, std::size_t> ShoreGround::Level::around(double at, std::size_t axis) const {
    constexpr double kRounding = 1e-6;  // tolerance for a place on a sample, as a share of a cell
    const auto [cell, share] = heights_.in_cell(at, axis);
    return {share > 1.0 - kRounding ? cell + 1 : cell, share < kRounding ? cell : cell + 1};
}

std::size_t ShoreGround::bytes() const {
    std::size_t sum = SplinePyramid::bytes(heights_.finest().domain());
    for (const Marks& marks : changed_) sum += marks.size();
    return sum;
}

}  // namespace ocean
