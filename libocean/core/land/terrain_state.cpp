// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The statistics of a terrain; see terrain.hpp.
#include "ocean/terrain.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/measured_rings.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/terrain_base.hpp"
#include "ocean/internal/terrain_law.hpp"
#include "ocean/internal/terrain_modes.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

constexpr int kStateRingsPerOctave = 8;
constexpr double kRadians = kTwoPi / 360.0;
/// Shares of the land whose slope angles are stated.
constexpr std::array kSlopeShares = {0.5, 0.9, 0.99};

/// Sums over the modes of a ring.
struct RingSum {
    double count = 0.0;
    double log_k = 0.0;     // sum of log k
    double asked = 0.0;     // sum of the variances [m^2]
    double resolved = 0.0;  // sum of |h|^2 [m^2]
    double asked_slope = 0.0;
    double resolved_slope = 0.0;
};

/// Returns the rings of a tile, kStateRingsPerOctave to an octave of the wave index from 1 on.
std::vector<RingSum> ring_sums(const TerrainModel& terrain, const Modes& modes,
                               const TerrainScale& scale) {
    const int size = modes.lattice.resolution;
    const double dk = modes.lattice.wavenumber_step();
    const TerrainAmplitudes amplitude(TerrainLaw(terrain), dk, dk * size);
    const CascadeModes& tile = modes.cascades.front();
    double layers = 1.0;  // the energy of all tiles, relative to the first
    for (const TerrainLayer& layer : terrain.layers) layers += layer.gain * layer.gain;
    std::vector<RingSum> rings(
        static_cast<std::size_t>(
            std::ceil(kStateRingsPerOctave * std::log2(0.75 * static_cast<double>(size)))) +
        1);
    const int half = size / 2;
    for (int m = 1 - half; m < half; ++m) {
        for (int n = 1 - half; n < half; ++n) {
            if (n == 0 && m == 0) continue;
            const double index = std::hypot(n, m);
            RingSum& ring =
                rings[static_cast<std::size_t>(kStateRingsPerOctave * std::log2(index) + 1e-9)];
            const double a = scale.gain * dk * amplitude(n * dk, m * dk);
            const double energy =
                4.0 * std::norm(std::complex<double>(tile.h0[mode_index(n, m, size)]));
            const double k = index * dk;
            ring.count += 1.0;
            ring.log_k += std::log(k);
            ring.asked += layers * a * a;
            ring.resolved += energy;
            ring.asked_slope += layers * a * a * k * k;
            ring.resolved_slope += energy * k * k;
        }
    }
    return rings;
}

RingSum total(std::span<const RingSum> rings) {
    RingSum sum;
    for (const RingSum& ring : rings) {
        sum.asked += ring.asked;
        sum.resolved += ring.resolved;
        sum.asked_slope += ring.asked_slope;
        sum.resolved_slope += ring.resolved_slope;
    }
    return sum;
}

void scale_asked(std::span<RingSum> rings, double factor) {
    for (RingSum& ring : rings) {
        ring.asked *= factor;
        ring.asked_slope *= factor;
    }
}

/// Returns minus half the slope of log(energy / count) over log k, weighted by count.
double ring_exponent(std::span<const RingSum> rings) {
    double count = 0.0, waves = 0.0, mean_x = 0.0, mean_y = 0.0;
    const auto x = [](const RingSum& ring) { return ring.log_k / ring.count; };
    const auto y = [](const RingSum& ring) { return std::log(ring.resolved / ring.count); };
    for (const RingSum& ring : rings) {
        waves += ring.count;
        if (ring.resolved <= 0.0) return std::numeric_limits<double>::quiet_NaN();
        count += ring.count;
        mean_x += ring.count * x(ring);
        mean_y += ring.count * y(ring);
    }
    constexpr double kMinWaves = 100.0;
    if (waves < kMinWaves) return std::numeric_limits<double>::quiet_NaN();
    mean_x /= count;
    mean_y /= count;
    double xx = 0.0, xy = 0.0;
    for (const RingSum& ring : rings) {
        xx += ring.count * (x(ring) - mean_x) * (x(ring) - mean_x);
        xy += ring.count * (x(ring) - mean_x) * (y(ring) - mean_y);
    }
    return -0.5 * xy / xx;
}

