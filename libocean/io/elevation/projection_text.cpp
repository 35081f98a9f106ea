// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Coordinate reference systems as the text of a .prj file. Their definitions are in a database of
// thousands; the zones of UTM, which many elevation models have, follow from their number.
#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "ocean/internal/elevation_rules.hpp"
#include "ocean/io/elevation.hpp"
#include "ocean/text.hpp"

namespace ocean::io {
namespace {

/// The EPSG codes of the UTM zones of a datum: first_code + zone.
struct UtmZones {
    int first_code;
    int first_zone;
    int last_zone;
    bool is_south;
    std::string_view name;
    std::string_view geographic;  // its system of degrees, WKT 1
};

constexpr std::string_view kWgs84 =
    R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],)"
    R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";
constexpr std::string_view kNad83 =
    R"(GEOGCS["NAD83",DATUM["North_American_Datum_1983",SPHEROID["GRS 1980",6378137,298.257222101]],)"
    R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";
constexpr std::string_view kEtrs89 =
    R"(GEOGCS["ETRS89",DATUM["European_Terrestrial_Reference_System_1989",)"
    R"(SPHEROID["GRS 1980",6378137,298.257222101]],)"
    R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";

constexpr UtmZones kUtmZones[] = {
    {32600, 1, 60, false, "WGS 84", kWgs84},
    {32700, 1, 60, true, "WGS 84", kWgs84},
    {26900, 1, 23, false, "NAD83", kNad83},
    {25800, 28, 38, false, "ETRS89", kEtrs89},
};

std::optional<int> epsg_code(std::string_view crs) {
    if (!crs.starts_with("EPSG:")) return std::nullopt;
    crs.remove_prefix(5);
    int code = 0;
    const auto [end, error] = std::from_chars(crs.data(), crs.data() + crs.size(), code);
    if (error != std::errc() || end != crs.data() + crs.size()) return std::nullopt;
    return code;
}

/// Returns the definition of a UTM zone; "" for another code.
std::string utm_text(int code) {
    for (const UtmZones& zones : kUtmZones) {
        const int zone = code - zones.first_code;
        if (zone < zones.first_zone || zone > zones.last_zone) continue;
        return "PROJCS[\"" + std::string(zones.name) + " / UTM zone " + std::to_string(zone) +
               (zones.is_south ? "S" : "N") + "\"," + std::string(zones.geographic) +
               ",PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0]," +
               "PARAMETER[\"central_meridian\"," + std::to_string(6 * zone - 183) +
               "],PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\",500000]," +
               "PARAMETER[\"false_northing\"," + (zones.is_south ? "10000000" : "0") +
               "],UNIT[\"metre\",1],AUTHORITY[\"EPSG\",\"" + std::to_string(code) + "\"]]";
    }
    return "";
}

std::string local_text(std::string name) {
    std::ranges::replace(name, '"', '\'');
    return "LOCAL_CS[\"" + name + "\",UNIT[\"metre\",1]]";
}

}  // namespace

std::string elevation_projection(const ElevationModel& model) {
    const std::string name = elevation::crs_name(model.crs);
    if (model.was_degrees) {
        return local_text("metres from " + fixed_text(model.geographic_origin[1], 6) + " N, " +
                          fixed_text(model.geographic_origin[0], 6) + " E" +
                          (name.empty() ? "" : " of " + name));
    }
    if (const std::optional<int> code = epsg_code(model.crs)) {
        const std::string utm = utm_text(*code);
        return utm.empty() ? local_text(model.crs) : utm;
    }
    if (name.empty()) return local_text("metres");
    return elevation::is_geographic(model.crs) == false ? model.crs : local_text(name);
}

}  // namespace ocean::io
