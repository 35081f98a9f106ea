// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of `ocean info`: integrals of the spectrum beside sums over the grid's modes.
#include "ocean/sea_state.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <complex>
#include <span>

#include "modes/mode_lattice.hpp"
#include "modes/quadrant_sampler.hpp"
#include "ocean/cascades.hpp"
#include "ocean/dispersion.hpp"
#include "ocean/error.hpp"
#include "ocean/foam.hpp"
#include "ocean/platform.hpp"
#include "ocean/spreading.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

namespace {

/// [p]: mean square slope of the modes that a map of 2^p samples holds and one of half as many
/// does not.
using SlopeByMap = std::array<double, 32>;

/// Of the mode with that larger wavenumber, in steps of the map's own lattice: the smallest p.
std::size_t smallest_map(int wavenumber) {
    return static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(wavenumber))) + 1;
}

/// Sums over one row of modes, or over all of a cascade.
struct ModeSums {
    double m0 = 0.0;
    double measured = 0.0;  // of m0, what measures the band
    double mean_square_slope = 0.0;
    SlopeByMap slope_by_map{};
    std::complex<double> direction = 0.0;
    double loop_error = 0.0;  // variance times the square of the speed's error
    double shortest = 0.0;
    double longest = 0.0;
    std::vector<double> ring;        // variance by whole |k| / dk of the cascade's lattice
    std::vector<double> ring_omega;  // variance times omega
};

/// A wave keeps its length and makes whole turns: its speed changes as its frequency does.
double speed_error(double omega, double loop_period) {
    if (loop_period <= 0.0) return 0.0;
    return turns_per_loop(omega, loop_period) / (omega * loop_period / kTwoPi) - 1.0;
}

/// What the modes of a sea are asked for.
struct StateSource {
    const Parameters& parameters;
    const ModeLattice& lattice;
    const QuadrantSampler& spectrum;
};

/// The modes (+-n, m) and (+-n, -m) of a cascade.
ModeSums sum_row(const StateSource& source, std::size_t cascade, const CascadeBand& band, int m) {
    const Parameters& parameters = source.parameters;
    const int half = parameters.grid.resolution / 2;
    const double period = parameters.grid.patch_size / band.divisor;
    const Dispersion dispersion(parameters.water);
    QuadrantVariances variances;
    source.lattice.variances(source.spectrum, cascade, m, variances);
    ModeSums sums;
    sums.ring.resize(static_cast<std::size_t>(half));
    sums.ring_omega.resize(sums.ring.size());
    for (int n = 0; n < half; ++n) {
        const auto at = [&](int quarter) {
            return variances.quarter[quarter][static_cast<std::size_t>(n)];
        };
        const double variance = variances.sum(static_cast<std::size_t>(n));
        if (variance <= 0.0) continue;
        const double length = std::hypot(n, m);
        const double k = kTwoPi / period * length;
        const double omega = dispersion.angular_frequency(k);
        const double off = speed_error(omega, parameters.time.loop_period);
        sums.m0 += variance;
        if (measures_band(band, parameters.grid.resolution, n, m)) sums.measured += variance;
        sums.mean_square_slope += k * k * variance;
        sums.slope_by_map[smallest_map(std::max(n, m) * band.divisor)] += k * k * variance;
        sums.loop_error += off * off * variance;
        sums.direction += std::complex<double>(n * (at(0) - at(1) - at(2) + at(3)),
                                               m * (at(0) + at(1) - at(2) - at(3))) /
                          length;
        const double wavelength = period / length;
        sums.shortest = sums.shortest > 0.0 ? std::min(sums.shortest, wavelength) : wavelength;
        sums.longest = std::max(sums.longest, wavelength);
        const auto ring = static_cast<std::size_t>(std::lround(length));
        if (ring >= sums.ring.size()) continue;
        sums.ring[ring] += variance;
        sums.ring_omega[ring] += variance * omega;
    }
    return sums;
}

void add(ModeSums& total, const ModeSums& row) {
    total.m0 += row.m0;
    total.measured += row.measured;
    total.mean_square_slope += row.mean_square_slope;
    for (std::size_t p = 0; p < row.slope_by_map.size(); ++p) {
        total.slope_by_map[p] += row.slope_by_map[p];
    }
    total.direction += row.direction;
    total.loop_error += row.loop_error;
    total.longest = std::max(total.longest, row.longest);
    if (row.shortest > 0.0) {
        total.shortest =
            total.shortest > 0.0 ? std::min(total.shortest, row.shortest) : row.shortest;
    }
    total.ring.resize(row.ring.size());
    total.ring_omega.resize(row.ring.size());
    for (std::size_t i = 0; i < row.ring.size(); ++i) {
        total.ring[i] += row.ring[i];
        total.ring_omega[i] += row.ring_omega[i];
    }
}