std::vector<TerrainOctave> octaves_of(const TerrainModel& terrain, std::span<const RingSum> rings) {
    const TerrainLaw law(terrain);
    const int octaves = std::bit_width(static_cast<unsigned>(terrain.resolution)) - 2;
    std::vector<TerrainOctave> result;
    for (int octave = 0; octave < octaves; ++octave) {
        const auto part = rings.subspan(static_cast<std::size_t>(octave) * kStateRingsPerOctave,
                                        kStateRingsPerOctave);
        TerrainOctave row;
        row.longest_wave = terrain.patch_size / std::exp2(octave);
        for (const RingSum& ring : part) {
            row.rms.asked += ring.asked;
            row.rms.resolved += ring.resolved;
        }
        row.rms = {std::sqrt(row.rms.asked), std::sqrt(row.rms.resolved)};
        row.exponent = {law.exponent(kTwoPi / row.longest_wave * std::sqrt(2.0)),
                        ring_exponent(part)};
        result.push_back(row);
    }
    return result;
}

/// Returns the angle [degrees] that a share of a Gaussian surface does not exceed: its slope is
/// Rayleigh distributed with the mean square slope.
double slope_angle(double mean_square, double share) {
    return std::atan(std::sqrt(-mean_square * std::log1p(-share))) / kRadians;
}

void add_warnings(const TerrainModel& terrain, TerrainState& state) {
    const auto warn = [&](std::string text) { state.warnings.push_back(std::move(text)); };
    if (terrain.base_model != nullptr) {
        for (const std::string& note : terrain.base_model->model.notes) warn("base: " + note);
    }
    if (state.rms.resolved == 0.0) {
        return warn("the terrain is flat: no wave lies within its limits, or rms = 0");
    }
    if (terrain.rings != nullptr) {
        const MeasuredRings& rings = *terrain.rings;
        const double longest = kTwoPi / rings.wavenumber.front();
        const double shortest = kTwoPi / rings.wavenumber.back();
        if (state.longest_wave > 2.0 * longest) {
            warn("waves longer than " + fixed_text(longest, 0) +
                 " m were not measured: their density continues with the slope of the outermost "
                 "rings; longest_wavelength leaves them out");
        }
        if (state.shortest_wave < 0.5 * shortest) {
            warn("waves shorter than " + fixed_text(shortest, 1) +
                 " m were not measured: their density continues with the slope of the outermost "
                 "rings; shortest_wavelength leaves them out");
        }
    }
    if (!state.octaves.empty() && state.octaves.back().rms.asked > 0.25 * state.rms.asked) {
        warn(
            "more than a quarter of the rms height is in waves of two to four samples: the land "
            "will look like noise; a larger beta or more resolution is smoother");
    }
}

}  // namespace

TerrainState terrain_state(const TerrainModel& terrain, const Modes& modes,
                           const TerrainScale& scale, double offset) {
    std::vector<RingSum> rings = ring_sums(terrain, modes, scale);
    RingSum sum = total(rings);
    if (!terrain.has_measured_rms() && sum.asked > 0.0) {
        // The gain gives this tile its rms, and the law requests the same rms.
        scale_asked(rings, scale.rms * scale.rms / sum.asked);
        sum = total(rings);
    }
    TerrainState state;
    state.rms = {std::sqrt(sum.asked), std::sqrt(sum.resolved)};
    state.rms_slope = {std::sqrt(sum.asked_slope), std::sqrt(sum.resolved_slope)};
    for (const double share : kSlopeShares) {
        state.slope_angles.push_back(
            {slope_angle(sum.asked_slope, share), slope_angle(sum.resolved_slope, share)});
    }
    state.mean = offset;
    state.period = terrain.patch_size;
    state.size = {terrain.patch_size, terrain.patch_size};
    state.cell = terrain.patch_size / terrain.resolution;
    state.shortest_wave =
        std::max(terrain.shortest_wavelength, modes.lattice.shortest_wavelength());
    state.longest_wave = terrain.longest_wavelength > 0.0
                             ? std::min(terrain.longest_wavelength, terrain.patch_size)
                             : terrain.patch_size;
    state.octaves = octaves_of(terrain, rings);
    if (!terrain.is_placed()) state.repeat = find_repeat(modes);
    state.memory_bytes = Terrain::bytes(terrain) + maps_bytes(terrain.resolution, 3);
    add_warnings(terrain, state);
    return state;
}

