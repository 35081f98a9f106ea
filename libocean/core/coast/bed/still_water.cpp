// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Water that no wave reaches: see still_water.hpp.
#include "still_water.hpp"

#include <algorithm>
#include <cmath>

#include "shore_border.hpp"

namespace ocean {
namespace {

constexpr double kSoftShore = 0.15;  // half the rise over which land begins to swallow [m]
constexpr double kAlongSide = 1e-6;  // cosine to a side's normal below which waves run along it

enum class Shore : std::uint8_t { unknown, land, open, still };

/// The samples of a bed while they are sorted.
struct WaterSamples {
    int columns, rows;
    std::vector<Shore> shore;
    std::vector<std::uint32_t> next;  // samples whose neighbours are still to be visited

    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(i);
    }
    /// Calls use(index) for the neighbours of a sample: four by sides, eight with corners.
    template <typename Use>
    void for_each_neighbour(std::uint32_t sample, bool corners, const Use& use) const {
        const int i = static_cast<int>(sample) % columns, j = static_cast<int>(sample) / columns;
        for (int dj = -1; dj <= 1; ++dj) {
            for (int di = -1; di <= 1; ++di) {
                if ((di == 0 && dj == 0) || (!corners && di != 0 && dj != 0)) continue;
                const int x = i + di, y = j + dj;
                if (x < 0 || x >= columns || y < 0 || y >= rows) continue;
                use(static_cast<std::uint32_t>(index(x, y)));
            }
        }
    }
    void reach(std::size_t sample) {
        if (shore[sample] != Shore::unknown) return;
        shore[sample] = Shore::open;
        next.push_back(static_cast<std::uint32_t>(sample));
    }
};

/// Marks the water along a side as reached, if waves of a direction enter by that side.
void enter(WaterSamples& samples, const BorderSide& side, double cell, PlaneVector direction,
           double beyond) {
    const double inward = direction.dot(side.inward);
    if (inward < kAlongSide) return;
    const double along = direction.x * side.di + direction.y * side.dj;
    const double shadow = beyond * std::abs(along) / inward / cell;  // of outer land [samples]
    double after_land = shadow + 1.0;
    for (int n = 0; n < side.length; ++n) {
        const int k = along >= 0.0 ? n : side.length - 1 - n;
        const std::size_t at = samples.index(side.i + k * side.di, side.j + k * side.dj);
        after_land = samples.shore[at] == Shore::land ? 0.0 : after_land + 1.0;
        if (after_land > shadow) samples.reach(at);
    }
}

void flood(WaterSamples& samples) {
    while (!samples.next.empty()) {
        const std::uint32_t sample = samples.next.back();
        samples.next.pop_back();
        samples.for_each_neighbour(sample, false,
                                   [&](std::uint32_t other) { samples.reach(other); });
    }
}

/// Returns for each sample whether it is still, or, on land, whether the nearest water is.
std::vector<std::uint8_t> spread_over_land(WaterSamples& samples) {
    std::vector<std::uint32_t> line, further;
    for (std::size_t n = 0; n < samples.shore.size(); ++n) {
        if (samples.shore[n] == Shore::unknown) samples.shore[n] = Shore::still;
        if (samples.shore[n] != Shore::land) line.push_back(static_cast<std::uint32_t>(n));
    }
    while (!line.empty()) {
        further.clear();
        for (const std::uint32_t sample : line) {
            samples.for_each_neighbour(sample, true, [&](std::uint32_t other) {
                if (samples.shore[other] != Shore::land) return;
                samples.shore[other] = samples.shore[sample];
                further.push_back(other);
            });
        }
        line.swap(further);
    }
    std::vector<std::uint8_t> still(samples.shore.size());
    for (std::size_t n = 0; n < still.size(); ++n) {
        still[n] = samples.shore[n] == Shore::still ? 1 : 0;
    }
    return still;
}

}  // namespace

float passing(double height) {
    return static_cast<float>(1.0 -
                              std::clamp((height + kSoftShore) / (2.0 * kSoftShore), 0.0, 1.0));
}

StillWater find_still_water(const BedGrid& bed_height, std::span<const double> directions) {
    const Domain& domain = bed_height.domain;
    WaterSamples samples{domain.samples[0], domain.samples[1], {}, {}};
    bool has_land = false;
    for (const float height : bed_height.values) {
        const bool is_land = passing(double{height}) <= 0.0f;
        has_land = has_land || is_land;
        samples.shore.push_back(is_land ? Shore::land : Shore::unknown);
    }
    if (!has_land) return {};
    const double beyond = std::max(domain.size[0], domain.size[1]);
    for (const BorderSide& side : border_sides(domain)) {
        for (const double direction : directions) {
            enter(samples, side, bed_height.cell(), {std::cos(direction), std::sin(direction)},
                  beyond);
        }
    }
    flood(samples);
    const auto is_shut_off = [](Shore shore) { return shore == Shore::unknown; };
    if (std::ranges::none_of(samples.shore, is_shut_off)) return {};
    return {spread_over_land(samples)};
}

std::size_t nearest_sample(const Domain& domain, const std::array<double, 2>& place) {
    std::array<std::size_t, 2> at{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double sample = std::round((place[axis] - domain.origin[axis]) / domain.step(axis));
        at[axis] = static_cast<std::size_t>(
            std::clamp(sample, 0.0, static_cast<double>(domain.samples[axis] - 1)));
    }
    return at[1] * static_cast<std::size_t>(domain.samples[0]) + at[0];
}

}  // namespace ocean
