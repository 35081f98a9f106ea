// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "waves/crests/crest_waves.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ocean/internal/dispersion.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/modes/mode_lattice.hpp"
#include "waves/modes/quadrant_sampler.hpp"

namespace ocean {

double long_wave_limit(const CrestSource& source) {
    constexpr double kOfPeak = 12.0;
    constexpr double kEnergy = 0.99;
    const Water& water = source.parameters.water;
    const SurfaceSettings& limits = source.parameters.surface;
    const SpectralMoments moments =
        source.spectrum.moments(water, limits.shortest_wavelength, limits.longest_wavelength);
    if (moments.m0 <= 0.0) return 0.0;
    const double peak = kTwoPi / Dispersion(water).wavenumber(moments.peak_omega);
    // Energy of waves longer than a length decreases with the length.
    double length = peak / kOfPeak;
    for (int halvings = 0; halvings < 12; ++halvings) {
        if (length <= limits.shortest_wavelength) break;
        const double held = source.spectrum.variance(water, length, limits.longest_wavelength);
        if (held >= kEnergy * moments.m0) break;
        length /= std::sqrt(2.0);
    }
    return kTwoPi / length;
}

CrestWaves::CrestWaves(const CrestSource& source, const Modes& modes, CrestPart part, double limit,
                       ThreadPool& pool)
    : source_(source), modes_(modes), part_(part), limit_(limit), pool_(pool) {
    if (part == CrestPart::short_waves) return;
    std::vector<std::vector<CrestWave>> waves(kCrestShares);
    read([&](std::size_t share, const CrestWave& wave) { waves[share].push_back(wave); });
    kept_ = std::move(waves);
}

void CrestWaves::for_each(const Visit& visit) const {
    if (part_ == CrestPart::short_waves) return read(visit);
    pool_.for_each_item(kCrestShares, [&](int item, int) {
        const auto share = static_cast<std::size_t>(item);
        for (const CrestWave& wave : kept_[share]) visit(share, wave);
    });
}

namespace {

/// Returns true for the cascade whose waves carry crests: those of others repeat in the patch.
bool carries_crests(std::size_t cascade) {
    return cascade == 0;
}

}  // namespace

void CrestWaves::read(const Visit& visit) const {
    const QuadrantSampler sampler(source_.spectrum);
    const bool wants_long = part_ == CrestPart::long_waves;
    const auto visit_row = [&](int share, std::size_t c, int m, QuadrantVariances& row) {
        const CascadeModes& cascade = modes_.cascades[c];
        const double step = cascade.lattice.wavenumber_step();
        source_.lattice.variances(sampler, c, m, row);
        for (std::size_t quarter = 0; quarter < 4; ++quarter) {
            const int sign_x = quarter == 0 || quarter == 3 ? 1 : -1;
            const int sign_y = quarter < 2 ? 1 : -1;
            const std::vector<double>& variances = row.quarter[quarter];
            for (std::size_t n = 0; n < variances.size(); ++n) {
                if (!(variances[n] > 0.0)) continue;
                CrestWave wave{.kx = step * sign_x * static_cast<double>(n),
                               .ky = step * sign_y * m,
                               .variance = 0.5 * source_.gains[c] * variances[n],
                               .cascade = c};
                const bool is_long = carries_crests(c) && std::hypot(wave.kx, wave.ky) <= limit_;
                if (is_long != wants_long) continue;
                wave.index = mode_index(sign_x * static_cast<int>(n), sign_y * m,
                                        cascade.lattice.resolution);
                wave.rate_high = static_cast<double>(cascade.rate_high[wave.index]);
                wave.rate_low = static_cast<double>(cascade.rate_low[wave.index]);
                wave.omega = kTwoPi * modes_.rate_unit() * (wave.rate_high + wave.rate_low);
                wave.displacement = static_cast<double>(cascade.displacement[wave.index]);
                visit(static_cast<std::size_t>(share), wave);
            }
        }
    };
    pool_.for_each_item(kCrestShares, [&](int share, int) {
        QuadrantVariances row;
        for (std::size_t c = 0; c < modes_.cascades.size(); ++c) {
            if (wants_long && !carries_crests(c)) continue;
            const Lattice& lattice = modes_.cascades[c].lattice;
            double rows = lattice.resolution / 2;
            if (wants_long) rows = std::min(rows, limit_ / lattice.wavenumber_step() + 1.0);
            for (int m = share; m < rows; m += kCrestShares) visit_row(share, c, m, row);
        }
    });
}

}  // namespace ocean
