// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Frequency spectra against golden values and closed forms.
#include "ocean/internal/spectrum.hpp"

#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/grid.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

constexpr SpectrumKind kKinds[] = {SpectrumKind::phillips, SpectrumKind::pierson_moskowitz,
                                   SpectrumKind::jonswap, SpectrumKind::tma};

double significant_wave_height(const WaveSystem& system, const Water& water = {}) {
    Parameters parameters;
    parameters.water = water;
    parameters.waves = {system};
    return make_directional_spectrum(parameters).moments(water).significant_wave_height();
}

WaveSystem jonswap(double wind, double fetch, double gamma = 3.3) {
    WaveSystem system;
    system.spectrum = SpectrumKind::jonswap;
    system.wind_speed = wind;
    system.fetch = fetch;
    system.peak_enhancement = gamma;
    return system;
}

TEST(Spectrum, PiersonMoskowitzPeakIsThatOfTheWindAt19_5Metres) {
    // d ln S / d omega = 0: omega_p^4 = (4 * 0.74 / 5) (g / U19.5)^4.
    EXPECT_NEAR(pierson_moskowitz_peak(17.0 / kWind195, 9.81), 0.8772 * 9.81 / 17.0, 5e-5);
    const double peak = pierson_moskowitz_peak(10.0, 9.81);
    for (const double x : {0.99, 1.01}) {
        EXPECT_LT(pierson_moskowitz_density(x * peak, 10.0, 9.81),
                  pierson_moskowitz_density(peak, 10.0, 9.81));
    }
}

TEST(Spectrum, JonswapPeakIsNarrowerBelowThanAbove) {
    const double peak = jonswap_peak(17.0, 300e3, 9.81);
    const auto enhancement = [&](double omega) {
        return jonswap_density(omega, 17.0, 300e3, 3.3, 9.81) /
               jonswap_density(omega, 17.0, 300e3, 1.0, 9.81);
    };
    EXPECT_NEAR(enhancement(peak), 3.3, 1e-12);
    EXPECT_NEAR(enhancement(peak * 0.93), std::pow(3.3, std::exp(-0.5)), 1e-9);
    EXPECT_NEAR(enhancement(peak * 1.09), std::pow(3.3, std::exp(-0.5)), 1e-9);
}

TEST(Spectrum, JonswapLimits) {
    const double g = 9.81;
    const double peak = jonswap_peak(17.0, 300e3, g);
    const double alpha = 0.076 * std::pow(g * 300e3 / (17.0 * 17.0), -0.22);
    EXPECT_NEAR(make_frequency_spectrum(jonswap(17.0, 300e3, 1.0), Water{}, 300.0).m0 /
                    (alpha * g * g / (5.0 * std::pow(peak, 4.0))),
                1.0, 1e-5);
    const double fast = 50.0 * peak;
    EXPECT_NEAR(jonswap_density(fast, 17.0, 300e3, 3.3, g) / (alpha * g * g * std::pow(fast, -5.0)),
                1.0, 1e-6);
    EXPECT_EQ(jonswap_density(0.1 * peak, 17.0, 300e3, 3.3, g), 0.0);
    // Where its peak meets that of a fully developed sea: chi = 1.88e4.
    const double fetch = 1.877e4 * 100.0 / g;
    EXPECT_NEAR(jonswap_peak(10.0, fetch, g) / pierson_moskowitz_peak(10.0, g), 1.0, 1e-3);
}

TEST(Spectrum, FiniteDepthFactorIsTheExactOne) {
    const double golden[][2] = {{0.1, 0.0050}, {0.3, 0.0450}, {0.5, 0.1248},
                                {1.0, 0.4828}, {1.5, 0.8785}, {2.0, 0.9934}};
    for (const auto& [omega_h, factor] : golden) {
        const double depth = 20.0;
        EXPECT_NEAR(finite_depth_factor(omega_h * std::sqrt(9.81 / depth), depth, 9.81), factor,
                    5e-5)
            << omega_h;
    }
    EXPECT_EQ(finite_depth_factor(5.0, 1000.0, 9.81), 1.0);
}

