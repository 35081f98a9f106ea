// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Where and when maps lie in the world. A domain is a square that repeats, as for every open sea,
// or a rectangle that exists once, as for a coast; a region is a rectangle that a user cuts out of
// a land or a coast; a timeline has the times of frames.
//
//     const Domain tile = Domain::tile(500.0, 1024);  // a square of 500 m that repeats
//     const auto [x, y] = tile.place(10, 20);         // of sample (10, 20) [m]
//     const Region window{.origin = {200.0, 0.0}, .size = {300.0, 400.0}, .cell = 2.0};
//     Surface surface = ocean.region(12.0, domain_of(window), {Channel::height});
//     const double t = timeline_of(sea).time_of(48);  // of frame 48 [s]
#pragma once

#include <array>
#include <cstddef>

namespace ocean {

struct Sea;

/// A rectangle of samples, x east and y north [m].
struct Domain {
    std::array<double, 2> origin{};  // of sample (0, 0) [m]
    std::array<double, 2> size{};    // [m]
    std::array<int, 2> samples{};
    /// True: the right edge continues at the left one and the top edge at the bottom one; samples
    /// lie size / samples apart. False: the last samples lie on the edges; samples lie size /
    /// (samples - 1) apart.
    bool wraps = true;

    /// Returns the square of side `period` [m] that repeats from the world's origin.
    static constexpr Domain tile(double period, int samples = 0) {
        return {{0.0, 0.0}, {period, period}, {samples, samples}, true};
    }
    /// Returns true for a domain that `tile` can return.
    constexpr bool is_tile() const {
        return wraps && origin == std::array{0.0, 0.0} && size[0] == size[1] &&
               samples[0] == samples[1];
    }
    /// Returns the distance of neighbouring samples along an axis [m].
    constexpr double step(std::size_t axis) const {
        return size[axis] / (wraps ? samples[axis] : samples[axis] - 1);
    }
    /// Returns the number of samples.
    constexpr std::size_t count() const {
        return static_cast<std::size_t>(samples[0]) * static_cast<std::size_t>(samples[1]);
    }
    /// Returns the position of sample (i, j) [m].
    constexpr std::array<double, 2> place(int i, int j) const {
        return {origin[0] + i * step(0), origin[1] + j * step(1)};
    }
    constexpr bool operator==(const Domain&) const = default;
};

// ---- Regions

inline constexpr int kMaxRegionSide = 32768;

/// A rectangle at any place, with samples `cell` apart; its far sides lie at the last samples
/// within the size.
struct Region {
    std::array<double, 2> origin{};  // [m]
    std::array<double, 2> size{};    // [m]
    double cell = 1.0;               // [m]
};

/// Returns the samples of a region. Throws Error invalid_value unless it has 2 .. kMaxRegionSide
/// samples along each side.
Domain domain_of(const Region& region);

/// Returns the rectangle of a domain that exists once, with samples `cell` apart [m] both ways:
/// from its origin as many samples as lie within the domain, at least 2 along each side.
Domain with_cell(Domain domain, double cell);

// ---- The times of frames

/// The times of a subject's frames. The default is the timeline of a subject that does not move.
struct Timeline {
    bool moves = false;
    double start = 0.0;  // of the first frame [s]
    int first_frame = 1;
    double frame_rate = 24.0;  // [1/s]
    /// True: parameters change with time, so that maps of different times differ in more than the
    /// phase of their waves.
    bool plays_take = false;

    /// Returns the time of a frame [s]: 0 for a subject that does not move.
    double time_of(double frame) const {
        return moves ? start + (frame - first_frame) / frame_rate : 0.0;
    }
};
/// Returns the timeline of a sea.
Timeline timeline_of(const Sea& sea);

}  // namespace ocean
