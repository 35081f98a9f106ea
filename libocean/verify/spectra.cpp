// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectra and directions against closed forms and quadratures: no grid and no random draw.
#include <array>
#include <string>

#include "bench.hpp"
#include "literature.hpp"
#include "ocean/enum_words.hpp"
#include "ocean/internal/directional_spectrum.hpp"

namespace ocean::verify {
namespace {

constexpr const char* kEnergyBound = "the table of densities keeps the energy to 1e-5";

DirectionalSpectrum spectrum_of(const Parameters& parameters, Bench& bench) {
    return make_directional_spectrum(parameters, bench.pool);
}

SpectralMoments moments_of(const Parameters& parameters, Bench& bench) {
    return spectrum_of(parameters, bench).moments(parameters.water);
}

void height_row(Bench& bench, const std::string& id, const std::string& claim,
                const std::string& reference, const Parameters& parameters, double m0,
                Plot plot = {}) {
    const double expected = 4.0 * std::sqrt(m0);
    bench.add({.id = "spectra." + id,
               .claim = claim,
               .reference = reference,
               .method = "Hs = 4 sqrt(m0) of the spectrum, no grid",
               .unit = "m",
               .expected = expected,
               .measured = moments_of(parameters, bench).significant_wave_height(),
               .tolerance = 1e-5 * expected,
               .bound = kEnergyBound,
               .plot = std::move(plot)});
}

void period_row(Bench& bench, const std::string& id, const std::string& claim,
                const std::string& reference, const Parameters& parameters, double omega) {
    const double expected = 2.0 * kPi / omega;
    bench.add({.id = "spectra." + id,
               .claim = claim,
               .reference = reference,
               .method = "the frequency of the highest density, no grid",
               .unit = "s",
               .expected = expected,
               .measured = 2.0 * kPi / moments_of(parameters, bench).peak_omega,
               .tolerance = 1e-4 * expected,
               .bound = "1e-4 of the period"});
}

/// Returns |c1| of cos^2s of half the angle.
double mean_vector(double s) {
    return s / (s + 1.0);
}

/// Returns |c1| of a spreading, which D(theta) has at omega, for the wind sea `sea`.
double mean_vector_at(SpreadingKind kind, const Jonswap& sea, double omega) {
    const double x = omega / sea.peak();
    const double age = sea.peak() * sea.wind / kG;  // U over the speed of the peak's waves
    switch (kind) {
        case SpreadingKind::cosine_squared:
            return 8.0 / (3.0 * kPi);
        case SpreadingKind::mitsuyasu:
            return mean_vector(
                std::min(200.0, 11.5 * std::pow(age, -2.5) * std::pow(x, x <= 1.0 ? 5.0 : -2.5)));
        case SpreadingKind::hasselmann:
            return mean_vector(x <= 1.0 ? 6.97 * std::pow(x, 4.06)
                                        : 9.77 * std::pow(x, -2.33 - 1.45 * (age - 1.17)));
        case SpreadingKind::donelan_banner:
            break;
    }
    const double beta = x < 0.95 ? 2.61 * std::pow(x, 1.3)
                        : x < 1.6
                            ? 2.28 * std::pow(x, -1.3)
                            : std::pow(10.0, -0.4 + 0.8393 * std::exp(-0.567 * 2.0 * std::log(x)));
    const auto shape = [&](double t) { return std::pow(std::cosh(beta * t), -2.0); };
    const auto along = [&](double t) { return std::cos(t) * shape(t); };
    return integral(along, 0.0, kPi, 200) / integral(shape, 0.0, kPi, 200);
}

struct NamedSpreading {
    SpreadingKind kind;
    const char* reference;
};
constexpr std::array kSpreadings = {
    NamedSpreading{SpreadingKind::cosine_squared, "D = (2/pi) cos^2 theta"},
    NamedSpreading{SpreadingKind::mitsuyasu,
                   "[Mitsuyasu 1975]: cos^2s(theta/2), s = 11.5 (omega_p U/g)^-2.5 "
                   "(omega/omega_p)^(5, -2.5)"},
    NamedSpreading{SpreadingKind::hasselmann,
                   "[Hasselmann 1980]: cos^2s(theta/2), s = 6.97 x^4.06 up to the peak, 9.77 "
                   "x^(-2.33 - 1.45 (omega_p U/g - 1.17)) beyond, x = omega/omega_p"},
    NamedSpreading{SpreadingKind::donelan_banner,
                   "[Donelan 1985], [Banner 1990]: sech^2(beta theta)"}};

void spreading_rows(Bench& bench) {
    for (const auto& [kind, reference] : kSpreadings) {
        Parameters parameters = wind_sea(12.0, 150e3, 128, 400.0);
        parameters.waves.front().spreading = kind;
        parameters.waves.front().wind_direction = 30.0;
        const Jonswap sea{12.0, 150e3};
        const double vector = sea.moment([&](double omega) {
            return mean_vector_at(kind, sea, omega);
        }) / sea.moment([](double) { return 1.0; });
        const SpectralMoments moments = moments_of(parameters, bench);
        bench.add({.id = "spectra." + std::string(word_of(kind)) + "_spread",
                   .claim = "Directional spread of " + std::string(word_of(kind)),
                   .reference = std::string(reference) +
                                "; spread sqrt(2 (1 - |c1|)) [Kuik 1988], weighted by JONSWAP",
                   .method = "moments of the spectrum of 12 m/s over 150 km, no grid",
                   .unit = "degrees",
                   .expected = std::sqrt(2.0 * (1.0 - vector)) * 180.0 / kPi,
                   .measured = moments.directional_spread * 180.0 / kPi,
                   .tolerance = 0.01,
                   .bound = "0.01 degrees"});
        if (kind != SpreadingKind::hasselmann) continue;
        bench.add({.id = "spectra.mean_direction",
                   .claim = "Waves travel to wind_direction",
                   .reference = "the mean of exp(i theta) over the spectrum points to 30 degrees",
                   .method = "moments of the same spectrum, no grid",
                   .unit = "degrees",
                   .expected = 30.0,
                   .measured = moments.mean_direction * 180.0 / kPi,
                   .tolerance = 0.01,
                   .bound = "0.01 degrees"});
    }
}

}  // namespace

void verify_spectra(Bench& bench) {
    Parameters developed = wind_sea(12.0, 300e3, 128, 400.0);
    developed.waves.front().spectrum = SpectrumKind::pierson_moskowitz;
    const double wind = 1.026 * 12.0;  // at 19.5 m
    height_row(bench, "pierson_moskowitz_height", "Height of Pierson and Moskowitz",
               "[Pierson and Moskowitz 1964]: m0 = 8.1e-3 U^4/(4 0.74 g^2), U = 1.026 * 12 m/s",
               developed, 8.1e-3 * std::pow(wind, 4.0) / (4.0 * 0.74 * kG * kG));
    period_row(bench, "pierson_moskowitz_period", "Peak period of Pierson and Moskowitz",
               "[Pierson and Moskowitz 1964]: omega_p = (4 0.74/5)^(1/4) g/U", developed,
               std::pow(4.0 * 0.74 / 5.0, 0.25) * kG / wind);

    Parameters phillips = developed;
    phillips.waves.front().spectrum = SpectrumKind::phillips;
    height_row(bench, "phillips_height", "Height of Phillips",
               "[Phillips 1958], [Tessendorf 2001]: m0 = 8.1e-3 L^2/4, L = U^2/g, U = 12 m/s",
               phillips, 8.1e-3 / 4.0 * std::pow(144.0 / kG, 2.0));

    const auto all = [](double) { return 1.0; };
    Parameters narrow = wind_sea(17.0, 300e3, 128, 400.0);
    narrow.waves.front().peak_enhancement = 1.0;
    const Jonswap plain{17.0, 300e3, 1.0}, sea{17.0, 300e3};
    height_row(bench, "jonswap_height_closed", "Height of JONSWAP without peak enhancement",
               "[Hasselmann 1973]: m0 = alpha g^2/(5 omega_p^4), U = 17 m/s, F = 300 km", narrow,
               plain.alpha() * kG * kG / (5.0 * std::pow(plain.peak(), 4.0)));

    const Parameters jonswap = wind_sea(17.0, 300e3, 128, 400.0);
    const DirectionalSpectrum table = spectrum_of(jonswap, bench);
    Plot plot{.title = "JONSWAP, 17 m/s over 300 km",
              .x_label = "angular frequency [rad/s]",
              .y_label = "density [m^2 s/rad]"};
    double worst = 0.0;
    for (double x = 0.6; x < 3.0; x *= 1.01) {
        const double omega = x * sea.peak(), density = table.frequency_density(omega);
        plot.curve.push_back({omega, sea.density(omega)});
        if (plot.curve.size() % 4 == 0) plot.measured.push_back({omega, density});
        worst = std::max(worst, std::abs(density - sea.density(omega)));
    }
    height_row(bench, "jonswap_height", "Height of JONSWAP",
               "[Hasselmann 1973]: quadrature of S, gamma = 3.3, U = 17 m/s, F = 300 km", jonswap,
               sea.moment(all), std::move(plot));
    period_row(bench, "jonswap_period", "Peak period of JONSWAP",
               "[Hasselmann 1973]: omega_p = 7 pi (g/U) (g F/U^2)^-0.33", jonswap, sea.peak());
    bench.add(
        {.id = "spectra.jonswap_density",
         .claim = "Density of JONSWAP",
         .reference = "[Hasselmann 1973]: S(omega)",
         .method = "largest difference from 0.6 to 3 peak frequencies over the peak density",
         .measured = worst / sea.density(sea.peak()),
         .tolerance = 3e-4,
         .bound = "the table keeps densities to 1e-4, and its energy by a factor within 2e-4"});

    Parameters shallow = jonswap;
    shallow.waves.front().spectrum = SpectrumKind::tma;
    shallow.water.depth = 15.0;
    height_row(bench, "tma_height", "Height of TMA in 15 m of water",
               "[Bouws 1985]: JONSWAP times tanh^2 kd/(1 + 2 kd/sinh 2 kd), quadrature", shallow,
               sea.moment([](double omega) { return finite_depth_share(omega, 15.0); }));
    spreading_rows(bench);
}

}  // namespace ocean::verify
