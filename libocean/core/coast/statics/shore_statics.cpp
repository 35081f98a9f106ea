// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See shore_statics.hpp. Packs the maps of delays and of energy for reading, and derives the
// influence of the bed from them.
#include "coast/statics/shore_statics.hpp"

#include <algorithm>
#include <cmath>

#include "coast/statics/energy_march.hpp"
#include "coast/statics/shore_blend.hpp"
#include "coast/statics/shore_delays.hpp"
#include "coast/statics/shore_land.hpp"
#include "field/grid_blur.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

/// Returns an angle within -pi .. pi.
float wrapped_angle(float angle) {
    return std::remainder(angle, static_cast<float>(kTwoPi));
}

/// Returns the slope of the bed, smoothed over 12 m, where waves may break: it fades from a depth
/// of 25 m on and is 0 from a depth of 40 m on.
std::vector<float> breaking_slope(const BedGrid& bed, ThreadPool& pool) {
    constexpr double kSmoothing = 12.0;  // [m]
    constexpr float kDeep = 25.0f;       // [m]
    constexpr float kFade = 15.0f;       // [m]
    BedGrid smooth = bed;
    GridPasses passes(pool, {}, kBlurPasses);
    blur(smooth.values, {bed.domain.samples[0], bed.domain.samples[1]}, kSmoothing / bed.cell(),
         passes);
    const int width = bed.domain.samples[0];
    const int height = bed.domain.samples[1];
    const auto between = [&](int i0, int j0, int i1, int j1) {
        const double steps = std::max(std::abs(i1 - i0), std::abs(j1 - j0));
        return static_cast<float>(
            (static_cast<double>(smooth.at(i1, j1)) - static_cast<double>(smooth.at(i0, j0))) /
            (steps * bed.cell()));
    };
    std::vector<float> slope(bed.values.size());
    pool.for_each_range(height, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            for (int i = 0; i < width; ++i) {
                const float x = between(std::max(i - 1, 0), j, std::min(i + 1, width - 1), j);
                const float y = between(i, std::max(j - 1, 0), i, std::min(j + 1, height - 1));
                const float depth = -smooth.at(i, j);
                slope[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(i)] =
                    std::sqrt(x * x + y * y) * shore_step(Plain((kDeep - depth) / kFade)).value();
            }
        }
    });
    return slope;
}

/// Returns the influence of the bed at each sample, from the largest phase difference to the open
/// sea among all pairs [rad].
std::vector<float> bed_influence_by_delays(const ShoreDelays& delays, std::size_t samples,
                                           ThreadPool& pool) {
    constexpr float kFully = 0.3f;  // [rad]
    std::vector<float> bed_influence(samples, 0.0f);
    pool.for_each_range(static_cast<int>(samples), [&](int first, int last) {
        for (std::size_t w = 0; w < delays.waves.size(); ++w) {
            const std::span<const Quad> quads = delays.waves[w].maps->quads();
            const auto k = static_cast<float>(delays.bands.centre(delays.bands.waves[w].band));
            for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last);
                 ++i) {
                const Quad at = quads[i];
                const float gained = std::abs(at[2]) + k * std::hypot(at[0], at[1]);
                bed_influence[i] =
                    std::max(bed_influence[i], shore_step(Plain(gained / kFully)).value());
            }
        }
    });
    return bed_influence;
}

QuadGrid packed(const Domain& domain, const DelayMaps& maps, double sector) {
    std::vector<float> turn(domain.count());
    for (std::size_t i = 0; i < turn.size(); ++i) {
        const float direction = std::atan2(maps.direction_y[i], maps.direction_x[i]);
        turn[i] = wrapped_angle(direction - static_cast<float>(sector));
    }
    return QuadGrid(domain, {maps.shift_x, maps.shift_y, maps.phase, turn});
}

/// Returns the pairs of a division, with the maps of the known pairs.
std::vector<BandSectorDelays> pairs_of(const ShoreBands& bands,
                                       std::span<const BandSectorDelays> known) {
    std::vector<BandSectorDelays> pairs;
    for (const ShoreWaves& waves : bands.waves) {
        const auto b = static_cast<std::size_t>(waves.band);
        BandSectorDelays pair{bands.edges[b], bands.edges[b + 1], waves.sector, nullptr};
        const auto same = std::ranges::find_if(known, [&](const BandSectorDelays& other) {
            return other.low == pair.low && other.high == pair.high && other.sector == pair.sector;
        });
        if (same != known.end()) pair.maps = same->maps;
        pairs.push_back(std::move(pair));
    }
    return pairs;
}

