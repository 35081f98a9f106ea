// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The land in the way of waves: see march_land.hpp.
#include "march_land.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ocean {
namespace {

/// A walk along one axis through squares of side 1.
struct Walk {
    int step;      // -1 or 1
    double next;   // share of the way at the next edge
    double width;  // from edge to edge

    Walk(double from, double to, int square)
        : step(to < from ? -1 : 1),
          next(std::numeric_limits<double>::infinity()),
          width(std::numeric_limits<double>::infinity()) {
        if (from == to) return;
        width = 1.0 / std::abs(to - from);
        next = (step > 0 ? square + 1 - from : from - square) * width;
    }
};

/// The energy that is left on a way.
struct EnergyOnWay {
    float left = 1.0f;
    float before_land = 1.0f;  // energy left where the current land began
    bool on_land = false;

    void pass(float height) {
        const bool is_land = height >= 0.0f;
        if (is_land && !on_land) before_land = left;
        on_land = is_land;
        left = std::min(left, passing(double{height}));
    }
};

}  // namespace

MarchLand::MarchLand(const BedGrid& bed_height, const StillWater& still)
    : bed_(bed_height),
      per_metre_(1.0 / bed_height.cell()),
      shore_squares_(bed_height.values.size()) {
    const int columns = bed_.domain.samples[0], rows = bed_.domain.samples[1];
    std::size_t n = 0;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i, ++n) {
            if (still.is_still(n)) bed_.values[n] = std::max(bed_.values[n], 1.0f);
            if (!is_shore(i, j)) continue;
            is_empty_ = false;
            is_at_border_ = is_at_border_ || i == 0 || j == 0 || i == columns - 1 || j == rows - 1;
            for (int y = std::max(j - 1, 0); y <= j; ++y) {
                for (int x = std::max(i - 1, 0); x <= i; ++x) {
                    shore_squares_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                                   static_cast<std::size_t>(x)] = 1;
                }
            }
        }
    }
}

std::array<double, 2> MarchLand::in_samples(const std::array<double, 2>& place) const {
    return {(place[0] - bed_.domain.origin[0]) * per_metre_,
            (place[1] - bed_.domain.origin[1]) * per_metre_};
}

float MarchLand::at(int i, int j) const {
    return bed_.at(std::clamp(i, 0, bed_.domain.samples[0] - 1),
                   std::clamp(j, 0, bed_.domain.samples[1] - 1));
}

bool MarchLand::has_shore(int i, int j) const {
    const int x = std::clamp(i, 0, bed_.domain.samples[0] - 1);
    const int y = std::clamp(j, 0, bed_.domain.samples[1] - 1);
    return shore_squares_[static_cast<std::size_t>(y) *
                              static_cast<std::size_t>(bed_.domain.samples[0]) +
                          static_cast<std::size_t>(x)] != 0;
}

float MarchLand::height(int i, int j, double x, double y) const {
    const auto u = static_cast<float>(x - i), v = static_cast<float>(y - j);
    const float a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
    if (a + d >= b + c) {
        return u > v ? a + u * (b - a) + v * (d - b) : a + v * (c - a) + u * (d - c);
    }
    return u + v < 1.0f ? a + u * (b - a) + v * (c - a)
                        : d + (1.0f - u) * (c - d) + (1.0f - v) * (b - d);
}

float MarchLand::height_at(const std::array<double, 2>& place) const {
    const auto [x, y] = in_samples(place);
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    return has_shore(i, j) ? height(i, j, x, y) : std::numeric_limits<float>::lowest();
}

bool MarchLand::is_land(const std::array<double, 2>& place) const {
    return height_at(place) >= 0.0f;
}

bool MarchLand::parts(const std::array<double, 2>& from, const std::array<double, 2>& to) const {
    return through(from, to) < passing(double{std::max(height_at(from), height_at(to))});
}

/// The bed is straight between the edges of triangles, so that its heights at the edges suffice.
float MarchLand::through(const std::array<double, 2>& from, const std::array<double, 2>& to) const {
    const auto [x, y] = in_samples(from);
    const auto [end_x, end_y] = in_samples(to);
    const double dx = end_x - x, dy = end_y - y;
    int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    const int last_i = static_cast<int>(std::floor(end_x));
    const int last_j = static_cast<int>(std::floor(end_y));
    Walk along_x(x, end_x, i), along_y(y, end_y, j);
    EnergyOnWay energy;
    if (has_shore(i, j)) energy.pass(height(i, j, x, y));
    if (energy.on_land) return 0.0f;
    double entry = 0.0;
    for (int left = std::abs(last_i - i) + std::abs(last_j - j);; --left) {
        const bool sideways = j == last_j || (i != last_i && along_x.next < along_y.next);
        Walk& walk = sideways ? along_x : along_y;
        const double exit = left > 0 ? walk.next : 1.0;
        if (has_shore(i, j)) {
            const bool rises = at(i, j) + at(i + 1, j + 1) >= at(i + 1, j) + at(i, j + 1);
            const double slope = rises ? dx - dy : dx + dy;
            const double offset = rises ? (x - i) - (y - j) : (x - i) + (y - j) - 1.0;
            const double ridge = slope != 0.0 ? -offset / slope : 0.0;
            if (ridge > entry && ridge < exit) {
                energy.pass(height(i, j, x + ridge * dx, y + ridge * dy));
            }
            if (left > 0) energy.pass(height(i, j, x + exit * dx, y + exit * dy));
        }
        if (left == 0) break;
        if (energy.left <= 0.0f && !energy.on_land) return 0.0f;
        (sideways ? i : j) += walk.step;
        walk.next += walk.width;
        entry = exit;
    }
    if (!has_shore(i, j) || height(i, j, end_x, end_y) < 0.0f) return energy.left;
    return energy.on_land ? energy.before_land : energy.left;
}

}  // namespace ocean
