// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Places on a base of smooth hills with what gullies write for each, for the tests of gullies.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "land/gullies/gullies_task.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/gullies.hpp"
#include "testing.hpp"

namespace ocean::test {

inline constexpr std::size_t kValues = 6;

/// Places with their values: height, slope_x, slope_y, wear, gully, ridge.
struct Points {
    std::vector<double> x, y;
    std::array<std::vector<float>, kValues> value;

    explicit Points(std::size_t count = 0) { resize(count); }
    void resize(std::size_t count) {
        x.resize(count);
        y.resize(count);
        for (auto& values : value) values.assign(count, 0.0f);
    }
    std::size_t size() const { return x.size(); }
    GullyPoints spans() {
        return {x, y, value[0], value[1], value[2], value[3], value[4], value[5]};
    }
    GullyArrays arrays() {
        return {size(),          x.data(),        y.data(),        value[0].data(), value[1].data(),
                value[2].data(), value[3].data(), value[4].data(), value[5].data()};
    }
    std::array<std::uint32_t, kValues> bits(std::size_t p) const {
        std::array<std::uint32_t, kValues> result;
        for (std::size_t a = 0; a < kValues; ++a) {
            result[a] = std::bit_cast<std::uint32_t>(value[a][p]);
        }
        return result;
    }
};

/// The lattice point of an octave next to a place along one axis, GullyCell of the shader.
struct GullyLatticePoint {
    std::uint32_t index = 0;  // 0 .. count - 1, or modulo 2^32
    double offset = 0.0;      // from the lattice point to the place [wavelengths], -1/2 .. 1/2
};
/// Returns the point for one place, as the loop over points finds it for several.
inline GullyLatticePoint nearest_lattice_point(const GullyOctave& octave, double place) {
    const double at = place * (1.0 / octave.wavelength);
    double whole = (at + kRoundDouble) - kRoundDouble;
    const double offset = at - whole;
    if (octave.count > 0) {
        const double count = octave.count;
        whole -= ((whole * (1.0 / count) + kRoundDouble) - kRoundDouble) * count;
        if (whole < 0.0) whole += count;
    }
    const auto bits = std::bit_cast<std::uint64_t>(whole + kRoundDouble);
    return {static_cast<std::uint32_t>(bits), offset};
}

/// Sets a smooth base of hills, 200 m high and kilometres apart, which repeats after 6100 m.
inline void set_hills(Points& points, std::size_t p) {
    const double kx = kTwoPi / 6100.0, ky = 2.0 * kTwoPi / 6100.0;
    const double a = kx * points.x[p] + ky * points.y[p];
    const double b = ky * points.x[p] - kx * points.y[p];
    points.value[0][p] = static_cast<float>(200.0 * (std::sin(a) + std::cos(b)));
    points.value[1][p] = static_cast<float>(200.0 * (kx * std::cos(a) - ky * std::sin(b)));
    points.value[2][p] = static_cast<float>(200.0 * (ky * std::cos(a) + kx * std::sin(b)));
}

inline Points random_hills(std::size_t count, double extent, unsigned seed) {
    Points points(count);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-extent, extent);
    for (std::size_t p = 0; p < count; ++p) {
        points.x[p] = place(random);
        points.y[p] = place(random);
        set_hills(points, p);
    }
    return points;
}

}  // namespace ocean::test
