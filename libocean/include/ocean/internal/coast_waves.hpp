// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The waves of a coast at one time as plain arrays, for a backend that sums them at many labels.
// Core makes the arrays, and finishes the surface from the sums: limiter, crests and swash are
// computed by the processor whichever backend sums.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ocean/domain.hpp"

namespace ocean {

struct WorldPoint;

/// Maps of four floats a sample, row-major, one after another, all over one domain that does not
/// wrap. They are read between samples by Catmull and Rom's cubic; beyond the border the values of
/// the edge continue.
struct QuadMaps {
    Domain domain;
    std::vector<const float*> maps;
    /// Equal owners have equal maps.
    std::shared_ptr<const void> owner;
};

/// The waves of one band and sector. Their analytic signal at a place is the cubic B-spline through
/// its coefficients times e^(i pi (half_turns . place)); the sea's period wraps.
struct CoastBandSector {
    int band = 0;                    // 0 .. 3
    float centre = 0.0f;             // direction of the middle of the sector [rad]
    float open_displacement = 0.0f;  // coth(k d) of the band in the open sea
    std::array<double, 2> cells_per_metre{};
    std::array<double, 2> half_turns{};   // [1/m]
    std::array<std::uint32_t, 2> mask{};  // the columns and rows, powers of two, less 1
    std::size_t pitch = 0;                // complex numbers of a row
    /// Rows of coefficients: one before the first column, all columns, three after the last.
    std::span<const float> values;
    std::span<const float> rates;  // the same for the derivative in time; empty: not made
};

struct CoastWaves {
    std::vector<CoastBandSector> pairs;
    /// A map of each pair: shift x, shift y [m], phase, turn [rad]; then the ground: height of the
    /// bed, depth that waves feel [m], slope, influence of the bed on the waves' phases.
    QuadMaps delays;
    /// The amplitudes of pairs 4 i .. 4 i + 3, relative to the open sea; then the remainder, whose
    /// third component is the influence of the bed on the waves' energy.
    QuadMaps energy;
    /// coth(k d) of the four bands at depths that are equal ratios apart, and where log(depth) lies
    /// among them: (log(depth) - first_log) * per_log.
    std::span<const float> displacement;
    float first_log = 0.0f;
    float per_log = 0.0f;
};

/// The sums at a label, in this order: Re Z, Im Z [m]; the sum of |Z|^2 of each pair [m^2]; the
/// displacement at choppiness 1 along x and y [m]; and the displacement of the open sea's waves
/// along the middles of their sectors, where the open sea is a part of the surface.
inline constexpr std::size_t kCoastSums = 7;

/// The input of a CoastFunction. parts: 1, values; 3, and their gradients [1/m]; 4, and their rates
/// [1/s]. Sum s of part p at label l is written to sums[(s * parts + p) * labels.size() + l]. Where
/// no wave feels the bed, any finite numbers may be written.
struct CoastRequest {
    const CoastWaves& waves;
    bool begins = true;  // false: same waves as in the request before
    std::span<const WorldPoint> labels;
    std::size_t parts = 1;
    std::span<float> sums;
};

}  // namespace ocean