/// Computes the maps of the pairs that have none yet.
void add_missing(const BedGrid& bed, const BedGrid& depth, const Water& water, ThreadPool& pool,
                 const ShoreProgress& progress, ShoreDelays& delays) {
    ShoreBands missing{delays.bands.edges, {}};
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < delays.waves.size(); ++i) {
        if (delays.waves[i].maps) continue;
        missing.waves.push_back(delays.bands.waves[i]);
        at.push_back(i);
    }
    if (at.empty()) return;
    std::vector<DelayMaps> maps = shore_delays(depth, missing, water, pool, progress);
    const std::vector<std::uint32_t> nearest = nearest_water(bed, pool);
    pool.for_each_item(static_cast<int>(at.size()), [&](int item, int) {
        const auto i = static_cast<std::size_t>(item);
        BandSectorDelays& pair = delays.waves[at[i]];
        continue_onto_land(maps[i], bed, nearest);
        pair.maps = std::make_shared<const QuadGrid>(
            packed(bed.domain, maps[i], sector_centre(pair.sector)));
        maps[i] = {};
    });
}

}  // namespace

std::shared_ptr<const ShoreDelays> make_shore_delays(const BedGrid& bed, const ShoreBands& bands,
                                                     const Water& water, ThreadPool& pool,
                                                     const ShoreProgress& progress,
                                                     std::span<const BandSectorDelays> known) {
    auto delays = std::make_shared<ShoreDelays>();
    delays->bands = bands;
    delays->waves = pairs_of(bands, known);
    const BedGrid depth = felt_depth(bed, water.depth);
    add_missing(bed, depth, water, pool, progress, *delays);
    const std::vector<float> slope = breaking_slope(bed, pool);
    const std::vector<float> bed_influence =
        bed_influence_by_delays(*delays, bed.values.size(), pool);
    delays->ground = QuadGrid(bed.domain, {bed.values, depth.values, slope, bed_influence});
    return delays;
}

namespace {

/// Returns for each cell the mean amplitude of the shortest band's waves, at most 1. It stands for
/// the still shorter waves, which have no maps of their own. A swell has no waves in that band: its
/// few waves in no band arrive with the others.
std::vector<float> short_amplitude(const EnergyMaps& maps, const ShoreBands& bands) {
    std::vector<float> sum(maps.domain.count(), 0.0f);
    float variance = 0.0f;
    for (std::size_t w = 0; w < bands.waves.size(); ++w) {
        if (bands.waves[w].band != kShoreBands - 1) continue;
        const auto share = static_cast<float>(bands.waves[w].variance);
        variance += share;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            const float amplitude = maps.amplitude[w][i];
            sum[i] += share * amplitude * amplitude;
        }
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
        const float energy = variance > 0.0f ? sum[i] / variance : maps.arrival[i];
        sum[i] = std::min(std::sqrt(energy), 1.0f);
    }
    return sum;
}

/// Returns the influence of the bed for each cell, from the change of energy: 0 where all
/// amplitudes equal the open sea's, 1 where the energy of one is a tenth off.
std::vector<float> bed_influence_by_energy(const EnergyMaps& maps) {
    constexpr float kFully = 0.05f;
    // Rounding of the march is no influence of the bed.
    constexpr float kNothing = 1e-5f;
    std::vector<float> bed_influence(maps.domain.count(), 0.0f);
    for (const std::vector<float>& amplitude : maps.amplitude) {
        for (std::size_t i = 0; i < bed_influence.size(); ++i) {
            const float change = std::abs(amplitude[i] - 1.0f) - kNothing;
            bed_influence[i] =
                std::max(bed_influence[i], shore_step(Plain(change / kFully)).value());
        }
    }
    return bed_influence;
}