/// Rows in parallel, a batch at a time to bound the memory, added in order: the same bits for any
/// number of threads.
ModeSums sum_modes(const StateSource& source, const DirectionalSpectrum& spectrum,
                   std::size_t cascade, const CascadeBand& band, ThreadPool& pool) {
    constexpr int kBatch = 64;
    const int half = source.parameters.grid.resolution / 2;
    ModeSums sums;
    for (int begin = 0; begin < half; begin += kBatch) {
        std::vector<ModeSums> rows(static_cast<std::size_t>(std::min(kBatch, half - begin)));
        pool.for_each_range(static_cast<int>(rows.size()), [&](int first, int last) {
            for (int row = first; row < last; ++row) {
                rows[static_cast<std::size_t>(row)] = sum_row(source, cascade, band, begin + row);
            }
        });
        for (const ModeSums& row : rows) add(sums, row);
    }
    const double gain = band_gain(spectrum, source.parameters, band, sums.measured);
    for (double* sum : {&sums.m0, &sums.mean_square_slope, &sums.loop_error}) *sum *= gain;
    sums.direction *= gain;
    for (double& slope : sums.slope_by_map) slope *= gain;
    for (double& variance : sums.ring) variance *= gain;
    for (double& moment : sums.ring_omega) moment *= gain;
    return sums;
}

/// Frequency of the ring with the largest density over omega; 0 for a flat sea.
double peak_of_rings(std::span<const ModeSums> cascades, std::span<const CascadeBand> bands,
                     const Parameters& parameters) {
    const Dispersion dispersion(parameters.water);
    double largest = 0.0;
    double peak = 0.0;
    for (std::size_t c = 0; c < bands.size(); ++c) {
        const ModeSums& sums = cascades[c];
        const double step = kTwoPi * bands[c].divisor / parameters.grid.patch_size;
        for (std::size_t i = 1; i < sums.ring.size(); ++i) {
            const double k = step * static_cast<double>(i);
            const double density = sums.ring[i] / (dispersion.group_velocity(k) * step);
            if (density <= largest) continue;
            largest = density;
            peak = sums.ring_omega[i] / sums.ring[i];
        }
    }
    return peak;
}

/// The waves of a cascade repeat at its own period, and at that of another whose divisor divides
/// its own.
std::vector<CascadeShare> cascade_shares(std::span<const ModeSums> cascades,
                                         std::span<const CascadeBand> bands, const ModeSums& total,
                                         double patch_size) {
    std::vector<CascadeShare> shares;
    for (std::size_t c = 0; c < bands.size(); ++c) {
        CascadeShare& share = shares.emplace_back();
        share.period = patch_size / bands[c].divisor;
        share.shortest_wave = cascades[c].shortest;
        share.longest_wave = cascades[c].longest;
        if (total.m0 <= 0.0) continue;
        for (std::size_t other = c; other < bands.size(); ++other) {
            if (bands[other].divisor % bands[c].divisor != 0) continue;
            share.height += cascades[other].m0 / total.m0;
            share.slope += cascades[other].mean_square_slope / total.mean_square_slope;
        }
    }
    return shares;
}

std::vector<MapSlope> map_slopes(const SlopeByMap& slope_by_map) {
    std::vector<MapSlope> slopes;
    double sum = 0.0;
    for (int p = 0; 1 << p <= kMaxResolution; ++p) {
        sum += slope_by_map[static_cast<std::size_t>(p)];
        slopes.push_back({1 << p, sum});
    }
    return slopes;
}

std::vector<LoopError> loop_errors(const Parameters& parameters, double longest, double shortest) {
    std::vector<LoopError> errors;
    if (parameters.time.loop_period <= 0.0) return errors;
    const Dispersion dispersion(parameters.water);
    for (double length = longest; length >= shortest; length *= 0.5) {
        const double omega = dispersion.angular_frequency(kTwoPi / length);
        errors.push_back({length, speed_error(omega, parameters.time.loop_period)});
    }
    return errors;
}

double degrees(double radians) {
    return radians * 180.0 / kPi;
}

std::string fixed(double value, int digits) {
    char buffer[64];
    const auto end =
        std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::fixed, digits);
    return {buffer, end.ptr};
}

