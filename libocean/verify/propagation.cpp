// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Speed and direction of waves, from the spectrum of maps in space and time.
//
// The coefficient of exp(i k x) in maps of a linear sea is c(t) = a e^(-i w t) + b e^(+i w t),
// where a travels along +k and b along -k. So c(t + s) + c(t - s) = 2 cos(w s) c(t), and c(t + s) -
// e^(i w s) c(t) = -2i sin(w s) a e^(-i w t).
#include <array>
#include <complex>
#include <limits>
#include <string>

#include "bench.hpp"
#include "literature.hpp"
#include "map_statistics.hpp"

namespace ocean::verify {
namespace {

using Complex = std::complex<double>;

Parameters wind_sea_towards(double direction) {
    Parameters parameters = wind_sea(10.0, 100e3, 128, 800.0);
    parameters.waves.front().wind_direction = direction;
    parameters.waves.front().spreading = SpreadingKind::cosine_squared;
    return parameters;
}

void direction_rows(Bench& bench) {
    SampleMean turn;
    double against = 0.0;
    for (int i = 0; i < 16; ++i) {
        Parameters parameters = wind_sea_towards(45.0 * i - 170.0);
        parameters.seed = static_cast<std::uint32_t>(i + 1);
        Ocean sea(parameters, bench.options());
        const Propagation found = measure_propagation(sea, 8, 0.4);
        const double wind = parameters.waves.front().direction_degrees();
        turn.add(std::remainder(found.direction - wind, 360.0));
        against = std::max(against, found.against_wind);
    }
    bench.add({.id = "propagation.direction",
               .claim = "Waves travel the way of the wind",
               .reference = "mean of exp(i theta) over the energy along +k, less wind_direction",
               .method = "mean of 16 seas with winds to 8 directions, 8 maps 0.4 s apart, N = 128, "
                         "L = 800 m",
               .unit = "degrees",
               .measured = turn.mean(),
               .tolerance = std::min(3.0 * turn.error(), 3.0),
               .bound = "3 standard errors, at most 3 degrees"});
    bench.add({.id = "propagation.against_wind",
               .claim = "No wave of cos^2 spreading travels against the wind",
               .reference = "D = 0 for |theta| > 90 degrees",
               .method =
                   "largest share of the energy of waves whose cell of the lattice lies beyond, in "
                   "the same maps",
               .measured = against,
               .tolerance = 1e-6,
               .bound = "1e-6 of the energy"});
}

/// Returns the frequency of a wave, in a loop that of a whole number of turns.
double frequency_of(double k, const Parameters& parameters) {
    const double omega = angular_frequency(k, parameters.water.depth);
    const double base = 2.0 * kPi / parameters.time.loop_period;
    if (!(parameters.time.loop_period > 0.0)) return omega;
    return base * std::max(1.0, std::round(omega / base));
}

}  // namespace

int samples_of_propagation(const Grid& grid) {
    return grid.cascades > 1 ? 2 * grid.resolution : grid.resolution;
}

Propagation measure_propagation(Ocean& sea, int frames, double step) {
    const Parameters& parameters = sea.parameters();
    const int n = samples_of_propagation(parameters.grid);
    const double dk = 2.0 * kPi / parameters.grid.patch_size;
    std::vector<std::vector<Complex>> maps;
    for (int t = 0; t < frames; ++t) {
        const Surface map = sea.evaluate(t * step, {Channel::height}, n);
        maps.push_back(coefficients(map.channel(Channel::height)));
    }
    const double wind = parameters.waves.front().direction_degrees() * kPi / 180.0;
    double highest = 0.0;
    for (const Complex& c : maps.front()) highest = std::max(highest, std::norm(c));
    Propagation found;
    Complex mean;
    double all = 0.0, against = 0.0, squares = 0.0, count = 0.0;
    for (std::size_t at = 1; at < maps.front().size(); ++at) {
        const double kx = dk * wave_index(at % static_cast<std::size_t>(n), n);
        const double ky = dk * wave_index(at / static_cast<std::size_t>(n), n);
        double even = 0.0, energy = 0.0;
        for (std::size_t t = 1; t + 1 < maps.size(); ++t) {
            even += std::real(std::conj(maps[t][at]) * (maps[t - 1][at] + maps[t + 1][at]));
            energy += std::norm(maps[t][at]);
        }
        if (energy < 1e-6 * highest * static_cast<double>(frames)) continue;
        const double k = std::hypot(kx, ky);
        const double omega = std::acos(std::clamp(0.5 * even / energy, -1.0, 1.0)) / step;
        const double theory = frequency_of(k, parameters);
        squares += std::pow(omega / theory - 1.0, 2.0);
        count += 1.0;
        if (ky == 0.0 && (found.omega.empty() || k > 1.06 * found.omega.back().x)) {
            found.omega.push_back({k, omega});
        }
        double along = 0.0;
        for (std::size_t t = 0; t + 1 < maps.size(); ++t) {
            along += std::norm(maps[t + 1][at] - std::polar(1.0, omega * step) * maps[t][at]);
        }
        along /= std::pow(std::sin(omega * step), 2.0);
        all += along;
        mean += along * Complex(kx, ky) / k;
        // The cell of a wave nearer to the border may reach over it.
        if (kx * std::cos(wind) + ky * std::sin(wind) < -std::sqrt(0.5) * dk) against += along;
    }
    found.error = std::sqrt(squares / count);
    found.direction = std::arg(mean) * 180.0 / kPi;
    found.against_wind = against / all;
    return found;
}

Row dispersion_row(Ocean& sea, double step, Row row) {
    const Parameters& parameters = sea.parameters();
    constexpr double kMaxSamples = 1 << 25;  // of all maps: half a GB
    const double samples = std::pow(samples_of_propagation(parameters.grid), 2.0);
    const int maps = static_cast<int>(std::clamp(kMaxSamples / samples, 6.0, 64.0));
    const Propagation found = measure_propagation(sea, maps, step);
    const bool loops = parameters.time.loop_period > 0.0;
    row.reference = std::string("[Lamb 1932]: omega^2 = (g k + (sigma/rho) k^3) tanh k d") +
                    (loops ? ", rounded to whole turns of the loop" : "");
    row.method = "rms over waves with 1e-6 of the highest energy of omega over theory, less 1; " +
                 std::to_string(maps) + " maps " +
                 std::to_string(static_cast<int>(std::lround(1000.0 * step))) + " ms apart" +
                 row.method;
    row.measured = found.error;
    row.tolerance = 1e-6;
    row.bound = "single precision of the weakest of these waves";
    row.plot = {.title = row.claim,
                .x_label = "wavenumber [rad/m]",
                .y_label = "angular frequency [rad/s]",
                .logarithmic = true,
                .measured = found.omega};
    double low = std::numeric_limits<double>::infinity(), high = 0.0;
    for (const Point& point : found.omega) {
        low = std::min(low, point.x);
        high = std::max(high, point.x);
    }
    for (double k = low; k <= high * 1.0001; k *= std::pow(high / low, 1.0 / 60.0)) {
        row.plot.curve.push_back({k, angular_frequency(k, parameters.water.depth)});
    }
    return row;
}

void verify_propagation(Bench& bench) {
    struct Case {
        const char *id, *claim, *method;
        double depth, wind, fetch, patch, step;
    };
    constexpr double kDeep = std::numeric_limits<double>::infinity();
    for (const Case& each : {Case{"deep", "Frequencies in deep water", ", N = 128, L = 400 m",
                                  kDeep, 10.0, 100e3, 400.0, 0.4},
                             Case{"depth_5_m", "Frequencies in 5 m of water",
                                  ", N = 128, L = 400 m", 5.0, 10.0, 100e3, 400.0, 0.4},
                             Case{"ripples", "Frequencies of ripples with surface tension",
                                  ", N = 128, L = 1 m", kDeep, 3.0, 1e3, 1.0, 0.02}}) {
        Parameters parameters = wind_sea(each.wind, each.fetch, 128, each.patch);
        parameters.water.depth = each.depth;
        Ocean sea(parameters, bench.options());
        bench.add(dispersion_row(sea, each.step,
                                 {.id = std::string("propagation.") + each.id,
                                  .claim = each.claim,
                                  .method = each.method}));
    }
    direction_rows(bench);
}

}  // namespace ocean::verify
