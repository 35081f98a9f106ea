// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Linear fields of the sea between the samples of a map: a cubic B-spline whose coefficients come
// straight from the transform.
//
// A spline s(u) = sum_j c_j B(u - j), u in samples, shows a mode e^(i theta u) of coefficients
// c_j = e^(i theta j) as sum_p B^(theta + 2 pi p) e^(i (theta + 2 pi p) u), with the transform
// B^(theta) = (sin(theta/2) / (theta/2))^4 of the kernel. Dividing the mode by B^(theta) first
// makes the wanted term (p = 0) exact and leaves the aliases alone. The largest, p = -1, has the
// amplitude
//     e = (n / (R - n))^4        of a mode of n waves on R samples, e^(3/4) in its derivative.
// Interpolation, c = the samples filtered by 1 / sum_p B^(theta + 2 pi p), is wrong by e in the
// wanted term too: its rms error is sqrt(2) times as large. The least squares choice gains only a
// further e^2 / 2. [Unser 1999] has the splines and B^. Along each axis e is at most 1/81 if R is
// at least twice that of the modes, 1/2401 with four times; only the shortest waves reach these
// limits. query_test.cpp proves it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>

#include "field/cubic.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/surface.hpp"
#include "waves/kernel/packed_modes.hpp"

namespace ocean {

class ThreadPool;

/// The values of the fields at one point, in their order, and the slopes of the first three.
struct SplineValue {
    std::array<float, 4> value;
};
struct SplineJet {
    std::array<float, 3> value;
    std::array<float, 3> by_x;  // per metre
    std::array<float, 3> by_y;
};

/// Returns floor(x). std::floor is a function call on machines as old as x86-64 allows.
inline long long floor_index(double x) {
    const auto whole = static_cast<long long>(x);
    return x < static_cast<double>(whole) ? whole - 1 : whole;
}

/// Returns the factor that turns a mode into a coefficient of a spline of `resolution` samples: 1 /
/// (B^(kx) B^(ky)), and 0 for a mode that a map of `band` samples does not hold.
ModeFactor spline_factor(const Modes& modes, int band, int resolution);

/// Four periodic fields of one time. Other classes write the coefficients, and only written
/// coefficients may be read.
class SplineMap {
  public:
    static constexpr int kFields = 4;

    SplineMap(Lattice lattice, ThreadPool& pool);

    const Lattice& lattice() const { return lattice_; }
    /// Returns the output that writes the coefficients of these fields; the coefficients of a field
    /// without a quantity stay unchanged. Whole vectors are written faster than parts.
    MapOutput output(const std::array<Quantity, kFields>& quantities);
    /// Returns the first and the last column that a value at x depends on.
    std::array<int, 2> columns(double x) const {
        const long long i = floor_index(x * per_metre_);
        const long long mask = lattice_.resolution - 1;
        return {static_cast<int>((i - 1) & mask), static_cast<int>((i + 2) & mask)};
    }
    static constexpr std::size_t bytes_per_sample() { return sizeof(Fields); }
    /// Returns the value at finite coordinates [m], not many periods from 0.
    SplineValue value(double x, double y) const;
    SplineJet jet(double x, double y) const;
    /// Prefetches the coefficients around a point.
    void prefetch(double x, double y) const {
        const Place at = place(x, y);
        for (const Fields* const row : at.row) {
            __builtin_prefetch(row + at.column[0]);
            __builtin_prefetch(row + at.column[3]);
        }
    }
    /// Returns the jet at a sample of the lattice (i, j), from nine coefficients instead of
    /// sixteen.
    SplineJet jet_of_sample(int i, int j) const;

    /// Reads along a line of one y: what its four rows add up to is kept for each column.
    class Line;

  private:
    /// The fields lie side by side, so that a point touches few cache lines.
    using Fields = float __attribute__((vector_size(kFields * sizeof(float))));
    struct Place {
        std::array<const Fields*, 4> row;
        std::array<std::size_t, 4> column;
        float x, y;  // within the cell, 0 .. 1
    };
    Place place(double x, double y) const;
    /// Returns the jet of a value and its slopes per sample.
    SplineJet jet_from(Fields value, Fields by_x, Fields by_y) const;

