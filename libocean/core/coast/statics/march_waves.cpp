// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The waves of a march: see march_waves.hpp.
#include "march_waves.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "breaking.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean {
namespace {

constexpr int kSlices = 360;  // slices of the circle; their edges include the sectors'
constexpr double kWidestBin = 75.0 * kDegree;
constexpr double kWidestWave = 60.0 * kDegree;    // max angle of a wave to its march at the start
constexpr double kWidestSector = 60.0 * kDegree;  // max angle of a sector to its group's mean
constexpr int kDepths = 128;                      // 5 % apart
constexpr double kDeepWater = 9.0;                // k d: tanh is 1 to 3e-8
constexpr double kFeelsBottom = 1e-4;  // relative changes below count as 0, above three times
                                       // this value in full

using Slices = std::array<double, kSlices>;

/// Returns an angle within -pi .. pi [rad].
double wrapped(double angle) {
    return angle - kTwoPi * std::round(angle / kTwoPi);
}

/// Returns the middle of a slice [rad].
double slice_centre(int slice) {
    return (slice + 0.5) * kTwoPi / kSlices;
}

/// Returns the angular frequencies of a band at which the spectrum bends, and the band's ends.
std::vector<double> frequencies_of(const DirectionalSpectrum& spectrum, double lowest,
                                   double highest) {
    std::vector<double> result{lowest};
    for (const double omega : spectrum.angular_frequencies()) {
        if (omega > lowest && omega < highest) result.push_back(omega);
    }
    result.push_back(highest);
    return result;
}

/// Returns weights for the integral over frequencies, by the trapezoidal rule.
std::vector<double> trapezoid_weights(const std::vector<double>& frequencies) {
    std::vector<double> weights(frequencies.size(), 0.0);
    for (std::size_t i = 0; i + 1 < frequencies.size(); ++i) {
        const double half = 0.5 * (frequencies[i + 1] - frequencies[i]);
        weights[i] += half;
        weights[i + 1] += half;
    }
    return weights;
}

/// Returns the energy of a band by direction, to a factor that all slices share.
Slices directions_of(const DirectionalSpectrum& spectrum, const std::vector<double>& frequencies) {
    Slices result{};
    const std::vector<double> weights = trapezoid_weights(frequencies);
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        for (int s = 0; s < kSlices; ++s) {
            result[static_cast<std::size_t>(s)] +=
                weights[i] * spectrum.density(frequencies[i], slice_centre(s));
        }
    }
    return result;
}

/// Returns the part of a band that lies in one sector, scaled to a sum of `variance`. If the
/// spectrum has no waves in the sector, the whole variance lies at its centre.
Slices sector_of(const Slices& band, int sector, double variance) {
    Slices result{};
    const double centre = sector_centre(sector);
    double sum = 0.0;
    std::size_t middle = 0;
    double nearest = kTwoPi;
    for (std::size_t s = 0; s < kSlices; ++s) {
        const double off = std::abs(wrapped(slice_centre(static_cast<int>(s)) - centre));
        if (off < 0.5 * kSectorWidth) sum += result[s] = band[s];
        if (off < nearest) middle = s, nearest = off;
    }
    if (sum > 0.0) {
        for (double& share : result) share *= variance / sum;
    } else {
        result[middle] = variance;
    }
    return result;
}

/// The energy of one sector: its sum, and its mean direction as a vector times the sum.
struct SectorEnergy {
    int sector;
    double x = 0.0, y = 0.0;
};

/// Returns the direction of the sum of sectors first .. first + count - 1 in the circle [rad], or
/// nothing if the centre of one of them lies too far from that direction.
std::optional<double> direction_of(const std::vector<SectorEnergy>& sectors, std::size_t first,
                                   std::size_t count) {
    double x = 0.0, y = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const SectorEnergy& sector = sectors[(first + i) % sectors.size()];
        x += sector.x;
        y += sector.y;
    }
    const double direction = std::atan2(y, x);
    for (std::size_t i = 0; i < count; ++i) {
        const SectorEnergy& sector = sectors[(first + i) % sectors.size()];
        if (std::abs(wrapped(sector_centre(sector.sector) - direction)) > kWidestSector) {
            return std::nullopt;
        }
    }
    return direction;
}

struct Range {
    std::size_t first, count;
    double direction;
};

