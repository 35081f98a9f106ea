// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The rows of a terrain's table, and access to its parameters by name. A new parameter is a member
// of TerrainModel and a row here.
#include "ocean/terrain_table.hpp"

#include <utility>

#include "ocean/channel.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean {
namespace {

constexpr TableSection kTerrain{"terrain"};
constexpr TableSection kLayer{"terrain.layer", "terrain layer", kMaxTerrainLayers};
constexpr TableSection kGullies{"terrain.gullies"};
constexpr TableSection kStream{"terrain.stream"};
constexpr TableSection kCoast{"terrain.coast"};
constexpr TableSection kSections[] = {kTerrain, kLayer, kGullies, kStream, kCoast};

constexpr ParameterClass kLive = ParameterClass::live;
constexpr ParameterClass kRebuild = ParameterClass::rebuild;
constexpr double kMaxLength = 1e7;  // [m]
constexpr double kMaxBeta = 6.0;

constexpr TableRow<TerrainModel> kRows[] = {
    {kTerrain, "kind", "", "Kind",
     "tile: a square that repeats; placed: a rectangle that exists once.",
     member<&TerrainModel::kind>(), 0, 0, 0, 0, kRebuild, TerrainStage::noise},
    {kTerrain, "resolution", "samples", "Resolution",
     "Samples along each side, and with them the shortest waves; a power of two. A finer terrain "
     "keeps the noise of the waves that it shares with a coarser one, and their amplitudes too if "
     "shortest_wavelength is set: else rms or range hold for more waves, and scale all of them.",
     member<&TerrainModel::resolution>(), kMinResolution, kMaxResolution, 64, 4096, kRebuild,
     TerrainStage::noise, OptionalColumns{.rule = NumberRule::power_of_two}},
    {kTerrain, "patch_size", "m", "Patch size", "Side of the square after which the land repeats.",
     member<&TerrainModel::patch_size>(), 1.0, kMaxLength, 100.0, 100000.0, kRebuild,
     TerrainStage::noise},
    {kTerrain, "seed", "", "Seed", "Number that selects one of many such terrains.",
     member<&TerrainModel::seed>(), 0.0, 4294967295.0, 0.0, 1000.0, kRebuild, TerrainStage::noise},
    {kTerrain, "beta", "", "Beta",
     "Exponent of the amplitudes: waves of wavenumber k have amplitudes of k^-beta, so the density "
     "over (kx, ky) falls as k^-2beta, the Hurst exponent is H = beta - 1 and the fractal "
     "dimension D = 4 - beta. 2.4 is smooth, 1.6 rough.",
     member<&TerrainModel::beta>(), 0.0, kMaxBeta, 1.0, 3.5, kLive, TerrainStage::filter},
    {kTerrain, "rms", "m", "RMS height",
     "Root mean square of the heights around their mean, of this very tile. Unset means 10 m, or "
     "with `measured` that of the measured spectrum.",
     member<&TerrainModel::rms>(), 0.0, 1e5, 0.0, 1000.0, kLive, TerrainStage::filter},
    {kTerrain, "range", "m", "Range",
     "Lowest and highest height of the tile's samples, in place of rms and mean.",
     member<&TerrainModel::range>(), -1e5, 1e5, -1000.0, 5000.0, kRebuild, TerrainStage::filter,
     OptionalColumns{.max_length = 2}},
    {kTerrain, "mean", "m", "Mean height", "Height of the mean of the tile.",
     member<&TerrainModel::mean>(), -1e5, 1e5, -100.0, 4000.0, kLive, TerrainStage::offset},
    {kTerrain, "outer_scale", "m", "Outer scale",
     "Wavelength beyond which the density is flat instead of growing, as (k^2 + k0^2)^-beta; 0 "
     "means none.",
     member<&TerrainModel::outer_scale>(), 0.0, kMaxLength, 0.0, 50000.0, kLive,
     TerrainStage::filter},
    {kTerrain, "breaks", "", "Breaks",
     "Pairs of a wavelength [m], in descending order, and the exponent beta of the waves that are "
     "shorter; the change takes about an octave.",
     member<&TerrainModel::breaks>(), 0.001, kMaxLength, 1.0, 10000.0, kRebuild,
     TerrainStage::filter,
     OptionalColumns{.max_length = 8, .second_min = 0.0, .second_max = kMaxBeta}},
    {kTerrain, "ridge_wavelength", "m", "Ridge wavelength",
     "Wavelength around which the density is raised, the distance of ridges; 0 means none.",
     member<&TerrainModel::ridge_wavelength>(), 0.0, kMaxLength, 0.0, 10000.0, kLive,
     TerrainStage::filter},
    {kTerrain, "ridge_gain", "", "Ridge gain",
     "Density added at the ridge wavelength, as a multiple of the law's.",
     member<&TerrainModel::ridge_gain>(), 0.0, 1000.0, 0.0, 20.0, kLive, TerrainStage::filter},
    {kTerrain, "ridge_width", "octaves", "Ridge width",
     "Standard deviation of the raised band, in octaves of wavelength.",
     member<&TerrainModel::ridge_width>(), 0.01, 10.0, 0.1, 2.0, kLive, TerrainStage::filter},
    {kTerrain, "ridge_direction", "deg", "Ridge direction",
     "Direction in which one crosses the ridges, counter-clockwise from +x; unset means all.",
     member<&TerrainModel::ridge_direction>(), -360.0, 360.0, -180.0, 180.0, kLive,
     TerrainStage::filter},
    {kTerrain, "ridge_spread", "", "Ridge spread",
     "Exponent s of cos^2s around ridge_direction: higher values make parallel ridges.",
     member<&TerrainModel::ridge_spread>(), 0.0, 100.0, 0.0, 20.0, kLive, TerrainStage::filter},
    {kTerrain, "longest_wavelength", "m", "Longest wavelength",
     "Waves longer than this are left out; 0 means no limit.",
     member<&TerrainModel::longest_wavelength>(), 0.0, kMaxLength, 0.0, 10000.0, kLive,
     TerrainStage::filter},
    {kTerrain, "shortest_wavelength", "m", "Shortest wavelength",
     "Waves shorter than this are left out; 0 means no limit.",
     member<&TerrainModel::shortest_wavelength>(), 0.0, kMaxLength, 0.0, 100.0, kLive,
     TerrainStage::filter},
    {kTerrain, "anisotropy", "", "Anisotropy",
     "Ratio of the wavelengths across and along `direction` that have equal density: 1 is the same "
     "in all directions, higher values stretch the land across it.",
     member<&TerrainModel::anisotropy>(), 1.0, 100.0, 1.0, 5.0, kLive, TerrainStage::filter},
    {kTerrain, "direction", "deg", "Direction",
     "Direction in which the land is steepest, counter-clockwise from +x; without effect while "
     "anisotropy is 1.",
     member<&TerrainModel::direction>(), -360.0, 360.0, -180.0, 180.0, kLive, TerrainStage::filter},
    {kTerrain, "measured", "", "Measured spectrum",
     "File with the spectrum of real land, in place of beta, breaks and outer_scale: rings.csv of "
     "`ocean terrain fit`, or an elevation model (.asc, .flt); relative to the terrain file.",
     member<&TerrainModel::measured>(), 0, 0, 0, 0, kRebuild, TerrainStage::filter},

    {kTerrain, "origin", "m", "Origin",
     "Where the south-west corner of a placed land lies: [EAST, NORTH]; empty means [0, 0].",
     member<&TerrainModel::origin>(), -1e8, 1e8, -10000.0, 10000.0, kRebuild, TerrainStage::shape,
     OptionalColumns{.max_length = 2, .neutral = "[]"}},
    {kTerrain, "size", "m", "Size",
     "Sides of a placed land, [EAST, NORTH]; empty means patch_size both ways, or the sides of the "
     "base.",
     member<&TerrainModel::size>(), 1.0, kMaxLength, 100.0, 100000.0, kRebuild, TerrainStage::shape,
     OptionalColumns{.max_length = 2, .neutral = "[]"}},
    {kTerrain, "island", "m", "Island",
     "Height that a placed land loses from its middle to its border, in a straight line, so that "
     "a sea surrounds it; 0 means none.",
     member<&TerrainModel::island>(), 0.0, 1e5, 0.0, 3000.0, kRebuild, TerrainStage::shape,
     OptionalColumns{.neutral = "0"}},
    {kTerrain, "base", "", "Base",
     "Elevation model (.asc, .flt) that is the placed land, relative to the terrain file; waves "
     "below its cell are added by its own measured spectrum.",
     member<&TerrainModel::base>(), 0, 0, 0, 0, kRebuild, TerrainStage::noise,
     OptionalColumns{.neutral = ""}},
    {kTerrain, "base_error", "m", "Base error",
     "Limit of the rms by which these waves move the samples of the base. Unset means a tenth of "
     "its rms slope times its cell.",
     member<&TerrainModel::base_error>(), 0.0, 1000.0, 0.0, 10.0, kRebuild, TerrainStage::shape},
    {kTerrain, "detail_wavelength", "m", "Detail wavelength",
     "Shortest wave below the cell of a placed land, added without repetition; 0 means none. Unset "
     "means a thirtieth of the cell of the base, without a base none.",
     member<&TerrainModel::detail_wavelength>(), 0.0, 1e5, 0.0, 10.0, kRebuild, TerrainStage::shape,
     OptionalColumns{.min_nonzero = 0.01}},

    {kLayer, "period", "m", "Period",
     "Side of the layer's square: patch_size divided by a whole number.",
     member<&TerrainModel::layers, &TerrainLayer::period>(), 0.01, kMaxLength, 10.0, 10000.0,
     kRebuild, TerrainStage::noise},
    {kLayer, "gain", "", "Gain", "Factor of the layer's amplitudes, relative to the first tile.",
     member<&TerrainModel::layers, &TerrainLayer::gain>(), 0.0, 100.0, 0.0, 2.0, kRebuild,
     TerrainStage::noise},
    {kLayer, "seed", "", "Seed", "Number that selects the layer's noise.",
     member<&TerrainModel::layers, &TerrainLayer::seed>(), 0.0, 4294967295.0, 0.0, 1000.0, kRebuild,
     TerrainStage::noise},

    {kGullies, "depth", "", "Gully depth",
     "Depth of gullies relative to their distance: stripes along the fall line, which shape slopes "
     "as rain does; 0 means none. The section alone means 0.055.",
     member<&TerrainModel::gullies, &GullySettings::depth>(), 0.0, 1.0, 0.0, 0.15, kRebuild,
     TerrainStage::filter, OptionalColumns{.neutral = "0"}},
    {kGullies, "longest", "m", "Gully distance",
     "Distance of the largest gullies. Waves of the land that are shorter fade out: gullies take "
     "their place.",
     member<&TerrainModel::gullies, &GullySettings::longest>(), 0.1, 1e6, 10.0, 5000.0, kRebuild,
     TerrainStage::filter, OptionalColumns{.neutral = "1500"}},
    {kGullies, "octaves", "", "Gully octaves",
     "Sizes of gullies, each half as large as the one before.",
     member<&TerrainModel::gullies, &GullySettings::octaves>(), 1, 12, 1, 10, kRebuild,
     TerrainStage::filter, OptionalColumns{.neutral = "6"}},
    {kGullies, "crease", "", "Crease", "Sharpness of the crests between gullies.",
     member<&TerrainModel::gullies, &GullySettings::crease>(), 0.0, 1.0, 0.0, 1.0, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "0.7"}},
    {kGullies, "flat", "", "Flat slope",
     "Slope at which gullies have half their depth: they fade out where the ground is flatter.",
     member<&TerrainModel::gullies, &GullySettings::flat>(), 0.001, 10.0, 0.02, 1.0, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "0.2"}},
    {kGullies, "seed", "", "Gully seed", "Number that selects one of many such gullies.",
     member<&TerrainModel::gullies, &GullySettings::seed>(), 0.0, 4294967295.0, 0.0, 1000.0,
     kRebuild, TerrainStage::shape, OptionalColumns{.neutral = "1"}},

    {kStream, "slope", "", "Stream slope",
     "Steady slope of hillslopes where the land rises fastest: streams cut a placed land until "
     "they carry away what rises; 0 means none. The section alone means 0.62.",
     member<&TerrainModel::stream, &StreamSettings::slope>(), 0.0, 10.0, 0.0, 2.0, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "0"}},
    {kStream, "exponent", "", "Area exponent",
     "Exponent by which the slope of a stream falls with the area that drains into it.",
     member<&TerrainModel::stream, &StreamSettings::exponent>(), 0.0, 1.0, 0.2, 0.7, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "0.45"}},
    {kStream, "hillslope_area", "m2", "Hillslope area",
     "Drained area at which hillslopes end and streams begin.",
     member<&TerrainModel::stream, &StreamSettings::hillslope_area>(), 1.0, 1e9, 1000.0, 100000.0,
     kRebuild, TerrainStage::shape, OptionalColumns{.neutral = "12000"}},
    {kStream, "max_slope", "", "Max slope", "Slope at which ground slides.",
     member<&TerrainModel::stream, &StreamSettings::max_slope>(), 0.01, 10.0, 0.3, 2.0, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "0.8"}},
    {kStream, "age", "", "Age",
     "Part of the time after which the last summit no longer rises: 1 is steady, lower values keep "
     "a plateau between young valleys.",
     member<&TerrainModel::stream, &StreamSettings::age>(), 0.001, 1.0, 0.05, 1.0, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "1"}},
    {kStream, "creep", "m", "Creep", "Reach of soil that creeps and rounds crests; 0 means none.",
     member<&TerrainModel::stream, &StreamSettings::creep>(), 0.0, 1000.0, 0.0, 200.0, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "55"}},
    {kStream, "seed", "", "Stream seed", "Number that selects one of many such networks.",
     member<&TerrainModel::stream, &StreamSettings::seed>(), 0.0, 4294967295.0, 0.0, 1000.0,
     kRebuild, TerrainStage::shape, OptionalColumns{.neutral = "1"}},

    {kCoast, "slope", "", "Beach slope",
     "Slope of the bed below sheltered beaches: shapes the shore of a placed land, beaches where "
     "it is sheltered and cliffs where it is exposed; 0 means none. The section alone means 1 in "
     "30.",
     member<&TerrainModel::coast, &ShorelineSettings::beach_slope>(), 0.0, 1.0, 0.0, 0.1, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "0"}},
    {kCoast, "level", "m", "Water level",
     "Height of the water that the shore is shaped for. Unset means that of the sea that floods "
     "it, alone 0.",
     member<&TerrainModel::coast_level>(), -1e5, 1e5, -100.0, 1000.0, kRebuild,
     TerrainStage::shape},
    {kCoast, "berm", "m", "Berm", "Height of a beach's berm over the water.",
     member<&TerrainModel::coast, &ShorelineSettings::berm>(), 0.0, 100.0, 0.0, 5.0, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "2.2"}},
    {kCoast, "face", "", "Beach face", "Slope of a beach at the water line.",
     member<&TerrainModel::coast, &ShorelineSettings::face>(), 0.001, 1.0, 0.02, 0.3, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "0.1"}},
    {kCoast, "closure", "m", "Closure depth", "Depth to which the slope of a beach reaches.",
     member<&TerrainModel::coast, &ShorelineSettings::closure>(), 0.1, 1000.0, 2.0, 20.0, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "9"}},
    {kCoast, "shelf", "m", "Shelf depth", "Depth of the shelf that the bed runs out into.",
     member<&TerrainModel::coast, &ShorelineSettings::shelf>(), 0.1, 10000.0, 10.0, 200.0, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "45"}},
    {kCoast, "smooth", "m", "Shore smoothing", "Length over which the shore line is smoothed.",
     member<&TerrainModel::coast, &ShorelineSettings::smooth>(), 0.0, 10000.0, 0.0, 200.0, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "40"}},
    {kCoast, "shelter", "m", "Shelter radius",
     "Radius in which land shelters a shore: bays get beaches, headlands cliffs.",
     member<&TerrainModel::coast, &ShorelineSettings::shelter>(), 1.0, 1e5, 50.0, 2000.0, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "450"}},
    {kCoast, "width", "m", "Beach width", "Width of a beach above the water.",
     member<&TerrainModel::coast, &ShorelineSettings::width>(), 0.0, 10000.0, 10.0, 400.0, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "130"}},
    {kCoast, "beaches", "", "Beaches",
     "How much less land around a shore suffices for a beach, as a share: 0 means beaches in bays "
     "alone, 0.2 cliffs at capes alone.",
     member<&TerrainModel::coast, &ShorelineSettings::beaches>(), 0.0, 1.0, 0.0, 0.3, kRebuild,
     TerrainStage::shape, OptionalColumns{.neutral = "0"}},
};
constexpr Table<TerrainModel> kTable{kTerrainKind, kSections, kRows};
static_assert(is_consistent(kTable));

}  // namespace

