// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A crest on cue, by the conditioning of a Gaussian sea on linear functionals c of its modes:
//   h0' = h0 + P sum_m lambda_m conj phi_m,   lambda = G^-1 (target - c),
// with P, phi and G of crest_rows.hpp. The mean over all seeds is the shape of a Gaussian process
// about a maximum, the Slepian model [Lindgren 1970], which the design of structures knows as
// NewWave [Tromans 1991]; what the rows leave open keeps its draw and its variance, at any depth
// and for any spectrum. Six rows make the crest: its height A; slopes and rise dh/dt of 0; and a
// displacement of 0, so that the point of that label is shown at its own place under any
// choppiness. The heights of crest_neighbours() around it take the six rows' mean shape, or a wave
// of the draw near it would be higher. Tests: Crests.IsTheHighestPointNear,
// Crests.SeedsHaveMeanAndVarianceOfTheory.
#include "ocean/internal/crests.hpp"

#include <complex>

#include "ocean/internal/modes.hpp"
#include "ocean/internal/second_order.hpp"
#include "waves/crests/crest_conditions.hpp"
#include "waves/modes/mode_lattice.hpp"

namespace ocean {

namespace {

void satisfy(const CrestConditions& conditions, const CrestWaves& waves, Modes& modes) {
    std::vector<double> miss = conditions.targets;
    for (std::size_t row = 0; row < miss.size(); ++row) miss[row] -= conditions.sums.now[row];
    const std::vector<double> lambda = DependentRows(conditions.sums.gram).solve(miss);
    std::vector<CrestFunctionals> functionals(kCrestShares, {conditions.rows, modes});
    waves.for_each([&](std::size_t share, const CrestWave& wave) {
        CrestFunctionals& phi = functionals[share];
        phi.set_wave(wave);
        std::complex<double> sum = 0.0;
        for (std::size_t row = 0; row < lambda.size(); ++row) {
            sum += lambda[row] * std::complex<double>(phi.real()[row], -phi.imaginary()[row]);
        }
        std::complex<float>& h0 = modes.cascades[wave.cascade].h0[wave.index];
        h0 = std::complex<float>(std::complex<double>(h0) + wave.variance * sum);
    });
}

/// Conditions the modes on the crests. A sea without crests keeps its bits.
void set_crests(const CrestSource& source, ThreadPool& pool, Modes& modes) {
    if (source.parameters.crests.empty()) return;
    const double limit = long_wave_limit(source);
    const CrestWaves longer(source, modes, CrestPart::long_waves, limit, pool);
    const CrestWaves shorter(source, modes, CrestPart::short_waves, limit, pool);
    satisfy(long_conditions(longer), longer, modes);
    satisfy(short_conditions(shorter), shorter, modes);
}

}  // namespace

std::vector<double> make_waves(const ModeLattice& lattice, const DirectionalSpectrum& spectrum,
                               const Parameters& parameters, ThreadPool& pool, Modes& modes) {
    const double wind = strongest_wind(parameters).value_or(0.0);
    std::vector<double> gains = lattice.set_waves(spectrum, wind, pool, modes);
    modes.binding_limit = binding_limit(spectrum, parameters);
    set_crests({spectrum, parameters, lattice, gains}, pool, modes);
    return gains;
}

Modes make_modes(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                 ThreadPool& pool) {
    const ModeLattice lattice(parameters, ModeLattice::Memory::none, pool);
    Modes modes = lattice.still_modes(pool);
    make_waves(lattice, spectrum, parameters, pool, modes);
    return modes;
}

}  // namespace ocean