void measure_shaped(const Surface& map, TerrainState& state) {
    const auto height = map.channel(Channel::height);
    const auto slope_x = map.channel(Channel::slope_x), slope_y = map.channel(Channel::slope_y);
    const auto count = static_cast<double>(height.size());
    double sum = 0.0, squares = 0.0, slope_squares = 0.0;
    std::vector<float> slopes;
    slopes.reserve(height.size());
    for (std::size_t i = 0; i < height.size(); ++i) {
        sum += static_cast<double>(height[i]);
        slopes.push_back(std::hypot(slope_x[i], slope_y[i]));
        slope_squares += static_cast<double>(slopes.back()) * static_cast<double>(slopes.back());
    }
    state.mean = sum / count;
    for (const float h : height) {
        const double difference = static_cast<double>(h) - state.mean;
        squares += difference * difference;
    }
    state.rms.resolved = std::sqrt(squares / count);
    state.rms_slope.resolved = std::sqrt(slope_squares / count);
    const auto [low, high] = std::ranges::minmax(height);
    state.lowest = static_cast<double>(low);
    state.highest = static_cast<double>(high);
    state.slope_angles.resize(kSlopeShares.size(), {std::nan(""), 0.0});
    for (std::size_t i = 0; i < kSlopeShares.size(); ++i) {
        const auto at = static_cast<std::ptrdiff_t>(kSlopeShares[i] * (count - 1.0));
        std::nth_element(slopes.begin(), slopes.begin() + at, slopes.end());
        state.slope_angles[i].resolved =
            std::atan(static_cast<double>(slopes[static_cast<std::size_t>(at)])) / kRadians;
    }
    state.measured_cell = map.domain().step(0);
    state.size = map.domain().size;
    state.period = map.domain().wraps ? map.domain().size[0] : 0.0;
}

namespace {

JsonObject pair_json(const AskedResolved& value) {
    return JsonObject()
        .add("asked", json_number_or_null(value.asked))
        .add("resolved", json_number_or_null(value.resolved));
}

}  // namespace

std::string terrain_state_json(const TerrainState& state) {
    JsonObject json(JsonLines{2});
    json.add("rms", pair_json(state.rms)).add("rms_slope", pair_json(state.rms_slope));
    JsonArray octaves;
    for (const TerrainOctave& octave : state.octaves) {
        octaves.add(JsonObject()
                        .add("longest_wave", octave.longest_wave)
                        .add("rms", pair_json(octave.rms))
                        .add("exponent", pair_json(octave.exponent)));
    }
    json.add("slope_angles", json_array(state.slope_angles, pair_json)).add("mean", state.mean);
    json.add("shortest_wave", state.shortest_wave).add("longest_wave", state.longest_wave);
    json.add("period", state.period).add("cell", state.cell);
    if (state.measured_cell > 0.0) json.add("measured_cell", state.measured_cell);
    json.add("octaves", octaves);
    const auto peak_json = [](const RepeatPeak& peak) {
        return JsonObject().add("correlation", peak.correlation).add("distance", peak.distance);
    };
    if (state.repeat) {
        json.add("repeat", JsonObject()
                               .add("height", peak_json(state.repeat->height))
                               .add("slope", peak_json(state.repeat->slope)));
    }
    if (state.lowest < state.highest) {
        json.add("size", json_array(state.size));
        json.add("lowest", state.lowest).add("highest", state.highest);
    }
    json.add("memory_bytes", state.memory_bytes);
    json.add("warnings", json_array(state.warnings));
    return json.text();
}

}  // namespace ocean
