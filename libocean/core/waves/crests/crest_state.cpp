// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How likely a sea makes its crests by itself, and what they do to the rest of the patch.
#include <cmath>
#include <string>

#include "ocean/internal/crests.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/text.hpp"
#include "waves/crests/crest_conditions.hpp"

namespace ocean {

// P(crest > A) = exp(-8 (A / Hs)^2), linear waves of one frequency [Longuet-Higgins 1952].
double rayleigh_exceedance(double height, double significant_wave_height) {
    return std::exp(-8.0 * std::pow(height / significant_wave_height, 2.0));
}

// P(crest > A) = exp(-(A / (alpha Hs))^beta) with steepness S1 = 2 pi Hs / (g Tm01^2) and Ursell
// number Ur = Hs / (k1^2 d^3), k1 the wavenumber of Tm01; the fit to second-order simulations of
// directional seas [Forristall 2000].
double forristall_exceedance(double height, double significant_wave_height, double mean_period,
                             const Water& water) {
    const double steepness =
        kTwoPi * significant_wave_height / (water.gravity * mean_period * mean_period);
    double ursell = 0.0;
    if (std::isfinite(water.depth)) {
        const double k = Dispersion(water).wavenumber(kTwoPi / mean_period);
        ursell = significant_wave_height / (k * k * std::pow(water.depth, 3.0));
    }
    const double alpha = 0.3536 + 0.2568 * steepness + 0.0800 * ursell;
    const double beta = 2.0 - 1.7912 * steepness - 0.5302 * ursell + 0.2840 * ursell * ursell;
    return std::exp(-std::pow(height / (alpha * significant_wave_height), beta));
}

namespace {

/// Sums over the long waves.
struct LongSums {
    double m0 = 0.0;     // [m^2]
    double m2 = 0.0;     // [m^2 rad^2/s^2]
    double added = 0.0;  // expected variance that the crests add to the patch [m^2]
};

/// The variance of a mode given the rows is P + |mean|^2 - P^2 phi* G^-1 phi, with the mean
/// P sum lambda conj phi.
LongSums sums_of(const CrestWaves& waves, const CrestConditions& conditions) {
    const DependentRows rows(conditions.sums.gram);
    const std::vector<double> lambda = rows.solve(conditions.targets);
    std::vector<LongSums> shares(kCrestShares);
    std::vector<CrestFunctionals> functionals(kCrestShares, {conditions.rows, waves.modes()});
    waves.for_each([&](std::size_t share, const CrestWave& wave) {
        CrestFunctionals& phi = functionals[share];
        phi.set_wave(wave);
        double real = 0.0;
        double imaginary = 0.0;
        for (std::size_t row = 0; row < lambda.size(); ++row) {
            real += lambda[row] * phi.real()[row];
            imaginary += lambda[row] * phi.imaginary()[row];
        }
        LongSums& sums = shares[share];
        sums.m0 += 2.0 * wave.variance;
        sums.m2 += 2.0 * wave.variance * wave.omega * wave.omega;
        sums.added += 2.0 * wave.variance * wave.variance *
                      (real * real + imaginary * imaginary - rows.form(phi.real()) -
                       rows.form(phi.imaginary()));
    });
    LongSums sums;
    for (const LongSums& share : shares) {
        sums.m0 += share.m0;
        sums.m2 += share.m2;
        sums.added += share.added;
    }
    return sums;
}

std::string percent(double share) {
    return fixed_text(100.0 * share, 1) + " %";
}

void add_warnings(double long_share, SeaState& state) {
    constexpr double kHigh = 1.25;          // [Hs]
    constexpr double kSteep = 0.4;          // of g
    constexpr double kMuchVariance = 1.05;  // of the patch
    constexpr double kMostEnergy = 0.95;    // in the long waves
    const auto warn = [&state](std::string text) { state.warnings.push_back(std::move(text)); };
    for (std::size_t i = 0; i < state.crests.size(); ++i) {
        const CrestSummary& crest = state.crests[i];
        const std::string name = "crests." + std::to_string(i) + ": ";
        if (std::abs(crest.relative_height) > kHigh) {
            const bool is_crest = crest.height > 0.0;
            warn(name + fixed_text(std::abs(crest.height), 2) + " m are " +
                 fixed_text(std::abs(crest.relative_height), 2) + " Hs: one " +
                 (is_crest ? "crest" : "trough") + " in " +
                 significant_text(is_crest ? crest.one_in_forristall : crest.one_in_rayleigh, 2) +
                 " is as high");
        }
        if (crest.steepness > kSteep) {
            warn(name + "the water falls with " + fixed_text(crest.steepness, 2) +
                 " g there; real waves break from about 0.4 g on");
        }
    }
    if (state.crest_variance > kMuchVariance) {
        warn("crests add " + percent(state.crest_variance - 1.0) +
             " to the variance of the whole patch, through which their waves pass again and "
             "again: make grid.patch_size larger");
    }
    if (long_share < kMostEnergy) {
        warn("crests are made of the waves of the first cascade, which hold " +
             percent(long_share) +
             " of the energy: more grid.resolution, or fewer cascades, make them the highest "
             "points for certain");
    }
}

}  // namespace

void add_crests(const CrestSource& source, const Modes& modes, ThreadPool& pool, SeaState& state) {
    const Parameters& parameters = source.parameters;
    const CrestWaves longer(source, modes, CrestPart::long_waves, long_wave_limit(source), pool);
    const LongSums sums = sums_of(longer, long_conditions(longer));
    const double hs = state.significant_wave_height.asked;
    for (const Crest& crest : parameters.crests) {
        const double height = crest.height.metres(hs);
        CrestSummary& summary = state.crests.emplace_back();
        summary = {crest.time, crest.x, crest.y, height, height / hs};
        summary.one_in_rayleigh = 1.0 / rayleigh_exceedance(std::abs(height), hs);
        if (height > 0.0) {
            summary.one_in_forristall =
                1.0 / forristall_exceedance(height, hs, state.mean_period.asked, parameters.water);
        }
        summary.steepness = std::abs(height) * sums.m2 / sums.m0 / parameters.water.gravity;
    }
    const double resolved = std::pow(state.significant_wave_height.resolved / 4.0, 2.0);
    state.crest_variance = 1.0 + sums.added / resolved;
    add_warnings(sums.m0 / resolved, state);
}

}  // namespace ocean