void add_warnings(const Parameters& parameters, bool flat, SeaState& state) {
    const auto warn = [&state](std::string text) { state.warnings.push_back(std::move(text)); };
    if (flat) {
        warn("the sea is flat: no wave system has any energy (wind_speed = 0?)");
        return;
    }
    if (state.energy_resolved < 0.95) {
        warn("this grid holds " + fixed(100.0 * state.energy_resolved, 1) +
             " % of the energy asked for; its waves are " + fixed(state.shortest_wave, 2) + " to " +
             fixed(state.longest_wave, 0) + " m long, the peak of the spectrum is at " +
             fixed(state.peak_wavelength.asked, 1) +
             " m: change grid.patch_size or grid.resolution");
    }
    if (state.energy_resolved > 1.02) {
        warn("the spectrum is narrower than the grid's modes lie apart: heights are " +
             fixed(100.0 * state.energy_resolved, 1) +
             " % of the energy asked for; make grid.patch_size larger");
    }
    if (state.loop_error > 0.05) {
        warn("time.loop_period = " + fixed(parameters.time.loop_period, 1) + " s moves the waves " +
             fixed(100.0 * state.loop_error, 1) + " % off their speed; a longer loop does less");
    }
    for (std::size_t c = 1; c < state.cascades.size(); ++c) {
        const CascadeShare& share = state.cascades[c];
        if (std::max(share.height, share.slope) <= 0.5) continue;
        warn(fixed(100.0 * share.height, 0) + " % of the variance of the height and " +
             fixed(100.0 * share.slope, 0) + " % of that of the slope repeat every " +
             fixed(share.period, 1) +
             " m, not only at grid.patch_size: choose smaller grid.cascade_divisors, fewer "
             "cascades or more grid.resolution");
    }
    if (parameters.grid.patch_size < 3.0 * state.peak_wavelength.asked) {
        warn("fewer than three of the dominant waves (" + fixed(state.peak_wavelength.asked, 1) +
             " m) fit into grid.patch_size = " + fixed(parameters.grid.patch_size, 1) +
             " m: the repetition will show");
    }
}

}  // namespace

SeaState sea_state(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                   ThreadPool& pool) {
    const SurfaceSettings& surface = parameters.surface;
    const Dispersion dispersion(parameters.water);
    const Grid& grid = parameters.grid;
    const std::vector<CascadeBand> bands = cascade_bands(grid);

    std::vector<ModeSums> cascades;
    ModeSums sums;
    const ModeLattice lattice(parameters, ModeLattice::Memory::none, pool);
    const QuadrantSampler sampler(spectrum);
    for (std::size_t c = 0; c < bands.size(); ++c) {
        cascades.push_back(sum_modes({parameters, lattice, sampler}, spectrum, c, bands[c], pool));
        add(sums, cascades.back());
    }
    const SpectralMoments asked =
        spectrum.moments(parameters.water, surface.shortest_wavelength, surface.longest_wavelength);

    const auto period = [](double omega) { return omega > 0.0 ? kTwoPi / omega : 0.0; };
    const auto wavelength = [&](double omega) {
        return omega > 0.0 ? kTwoPi / dispersion.wavenumber(omega) : 0.0;
    };
    const double peak = peak_of_rings(cascades, bands, parameters);
    SeaState state;
    state.significant_wave_height = {asked.significant_wave_height(), 4.0 * std::sqrt(sums.m0)};
    state.peak_period = {period(asked.peak_omega), period(peak)};
    state.peak_wavelength = {wavelength(asked.peak_omega), wavelength(peak)};
    state.mean_square_slope = {asked.mean_square_slope, sums.mean_square_slope};
    state.map_slopes = map_slopes(sums.slope_by_map);
    state.mean_direction = {degrees(asked.mean_direction), degrees(std::arg(sums.direction))};
    state.directional_spread = {
        degrees(asked.directional_spread),
        sums.m0 > 0.0 ? degrees(circular_spread(std::abs(sums.direction) / sums.m0)) : 0.0};
    state.energy_resolved = asked.m0 > 0.0 ? sums.m0 / asked.m0 : 1.0;
    const auto corner = [](const Lattice& lattice) {
        return lattice.shortest_wavelength() / std::sqrt(2.0);
    };
    const Lattice finest{grid.resolution, grid.patch_size / bands.back().divisor};
    state.shortest_wave = sums.shortest > 0.0 ? sums.shortest : corner(finest);
    state.longest_wave = sums.longest > 0.0 ? sums.longest : grid.patch_size;
    state.map_resolution = default_map_resolution(grid);
    const Lattice map{state.map_resolution, grid.patch_size};
    state.map_shortest_wave = std::max(state.shortest_wave, corner(map));
    state.cascades = cascade_shares(cascades, bands, sums, grid.patch_size);
    state.loop_errors = loop_errors(parameters, state.longest_wave, state.shortest_wave);
    state.loop_error = sums.m0 > 0.0 ? std::sqrt(sums.loop_error / sums.m0) : 0.0;
    state.period = grid.patch_size;
    state.memory_bytes =
        modes_bytes(grid) + surface_bytes(state.map_resolution, 12) + spectrum.table().size_bytes();
    const FoamClock clock = foam_clock(surface, parameters.time.loop_period);
    state.foam_preroll_seconds = static_cast<double>(preroll_ticks(
                                     clock, 0, [&](double) { return surface.foam_lifetime; })) *
                                 clock.step;
    add_warnings(parameters, asked.m0 <= 0.0, state);
    state.energy_resolved = std::min(state.energy_resolved, 1.0);  // midpoint sums may exceed it
    return state;
}

