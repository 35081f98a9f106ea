// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks and conversions of points and options that all kinds of queries share.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/query.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/kernel/map_kernel.hpp"
#include "waves/query/spline_map.hpp"

namespace ocean {

/// Returns the samples of the map whose waves a query shows.
inline int shown_resolution(int grid_resolution, const QueryOptions& options) {
    return options.resolution > 0 ? options.resolution : grid_resolution;
}

/// Returns the samples of the spline on which a query interpolates. Throws Error invalid_value.
inline int spline_resolution(int grid_resolution, const QueryOptions& options) {
    const int shown = shown_resolution(grid_resolution, options);
    require_resolution(shown);
    const int finest = std::max(kMaxResolution / (2 * shown), 1);
    if (!is_power_of_two(options.refine) || options.refine > finest) {
        const std::string given = std::to_string(options.refine);
        const std::string side = std::to_string(shown);
        const std::string allowed = "a power of two, 1 .. " + std::to_string(finest);
        throw Error(ErrorKind::invalid_value,
                    "refine = " + given + "; allowed for a map of " + side + " x " + side +
                        " samples: " + allowed,
                    {.parameter = "refine", .value = given, .allowed = allowed});
    }
    return std::min(2 * shown * options.refine, kMaxResolution);
}

/// Returns the resolution of the lattice of labels on which folds are searched: two samples for
/// each sample of the displayed map.
inline int fold_resolution(int grid_resolution, const QueryOptions& options) {
    return std::min(2 * shown_resolution(grid_resolution, options),
                    spline_resolution(grid_resolution, options));
}

/// Returns the bytes of `splines` splines and of the kernels that write `fields` fields to them.
inline std::uint64_t spline_bytes(int grid_resolution, const QueryOptions& options, int splines,
                                  int fields) {
    const auto shown = static_cast<std::uint64_t>(shown_resolution(grid_resolution, options));
    const auto fine = static_cast<std::uint64_t>(spline_resolution(grid_resolution, options));
    // Between the passes: for each field the columns that have modes, complex.
    constexpr std::uint64_t kBetween = 4;
    return static_cast<std::uint64_t>(splines) * SplineMap::bytes_per_sample() * fine * fine +
           packed_bytes(static_cast<int>(shown)) +
           kBetween * static_cast<std::uint64_t>(fields) * fine * shown;
}

/// Returns x modulo the period, in [0, period).
inline double wrapped(double x, double period) {
    if (x >= 0.0 && x < period) return x;
    const double rest = std::fmod(x, period);
    const double positive = rest < 0.0 ? rest + period : rest;
    return positive < period ? positive : 0.0;  // -1e-20 + period rounds to the period
}

inline void require_finite(std::span<const WorldPoint> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i].x) && std::isfinite(points[i].y)) continue;
        throw Error(ErrorKind::invalid_value,
                    "point " + std::to_string(i) + " = (" + plain_text(points[i].x) + ", " +
                        plain_text(points[i].y) + "); allowed: finite coordinates in metres");
    }
}

/// Calls sample(z, places, motions) for each height z of the points, with the places at that
/// height, and writes each motion where its point stands. Throws Error invalid_value, before any
/// call, for a point that is not finite.
template <typename Sample>
void for_each_height(std::span<const WaterPoint> points, std::span<WaterMotion> motions,
                     const Sample& sample) {
    for (const WaterPoint& point : points) {
        if (std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)) continue;
        throw Error(ErrorKind::invalid_value,
                    "the coordinates of a point must be finite numbers of metres");
    }
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return points[i].z; });
    std::vector<WorldPoint> level;
    std::vector<WaterMotion> found;
    for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
        const double z = points[order[first]].z;
        level.clear();
        for (; last < order.size() && points[order[last]].z == z; ++last) {
            level.push_back({points[order[last]].x, points[order[last]].y});
        }
        found.resize(level.size());
        sample(z, std::span<const WorldPoint>(level), std::span<WaterMotion>(found));
        for (std::size_t i = first; i < last; ++i) motions[order[i]] = found[i - first];
    }
}

/// Calls body(first, last) for pieces of [0, count) on all threads. An exact point sums all waves,
/// which takes long enough for a piece of its own, after which a call may be stopped.
template <typename Body>
void for_each_point(ThreadPool& pool, std::size_t count, bool exact, const Body& body) {
    const std::size_t piece = exact ? 1 : 256;
    constexpr std::size_t kMaxItems = std::numeric_limits<int>::max();
    for (std::size_t start = 0; start < count; start += kMaxItems * piece) {
        const std::size_t end = std::min(count, start + kMaxItems * piece);
        const std::size_t pieces = (end - start + piece - 1) / piece;
        pool.for_each_item(static_cast<int>(pieces), [&](int item, int) {
            const std::size_t first = start + static_cast<std::size_t>(item) * piece;
            body(first, std::min(first + piece, end));
        });
    }
}

}  // namespace ocean