/// Returns for each cell the correlation of the coast's surface with the open sea's at the same
/// place, by the phases that the waves' middles have gained; at least 0.
std::vector<float> correlation(const EnergyMaps& maps, const ShoreDelays& delays) {
    const ShoreBands& bands = delays.bands;
    const Domain& domain = maps.domain;
    std::vector<float> result(domain.count());
    for (int j = 0; j < domain.samples[1]; ++j) {
        for (int i = 0; i < domain.samples[0]; ++i) {
            const std::size_t at =
                static_cast<std::size_t>(j) * static_cast<std::size_t>(domain.samples[0]) +
                static_cast<std::size_t>(i);
            const auto [x, y] = domain.place(i, j);
            double shared = 0.0;
            double open = 0.0;
            double arrived = 0.0;
            for (std::size_t w = 0; w < bands.waves.size(); ++w) {
                const ShoreWaves& waves = bands.waves[w];
                const double centre = sector_centre(waves.sector);
                const QuadSample delay = delays.waves[w].maps->read(x, y);
                const double gained = static_cast<double>(delay.value[2]) +
                                      bands.centre(waves.band) *
                                          (std::cos(centre) * static_cast<double>(delay.value[0]) +
                                           std::sin(centre) * static_cast<double>(delay.value[1]));
                const auto amplitude = static_cast<double>(maps.amplitude[w][at]);
                shared += waves.variance * amplitude * std::cos(gained);
                open += waves.variance;
                arrived += waves.variance * amplitude * amplitude;
            }
            const double norm = std::sqrt(open * arrived);
            result[at] = static_cast<float>(norm > 0.0 ? std::max(shared / norm, 0.0) : 0.0);
        }
    }
    return result;
}

}  // namespace

std::shared_ptr<const ShoreEnergy> make_shore_energy(const BedGrid& bed, const ShoreDelays& delays,
                                                     const DirectionalSpectrum& spectrum,
                                                     const Water& water, ThreadPool& pool,
                                                     const ShoreProgress& progress) {
    const ShoreBands& bands = delays.bands;
    EnergyMaps maps = march_energy(bed, bands, spectrum, water, {}, pool, progress);
    continue_onto_land(maps, bed, pool);
    const SpectralMoments moments = spectrum.moments(water);
    auto energy = std::make_shared<ShoreEnergy>();
    energy->open_height = moments.significant_wave_height();
    energy->peak_omega = moments.peak_omega;
    energy->depths = ShoreDepths(bands, moments.peak_omega, water);
    for (std::size_t first = 0; first < bands.waves.size(); first += 4) {
        std::array<std::span<const float>, 4> fields;
        for (std::size_t w = first; w < std::min(first + 4, bands.waves.size()); ++w) {
            fields[w - first] = maps.amplitude[w];
        }
        energy->amplitudes.emplace_back(maps.domain, fields);
    }
    energy->breaking = QuadGrid(
        maps.domain, {maps.rms_height, maps.breaking_share, maps.arrival, maps.group_width});
    energy->lee = make_lee_map(bed, maps, energy->breaking, border_margin(bed.domain));
    const std::vector<float> short_waves = short_amplitude(maps, bands);
    const std::vector<float> correlated = correlation(maps, delays);
    const std::vector<float> bed_influence = bed_influence_by_energy(maps);
    energy->remainder = QuadGrid(maps.domain, {short_waves, correlated, bed_influence});
    return energy;
}

Jet ShoreStatics::share_of_coast(double x, double y) const {
    const Jet share = share_inside(domain(), border_margin(domain()), x, y);
    if (share.value() >= 1.0f || energy->lee.is_empty()) return share;
    const Jet behind_land = energy->lee.at(x, y).inside;
    return behind_land.value() > share.value() ? behind_land : share;
}

std::uint64_t shore_statics_bytes(const Domain& bed, std::size_t waves) {
    // Kept memory: a quad for each of the waves and one for the ground, and two floats for lees.
    // Work space: five floats for each of the waves, and the solutions at the edges of bands and
    // sectors.
    constexpr std::uint64_t kKept = sizeof(Quad);
    constexpr std::uint64_t kLees = 2 * sizeof(float);
    constexpr std::uint64_t kWork = 5 * sizeof(float) + 3 * sizeof(double);
    return bed.count() * ((waves + 1) * kKept + kLees + waves * kWork + 8 * sizeof(float));
}

}  // namespace ocean