/// Returns the fewest ranges of neighbouring sectors that can march together. From each sector of
/// the circle in turn, the ranges are made as long as possible.
std::vector<Range> fewest_ranges(const std::vector<SectorEnergy>& sectors) {
    std::vector<Range> best;
    for (std::size_t start = 0; start < sectors.size(); ++start) {
        std::vector<Range> ranges;
        for (std::size_t done = 0; done < sectors.size();) {
            std::size_t count = sectors.size() - done;
            std::optional<double> direction = direction_of(sectors, start + done, count);
            while (!direction && count > 1) {
                direction = direction_of(sectors, start + done, --count);
            }
            const std::size_t first = (start + done) % sectors.size();
            ranges.push_back(
                {first, count, direction.value_or(sector_centre(sectors[first].sector))});
            done += count;
        }
        if (best.empty() || ranges.size() < best.size()) best = std::move(ranges);
    }
    return best;
}

/// Returns the shares of the bins of a march. Slices beyond kWidestWave count at that angle.
std::vector<float> bin_shares(const Slices& energy, double march_direction,
                              const DirectionBins& bins) {
    std::vector<double> sums(static_cast<std::size_t>(bins.count), 0.0);
    const double total = std::accumulate(energy.begin(), energy.end(), 0.0);
    const double most = std::floor(kWidestWave / bins.width + 1e-9) * bins.width;
    for (std::size_t s = 0; s < kSlices; ++s) {
        if (energy[s] == 0.0) continue;
        const double off = wrapped(slice_centre(static_cast<int>(s)) - march_direction);
        const double at = (std::clamp(off, -most, most) - bins.centre(0)) / bins.width;
        const auto below = static_cast<std::size_t>(at);
        const double above_share = at - std::floor(at);
        sums[below] += (1.0 - above_share) * energy[s] / total;
        if (above_share > 0.0) sums[below + 1] += above_share * energy[s] / total;
    }
    return {sums.begin(), sums.end()};
}

/// Returns a relative change, or exactly 0 for a change too small to matter, so that waves over
/// deep water equal the open sea's.
double change_by_bed(double change) {
    return change * breaking_step((std::abs(change) - kFeelsBottom) / (2.0 * kFeelsBottom));
}

/// Returns a band at the depths of `local`, the last of which is the open sea's.
BandDepths band_depths(const ShoreBands& bands, int b, const DirectionalSpectrum& spectrum,
                       const Dispersion& open, const std::vector<Dispersion>& local) {
    const auto edge = static_cast<std::size_t>(b);
    const std::vector<double> frequencies =
        frequencies_of(spectrum, open.angular_frequency(bands.edges[edge]),
                       open.angular_frequency(bands.edges[edge + 1]));
    std::vector<double> energies = trapezoid_weights(frequencies), fluxes;
    double variance = 0.0, flux = 0.0;
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        // A band without energy has the speeds of white noise.
        energies[i] *= std::max(spectrum.frequency_density(frequencies[i]), 1e-30);
        fluxes.push_back(energies[i] * open.group_velocity(open.wavenumber(frequencies[i])));
        variance += energies[i];
        flux += fluxes[i];
    }
    std::vector<double> log_speeds, shoaled;
    for (const Dispersion& dispersion : local) {
        double log_speed = 0.0, energy = 0.0;
        for (std::size_t i = 0; i < frequencies.size(); ++i) {
            const double k = dispersion.wavenumber(frequencies[i]);
            log_speed -= energies[i] / variance * std::log(k);
            energy += fluxes[i] / dispersion.group_velocity(k);
        }
        log_speeds.push_back(log_speed);
        shoaled.push_back(energy);
    }
    BandDepths result{.open_group_speed = flux / variance};
    for (std::size_t n = 0; n < local.size(); ++n) {
        result.log_speed.push_back(
            static_cast<float>(change_by_bed(log_speeds[n] - log_speeds.back())));
        result.shoaling.push_back(
            static_cast<float>(1.0 + change_by_bed(shoaled[n] / shoaled.back() - 1.0)));
    }
    return result;
}

/// Returns the directions from which a sea comes, by its energy over the slices.
std::vector<double> incoming_directions(const Slices& energy) {
    constexpr int kHalfWindow = 30;   // [slices]
    constexpr double kSystem = 0.05;  // min share of the energy in a window about a system
    constexpr double kAsHigh = 1.0 - 1e-9;
    const auto slice = [](int s) { return static_cast<std::size_t>((s + kSlices) % kSlices); };
    Slices windows{};
    for (int s = 0; s < kSlices; ++s) {
        for (int off = -kHalfWindow; off <= kHalfWindow; ++off) {
            windows[slice(s)] += energy[slice(s + off)];
        }
    }
    const double all = std::accumulate(energy.begin(), energy.end(), 0.0);
    std::vector<double> result;
    for (int s = 0; s < kSlices; ++s) {
        const double window = windows[slice(s)];
        if (!(window > kSystem * all)) continue;
        bool highest = true;
        for (int off = -kHalfWindow; off <= kHalfWindow && highest; ++off) {
            highest = window >= kAsHigh * windows[slice(s + off)];
        }
        for (int side = -2; side <= 2 && highest; ++side) {
            result.push_back(slice_centre(s) + 15.0 * kDegree * side);
        }
    }
    return result;
}

}  // namespace

