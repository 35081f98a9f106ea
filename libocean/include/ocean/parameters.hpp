// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The parameters that define a sea, as one plain value, which sea file, panel, knob and take set
// and the mathematics reads. The table of parameter_table.hpp states the unit, range, label and
// help of each member; the initialisers here are the defaults.
//
//     Parameters parameters;
//     parameters.grid.resolution = 1024;
//     parameters.grid.patch_size = 500.0;
//     WaveSystem& wind_sea = parameters.waves.front();
//     wind_sea.spectrum = SpectrumKind::jonswap;
//     wind_sea.wind_speed = 14.0;
//     wind_sea.wind_direction = 30.0;
//     validate(parameters);  // parameter_table.hpp
//     Ocean ocean(parameters);
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ocean/table.hpp"

namespace ocean {

// The words of sea files are the enumerators (enum_words.hpp).
enum class SpectrumKind { phillips, pierson_moskowitz, jonswap, tma, measured };
enum class SpreadingKind { cosine_squared, mitsuyasu, hasselmann, donelan_banner };
enum class Estimator { maximum_entropy, fourier };
enum class FoamCoverage { monahan, threshold };
enum class BedUnit { m, ft, us_ft };
enum class BedSign { up, down };
enum class Swash { on, off };
enum class HullShape { wall_sided, wigley };

/// Where foam begins; no parameter of a sea file.
enum class FoamStart {
    settled,  // as far back as foam lives: the same bits as from any earlier start
    empty,    // at the first requested time, for live tools; see OceanOptions::foam_start
};

struct SeaBed;          // sea_bed.hpp
struct SpectrumRecord;  // below
struct HullTrack;       // below

/// The edge of a sea with a bed: [water.shore].
struct ShoreSettings {
    Swash swash = Swash::on;
    double surf_foam_lifetime = 3.6;  // [s]
    bool operator==(const ShoreSettings&) const = default;
};

struct Water {
    double depth = std::numeric_limits<double>::infinity();
    double gravity = 9.81;
    double surface_tension = 0.074;
    double density = 1000.0;
    std::string seabed = {};  // file of the bed; empty: no bed, or a bed without a file
    std::vector<double> seabed_origin = {};  // its south-west sample [m]; empty: (0, 0)
    BedUnit seabed_unit = BedUnit::m;
    BedSign seabed_sign = BedSign::up;
    double level = 0.0;  // of still water in the heights of the bed [m]
    ShoreSettings shore = {};

    /// The bed, read by ocean::seafile or given by a host. Shared and never modified. Not in the
    /// table.
    std::shared_ptr<const SeaBed> bed = {};

    /// Returns s in omega^2 = (g k + s k^3) tanh(k d) [m^3/s^2].
    double kinematic_tension() const { return surface_tension / density; }
    /// Returns the position of the bed's south-west sample [m].
    std::array<double, 2> bed_origin() const {
        if (seabed_origin.size() != 2) return {0.0, 0.0};
        return {seabed_origin[0], seabed_origin[1]};
    }
    /// Compares beds by their content.
    bool operator==(const Water& other) const;
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
    int foam_resolution = 0;  // 0: each map's own
    FoamCoverage foam_coverage = FoamCoverage::monahan;
    double foam_threshold = 0.75;
    double foam_width = 0.2;
    bool second_order = false;
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

inline constexpr double kDefaultWind = 10.0;  // [m/s]

/// One wave system: a spectrum with its spreading. The energies of several systems add.
struct WaveSystem {
    SpectrumKind spectrum = SpectrumKind::phillips;
    /// Unset means kDefaultWind for a system that is a wind sea (is_wind_sea), and else an unknown
    /// wind, which makes no whitecaps.
    std::optional<double> wind_speed;
    /// Unset means 0 for a parametric spectrum, and "as measured" for a record with directions.
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

    /// Share of this system's energy that counts: 1, except in the copies that Sea::at makes while
    /// a take glides between spreadings. The table has no row for it.
    double energy_share = 1.0;

    /// Share of wind_speed that makes whitecaps: 1, except while a take introduces a wind over
    /// waves that had none. The table has no row for it.
    double wind_onset = 1.0;

    /// The chosen record of `file`, read by ocean::seafile. Shared and never modified.
    std::shared_ptr<const SpectrumRecord> measured;

    double direction_degrees() const { return wind_direction.value_or(0.0); }

