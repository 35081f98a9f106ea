// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Fetch-limited spectra beyond full development: JONSWAP's powers of the fetch grow without end,
// the sea does not. This file writes sentences for SeaState::warnings; the spectra stay as
// requested.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/spectrum.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/sea_state.hpp"
#include "waves/spectrum/wave_system_table.hpp"

namespace ocean {

namespace {

// The scatter of fully developed seas, m0 g^2/U^4 = (3.6 +- 0.9)e-3 and f_p U/g = 0.13 +- 0.02
// [Young 1999] section 5.3: waves within this scatter get no warning.
constexpr double kMaxHeight = 1.118;  // sqrt(1 + 0.9/3.6), of the fully developed height
constexpr double kMaxPeriod = 1.18;   // 0.13 / (0.13 - 0.02), of the fully developed period

bool grows_with_fetch(const WaveSystem& system) {
    return system.spectrum == SpectrumKind::jonswap || system.spectrum == SpectrumKind::tma;
}

/// Returns the fetch [m] at which JONSWAP with this wind and peak enhancement has the variance of
/// Pierson and Moskowitz in deep water. m0 is proportional to alpha omega_p^-4, which is chi^(4
/// 0.33 - 0.22) at one wind. A peak enhancement of 3.3 gives chi = 1.20e4, 1 gives 1.76e4.
double fetch_of_developed_height(const WaveSystem& system, double gravity) {
    WaveSystem deep = system;
    deep.spectrum = SpectrumKind::jonswap;
    WaveSystem developed = system;
    developed.spectrum = SpectrumKind::pierson_moskowitz;
    const Water water{.gravity = gravity};
    const double ratio = make_frequency_spectrum(developed, water, 0.0).m0 /
                         make_frequency_spectrum(deep, water, 0.0).m0;
    return system.fetch * std::pow(ratio, 1.0 / 1.1);
}

/// Returns the fetch [m] at which the peaks of JONSWAP and of Pierson and Moskowitz meet, where
/// 2 pi 3.5 chi^-0.33 = omega_p U/g: chi = 1.88e4.
double fetch_of_developed_period(const WaveSystem& system, double gravity) {
    const double wind = system.wind();
    const double scale = wind / gravity;
    const double power = kTwoPi * 3.5 / (pierson_moskowitz_peak(wind, gravity) * scale);
    return scale * wind * std::pow(power, 1.0 / 0.33);
}

NaturalScale scale_at_fetch(WaveSystem system, double fetch, const Parameters& parameters) {
    system.fetch = fetch;
    return natural_scale(system, parameters.water, highest_frequency(parameters));
}

/// Returns three significant figures, without an exponent from 0.0001 on.
std::string figures(double value) {
    if (value < 1000.0) return format_text("%.3g", value);
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
    return fixed_text(std::round(value / unit) * unit, 0);
}

/// Returns the warning of one wave system, if it has one.
std::optional<std::string> beyond_full_development(const Parameters& parameters,
                                                   std::size_t number) {
    const WaveSystem& system = parameters.waves[number];
    const bool height_is_given = system.significant_wave_height.has_value();
    if (!grows_with_fetch(system) || (height_is_given && system.peak_period)) return std::nullopt;
    const NaturalScale now = scale_at_fetch(system, system.fetch, parameters);
    if (!(now.height > 0.0)) return std::nullopt;
    const double gravity = parameters.water.gravity;
    const double fetch = height_is_given ? fetch_of_developed_period(system, gravity)
                                         : fetch_of_developed_height(system, gravity);
    const NaturalScale developed = scale_at_fetch(system, fetch, parameters);
    const bool is_beyond = height_is_given ? now.period > kMaxPeriod * developed.period
                                           : now.height > kMaxHeight * developed.height;
    if (!is_beyond) return std::nullopt;
    const std::string name = "waves." + std::to_string(number) + ".";
    const auto number_of = [&](const NaturalScale& scale) {
        return height_is_given ? figures(scale.period) + " s" : figures(scale.height) + " m";
    };
    return name + "fetch = " + fixed_text(system.fetch, 0) +
           " m is beyond full development: with a wind of " + figures(system.wind()) +
           " m/s it gives a " + (height_is_given ? "peak period" : "significant wave height") +
           " of " + number_of(now) + ", where a fully developed sea has " + number_of(developed) +
           " from a fetch of " + figures(fetch) + " m on; allow no more fetch or, for swell, set " +
           (height_is_given ? "" : name + "significant_wave_height and ") + name + "peak_period";
}

/// Returns true for a copy of a wave system. A sea has copies after its own systems while
/// spreadings glide.
bool is_copy(const std::vector<WaveSystem>& waves, std::size_t number) {
    const WaveSystem& system = waves[number];
    const auto is_original = [&](const WaveSystem& other) {
        return other.wind_speed == system.wind_speed && other.fetch == system.fetch &&
               other.energy_share < 1.0;
    };
    return system.energy_share < 1.0 &&
           std::any_of(waves.begin(), waves.begin() + static_cast<std::ptrdiff_t>(number),
                       is_original);
}

}  // namespace

std::vector<std::string> full_development_warnings(const Parameters& parameters) {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < parameters.waves.size(); ++i) {
        if (is_copy(parameters.waves, i)) continue;
        auto warning = beyond_full_development(parameters, i);
        if (warning) warnings.push_back(std::move(*warning));
    }
    return warnings;
}

}  // namespace ocean