DirectionBins DirectionBins::of_width(double width) {
    return {width, 2 * static_cast<int>(kWidestBin / width + 1e-9) + 1};
}

MarchSea make_march_sea(const ShoreBands& bands, const DirectionalSpectrum& spectrum,
                        const Water& water, const DirectionBins& bins) {
    const Dispersion dispersion(water);
    std::array<Slices, kShoreBands> by_band{};
    for (std::size_t b = 0; b < kShoreBands && !bands.waves.empty(); ++b) {
        by_band[b] = directions_of(
            spectrum, frequencies_of(spectrum, dispersion.angular_frequency(bands.edges[b]),
                                     dispersion.angular_frequency(bands.edges[b + 1])));
    }
    std::vector<Slices> by_wave;
    Slices energies{};
    std::vector<SectorEnergy> sectors;
    for (int sector = 0; sector < kShoreSectors; ++sector) {
        SectorEnergy energy{.sector = sector};
        bool present = false;
        for (std::size_t w = 0; w < bands.waves.size(); ++w) {
            const ShoreWaves& waves = bands.waves[w];
            if (waves.sector != sector) continue;
            by_wave.resize(bands.waves.size());
            by_wave[w] =
                sector_of(by_band[static_cast<std::size_t>(waves.band)], sector, waves.variance);
            for (int s = 0; s < kSlices; ++s) {
                const double e = by_wave[w][static_cast<std::size_t>(s)];
                energies[static_cast<std::size_t>(s)] += e;
                energy.x += e * std::cos(slice_centre(s));
                energy.y += e * std::sin(slice_centre(s));
            }
            present = true;
        }
        if (present) sectors.push_back(energy);
    }
    MarchSea sea;
    if (!sectors.empty()) sea.incoming = incoming_directions(energies);
    for (const Range& range : fewest_ranges(sectors)) {
        MarchGroup group{.direction = range.direction};
        for (std::size_t i = 0; i < range.count; ++i) {
            const int sector = sectors[(range.first + i) % sectors.size()].sector;
            for (std::size_t w = 0; w < bands.waves.size(); ++w) {
                const ShoreWaves& waves = bands.waves[w];
                if (waves.sector != sector) continue;
                group.members.push_back(w);
                group.waves.push_back(
                    {waves.band, waves.variance, bin_shares(by_wave[w], range.direction, bins)});
            }
        }
        sea.groups.push_back(std::move(group));
    }
    return sea;
}

MarchGroup without_sectors(const MarchGroup& group) {
    MarchGroup result{.direction = group.direction};
    for (int band = 0; band < kShoreBands; ++band) {
        MarchWave joined{.band = band};
        std::vector<double> energy;
        for (const MarchWave& wave : group.waves) {
            if (wave.band != band) continue;
            energy.resize(wave.bin_share.size(), 0.0);
            for (std::size_t n = 0; n < energy.size(); ++n) {
                energy[n] += wave.variance * double{wave.bin_share[n]};
            }
            joined.variance += wave.variance;
        }
        if (!(joined.variance > 0.0)) continue;
        for (const double e : energy) {
            joined.bin_share.push_back(static_cast<float>(e / joined.variance));
        }
        result.waves.push_back(std::move(joined));
    }
    return result;
}

DepthTables::DepthTables(const ShoreBands& bands, const DirectionalSpectrum& spectrum,
                         const Water& water, double min_depth)
    : least_(std::min(min_depth, 0.5 * water.depth)),
      greatest_(std::max(std::min(water.depth, kDeepWater / bands.edges[0]), 1.01 * least_)),
      per_log_((kDepths - 1) / std::log(greatest_ / least_)) {
    double highest = 0.0;
    for (const double omega : spectrum.angular_frequencies()) {
        const double density = spectrum.frequency_density(omega);
        if (density > highest) highest = density, peak_frequency_ = omega / kTwoPi;
    }
    const Dispersion open(water);
    std::vector<Dispersion> local;
    for (int n = 0; n < kDepths; ++n) {
        Water at_depth = water;
        at_depth.depth = n + 1 == kDepths ? greatest_ : least_ * std::exp(n / per_log_);
        local.emplace_back(at_depth);
    }
    for (int b = 0; b < kShoreBands; ++b) {
        bands_[static_cast<std::size_t>(b)] = band_depths(bands, b, spectrum, open, local);
    }
}

float DepthTables::position(double depth) const {
    if (depth >= greatest_) return kDepths - 1;
    if (depth <= least_) return 0.0f;
    return static_cast<float>(std::log(depth / least_) * per_log_);
}

}  // namespace ocean