    /// Returns true if height, period or both follow from the wind: the system is parametric and
    /// does not have both given.
    bool is_wind_sea() const {
        return spectrum != SpectrumKind::measured && !(significant_wave_height && peak_period);
    }
    /// Returns the wind that spectrum and spreading use [m/s].
    double wind() const { return wind_speed.value_or(kDefaultWind); }
    /// Returns the wind over these waves, which makes whitecaps [m/s]; unset if it is unknown.
    std::optional<double> wind_above() const {
        if (wind_speed) return wind_onset * *wind_speed;
        return is_wind_sea() ? std::optional(kDefaultWind) : std::nullopt;
    }
};

/// A crest, or a trough, at a place and a time: [[crests]].
struct Crest {
    double time = 0.0;                     // [s]
    double x = 0.0;                        // [m]
    double y = 0.0;                        // [m]
    WaveHeight height = {};                // over still water; below 0: a trough
    std::optional<double> direction = {};  // that it travels to [degrees]; unset: the sea's own
    bool operator==(const Crest&) const = default;
};
inline constexpr std::size_t kMaxCrests = 16;
/// Max height of a crest, in units of the significant wave height: one crest in 10^14 exceeds it.
inline constexpr double kMaxCrestHeight = 2.0;

/// A hull that makes waves: [[hulls]].
struct Hull {
    double length = 30.0;
    double beam = 6.0;
    double draught = 1.8;
    HullShape shape = HullShape::wall_sided;
    double factor = 1.0;
    double trail_lifetime = 25.0;  // of the white water behind it [s]
    std::string track_file;
    std::vector<double> origin = {};  // of a GPX track: latitude, longitude [degrees]
    std::string origin_time;          // of a GPX track: at 0 s; empty: of its first point
    double wake_size = 0.0;           // 0: chosen, see wake_lattice.hpp
    int wake_resolution = 256;
    double wake_age = 0.0;  // 0: chosen

    /// The track, read by ocean::seafile or given by a host. Shared and never modified. Not in the
    /// table.
    std::shared_ptr<const HullTrack> track;

    /// Compares tracks by their content.
    bool operator==(const Hull& other) const;
};

/// Times lie within -kLatestTime .. kLatestTime [s]: 31 years. A double resolves a tenth of a
/// microsecond there.
inline constexpr double kLatestTime = 1e9;
/// Throws Error invalid_value for NaN and for a time beyond kLatestTime.
void require_time(double time);

struct Parameters {
    Water water;
    Grid grid;
    SurfaceSettings surface;
    Timing time;
    std::uint32_t seed = 1;
    std::vector<WaveSystem> waves = {WaveSystem{}};  // 1 .. kMaxWaveSystems
    std::vector<Crest> crests = {};                  // 0 .. kMaxCrests
    std::vector<Hull> hulls = {};                    // at most kMaxHulls
};
/// Returns true if maps of one period are the whole sea: a bed exists once, and so does a wake.
inline bool repeats(const Parameters& sea) {
    return !sea.water.bed && sea.hulls.empty();
}
inline constexpr std::size_t kMaxWaveSystems = 16;
inline constexpr std::size_t kMaxHulls = 16;

// ---- Measured spectra

/// One measured sea: the record of a buoy or a wave model for one time at one place. Readers in
/// ocean::seafile make it; the directional estimate consumes it. A plain value. Angles are
/// converted already: counter-clockwise from east, the direction that waves travel to. A record has
/// no directions, or their first two moments (buoys), or the full distribution (wave models), never
/// both. Vectors are parallel to `frequency` unless stated otherwise.
struct SpectrumRecord {
    std::string station;
    std::string time;  // ISO 8601 in UTC, to the minute: 2020-06-08T03:50; empty = unknown
    double latitude = std::numeric_limits<double>::quiet_NaN();   // north [degrees]
    double longitude = std::numeric_limits<double>::quiet_NaN();  // east [degrees]
    double depth = std::numeric_limits<double>::quiet_NaN();      // [m]; NaN = unknown

    std::vector<double> frequency;  // [Hz], ascending, > 0
    std::vector<double> density;    // S(f) [m^2/Hz], >= 0

    // First and second normalised Fourier moments of the directional distribution, a_n = mean of
    // cos(n theta), b_n = mean of sin(n theta). Empty: not measured. NaN in a bin: missing there.
    // If only a2 and b2 are missing, a mean direction and a spread are known, and the distribution
    // is taken to be cos^2s of half the angle.
    std::vector<double> a1, b1, a2, b2;

    // The spectrum over frequency and direction: piecewise linear and periodic in direction.
    // Its integral over the circle at a frequency is `density` there.
    std::vector<double> direction;            // [degrees], 0 <= d < 360, ascending, 3 or more
    std::vector<double> directional_density;  // [m^2/Hz/degree], >= 0, [frequency][direction]

    // Assumptions, omissions and corrections of the reader: sentences for people.
    std::vector<std::string> warnings;
    // Why the record cannot be used, "PATH:LINE: FAULT"; empty for a good one. A record with a
    // fault has only time and place set.
    std::string fault;

    bool has_moments() const { return !a1.empty(); }
    bool is_directional() const { return !direction.empty(); }
    bool has_directions() const { return has_moments() || is_directional(); }
    bool operator==(const SpectrumRecord&) const = default;
};

// ---- Tracks of hulls

struct TrackRow {
    double time;  // [s]
    double x, y;  // of the middle of the hull [m]
    bool operator==(const TrackRow&) const = default;
};

/// The direction in which a hull travels and its speed at one row.
struct TrackCourse {
    double heading;  // counter-clockwise from +x [degrees]
    double speed;    // [m/s]
    bool operator==(const TrackCourse&) const = default;
};

/// The track of a hull: rows ordered by time. Between them the hull follows a smooth curve through
/// their positions. It exists from the first row to the last; in a sea with a loop the track
/// repeats.
struct HullTrack {
    std::vector<TrackRow> rows;
    /// One for each row, or none: courses then follow from the positions.
    std::vector<TrackCourse> courses;

    double duration() const { return rows.back().time - rows.front().time; }
    bool operator==(const HullTrack&) const = default;
};

}  // namespace ocean
