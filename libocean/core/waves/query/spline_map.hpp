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

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

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

    /// Reads at places x of many lines.
    class Lines;
    /// The fields lie side by side, so that a point touches few cache lines.
    using Fields = float __attribute__((vector_size(kFields * sizeof(float))));

  private:
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

/// Reads along lines of one y each, at places x that they share and that only grow: what the four
/// rows of a line add up to is kept for each column.
class SplineMap::Lines {
  public:
    Lines(Lattice lattice, std::span<const double> x);

    /// Has write(i, value, by_x, by_y, rate) take the fields of `map` and their slopes, and the
    /// fields of `rates`, 0 without it, at each of `count` places, i = 0 .. count - 1, beginning
    /// with place `first` of a line. The maps must be of the lattice.
    template <typename Write>
    void read(const SplineMap& map, const SplineMap* rates, double y, std::size_t first,
              std::size_t count, const Write& write) const;

  private:
    struct Along {
        long long column;  // the first
        std::array<float, 4> weights;
        std::array<float, 4> slopes;
    };
    struct Column {
        Fields value;
        Fields by_y;  // per sample
        Fields rate;
    };

    std::vector<Along> places_;
};

template <typename Write>
void SplineMap::Lines::read(const SplineMap& map, const SplineMap* rates, double y,
                            std::size_t first, std::size_t count, const Write& write) const {
    if (count == 0) return;
    const std::span<const Along> places = std::span(places_).subspan(first, count);
    const long long begin = places.front().column;
    const long long mask = map.lattice_.resolution - 1;
    const Place line = map.place(0.0, y);
    const Place rate_line = rates != nullptr ? rates->place(0.0, y) : line;
    const std::array<float, 4> weights = b_spline(line.y);
    const std::array<float, 4> slopes = b_spline_slopes(line.y);
    const auto size = static_cast<std::size_t>(places.back().column + 4 - begin);
    const auto columns = std::make_unique_for_overwrite<Column[]>(size);
    for (std::size_t c = 0; c < size; ++c) {
        const auto at = static_cast<std::size_t>((begin + static_cast<long long>(c)) & mask);
        Column made{};
        for (std::size_t j = 0; j < 4; ++j) {
            const Fields texel = line.row[j][at];
            made.value += weights[j] * texel;
            made.by_y += slopes[j] * texel;
            if (rates != nullptr) made.rate += weights[j] * rate_line.row[j][at];
        }
        columns[c] = made;
    }
    const auto scale = static_cast<float>(map.per_metre_);
    for (std::size_t i = 0; i < count; ++i) {
        const Along& along = places[i];
        const Column* const from = columns.get() + (along.column - begin);
        Fields value{}, by_x{}, by_y{}, rate{};
        for (std::size_t a = 0; a < 4; ++a) {
            value += along.weights[a] * from[a].value;
            by_x += along.slopes[a] * from[a].value;
            by_y += along.weights[a] * from[a].by_y;
            rate += along.weights[a] * from[a].rate;
        }
        write(i, value, scale * by_x, scale * by_y, rate);
    }
}

}  // namespace ocean