void add_whitecaps(const Modes& modes, const SurfaceSettings& settings, SeaState& state) {
    const GradientCovariance covariance = modes.gradient_covariance(state.map_resolution);
    state.foam_threshold = whitecap_threshold(covariance, settings, modes.wind_speed);
    state.whitecap_coverage = {
        monahan_coverage(modes.wind_speed),
        mean_whitecap(covariance, settings.choppiness, state.foam_threshold, settings.foam_width)};
}

std::string sea_state_json(const SeaState& state) {
    const auto number = [](double value) {
        char buffer[32];
        const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value);
        return std::string(buffer, end.ptr);
    };
    std::string result = "{\n";
    const auto pair = [&](const char* name, const AskedResolved& value) {
        result += "  \"" + std::string(name) + "\": {\"asked\": " + number(value.asked) +
                  ", \"resolved\": " + number(value.resolved) + "},\n";
    };
    const auto single = [&](const char* name, const std::string& value) {
        result += "  \"" + std::string(name) + "\": " + value + ",\n";
    };
    pair("significant_wave_height", state.significant_wave_height);
    pair("peak_period", state.peak_period);
    pair("peak_wavelength", state.peak_wavelength);
    pair("mean_square_slope", state.mean_square_slope);
    pair("mean_direction", state.mean_direction);
    pair("directional_spread", state.directional_spread);
    single("energy_resolved", number(state.energy_resolved));
    single("shortest_wave", number(state.shortest_wave));
    single("longest_wave", number(state.longest_wave));
    single("period", number(state.period));
    single("map_resolution", std::to_string(state.map_resolution));
    single("map_shortest_wave", number(state.map_shortest_wave));
    result += "  \"map_slopes\": [";
    for (const MapSlope& map : state.map_slopes) {
        result += (result.back() == '[' ? "" : ", ") +
                  ("{\"resolution\": " + std::to_string(map.resolution)) +
                  ", \"mean_square_slope\": " + number(map.mean_square_slope) + "}";
    }
    result += "],\n";
    result += "  \"cascades\": [";
    for (const CascadeShare& share : state.cascades) {
        result += (result.back() == '[' ? "" : ", ") + ("{\"period\": " + number(share.period)) +
                  ", \"shortest_wave\": " + number(share.shortest_wave) +
                  ", \"longest_wave\": " + number(share.longest_wave) +
                  ", \"height_share\": " + number(share.height) +
                  ", \"slope_share\": " + number(share.slope) + "}";
    }
    result += "],\n";
    single("memory_bytes", std::to_string(state.memory_bytes));
    single("foam_preroll_seconds", number(state.foam_preroll_seconds));
    pair("whitecap_coverage", state.whitecap_coverage);
    single("foam_threshold", number(state.foam_threshold));
    single("loop_error", number(state.loop_error));
    result += "  \"loop_errors\": [";
    for (const LoopError& error : state.loop_errors) {
        result += (result.back() == '[' ? "" : ", ") +
                  ("{\"wavelength\": " + number(error.wavelength)) +
                  ", \"speed_error\": " + number(error.speed_error) + "}";
    }
    result += "],\n  \"warnings\": [";
    for (const std::string& warning : state.warnings) {
        result += (result.back() == '[' ? "\"" : ", \"") + warning + "\"";
    }
    return result + "]\n}\n";
}

std::uint64_t modes_bytes(const Grid& grid) {
    const auto n = static_cast<std::uint64_t>(grid.resolution);
    return n * n * (sizeof(std::complex<float>) + 3 * sizeof(float)) *
           static_cast<std::uint64_t>(grid.cascades);
}

std::uint64_t surface_bytes(int resolution, int channels) {
    // The maps themselves, the linear planes they are made of, and the half spectra between the two
    // passes of the transform: at most eleven linear fields exist.
    const auto n = static_cast<std::uint64_t>(resolution);
    const auto maps = static_cast<std::uint64_t>(channels);
    const std::uint64_t linear = std::min<std::uint64_t>(maps + 5, 11);
    return n * n * sizeof(float) * (maps + 2 * linear);
}

void require_memory(std::uint64_t bytes, const std::string& what, const std::string& advice) {
    const std::uint64_t there = available_memory();
    if (bytes <= there) return;
    const auto mebibytes = [](std::uint64_t value) { return std::to_string(value >> 20) + " MiB"; };
    throw Error(ErrorKind::out_of_memory, what + " needs " + mebibytes(bytes) +
                                              " of memory, there are " + mebibytes(there) + "; " +
                                              advice);
}

}  // namespace ocean
