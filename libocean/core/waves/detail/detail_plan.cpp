// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The waves that a shown map lacks: their tiles, and their slopes; see detail_plan.hpp.
#include "waves/detail/detail_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/noise_streams.hpp"
#include "ocean/backend.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/modes/quadrant_sampler.hpp"

namespace ocean {
namespace {

static_assert(streams_of(NoiseStream::detail_bands) == kMaxDetailBands);

constexpr double kFactor = 6.0;        // from one band to the next
constexpr double kTwoBandsUpTo = 2.0;  // m
// With this many, the waves of a tile run in enough directions and are enough for a Gaussian field.
constexpr double kWavesOfTile = 8.3;
constexpr double kMinTile = 1.0;  // m

/// Returns half the side of the square of wavenumbers that a map holds, in steps of the patch's
/// lattice: along an axis it ends with the cells of the last modes of the cascade that contains its
/// Nyquist line.
double map_half_side(const Grid& grid, int resolution) {
    const std::vector<CascadeBand> bands = cascade_bands(grid);
    const auto last = std::find_if(bands.rbegin(), bands.rend(), [&](const CascadeBand& band) {
        return band.inner < resolution / 2;
    });
    const int half = half_of(grid.resolution, last->divisor, resolution);
    return std::max((half - 0.5) * last->divisor, last->inner);
}

/// Returns the modes along a side of a lattice that holds the ring.
int lattice_size(const CascadeBand& ring, int samples) {
    int size = kMinResolution;
    while (size < samples && size / 2 <= ring.outer) size *= 2;
    return size;
}

void require_settings(const DetailSettings& settings) {
    if (settings.resolution != 0) require_resolution(settings.resolution);
    if (is_power_of_two(settings.samples) && settings.samples >= kMinDetailSamples &&
        settings.samples <= kMaxDetailSamples) {
        return;
    }
    const std::string given = std::to_string(settings.samples);
    const std::string allowed = "a power of two, 256 .. 1024";
    throw Error(ErrorKind::invalid_value, "detail: samples = " + given + "; allowed: " + allowed,
                {.parameter = "samples", .value = given, .allowed = allowed});
}

}  // namespace

DetailPlan plan_detail(const Parameters& parameters, const DetailSettings& settings) {
    require_settings(settings);
    const Grid& grid = parameters.grid;
    const int resolution =
        settings.resolution != 0 ? settings.resolution : default_map_resolution(grid);
    const double map_ends = grid.patch_size / map_half_side(grid, resolution);
    const SurfaceSettings& limits = parameters.surface;
    const double end = std::max(kShortestDetail, limits.shortest_wavelength);
    double longest = map_ends;
    if (limits.longest_wavelength > 0.0) longest = std::min(longest, limits.longest_wavelength);

    DetailPlan plan{kTwoPi / map_ends, {}, longest};
    auto& [edge, bands, rest] = plan;
    const std::size_t most = longest <= kTwoBandsUpTo ? 2 : kMaxDetailBands;
    while (bands.size() < most && rest > end) {
        PlannedBand planned;
        planned.noise =
            noise_stream(NoiseStream::detail_bands, static_cast<std::uint32_t>(bands.size()));
        DetailBand& band = planned.band;
        band.longest_wave = rest;
        band.tile = std::max(kMinTile, kWavesOfTile * rest);
        // A last band less than twice as wide as the others stays whole.
        const bool last = bands.size() + 1 == most || rest <= 2.0 * kFactor * end;
        const double held = band.tile / (settings.samples / 2 - 1);
        band.shortest_wave = std::max(last ? end : rest / kFactor, held);
        planned.ring = {1, band.tile / rest, band.tile / band.shortest_wave, band.tile / map_ends};
        planned.parameters = parameters;
        planned.parameters.grid = {lattice_size(planned.ring, settings.samples), band.tile, 1, {}};
        rest = band.shortest_wave;
        bands.push_back(std::move(planned));
    }
    return plan;
}

std::vector<DetailBand> detail_bands(const Parameters& parameters, const DetailSettings& settings) {
    std::vector<DetailBand> bands;
    for (const PlannedBand& planned : plan_detail(parameters, settings).bands) {
        bands.push_back(planned.band);
    }
    return bands;
}

namespace {

/// Returns the integral of k^2 f(omega, k) over the frequencies of the wavenumbers low .. high
/// [rad/m], for an f that is linear between the rows of the table: three Gauss points in each gap.
template <typename Density>
double integral_of_slope(const DirectionalSpectrum& spectrum, const Dispersion& dispersion,
                         double low, double high, const Density& density) {
    constexpr double kNode[3] = {-0.7745966692414834, 0.0, 0.7745966692414834};
    constexpr double kWeight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    if (low >= high || spectrum.flat()) return 0.0;
    const double first = low > 0.0 ? dispersion.angular_frequency(low) : 0.0;
    const double last = dispersion.angular_frequency(high);
    const std::span<const double> rows = spectrum.angular_frequencies();
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        const double from = std::max(rows[i], first);
        const double to = std::min(rows[i + 1], last);
        if (from >= to) continue;
        for (int q = 0; q < 3; ++q) {
            const double omega = 0.5 * (from + to) + 0.5 * (to - from) * kNode[q];
            const double k = dispersion.wavenumber(omega);
            sum += kWeight[q] * (to - from) * k * k * density(omega, k);
        }
    }
    return sum;
}

/// Returns the integral over the directions in which a wavenumber lies outside the square, within
/// acos(edge/k) of an axis, with one point for each direction of the table, which is linear in
/// between.
double density_outside(const DirectionalSpectrum& spectrum, double omega, double edge_over_k) {
    const double reach = std::acos(std::min(edge_over_k, 1.0));
    const int points = std::max(8, static_cast<int>(reach / kPi * spectrum.directions()));
    const double width = 2.0 * reach / points;
    double sum = 0.0;
    for (int axis = 0; axis < 4; ++axis) {
        for (int i = 0; i < points; ++i) {
            const double theta = axis * 0.5 * kPi - reach + (i + 0.5) * width;
            sum += width * spectrum.density(omega, theta);
        }
    }
    return sum;
}

}  // namespace