TEST(Spectrum, TmaIsJonswapTimesTheDepthFactorAndEqualInDeepWater) {
    WaveSystem system = jonswap(17.0, 300e3);
    system.spectrum = SpectrumKind::tma;
    EXPECT_NEAR(significant_wave_height(system), 5.9386, 5e-5);
    const Water shallow{.depth = 15.0};
    const FrequencySpectrum spectrum = make_frequency_spectrum(system, shallow, 100.0);
    EXPECT_NEAR(spectrum.density(0.7) / (jonswap_density(0.7, 17.0, 300e3, 3.3, 9.81) *
                                         finite_depth_factor(0.7, 15.0, 9.81)),
                1.0, 1e-12);
    EXPECT_LT(significant_wave_height(system, shallow), 4.0);
}

TEST(Spectrum, VarianceIsTheIntegralOfTheDensityAndThePeakItsLargest) {
    for (const SpectrumKind kind : kKinds) {
        for (const double depth : {3.0, 30.0, std::numeric_limits<double>::infinity()}) {
            WaveSystem system = jonswap(17.0, 300e3, 10.0);
            system.spectrum = kind;
            system.cutoff_wavelength = 0.5;
            const FrequencySpectrum spectrum =
                make_frequency_spectrum(system, Water{.depth = depth}, 100.0);
            double sum = 0.0, largest = 0.0;
            constexpr int kSteps = 40000;  // the midpoint rule, blind to peaks and kinks
            const double step = std::log(spectrum.highest / spectrum.lowest) / kSteps;
            for (int i = 0; i < kSteps; ++i) {
                const double omega = spectrum.lowest * std::exp(step * (i + 0.5));
                sum += spectrum.density(omega) * omega * step;
                largest = std::max(largest, spectrum.density(omega));
            }
            EXPECT_NEAR(spectrum.m0 / sum, 1.0, 1e-7) << depth;
            EXPECT_GE(spectrum.density(spectrum.peak), largest * (1.0 - 1e-12)) << depth;
        }
    }
}

TEST(Spectrum, PhillipsCutoffIsTheWavelengthOfOneEthOfTheEnergy) {
    const double k = kTwoPi / 0.7;
    EXPECT_NEAR(phillips_wavenumber_density(k, 12.0, 1.0, 0.7, 9.81) /
                    phillips_wavenumber_density(k, 12.0, 1.0, 0.0, 9.81),
                std::exp(-1.0), 1e-12);
}

TEST(Spectrum, HeightAndPeriodRescaleAsAsked) {
    for (const SpectrumKind kind : kKinds) {
        Parameters parameters;
        parameters.water.depth = 30.0;
        WaveSystem& system = parameters.waves.front();
        system.spectrum = kind;
        system.significant_wave_height = 3.5;
        system.peak_period = 9.0;
        const SpectralMoments moments =
            make_directional_spectrum(parameters).moments(parameters.water);
        EXPECT_NEAR(moments.significant_wave_height(), 3.5, 3.5e-5);
        EXPECT_NEAR(kTwoPi / moments.peak_omega, 9.0, 0.01);
    }
}

TEST(Spectrum, ThePeriodAloneKeepsTheEnergy) {
    WaveSystem system = jonswap(17.0, 300e3);
    system.peak_period = 14.0;
    EXPECT_NEAR(significant_wave_height(system), 5.9386, 1e-4);
}

TEST(Spectrum, OfHardlyAnyWindIsFlatAndThereAtOnce) {
    for (const SpectrumKind kind : kKinds) {
        WaveSystem system;
        system.spectrum = kind;
        for (const double wind : {5e-324, 1e-60, 9e-7}) {
            system.wind_speed = wind;
            EXPECT_EQ(make_frequency_spectrum(system, {}, 10.0).m0, 0.0);
        }
        system.wind_speed = 1e-6;
        const double height = 4.0 * std::sqrt(make_frequency_spectrum(system, {}, 10.0).m0);
        EXPECT_GE(height, 0.0);
        EXPECT_LT(height, 2e-6);
    }
}

}  // namespace
}  // namespace ocean
