// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// GeoTIFF's keys: see geo_keys.hpp. Numbers of keys and codes are those of the standard.
#include "geo_keys.hpp"

#include <cmath>
#include <optional>

namespace ocean::elevation {
namespace {

enum Key : std::uint16_t {
    kModelType = 1024,   // 1 projected, 2 geographic, 3 geocentric
    kRasterType = 1025,  // 1 pixel is area, 2 pixel is point
    kCitation = 1026,
    kGeographicSystem = 2048,
    kAngularUnits = 2054,
    kProjectedSystem = 3072,
    kProjectedCitation = 3073,
    kLinearUnits = 3076,
    kVerticalUnits = 4099,
};
constexpr std::uint16_t kDegree = 9102;
constexpr std::uint16_t kDirectoryLocation = 0;
constexpr std::uint16_t kTextsLocation = 34737;
constexpr std::uint16_t kMinCode = 1024;  // of EPSG
constexpr std::uint16_t kUserDefined = 32767;

class GeoKeys {
  public:
    explicit GeoKeys(const GeoTags& tags) : tags_(tags) {}

    /// Returns the value of a key that is one short integer.
    std::optional<std::uint16_t> code(Key key) const {
        const std::uint16_t* entry = find(key);
        if (entry == nullptr || entry[1] != kDirectoryLocation) return std::nullopt;
        return entry[3];
    }
    /// Returns the text of a key, without the bar that ends it.
    std::string text(Key key) const {
        const std::uint16_t* entry = find(key);
        if (entry == nullptr || entry[1] != kTextsLocation) return "";
        const std::size_t begin = entry[3], size = entry[2];
        if (begin > tags_.texts.size()) return "";
        std::string text = tags_.texts.substr(begin, size);
        while (!text.empty() && (text.back() == '|' || text.back() == '\0')) text.pop_back();
        return text;
    }

  private:
    /// Returns the four numbers of a key: key, location, count, value.
    const std::uint16_t* find(Key key) const {
        const std::vector<std::uint16_t>& all = tags_.directory;
        for (std::size_t i = 4; i + 4 <= all.size(); i += 4) {
            if (all[i] == key) return &all[i];
        }
        return nullptr;
    }

    const GeoTags& tags_;
};

std::optional<HeightUnit> unit_of(std::optional<std::uint16_t> code) {
    if (!code) return std::nullopt;
    switch (*code) {
        case 9001:
            return HeightUnit::metre;
        case 9002:
            return HeightUnit::foot;
        case 9003:
            return HeightUnit::us_survey_foot;
        default:
            throw RasterFault("has the unit EPSG:" + std::to_string(*code) +
                              "; allowed are metres, feet and US survey feet");
    }
}

/// Sets origin and cell by a scale and the point that one raster position is tied to.
void place_by_scale(const GeoTags& tags, double centre, RasterFacts& facts) {
    const double* tie = tags.tie_points.data();
    facts.cell = {tags.pixel_scale[0], tags.pixel_scale[1]};
    const double last_row = static_cast<double>(facts.rows - 1);
    facts.south_west_centre = {tie[3] + (centre - tie[0]) * facts.cell[0],
                               tie[4] - (last_row + centre - tie[1]) * facts.cell[1]};
    facts.has_place = true;
}

/// Sets origin and cell by the affine map x = a i + b j + d, y = e i + f j + h.
void place_by_matrix(const GeoTags& tags, double centre, RasterFacts& facts) {
    const std::vector<double>& m = tags.transformation;
    if (m[1] != 0.0 || m[4] != 0.0) {
        throw RasterFault("is turned against east and north; `gdalwarp` makes a grid of it");
    }
    facts.cell = {m[0], -m[5]};
    facts.south_west_centre = {m[3] + centre * m[0],
                               m[7] + (static_cast<double>(facts.rows - 1) + centre) * m[5]};
    facts.has_place = true;
}

void set_place(const GeoTags& tags, bool pixel_is_point, RasterFacts& facts) {
    const double centre = pixel_is_point ? 0.0 : 0.5;  // of the first pixel, in raster positions
    if (tags.transformation.size() >= 16) {
        place_by_matrix(tags, centre, facts);
    } else if (tags.pixel_scale.size() >= 2 && tags.tie_points.size() >= 6) {
        place_by_scale(tags, centre, facts);
    } else if (tags.tie_points.size() > 6) {
        throw RasterFault("is placed by control points; `gdalwarp` makes a grid of it");
    } else {
        return;
    }
    for (const double value :
         {facts.cell[0], facts.cell[1], facts.south_west_centre[0], facts.south_west_centre[1]}) {
        if (!std::isfinite(value)) throw RasterFault("has a georeference that is not finite");
    }
    if (!(facts.cell[0] > 0.0 && facts.cell[1] > 0.0)) {
        throw RasterFault("has rows from south to north, or mirrored; `gdalwarp` turns it");
    }
}

/// Returns true for the EPSG codes of UTM zones, whose unit is the metre.
bool is_utm(std::uint16_t code) {
    return (code > 32600 && code <= 32660) || (code > 32700 && code <= 32760) ||
           (code > 26900 && code <= 26923) || (code >= 25828 && code <= 25838);
}

void set_projected(const GeoKeys& keys, RasterFacts& facts) {
    facts.is_geographic = false;
    const std::optional<std::uint16_t> code = keys.code(kProjectedSystem);
    const bool has_code = code && *code >= kMinCode && *code < kUserDefined;
    const std::string citation = keys.text(kProjectedCitation);
    facts.crs = has_code           ? "EPSG:" + std::to_string(*code)
                : citation.empty() ? keys.text(kCitation)
                                   : citation;
    const std::optional<HeightUnit> unit = unit_of(keys.code(kLinearUnits));
    facts.metres_per_unit = metres_of(unit.value_or(HeightUnit::metre));
    if (!unit && !(has_code && is_utm(*code))) {
        facts.notes.push_back("the file does not name the unit of its cells; metres are assumed");
    }
}

void set_geographic(const GeoKeys& keys, RasterFacts& facts) {
    facts.is_geographic = true;
    const std::optional<std::uint16_t> code = keys.code(kGeographicSystem);
    const bool has_code = code && *code >= kMinCode && *code < kUserDefined;
    facts.crs = has_code ? "EPSG:" + std::to_string(*code) : keys.text(kCitation);
    const std::uint16_t unit = keys.code(kAngularUnits).value_or(kDegree);
    if (unit != kDegree) {
        throw RasterFault("has cells in the angle EPSG:" + std::to_string(unit) +
                          "; allowed are degrees");
    }
}

}  // namespace

void apply_geo_tags(const GeoTags& tags, RasterFacts& facts) {
    const GeoKeys keys(tags);
    set_place(tags, keys.code(kRasterType) == 2, facts);
    switch (keys.code(kModelType).value_or(0)) {
        case 1:
            set_projected(keys, facts);
            break;
        case 2:
            set_geographic(keys, facts);
            break;
        case 3:
            throw RasterFault("is in geocentric coordinates; `gdalwarp` makes a map of it");
        default:
            break;
    }
    facts.height_unit = unit_of(keys.code(kVerticalUnits));
}

}  // namespace ocean::elevation
