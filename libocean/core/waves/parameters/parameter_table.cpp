// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The table itself: one entry per parameter, in the order of the sea file. To add a parameter, add
// a member to parameters.hpp and its entry here; every host follows. The entry names its default as
// the neutral value, {.neutral = "0"}, so that the texts of older seas stay.
#include "ocean/parameter_table.hpp"

#include <algorithm>
#include <limits>

#include "ocean/internal/grid.hpp"

namespace ocean {

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr ParameterClass kLive = ParameterClass::live;
constexpr ParameterClass kRebuild = ParameterClass::rebuild;

constexpr TableSection kWater{"water"};
constexpr TableSection kShore{"water.shore"};
constexpr TableSection kGrid{"grid"};
constexpr TableSection kSurface{"surface"};
constexpr TableSection kTime{"time"};
constexpr TableSection kRandom{"random"};
constexpr TableSection kWaves{"waves", "wave system", kMaxWaveSystems};
// Its keys are common words, so that none of them alone names a crest.
constexpr TableSection kCrests{"crests", "crest", kMaxCrests, false};
constexpr TableSection kHulls{"hulls", "hull", kMaxHulls};
constexpr TableSection kSections[] = {kWater,  kShore, kGrid,   kSurface, kTime,
                                      kRandom, kWaves, kCrests, kHulls};

constexpr OptionalColumns used_by(std::string_view words, NumberRule rule = NumberRule::any) {
    return {.used_by = words, .rule = rule};
}
constexpr OptionalColumns min_nonzero(double value) {
    return {.min_nonzero = value};
}
constexpr OptionalColumns rule(NumberRule rule) {
    return {.rule = rule};
}
constexpr OptionalColumns max_length(std::size_t numbers) {
    return {.max_length = numbers};
}
constexpr OptionalColumns neutral(std::string_view value) {
    return {.neutral = value};
}
constexpr OptionalColumns kCoarserLattice{
    .min_nonzero = kMinResolution, .rule = NumberRule::power_of_two, .neutral = "0"};

// The soft range of a live parameter begins where a glide over a tenth of the range still moves the
// sea by less than 2 % of its height in a frame, see
// TakeMotion.AStepOfATenthOfTheSoftRangeMovesLittleWithinAFrame.
// section, key, unit, label, help, member, hard range, soft range, class, dirties, further columns
constexpr ParameterInfo kTable[] = {
    {kWater, "depth", "m", "Depth", "Water depth; inf means deep water.",
     member<&Parameters::water, &Water::depth>(), 0.01, kInf, 1.0, 500.0, kRebuild,
     Stage::spectrum},
    {kWater, "gravity", "m/s^2", "Gravity", "Acceleration of gravity.",
     member<&Parameters::water, &Water::gravity>(), 0.1, 100.0, 1.0, 25.0, kRebuild,
     Stage::spectrum},
    {kWater, "surface_tension", "N/m", "Surface tension",
     "Surface tension of the water; it speeds up waves shorter than a few centimetres.",
     member<&Parameters::water, &Water::surface_tension>(), 0.0, 1.0, 0.0, 0.1, kRebuild,
     Stage::spectrum},
    {kWater, "density", "kg/m^3", "Density", "Density of the water.",
     member<&Parameters::water, &Water::density>(), 100.0, 20000.0, 900.0, 1100.0, kRebuild,
     Stage::spectrum},
    {kWater, "seabed", "", "Sea bed",
     "File of the bed that waves feel near a coast: a terrain file (.toml) or an elevation model "
     "on square cells (.asc, .flt), relative to the sea file. Empty means an open sea.",
     member<&Parameters::water, &Water::seabed>(), 0, 0, 0, 0, kRebuild, Stage::surface,
     neutral("")},
    {kWater, "seabed_origin", "m", "Sea bed origin",
     "Place of the bed's south-west sample in the sea, x and y; empty means (0, 0).",
     member<&Parameters::water, &Water::seabed_origin>(), -1e7, 1e7, -10000.0, 10000.0, kRebuild,
     Stage::surface, OptionalColumns{.max_length = 2, .neutral = "[]"}},
    {kWater, "seabed_unit", "", "Sea bed unit",
     "Unit of the bed's heights: m, or the unit that the file states itself; ft, 0.3048 m; us_ft, "
     "1200/3937 m.",
     member<&Parameters::water, &Water::seabed_unit>(), 0, 0, 0, 0, kRebuild, Stage::surface,
     neutral("m")},
    {kWater, "seabed_sign", "", "Sea bed sign",
     "up: the bed's heights are positive above its datum; down: they are depths.",
     member<&Parameters::water, &Water::seabed_sign>(), 0, 0, 0, 0, kRebuild, Stage::surface,
     neutral("up")},
    {kWater, "level", "m", "Water level",
     "Height of still water above the datum of the bed: raises the tide.",
     member<&Parameters::water, &Water::level>(), -10000.0, 10000.0, -10.0, 10.0, kRebuild,
     Stage::surface, neutral("0")},

    {kShore, "swash", "", "Swash",
     "on: waves run up and down the beach of a sea with a bed; off: they end at the still water "
     "line.",
     member<&Parameters::water, &Water::shore, &ShoreSettings::swash>(), 0, 0, 0, 0, kRebuild,
     Stage::surface, neutral("on")},
    {kShore, "surf_foam_lifetime", "s", "Surf foam lifetime",
     "Time in which the foam of waves that break over the bed fades to 1/e.",
     member<&Parameters::water, &Water::shore, &ShoreSettings::surf_foam_lifetime>(), 0.0, 600.0,
     0.5, 30.0, kRebuild, Stage::foam, neutral("3.6")},

    {kGrid, "resolution", "samples", "Resolution",
     "Samples along each side; a power of two. With cascades, maps have four times as many: 2048 "
     "for 512.",
     member<&Parameters::grid, &Grid::resolution>(), kMinResolution, kMaxResolution, 64, 2048,
     kRebuild, Stage::spectrum, rule(NumberRule::power_of_two)},
    {kGrid, "patch_size", "m", "Patch size",
     "Side of the square after which the sea repeats; it should hold a few of the longest waves.",
     member<&Parameters::grid, &Grid::patch_size>(), 1.0, 100000.0, 10.0, 5000.0, kRebuild,
     Stage::spectrum},
    {kGrid, "cascades", "", "Cascades",
     "Number of wavelength bands, each with a grid of its own: adds short waves to a large patch. "
     "With more than one, maps have four times the grid's samples along each side: 2048 for 512.",
     member<&Parameters::grid, &Grid::cascades>(), 1, 5, 1, 5, kRebuild, Stage::modes},
    {kGrid, "cascade_divisors", "", "Cascade divisors",
     "Whole numbers by which the patch size is divided, one for each cascade, ascending from 1; "
     "empty means automatic.",
     member<&Parameters::grid, &Grid::cascade_divisors>(), 1, 100000, 1, 1000, kRebuild,
     Stage::modes, max_length(5)},

    {kSurface, "choppiness", "", "Choppiness",
     "Scale of the horizontal displacement: 0 moves the water only up and down, 1 is linear "
     "theory, higher values sharpen crests until they fold.",
     member<&Parameters::surface, &SurfaceSettings::choppiness>(), 0.0, 4.0, 0.0, 1.5, kLive,
     Stage::surface},
    {kSurface, "shortest_wavelength", "m", "Shortest wavelength",
     "Waves shorter than this are left out; 0 means no limit.",
     member<&Parameters::surface, &SurfaceSettings::shortest_wavelength>(), 0.0, 100000.0, 0.0,
     50.0, kRebuild, Stage::modes},
    {kSurface, "longest_wavelength", "m", "Longest wavelength",
     "Waves longer than this are left out; 0 means no limit.",
     member<&Parameters::surface, &SurfaceSettings::longest_wavelength>(), 0.0, 100000.0, 0.0,
     1000.0, kRebuild, Stage::modes},
    {kSurface, "foam_lifetime", "s", "Foam lifetime",
     "Time in which foam fades to 1/e; 0 means no foam, only whitecaps.",
     member<&Parameters::surface, &SurfaceSettings::foam_lifetime>(), 0.0, 600.0, 0.5, 30.0, kLive,
     Stage::foam},
    {kSurface, "foam_step", "s", "Foam step",
     "Time step of the foam, independent of the frame rate.",
     member<&Parameters::surface, &SurfaceSettings::foam_step>(), 0.01, 1.0, 0.02, 0.2, kRebuild,
     Stage::foam},
    {kSurface, "foam_resolution", "samples", "Foam resolution",
     "Samples along each side of the lattice that keeps the foam's past; 0 means grid.resolution "
     "with cascades, else the map's own. Finer maps read it and sharpen it with their own "
     "whitecaps. As fine as the map, a frame with cascades takes up to 100 times as long.",
     member<&Parameters::surface, &SurfaceSettings::foam_resolution>(), 0, kMaxResolution, 0, 2048,
     kRebuild, Stage::foam, kCoarserLattice},
    {kSurface, "foam_coverage", "", "Foam coverage",
     "monahan: the strongest wind determines the area of whitecaps; threshold: whitecaps form "
     "where the Jacobian is below foam_threshold.",
     member<&Parameters::surface, &SurfaceSettings::foam_coverage>(), 0, 0, 0, 0, kLive,
     Stage::foam},
    {kSurface, "foam_threshold", "", "Foam threshold",
     "Jacobian below which whitecaps form, with foam_coverage = \"threshold\".",
     member<&Parameters::surface, &SurfaceSettings::foam_threshold>(), -2.0, 2.0, 0.0, 1.0, kLive,
     Stage::foam, used_by("threshold")},
    {kSurface, "foam_width", "", "Foam width",
     "How far the Jacobian falls below the threshold where a whitecap is fully white.",
     member<&Parameters::surface, &SurfaceSettings::foam_width>(), 0.001, 2.0, 0.05, 0.5, kLive,
     Stage::foam},
    {kSurface, "second_order", "", "Second order",
     "Waves that the products of the sea's waves bind make crests higher and sharper and troughs "
     "flatter, with the skewness of second-order theory; for deep water.",
     member<&Parameters::surface, &SurfaceSettings::second_order>(), 0, 0, 0, 0, kRebuild,
     Stage::modes, neutral("false")},

    {kTime, "start", "s", "Start", "Time of the first frame.",
     member<&Parameters::time, &Timing::start>(), -kLatestTime, kLatestTime, 0.0, 3600.0, kRebuild,
     Stage::clock},
    {kTime, "first_frame", "", "First frame", "Number of the frame that shows the start time.",
     member<&Parameters::time, &Timing::first_frame>(), -1000000, 1000000, 0, 1000, kRebuild,
     Stage::clock},
    {kTime, "fps", "1/s", "Frame rate", "Frames per second.",
     member<&Parameters::time, &Timing::fps>(), 0.001, 100000.0, 12.0, 120.0, kRebuild,
     Stage::clock},
    {kTime, "loop_period", "s", "Loop period",
     "Time after which the sea repeats; wave frequencies are rounded to fit it. 0 means no loop.",
     member<&Parameters::time, &Timing::loop_period>(), 0.0, 1e6, 0.0, 120.0, kRebuild,
     Stage::modes, min_nonzero(0.01)},
    {kTime, "glide", "s", "Glide",
     "Time in which a live parameter covers 63 % of the way to a new value from a take; 0 means at "
     "once.",
     member<&Parameters::time, &Timing::glide>(), 0.0, 60.0, 0.0, 5.0, kRebuild, Stage::clock},
    {kTime, "take", "", "Take",
     "File of a recorded performance, with lines SECONDS NAME VALUE; relative to the sea file.",
     member<&Parameters::time, &Timing::take>(), 0, 0, 0, 0, kRebuild, Stage::spectrum},

    {kRandom, "seed", "", "Seed",
     "Selects the random sea: each seed gives another one with the same statistics.",
     member<&Parameters::seed>(), 0, 4294967295.0, 0, 1000, kRebuild, Stage::modes},

    {kWaves, "spectrum", "", "Spectrum", "Distribution of the energy over the frequencies.",
     member<&Parameters::waves, &WaveSystem::spectrum>(), 0, 0, 0, 0, kRebuild, Stage::spectrum},
    {kWaves, "wind_speed", "m/s", "Wind speed",
     "Mean wind speed 10 m above the water; 0 means flat water. Unset means 10 if height or period "
     "follow from the wind; measured waves, and those with both given, then make no whitecaps.",
     member<&Parameters::waves, &WaveSystem::wind_speed>(), 0.0, 75.0, 2.0, 35.0, kLive,
     Stage::spectrum},
    {kWaves, "wind_direction", "deg", "Wind direction",
     "Direction that the waves travel to, counter-clockwise from +x. For a measured spectrum it "
     "replaces the measured mean.",
     member<&Parameters::waves, &WaveSystem::wind_direction>(), -360.0, 360.0, -180.0, 180.0, kLive,
     Stage::spectrum},
    {kWaves, "fetch", "m", "Fetch", "Distance over which the wind has blown (jonswap, tma).",
     member<&Parameters::waves, &WaveSystem::fetch>(), 1000.0, 1e7, 5e4, 1e6, kLive,
     Stage::spectrum, used_by("jonswap, tma")},
    {kWaves, "peak_enhancement", "", "Peak enhancement",
     "Height of the spectral peak relative to that of a fully developed sea (jonswap, tma).",
     member<&Parameters::waves, &WaveSystem::peak_enhancement>(), 1.0, 10.0, 1.0, 7.0, kLive,
     Stage::spectrum, used_by("jonswap, tma")},
    {kWaves, "spreading", "", "Spreading",
     "Distribution of the energy over the directions (not for phillips or measured directions).",
     member<&Parameters::waves, &WaveSystem::spreading>(), 0, 0, 0, 0, kLive, Stage::spectrum,
     used_by("pierson_moskowitz, jonswap, tma, measured")},
    {kWaves, "swell", "", "Swell",
     "Above 0, long waves become more parallel; below 0, waves come increasingly from all "
     "directions.",
     member<&Parameters::waves, &WaveSystem::swell>(), -1.0, 1.0, 0.0, 1.0, kLive, Stage::spectrum},
    {kWaves, "opposing", "", "Opposing waves",
     "Share of the energy that waves against the wind keep.",
     member<&Parameters::waves, &WaveSystem::opposing>(), 0.0, 1.0, 0.0, 1.0, kRebuild,
     Stage::spectrum},
    {kWaves, "significant_wave_height", "m", "Significant wave height",
     "Height to which this system is scaled; unset keeps the spectrum's own.",
     member<&Parameters::waves, &WaveSystem::significant_wave_height>(), 0.0, 100.0, 0.1, 20.0,
     kLive, Stage::spectrum},
    {kWaves, "peak_period", "s", "Peak period",
     "Period to which this system is stretched at constant energy; unset keeps the spectrum's own.",
     member<&Parameters::waves, &WaveSystem::peak_period>(), 0.05, 1000.0, 4.0, 18.0, kLive,
     Stage::spectrum},
    {kWaves, "amplitude", "", "Amplitude", "Energy in units of Phillips' constant (phillips).",
     member<&Parameters::waves, &WaveSystem::amplitude>(), 0.0, 1000.0, 0.0, 4.0, kRebuild,
     Stage::spectrum, used_by("phillips")},
    {kWaves, "alignment", "", "Alignment",
     "Even power of the cosine of the angle to the wind; higher values make waves more parallel "
     "(phillips).",
     member<&Parameters::waves, &WaveSystem::alignment>(), 2, 16, 2, 16, kRebuild, Stage::spectrum,
     used_by("phillips", NumberRule::even)},
    {kWaves, "cutoff_wavelength", "m", "Cut-off wavelength",
     "Wavelength at which short waves keep 1/e of their energy (phillips); 0 means no cut-off.",
     member<&Parameters::waves, &WaveSystem::cutoff_wavelength>(), 0.0, 1000.0, 0.0, 5.0, kRebuild,
     Stage::spectrum, used_by("phillips")},
    {kWaves, "file", "", "Spectrum file",
     "File of measured spectra, relative to the sea file (measured).",
     member<&Parameters::waves, &WaveSystem::file>(), 0, 0, 0, 0, kRebuild, Stage::spectrum,
     used_by("measured")},
    {kWaves, "record", "", "Record",
     "Time of the record, UTC: selects the nearest within 30 minutes. Empty selects the first "
     "(measured).",
     member<&Parameters::waves, &WaveSystem::record>(), 0, 0, 0, 0, kRebuild, Stage::spectrum,
     used_by("measured")},
    {kWaves, "place", "", "Place",
     "Station, or LATITUDE,LONGITUDE: selects the nearest within 50 km. Empty selects the first "
     "(measured).",
     member<&Parameters::waves, &WaveSystem::place>(), 0, 0, 0, 0, kRebuild, Stage::spectrum,
     used_by("measured")},
    {kWaves, "estimator", "", "Estimator",
     "Method that turns directional moments into a distribution (measured).",
     member<&Parameters::waves, &WaveSystem::estimator>(), 0, 0, 0, 0, kRebuild, Stage::spectrum,
     used_by("measured")},

    {kCrests, "time", "s", "Time", "Time at which the crest is highest.",
     member<&Parameters::crests, &Crest::time>(), -kLatestTime, kLatestTime, 0.0, 60.0, kRebuild,
     Stage::modes},
    {kCrests, "x", "m", "X", "Place of the crest, east; the sea repeats after patch_size.",
     member<&Parameters::crests, &Crest::x>(), -1e7, 1e7, 0.0, 500.0, kRebuild, Stage::modes},
    {kCrests, "y", "m", "Y", "Place of the crest, north.", member<&Parameters::crests, &Crest::y>(),
     -1e7, 1e7, 0.0, 500.0, kRebuild, Stage::modes},
    {kCrests, "height", "m", "Height",
     "Height of the crest over still water, or below 0 the depth of a trough: metres, or a "
     "multiple of the sea's significant wave height; at most 2 Hs.",
     member<&Parameters::crests, &Crest::height>(), -200.0, 200.0, -20.0, 20.0, kRebuild,
     Stage::modes},
    {kCrests, "direction", "deg", "Direction",
     "Direction that the crest travels to, counter-clockwise from +x: picks one of several wave "
     "systems. Unset means that of all waves.",
     member<&Parameters::crests, &Crest::direction>(), -360.0, 360.0, -180.0, 180.0, kRebuild,
     Stage::modes},

    {kHulls, "length", "m", "Hull length", "Length of the hull in the water.",
     member<&Parameters::hulls, &Hull::length>(), 0.5, 1000.0, 3.0, 300.0, kRebuild, Stage::clock},
    {kHulls, "beam", "m", "Beam", "Width of the hull at the water line.",
     member<&Parameters::hulls, &Hull::beam>(), 0.05, 200.0, 1.0, 50.0, kRebuild, Stage::clock},
    {kHulls, "draught", "m", "Draught", "Depth of the hull below the water line.",
     member<&Parameters::hulls, &Hull::draught>(), 0.02, 100.0, 0.2, 15.0, kRebuild, Stage::clock},
    {kHulls, "shape", "", "Hull shape",
     "wall_sided: vertical sides with a parabolic water line; wigley: Wigley's parabolas, a finer "
     "hull of two thirds of that volume.",
     member<&Parameters::hulls, &Hull::shape>(), 0, 0, 0, 0, kRebuild, Stage::clock},
    {kHulls, "factor", "", "Wake factor",
     "Factor on the height of the waves. At 1 it is that of linear theory, which no measured wash "
     "has confirmed: for full hulls near the hump speed it is probably too high.",
     member<&Parameters::hulls, &Hull::factor>(), 0.0, 10.0, 0.0, 2.0, kRebuild, Stage::clock,
     neutral("1")},
    {kHulls, "trail_lifetime", "s", "Trail lifetime",
     "Time in which the white water behind the hull fades to 1/e, in the mask `trail`; 0 leaves it "
     "out.",
     member<&Parameters::hulls, &Hull::trail_lifetime>(), 0.0, 600.0, 0.0, 120.0, kRebuild,
     Stage::clock, OptionalColumns{.min_nonzero = 0.1, .neutral = "25"}},
    {kHulls, "track_file", "", "Track file",
     "CSV file of the track, with a header: time,x,y, or time,x,y,heading,speed, or way points "
     "x,y,speed; or a GPX file, with origin; relative to the sea file. The rows themselves may "
     "stand in the sea file as track = [[time, x, y], ...].",
     member<&Parameters::hulls, &Hull::track_file>(), 0, 0, 0, 0, kRebuild, Stage::clock,
     neutral("")},
    {kHulls, "origin", "deg", "Track origin",
     "Latitude and longitude of (0, 0), for a GPX track; x is east and y is north there.",
     member<&Parameters::hulls, &Hull::origin>(), -180.0, 180.0, -180.0, 180.0, kRebuild,
     Stage::clock, OptionalColumns{.max_length = 2, .neutral = "[]"}},
    {kHulls, "origin_time", "", "Track start",
     "Date and time of the sea's time 0, for a GPX track, such as 2026-05-01T10:00:00Z; empty: "
     "those of its first point.",
     member<&Parameters::hulls, &Hull::origin_time>(), 0, 0, 0, 0, kRebuild, Stage::clock,
     neutral("")},
    {kHulls, "wake_size", "m", "Wake size",
     "Side of the square of water around the hull that shows its wake; 0 means chosen: 16 lengths "
     "or 12 of its transverse waves, at most 32 lengths.",
     member<&Parameters::hulls, &Hull::wake_size>(), 0.0, 100000.0, 0.0, 5000.0, kRebuild,
     Stage::clock, neutral("0")},
    {kHulls, "wake_resolution", "samples", "Wake resolution",
     "Samples along each side of that square; a power of two.",
     member<&Parameters::hulls, &Hull::wake_resolution>(), 64, 2048, 128, 1024, kRebuild,
     Stage::clock, OptionalColumns{.rule = NumberRule::power_of_two, .neutral = "256"}},
    {kHulls, "wake_age", "s", "Wake age",
     "Age at which waves are forgotten, faded out over its last quarter; 0 means chosen: 3.2 times "
     "the time in which the hull crosses the square.",
     member<&Parameters::hulls, &Hull::wake_age>(), 0.0, 3600.0, 0.0, 600.0, kRebuild, Stage::clock,
     OptionalColumns{.min_nonzero = 10.0, .neutral = "0"}},
};

/// A type that converts to a value of any type.
struct Anything {
    template <typename Value>
    constexpr operator Value() const {
        return {};
    }
};

/// Counts the members of a plain struct: the max number of values that can initialise it.
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

// Each member needs a row, except the two in the comment: without a row it could not be set.
static_assert(rows_of("water") + 2 == member_count<Water>());  // shore, bed
static_assert(rows_of("water.shore") == member_count<ShoreSettings>());
static_assert(rows_of("grid") == member_count<Grid>());
static_assert(rows_of("surface") == member_count<SurfaceSettings>());
static_assert(rows_of("time") == member_count<Timing>());
static_assert(rows_of("waves") + 3 ==
              member_count<WaveSystem>());  // energy_share, wind_onset, measured
static_assert(rows_of("crests") == member_count<Crest>());
static_assert(rows_of("hulls") + 1 == member_count<Hull>());  // track

constexpr Table<Parameters> kSeaTable{"sea", kSections, kTable};
static_assert(is_consistent(kSeaTable));

}  // namespace

const Table<Parameters>& sea_table() {
    return kSeaTable;
}

std::span<const ParameterInfo> parameter_table() {
    return kTable;
}

}  // namespace ocean
