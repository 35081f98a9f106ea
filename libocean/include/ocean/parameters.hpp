// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Everything that defines a sea, as one plain value. Where a sea file, a panel, a knob or a take
// ends, and where the mathematics begins. Units, ranges, labels and help of each member stand once,
// in the table of parameter_table.hpp; the initialisers here are the defaults.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ocean/spectrum_record.hpp"

namespace ocean {

// The words that sea files choose from (enum_words.hpp).
enum class SpectrumKind { phillips, pierson_moskowitz, jonswap, tma, measured };
enum class SpreadingKind { cosine_squared, mitsuyasu, hasselmann, donelan_banner };
enum class Estimator { maximum_entropy, fourier };
enum class FoamCoverage { monahan, threshold };

struct Water {
    double depth = std::numeric_limits<double>::infinity();
    double gravity = 9.81;
    double surface_tension = 0.074;
    double density = 1000.0;

    /// s in omega^2 = (g k + s k^3) tanh(k d), m^3/s^2.
    double kinematic_tension() const { return surface_tension / density; }
    bool operator==(const Water&) const = default;
};

struct Grid {
    int resolution = 512;
    double patch_size = 500.0;
    int cascades = 1;
    std::vector<int> cascade_divisors;
    bool operator==(const Grid&) const = default;
};

struct SurfaceSettings {
    double choppiness = 1.0;
    double shortest_wavelength = 0.0;
    double longest_wavelength = 0.0;
    double foam_lifetime = 4.0;
    double foam_step = 0.05;
    int foam_resolution = 0;  // 0: grid.resolution
    FoamCoverage foam_coverage = FoamCoverage::monahan;
    double foam_threshold = 0.75;
    double foam_width = 0.2;
    bool operator==(const SurfaceSettings&) const = default;
};

struct Timing {
    double start = 0.0;
    int first_frame = 1;
    double fps = 24.0;
    double loop_period = 0.0;
    double glide = 0.5;
    std::string take;
    bool operator==(const Timing&) const = default;
};

inline constexpr double kDefaultWind = 10.0;  // m/s

/// One source of waves. Their energies add.
struct WaveSystem {
    SpectrumKind spectrum = SpectrumKind::phillips;
    /// Unset means 10 m/s for waves that a wind makes, and no wind that is known of over others.
    std::optional<double> wind_speed;
    /// Unset means 0 for a parametric spectrum and "as measured" for one with directions.
    std::optional<double> wind_direction;
    double fetch = 300000.0;
    double peak_enhancement = 3.3;
    SpreadingKind spreading = SpreadingKind::cosine_squared;
    double swell = 0.0;
    double opposing = 1.0;
    std::optional<double> significant_wave_height;
    std::optional<double> peak_period;
    double amplitude = 1.0;
    int alignment = 2;
    double cutoff_wavelength = 0.0;
    std::string file;
    std::string record;
    std::string place;
    Estimator estimator = Estimator::maximum_entropy;

    /// Of the energy that all of the above give this system. 1 but in the copies that Sea::at makes
    /// while a take glides between spreadings; not in the table.
    double energy_share = 1.0;

    /// Of wind_speed, what makes whitecaps. 1 but while a take brings a wind over waves that none
    /// was given for; not in the table.
    double wind_onset = 1.0;

    /// The chosen record of `file`, resolved by ocean::seafile. Shared, never changed.
    std::shared_ptr<const SpectrumRecord> measured;

    double direction_degrees() const { return wind_direction.value_or(0.0); }

    /// Height, period or both come from the wind: not measured, not given both.
    bool is_wind_sea() const {
        return spectrum != SpectrumKind::measured && !(significant_wave_height && peak_period);
    }
    /// What spectrum and spreading are made with, m/s.
    double wind() const { return wind_speed.value_or(kDefaultWind); }
    /// The wind over these waves, m/s; unset where nothing says how it blows.
    std::optional<double> wind_above() const {
        if (wind_speed) return wind_onset * *wind_speed;
        return is_wind_sea() ? std::optional(kDefaultWind) : std::nullopt;
    }
};

/// Of all times, s from 0, before and after: 31 years. A double still tells a tenth of a
/// microsecond there.
inline constexpr double kLatestTime = 1e9;
/// Throws Error invalid_value for a later one, and for what is no number.
void require_time(double time);

struct Parameters {
    Water water;
    Grid grid;
    SurfaceSettings surface;
    Timing time;
    std::uint32_t seed = 1;
    std::vector<WaveSystem> waves = {WaveSystem{}};  // 1 .. kMaxWaveSystems
};
inline constexpr std::size_t kMaxWaveSystems = 16;

}  // namespace ocean
