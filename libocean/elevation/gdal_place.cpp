// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Place, system and units of a raster by GDAL and PROJ: see gdal_place.hpp.
#include <cpl_conv.h>
#include <cpl_string.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "gdal_place.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::elevation {
namespace {

struct SystemDeleter {
    void operator()(void* system) const { OSRDestroySpatialReference(system); }
};
using System = std::unique_ptr<void, SystemDeleter>;

constexpr double kFoot = 0.3048, kUsFoot = 1200.0 / 3937.0;
/// Units by the letters of their names, in lower case, between blanks.
constexpr std::pair<std::string_view, double> kUnits[] = {
    {" m ", 1.0},
    {" ft internationalfoot ", kFoot},
    {" usft ftus sft ussurveyfoot ussurveyfeet usfoot usfeet footus footussurvey ", kUsFoot},
    {" km kilometre kilometer ", 1000.0},
    {" dm decimetre decimeter ", 0.1},
    {" cm centimetre centimeter ", 0.01},
    {" mm millimetre millimeter ", 0.001},
    {" fathom fathoms ", 1.8288},
};

/// Returns a length with all of its digits where PROJ's table has fewer.
double exact_unit(double metres) {
    for (const double exact : {1.0, kFoot, kUsFoot}) {
        if (std::abs(metres / exact - 1.0) < 1e-12) return exact;
    }
    return metres;
}

/// Returns the length of a unit [m] by its name, 0 for none, nothing for an unknown one.
std::optional<double> unit_of(std::string_view name) {
    std::string key;
    for (const char c : name) {
        const char small = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
        if (small >= 'a' && small <= 'z') key += small;
    }
    if (key.empty() || key == "unknown" || key == "none") return 0.0;
    for (const auto& [names, metres] : kUnits) {
        if (names.find(" " + key + " ") != names.npos) return metres;
    }
    // "metres above the geoid"
    if (key.starts_with("metre") || key.starts_with("meter")) return 1.0;
    if (key.starts_with("foot") || key.starts_with("feet")) return kFoot;
    return std::nullopt;
}

/// Sets the unit of the heights: that of the band, else that of the vertical system.
void set_height_unit(GDALDatasetH dataset, OGRSpatialReferenceH system, RasterFacts& facts) {
    if (system != nullptr && OSRIsVertical(system) != 0) {
        facts.height_unit = exact_unit(OSRGetTargetLinearUnits(system, "VERT_CS", nullptr));
    }
    const std::string name = GDALGetRasterUnitType(GDALGetRasterBand(dataset, 1));
    const std::optional<double> unit = unit_of(name);
    if (unit == 0.0) return;
    if (!unit) {
        facts.notes.push_back("the file states the unit '" + text::printable(name, 40) +
                              "' for its heights, which is not known; without --unit they are " +
                              (facts.height_unit ? "in that of its vertical system" : "metres"));
        return;
    }
    if (facts.height_unit && std::abs(*unit / *facts.height_unit - 1.0) > 1e-9) {
        facts.notes.push_back("the vertical system of the file has a unit of " +
                              shortest_text(*facts.height_unit) + " m and its band one of " +
                              shortest_text(*unit) + " m, which is taken");
    }
    facts.height_unit = unit;
}

void set_grid(GDALDatasetH dataset, const std::optional<GridWindow>& window, RasterFacts& facts) {
    double g[6];  // x = g0 + i g1 + j g2, y = g3 + i g4 + j g5 of the corners of pixels
    if (GDALGetGeoTransform(dataset, g) != CE_None) {
        if (GDALGetGCPCount(dataset) == 0) return;
        throw RasterFault("is placed by control points; `gdalwarp` makes a grid of it");
    }
    if (g[2] != 0.0 || g[4] != 0.0) {
        throw RasterFault("is turned against east and north; `gdalwarp` makes a grid of it");
    }
    for (const double value : {g[0], g[1], g[3], g[5]}) {
        if (!std::isfinite(value)) throw RasterFault("has a georeference that is not finite");
    }
    if (!(g[1] > 0.0) || g[5] == 0.0) throw RasterFault("is mirrored; `gdalwarp` turns it");
    facts.has_place = true;
    facts.rows_from_south = g[5] > 0.0;
    facts.cell = {g[1], std::abs(g[5])};
    const auto column = static_cast<double>(window ? window->west : 0);
    const auto row = static_cast<double>(window ? window->south : 0);
    const auto rows = static_cast<double>(GDALGetRasterYSize(dataset));
    facts.south_west_centre = {
        g[0] + (column + 0.5) * g[1],
        g[3] + (facts.rows_from_south ? row + 0.5 : rows - 1.0 - row + 0.5) * g[5]};
}

/// Returns the place of a longitude and a latitude [degrees] on the ellipsoid, from its centre [m].
std::array<double, 3> geocentric(OGRSpatialReferenceH degrees, double longitude, double latitude) {
    constexpr double kRadians = std::numbers::pi / 180.0;
    const double a = OSRGetSemiMajor(degrees, nullptr);
    const double inverse = OSRGetInvFlattening(degrees, nullptr);
    const double f = inverse > 0.0 ? 1.0 / inverse : 0.0, e2 = f * (2.0 - f);
    const double sine = std::sin(latitude * kRadians), cosine = std::cos(latitude * kRadians);
    const double normal = a / std::sqrt(1.0 - e2 * sine * sine);
    return {normal * cosine * std::cos(longitude * kRadians),
            normal * cosine * std::sin(longitude * kRadians), normal * (1.0 - e2) * sine};
}

struct TransformationDeleter {
    void operator()(void* transformation) const {
        OCTDestroyCoordinateTransformation(
            static_cast<OGRCoordinateTransformationH>(transformation));
    }
};

/// The ground at a place of a map.
struct GroundPlace {
    std::array<double, 2> degrees{};  // east, north
    std::array<double, 2> lengths{};  // of a unit of the map to the east and to the north [m]
};

/// Returns the ground at a share of the map from its south-west to its north-east cell, by the
/// longitudes and latitudes of that cell's neighbours; nothing for a place that lies nowhere.
std::optional<GroundPlace> ground_at(OGRSpatialReferenceH system, const RasterFacts& facts,
                                     const std::array<double, 2>& share) {
    const System degrees(OSRCloneGeogCS(system));
    if (!degrees) return std::nullopt;
    OSRSetAxisMappingStrategy(degrees.get(), OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<void, TransformationDeleter> transformation(
        OCTNewCoordinateTransformation(system, degrees.get()));
    const auto [width, height] = facts.cell;
    const double east =
        facts.south_west_centre[0] + share[0] * static_cast<double>(facts.columns - 1) * width;
    const double north =
        facts.south_west_centre[1] + share[1] * static_cast<double>(facts.rows - 1) * height;
    double x[] = {east - width, east + width, east, east, east};
    double y[] = {north, north, north - height, north + height, north};
    int done[5] = {};
    if (!transformation ||
        OCTTransformEx(static_cast<OGRCoordinateTransformationH>(transformation.get()), 5, x, y,
                       nullptr, done) == 0) {
        return std::nullopt;
    }
    GroundPlace ground{.degrees = {x[4], y[4]}};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto one = geocentric(degrees.get(), x[2 * axis], y[2 * axis]);
        const auto other = geocentric(degrees.get(), x[2 * axis + 1], y[2 * axis + 1]);
        ground.lengths[axis] = std::hypot(other[0] - one[0], other[1] - one[1], other[2] - one[2]) /
                               (2.0 * facts.cell[axis]);
    }
    return ground;
}

/// Returns true if the area for which a system was made has the place, or is not known.
bool is_in_its_area(OGRSpatialReferenceH system, const std::array<double, 2>& degrees) {
    double west = 0.0, south = 0.0, east = 0.0, north = 0.0;
    const auto has_area = [&](OGRSpatialReferenceH of) {
        return OSRGetAreaOfUse(of, &west, &south, &east, &north, nullptr) != 0 && west >= -180.0;
    };
    if (!has_area(system)) {
        // A part of a system with heights has lost it.
        const char* const authority = OSRGetAuthorityName(system, nullptr);
        const char* const code = OSRGetAuthorityCode(system, nullptr);
        if (authority == nullptr || code == nullptr || authority != std::string_view("EPSG")) {
            return true;
        }
        const System named(OSRNewSpatialReference(nullptr));
        if (OSRImportFromEPSG(named.get(), std::atoi(code)) != OGRERR_NONE) return true;
        if (!has_area(named.get())) return true;
    }
    const bool in_longitudes = west <= east ? degrees[0] >= west && degrees[0] <= east
                                            : degrees[0] >= west || degrees[0] <= east;
    return in_longitudes && degrees[1] >= south && degrees[1] <= north;
}

/// Sets how long the cells are on the ground, where a map stretches it by more than 1 %.
void set_ground_scale(OGRSpatialReferenceH system, RasterFacts& facts) {
    constexpr double kMaxStretch = 0.01;
    if (!facts.has_place) return;
    const std::optional<GroundPlace> centre = ground_at(system, facts, {0.5, 0.5});
    if (!centre) return;
    std::array<double, 2> scale{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        scale[axis] = centre->lengths[axis] / facts.metres_per_unit;
        if (!(scale[axis] > 1e-3 && scale[axis] < 1e3)) return;
    }
    const bool is_stretched =
        std::max(std::abs(scale[0] - 1.0), std::abs(scale[1] - 1.0)) > kMaxStretch;
    if (is_stretched && is_in_its_area(system, centre->degrees)) {
        facts.ground_scale = scale;
    } else if (is_stretched) {
        facts.notes.push_back(
            "the map lies outside the area of its system, at " + fixed_text(centre->degrees[1], 2) +
            " N, " + fixed_text(centre->degrees[0], 2) + " E, where a metre of it is " +
            significant_text(scale[0], 4) + " x " + significant_text(scale[1], 4) +
            " m on the ground; its cells are not scaled");
    }
    double least = 1.0, most = 1.0;
    for (const int corner : {0, 1, 2, 3}) {
        const auto ground = ground_at(system, facts, {corner / 2 * 1.0, corner % 2 * 1.0});
        for (std::size_t axis = 0; ground && axis < 2; ++axis) {
            least = std::min(least, ground->lengths[axis] / centre->lengths[axis]);
            most = std::max(most, ground->lengths[axis] / centre->lengths[axis]);
        }
    }
    if (least >= 1.0 - kMaxStretch && most <= 1.0 + kMaxStretch) return;
    facts.notes.push_back("the length of a cell on the ground is " + significant_text(least, 3) +
                          " .. " + significant_text(most, 3) +
                          " times that at the centre of the map, which all cells have here");
}

std::string exported(OGRSpatialReferenceH system) {
    constexpr const char* kOptions[] = {"FORMAT=WKT1_GDAL", "MULTILINE=NO", nullptr};
    char* text = nullptr;
    const bool good = OSRExportToWktEx(system, &text, kOptions) == OGRERR_NONE && text != nullptr;
    std::string wkt = good ? text : "";
    CPLFree(text);
    return wkt;
}

void set_system(OGRSpatialReferenceH given, RasterFacts& facts) {
    if (OSRIsGeocentric(given) != 0) {
        throw RasterFault("is in geocentric coordinates; `gdalwarp` makes a map of it");
    }
    const System system(OSRClone(given));
    OSRStripVertical(system.get());
    OSRDemoteTo2D(system.get(), nullptr);
    OSRSetAxisMappingStrategy(system.get(), OAMS_TRADITIONAL_GIS_ORDER);
    const char* const authority = OSRGetAuthorityName(system.get(), nullptr);
    const char* const code = OSRGetAuthorityCode(system.get(), nullptr);
    const char* const name = OSRGetName(system.get());
    if (authority != nullptr && code != nullptr) {
        facts.crs = std::string(authority) + ":" + code;
    } else if (name != nullptr && name != std::string_view("unknown")) {
        facts.crs = name;
    }
    facts.is_geographic = OSRIsGeographic(system.get()) != 0;
    if (*facts.is_geographic) {
        constexpr double kDegree = std::numbers::pi / 180.0;
        char* unit = nullptr;
        const double angle = OSRGetAngularUnits(system.get(), &unit);
        if (std::abs(angle / kDegree - 1.0) < 1e-9) return;
        throw RasterFault("has cells in the angle '" + text::printable(unit, 40) +
                          "'; allowed are degrees");
    }
    facts.metres_per_unit = exact_unit(OSRGetLinearUnits(system.get(), nullptr));
    facts.definition = exported(system.get());
    if (OSRIsProjected(system.get()) != 0) set_ground_scale(system.get(), facts);
}

}  // namespace

void set_place(GDALDatasetH dataset, const std::optional<GridWindow>& window, RasterFacts& facts) {
    set_grid(dataset, window, facts);
    const OGRSpatialReferenceH system = GDALGetSpatialRef(dataset);
    if (system != nullptr) set_system(system, facts);
    set_height_unit(dataset, system, facts);
}

}  // namespace ocean::elevation