const Table<TerrainModel>& terrain_table() {
    return kTable;
}

void set_parameter(TerrainModel& terrain, std::string_view name, std::string_view text) {
    const RefOf<TerrainModel> ref = find_parameter(kTable, name);
    TerrainModel changed = terrain;
    assign(changed, ref, parse_value(*ref.info, ref.item, text));
    if (changed.measured != terrain.measured) changed.rings = nullptr;
    if (changed.base != terrain.base) changed.base_model = nullptr;
    terrain = std::move(changed);
}

std::string get_parameter(const TerrainModel& terrain, std::string_view name) {
    return to_text(value_of(terrain, find_parameter(kTable, name)));
}

const TerrainRow* switch_of(const TerrainRow& row) {
    if (!row.section.starts_with("terrain.") || row.in_list()) return nullptr;
    for (const TerrainRow& first : kTable.rows) {
        if (first.section == row.section) return &first;
    }
    return nullptr;
}

bool is_switched_off(const TerrainModel& terrain, const TerrainRow& row) {
    const TerrainRow* const first = switch_of(row);
    return first != nullptr && first->member.get(terrain, 0) == ParameterValue(0.0);
}

std::optional<TerrainStage> first_dirty_stage(const TerrainModel& before,
                                              const TerrainModel& after) {
    if (before.layers.size() != after.layers.size()) return TerrainStage::noise;
    std::optional<TerrainStage> first;
    if (before.rings != after.rings) first = TerrainStage::filter;
    if (before.base_model != after.base_model) first = TerrainStage::filter;
    for (const TerrainRow& row : kTable.rows) {
        if (first && *first <= row.dirties) continue;
        for (std::size_t item = 0; item < row.member.items(before); ++item) {
            if (row.member.get(before, item) != row.member.get(after, item)) first = row.dirties;
        }
    }
    return first;
}

}  // namespace ocean
