// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The table itself: one entry per parameter, in the order of the sea file. To add a parameter, add
// a member to parameters.hpp and its entry here; every host follows.
#include "ocean/parameter_table.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "ocean/enum_words.hpp"
#include "ocean/grid.hpp"

namespace ocean {

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr ParameterClass kLive = ParameterClass::live;
constexpr ParameterClass kRebuild = ParameterClass::rebuild;

// Soft ranges of live parameters begin where a tenth of the range still moves the sea by less than
// 2 % of its height in a frame while it glides, see
// TakeMotion.AStepOfATenthOfTheSoftRangeMovesLittleWithinAFrame.
// section, key, unit, label, help, member, hard range, soft range, class, dirties
constexpr ParameterInfo kTable[] = {
    {"water", "depth", "m", "Depth", "Water depth; inf is deep water.", &Water::depth, 0.01, kInf,
     1.0, 500.0, kRebuild, Stage::spectrum},
    {"water", "gravity", "m/s^2", "Gravity", "Acceleration of gravity.", &Water::gravity, 0.1,
     100.0, 1.0, 25.0, kRebuild, Stage::spectrum},
    {"water", "surface_tension", "N/m", "Surface tension",
     "Stiffens waves of a few centimetres and less.", &Water::surface_tension, 0.0, 1.0, 0.0, 0.1,
     kRebuild, Stage::spectrum},
    {"water", "density", "kg/m^3", "Density", "Of the water.", &Water::density, 100.0, 20000.0,
     900.0, 1100.0, kRebuild, Stage::spectrum},

    {"grid", "resolution", "samples", "Resolution", "Samples along each side; a power of two.",
     &Grid::resolution, kMinResolution, kMaxResolution, 64, 2048, kRebuild, Stage::spectrum},
    {"grid", "patch_size", "m", "Patch size",
     "Side of the square that repeats; a few of the longest waves should fit.", &Grid::patch_size,
     1.0, 100000.0, 10.0, 5000.0, kRebuild, Stage::spectrum},
    {"grid", "cascades", "", "Cascades",
     "Bands of wavelengths with a lattice each: short waves on a large patch.", &Grid::cascades, 1,
     5, 1, 5, kRebuild, Stage::modes},
    {"grid", "cascade_divisors", "", "Cascade divisors",
     "Whole numbers that divide the patch, one for each cascade, ascending from 1; empty chooses "
     "them.",
     &Grid::cascade_divisors, 1, 100000, 1, 1000, kRebuild, Stage::modes},

    {"surface", "choppiness", "", "Choppiness",
     "Scale of the horizontal displacement: 0 is upright waves, 1 linear theory, more sharpens "
     "crests until they fold.",
     &SurfaceSettings::choppiness, 0.0, 4.0, 0.0, 1.5, kLive, Stage::surface},
    {"surface", "shortest_wavelength", "m", "Shortest wavelength",
     "Waves shorter than this are left out; 0 is no limit.", &SurfaceSettings::shortest_wavelength,
     0.0, 100000.0, 0.0, 50.0, kRebuild, Stage::modes},
    {"surface", "longest_wavelength", "m", "Longest wavelength",
     "Waves longer than this are left out; 0 is no limit.", &SurfaceSettings::longest_wavelength,
     0.0, 100000.0, 0.0, 1000.0, kRebuild, Stage::modes},
    {"surface", "foam_lifetime", "s", "Foam lifetime",
     "Time in which foam fades to 1/e; 0 leaves the whitecaps alone.",
     &SurfaceSettings::foam_lifetime, 0.0, 600.0, 0.5, 30.0, kLive, Stage::foam},
    {"surface", "foam_step", "s", "Foam step",
     "Tick of the foam's own clock, whatever the frame rate.", &SurfaceSettings::foam_step, 0.01,
     1.0, 0.02, 0.2, kRebuild, Stage::foam},
    {"surface", "foam_coverage", "", "Foam coverage",
     "monahan: as much whitecap as the strongest wind makes; threshold: where the Jacobian falls "
     "below foam_threshold.",
     &SurfaceSettings::foam_coverage, 0, 0, 0, 0, kLive, Stage::foam},
    {"surface", "foam_threshold", "", "Foam threshold",
     "Jacobian where whitecaps begin, with foam_coverage = \"threshold\".",
     &SurfaceSettings::foam_threshold, -2.0, 2.0, 0.0, 1.0, kLive, Stage::foam, "threshold"},
    {"surface", "foam_width", "", "Foam width",
     "Fall of the Jacobian over which a whitecap becomes full.", &SurfaceSettings::foam_width,
     0.001, 2.0, 0.05, 0.5, kLive, Stage::foam},

    {"time", "start", "s", "Start", "Time of the first frame.", &Timing::start, -kLatestTime,
     kLatestTime, 0.0, 3600.0, kRebuild, Stage::clock},
    {"time", "first_frame", "", "First frame", "Frame number that shows the start time.",
     &Timing::first_frame, -1000000, 1000000, 0, 1000, kRebuild, Stage::clock},
    {"time", "fps", "1/s", "Frame rate", "Frames per second.", &Timing::fps, 0.001, 100000.0, 12.0,
     120.0, kRebuild, Stage::clock},
    {"time", "loop_period", "s", "Loop period",
     "The sea repeats after this time: every wave's frequency is rounded to it; 0 is never.",
     &Timing::loop_period, 0.0, 1e6, 0.0, 120.0, kRebuild, Stage::modes, "", 0.01},
    {"time", "glide", "s", "Glide",
     "Time in which a live parameter goes 63 % of the way to the value that a take gives it; 0 "
     "jumps.",
     &Timing::glide, 0.0, 60.0, 0.0, 5.0, kRebuild, Stage::clock},
    {"time", "take", "", "Take",
     "A recorded performance, a file of lines SECONDS NAME VALUE, relative to the sea file.",
     &Timing::take, 0, 0, 0, 0, kRebuild, Stage::spectrum},

    {"random", "seed", "", "Seed", "Another sea of the same statistics.", &Parameters::seed, 0,
     4294967295.0, 0, 1000, kRebuild, Stage::modes},

    {"waves", "spectrum", "", "Spectrum", "How the energy is spread over the frequencies.",
     &WaveSystem::spectrum, 0, 0, 0, 0, kRebuild, Stage::spectrum},
    {"waves", "wind_speed", "m/s", "Wind speed",
     "Mean wind 10 m above the water; 0 is flat. Unset is 10 where the wind makes height or "
     "period; "
     "measured waves and those with both given then have no whitecaps of their own.",
     &WaveSystem::wind_speed, 0.0, 75.0, 2.0, 35.0, kLive, Stage::spectrum},
    {"waves", "wind_direction", "deg", "Wind direction",
     "Where the waves travel to, counter-clockwise from +x. Given for a measured spectrum, it "
     "replaces the measured mean.",
     &WaveSystem::wind_direction, -360.0, 360.0, -180.0, 180.0, kLive, Stage::spectrum},
    {"waves", "fetch", "m", "Fetch", "Distance over which the wind has blown (jonswap, tma).",
     &WaveSystem::fetch, 1000.0, 1e7, 5e4, 1e6, kLive, Stage::spectrum, "jonswap, tma"},
    {"waves", "peak_enhancement", "", "Peak enhancement",
     "Height of the spectral peak over a fully developed sea's (jonswap, tma).",
     &WaveSystem::peak_enhancement, 1.0, 10.0, 1.0, 7.0, kLive, Stage::spectrum, "jonswap, tma"},
    {"waves", "spreading", "", "Spreading",
     "How the energy is spread over the directions (not phillips, nor measured directions).",
     &WaveSystem::spreading, 0, 0, 0, 0, kLive, Stage::spectrum,
     "pierson_moskowitz, jonswap, tma, measured"},
    {"waves", "swell", "", "Swell",
     "Above 0 aligns long waves, below 0 blends towards waves from everywhere.", &WaveSystem::swell,
     -1.0, 1.0, 0.0, 1.0, kLive, Stage::spectrum},
    {"waves", "opposing", "", "Opposing waves", "Energy kept in waves against the wind.",
     &WaveSystem::opposing, 0.0, 1.0, 0.0, 1.0, kRebuild, Stage::spectrum},
    {"waves", "significant_wave_height", "m", "Significant wave height",
     "Scales this system's heights to it; unset keeps the spectrum's own.",
     &WaveSystem::significant_wave_height, 0.0, 100.0, 0.1, 20.0, kLive, Stage::spectrum},
    {"waves", "peak_period", "s", "Peak period",
     "Stretches this system's periods to it at constant energy; unset keeps the spectrum's own.",
     &WaveSystem::peak_period, 0.05, 1000.0, 4.0, 18.0, kLive, Stage::spectrum},
    {"waves", "amplitude", "", "Amplitude", "Energy in units of Phillips' constant (phillips).",
     &WaveSystem::amplitude, 0.0, 1000.0, 0.0, 4.0, kRebuild, Stage::spectrum, "phillips"},
    {"waves", "alignment", "", "Alignment", "Even power of the cosine to the wind (phillips).",
     &WaveSystem::alignment, 2, 16, 2, 16, kRebuild, Stage::spectrum, "phillips"},
    {"waves", "cutoff_wavelength", "m", "Cut-off wavelength",
     "Where small waves have faded to 1/e of their energy (phillips); 0 is no cut-off.",
     &WaveSystem::cutoff_wavelength, 0.0, 1000.0, 0.0, 5.0, kRebuild, Stage::spectrum, "phillips"},
    {"waves", "file", "", "Spectrum file", "Measured spectra, relative to the sea file (measured).",
     &WaveSystem::file, 0, 0, 0, 0, kRebuild, Stage::spectrum, "measured"},
    {"waves", "record", "", "Record",
     "Time of the record to take, UTC; the nearest within 30 minutes, empty the first (measured).",
     &WaveSystem::record, 0, 0, 0, 0, kRebuild, Stage::spectrum, "measured"},
    {"waves", "place", "", "Place",
     "Station, or LATITUDE,LONGITUDE with the nearest within 50 km; empty the first (measured).",
     &WaveSystem::place, 0, 0, 0, 0, kRebuild, Stage::spectrum, "measured"},
    {"waves", "estimator", "", "Estimator",
     "How directional moments become a distribution (measured).", &WaveSystem::estimator, 0, 0, 0,
     0, kRebuild, Stage::spectrum, "measured"},
};

/// Stands for a value of any type.
struct Anything {
    template <typename Value>
    constexpr operator Value() const {
        return {};
    }
};

/// Members of a plain struct: as many as there are values that it can be made from.
template <typename Struct, typename... Values>
constexpr std::size_t member_count() {
    if constexpr (requires { Struct{Values{}..., Anything{}}; }) {
        return member_count<Struct, Values..., Anything>();
    } else {
        return sizeof...(Values);
    }
}

constexpr std::size_t rows_of(std::string_view section) {
    return static_cast<std::size_t>(
        std::ranges::count(kTable, section, [](const ParameterInfo& row) { return row.section; }));
}

// A member without a row is one that nobody can set.
static_assert(rows_of("water") == member_count<Water>());
static_assert(rows_of("grid") == member_count<Grid>());
static_assert(rows_of("surface") == member_count<SurfaceSettings>());
static_assert(rows_of("time") == member_count<Timing>());
static_assert(rows_of("waves") + 3 ==
              member_count<WaveSystem>());  // energy_share, wind_onset, measured

template <typename Section, typename Value>
constexpr std::span<const std::string_view> choices_of(Value Section::*) {
    if constexpr (std::is_enum_v<Value>) return kEnumWords<Value>;
    return {};
}

template <typename Section, typename Value>
constexpr std::string_view type_of(Value Section::*) {
    if constexpr (std::is_enum_v<Value>) return "enum";
    if constexpr (std::is_integral_v<Value>) return "int";
    if constexpr (std::is_same_v<Value, std::string>) return "text";
    if constexpr (std::is_same_v<Value, std::vector<int>>) return "list";
    return "float";
}

}  // namespace

std::span<const ParameterInfo> parameter_table() {
    return kTable;
}

std::string ParameterInfo::path(std::size_t wave) const {
    std::string result(section);
    if (per_wave_system()) result += "." + std::to_string(wave);
    return result + "." + std::string(key);
}

std::span<const std::string_view> ParameterInfo::choices() const {
    return std::visit([](auto pointer) { return choices_of(pointer); }, member);
}

std::string_view ParameterInfo::type() const {
    return std::visit([](auto pointer) { return type_of(pointer); }, member);
}

}  // namespace ocean