    Lattice lattice_;
    double per_metre_;
    PageVector<Fields> texels_;
};

inline SplineMap::Place SplineMap::place(double x, double y) const {
    const double u = x * per_metre_;
    const double v = y * per_metre_;
    const long long i = floor_index(u);
    const long long j = floor_index(v);
    const long long mask = lattice_.resolution - 1;
    Place place;
    for (int a = 0; a < 4; ++a) {
        const auto at = static_cast<std::size_t>(a);
        place.column[at] = static_cast<std::size_t>((i + a - 1) & mask);
        place.row[at] = texels_.data() + static_cast<std::size_t>((j + a - 1) & mask) *
                                             static_cast<std::size_t>(lattice_.resolution);
    }
    place.x = static_cast<float>(u - static_cast<double>(i));
    place.y = static_cast<float>(v - static_cast<double>(j));
    return place;
}

inline SplineValue SplineMap::value(double x, double y) const {
    const Place at = place(x, y);
    const std::array<float, 4> wx = b_spline(at.x);
    const std::array<float, 4> wy = b_spline(at.y);
    Fields sum{};
    for (std::size_t j = 0; j < 4; ++j) {
        Fields along{};
        for (std::size_t i = 0; i < 4; ++i) along += wx[i] * at.row[j][at.column[i]];
        sum += wy[j] * along;
    }
    return {{sum[0], sum[1], sum[2], sum[3]}};
}

inline SplineJet SplineMap::jet_from(Fields value, Fields by_x, Fields by_y) const {
    const auto scale = static_cast<float>(per_metre_);
    by_x *= scale;
    by_y *= scale;
    return {
        {value[0], value[1], value[2]}, {by_x[0], by_x[1], by_x[2]}, {by_y[0], by_y[1], by_y[2]}};
}

inline SplineJet SplineMap::jet(double x, double y) const {
    const Place at = place(x, y);
    const std::array<float, 4> wx = b_spline(at.x);
    const std::array<float, 4> wy = b_spline(at.y);
    const std::array<float, 4> sx = b_spline_slopes(at.x);
    const std::array<float, 4> sy = b_spline_slopes(at.y);
    Fields sum{};
    Fields by_x{};
    Fields by_y{};
    for (std::size_t j = 0; j < 4; ++j) {
        Fields along{};
        Fields slope{};
        for (std::size_t i = 0; i < 4; ++i) {
            const Fields texel = at.row[j][at.column[i]];
            along += wx[i] * texel;
            slope += sx[i] * texel;
        }
        sum += wy[j] * along;
        by_x += wy[j] * slope;
        by_y += sy[j] * along;
    }
    return jet_from(sum, by_x, by_y);
}

inline SplineJet SplineMap::jet_of_sample(int i, int j) const {
    const int mask = lattice_.resolution - 1;
    const auto texel = [&](int column, int row) {
        return texels_[static_cast<std::size_t>(row & mask) *
                           static_cast<std::size_t>(lattice_.resolution) +
                       static_cast<std::size_t>(column & mask)];
    };
    // The kernel at -1, 0, 1 is 1/6, 4/6, 1/6; its derivative -1/2, 0, 1/2.
    constexpr float kSide = 1.0f / 6.0f;
    constexpr float kMiddle = 4.0f / 6.0f;
    Fields along[3];
    Fields slope[3];
    for (int a = 0; a < 3; ++a) {
        const Fields south = texel(i + a - 1, j - 1);
        const Fields middle = texel(i + a - 1, j);
        const Fields north = texel(i + a - 1, j + 1);
        along[a] = kSide * (south + north) + kMiddle * middle;
        slope[a] = 0.5f * (north - south);
    }
    return jet_from(kSide * (along[0] + along[2]) + kMiddle * along[1],
                    0.5f * (along[2] - along[0]),
                    kSide * (slope[0] + slope[2]) + kMiddle * slope[1]);
}

/// The values at a line of one y, read at places x that only grow. The map must live longer.
class SplineMap::Line {
  public:
    Line(const SplineMap& map, double y)
        : map_(map),
          weights_(b_spline(map.place(0.0, y).y)),
          slopes_(b_spline_slopes(map.place(0.0, y).y)),
          rows_(map.place(0.0, y).row),
          columns_(std::make_unique_for_overwrite<Column[]>(
              static_cast<std::size_t>(map.lattice_.resolution))) {}

    SplineValue value(double x) {
        const auto [first, weights, unused] = begin(x);
        Fields sum{};
        for (int a = 0; a < 4; ++a) sum += weights[at(a)] * column(first + a).value;
        return {{sum[0], sum[1], sum[2], sum[3]}};
    }
    SplineJet jet(double x) {
        const auto [first, weights, offset] = begin(x);
        const std::array<float, 4> slopes = b_spline_slopes(offset);
        Fields sum{};
        Fields by_x{};
        Fields by_y{};
        for (int a = 0; a < 4; ++a) {
            const Column& along = column(first + a);
            sum += weights[at(a)] * along.value;
            by_x += slopes[at(a)] * along.value;
            by_y += weights[at(a)] * along.by_y;
        }
        return map_.jet_from(sum, by_x, by_y);
    }

  private:
    struct Column {
        Fields value;
        Fields by_y;  // per sample
    };
    struct Begun {
        long long first;  // column
        std::array<float, 4> weights;
        float offset;  // within the cell, 0 .. 1
    };
    static std::size_t at(int a) { return static_cast<std::size_t>(a); }
    std::size_t index(long long column) const {
        return static_cast<std::size_t>(column & (map_.lattice_.resolution - 1));
    }
    const Column& column(long long number) const { return columns_[index(number)]; }

    /// Makes the columns around x that are missing.
    Begun begin(double x) {
        const double u = x * map_.per_metre_;
        const long long i = floor_index(u);
        for (end_ = std::max(end_, i - 1); end_ < i + 3; ++end_) {
            const std::size_t to = index(end_);
            Column made{};
            for (std::size_t j = 0; j < 4; ++j) {
                const Fields texel = rows_[j][to];
                made.value += weights_[j] * texel;
                made.by_y += slopes_[j] * texel;
            }
            columns_[to] = made;
        }
        const auto offset = static_cast<float>(u - static_cast<double>(i));
        return {i - 1, b_spline(offset), offset};
    }

    const SplineMap& map_;
    std::array<float, 4> weights_;
    std::array<float, 4> slopes_;
    std::array<const Fields*, 4> rows_;
    std::unique_ptr<Column[]> columns_;
    long long end_ = std::numeric_limits<long long>::min();  // the first column that is missing
};

}  // namespace ocean