double slopes_outside(const DirectionalSpectrum& spectrum, const Water& water, double map_edge,
                      double shortest, double longest) {
    const Dispersion dispersion(water);
    const double corner = std::numbers::sqrt2 * map_edge;
    const double low = std::max(kTwoPi / longest, map_edge);
    const double high = shortest > 0.0 ? kTwoPi / shortest
                        : spectrum.flat()
                            ? 0.0
                            : dispersion.wavenumber(spectrum.angular_frequencies().back());
    const double beside = integral_of_slope(
        spectrum, dispersion, low, std::min(corner, high),
        [&](double omega, double k) { return density_outside(spectrum, omega, map_edge / k); });
    const double beyond =
        integral_of_slope(spectrum, dispersion, std::max(low, corner), high,
                          [&](double omega, double) { return spectrum.frequency_density(omega); });
    return beside + beyond;
}

SlopeVariance slopes_of_modes(const ModeLattice& lattice, const DirectionalSpectrum& spectrum,
                              const Grid& grid, ThreadPool& pool) {
    const QuadrantSampler sampler(spectrum);
    const double step = kTwoPi / grid.patch_size;
    std::vector<SlopeVariance> rows(static_cast<std::size_t>(grid.resolution / 2));
    pool.for_each_range(grid.resolution / 2, [&](int first, int last) {
        QuadrantVariances variances;
        for (int m = first; m < last; ++m) {
            lattice.variances(sampler, 0, m, variances);
            const auto& v = variances.quarter;
            SlopeVariance& sum = rows[static_cast<std::size_t>(m)];
            for (std::size_t n = 0; n < v[0].size(); ++n) {
                const double kx = step * static_cast<double>(n);
                const double ky = step * m;
                const double all = variances.sum(n);
                sum.x += kx * kx * all;
                sum.y += ky * ky * all;
                sum.xy += kx * ky * (v[0][n] - v[1][n] + v[2][n] - v[3][n]);
            }
        }
    });
    // The sum runs in order, so that the bits are the same for any number of threads.
    SlopeVariance sum;
    for (const SlopeVariance& row : rows) {
        sum.x += row.x;
        sum.y += row.y;
        sum.xy += row.xy;
    }
    return sum;
}

}  // namespace ocean
