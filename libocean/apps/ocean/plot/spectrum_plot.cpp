// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See plots.hpp.
#include "plots.hpp"

#include <algorithm>
#include <cmath>

#include "any_spectra.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/ocean.hpp"
#include "spectrum_panels.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

/// Returns the frequency below which this share of the energy lies, with a margin [Hz].
double frequency_below(const DirectionalSpectrum& spectrum, double share) {
    const std::span<const double> omega = spectrum.angular_frequencies();
    std::vector<double> energy(omega.size(), 0.0);
    for (std::size_t i = 1; i < omega.size(); ++i) {
        const double mean =
            0.5 * (spectrum.frequency_density(omega[i - 1]) + spectrum.frequency_density(omega[i]));
        energy[i] = energy[i - 1] + mean * (omega[i] - omega[i - 1]);
    }
    if (energy.empty() || !(energy.back() > 0.0)) return 1.0;
    const auto end = std::lower_bound(energy.begin(), energy.end(), share * energy.back());
    const double hertz = omega[static_cast<std::size_t>(end - energy.begin())] / kTwoPi;
    const double step = tick_step(1.1 * hertz, 10);
    return std::ceil(1.1 * hertz / step) * step;
}

/// Returns whole degrees in [0, 360).
int whole_degrees(double degrees) {
    return static_cast<int>(std::lround(std::fmod(degrees + 720.0, 360.0))) % 360;
}

std::string title_of(const Parameters& parameters, const std::string& name) {
    for (const WaveSystem& waves : parameters.waves) {
        if (!waves.measured) continue;
        return name + "  \u2013  " + origin_text(*waves.measured);
    }
    return name;
}

void draw_title(Figure& figure, const Picture& picture, const std::string& name) {
    const SeaState& state = picture.state;
    const Grid& grid = picture.parameters.grid;
    figure.text({82, 30}, title_of(picture.parameters, name), 17.0, kInk, Anchor::left, false,
                true);
    std::string line = "flat: there are no waves";
    if (state.significant_wave_height.asked > 0.0) {
        const double to = state.mean_direction.asked;
        line = format_text(
            "Hs %.2f m     Tp %.2f s     mean direction %d\u00b0 (nautical: from "
            "%d\u00b0)     grid %d \u00d7 %d, %g m",
            state.significant_wave_height.asked, state.peak_period.asked, whole_degrees(to),
            whole_degrees(270.0 - to), grid.resolution, grid.resolution, state.period);
    }
    figure.text({82, 54}, line, 13.5, kInk, Anchor::left);
}

/// Returns the variance density of the grid's modes, without random draws, in even steps over
/// [0, highest] [m^2/Hz].
std::vector<double> resolved_steps(const DirectionalSpectrum& spectrum,
                                   const Parameters& parameters, double highest, int steps,
                                   ThreadPool& pool) {
    const int n = parameters.grid.resolution;
    const std::vector<CascadeBand> bands = cascade_bands(parameters.grid);
    const Dispersion dispersion(parameters.water);
    const auto columns = static_cast<std::size_t>(steps);
    // Each row of modes has a histogram, so that the sum does not depend on the number of threads.
    std::vector<double> rows(static_cast<std::size_t>(n) * columns, 0.0);
    pool.for_each_range(n, [&](int first, int last) {
        for (int row = first; row < last; ++row) {
            const std::span histogram(rows.data() + static_cast<std::size_t>(row) * columns,
                                      columns);
            const int m = signed_wavenumber(row, n);
            if (m == -n / 2) continue;
            for (const CascadeBand& band : bands) {
                const double unit = kTwoPi * band.divisor / parameters.grid.patch_size;
                for (int nx = -n / 2 + 1; nx < n / 2; ++nx) {
                    if (nx == 0 && m == 0) continue;
                    const double f =
                        dispersion.angular_frequency(unit * std::hypot(nx, m)) / kTwoPi;
                    const auto step = static_cast<std::size_t>(f / highest * steps);
                    if (step >= columns) continue;
                    histogram[step] += modal_variance(spectrum, parameters, nx, m, band);
                }
            }
        }
    });
    std::vector<double> density(columns, 0.0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        density[i % columns] += rows[i] * steps / highest;
    }
    return density;
}

}  // namespace

std::string plot_spectrum(Ocean& ocean, const std::string& name, int threads) {
    constexpr int kSteps = 60;
    const DirectionalSpectrum& spectrum = ocean.spectrum();
    const double highest = frequency_below(spectrum, 0.985);
    ThreadPool pool(threads);
    const std::vector<double> steps =
        resolved_steps(spectrum, ocean.parameters(), highest, kSteps, pool);
    const SeaState state = ocean.state();
    const Picture picture{
        spectrum, ocean.parameters(), state, highest, steps, frequency_below(spectrum, 0.95)};

    Figure figure(1240.0, 600.0, 1.5);
    draw_title(figure, picture, name);
    draw_frequency_panel(figure, {82, 106, 620, 530}, picture);
    draw_direction_panel(figure, {{895, 310}, 196}, {1172, 396, 1186, 530}, picture);
    return figure.png();
}

}  // namespace ocean::app
