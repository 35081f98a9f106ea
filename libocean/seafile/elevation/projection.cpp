// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The few facts that a grid needs from the text of a coordinate reference system: degrees or
// lengths, and the length of the unit. The reader knows WKT 1, as in .prj files, the LENGTHUNIT of
// WKT 2, and ArcInfo's lines "Projection UTM", "Units METERS".
#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "ocean/internal/elevation_rules.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean::elevation {
namespace {

constexpr std::size_t kMaxProjectionBytes = 65536;

std::string upper_case(std::string_view text) {
    std::string upper(text);
    std::ranges::transform(upper, upper.begin(), [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return upper;
}

bool names_any_of(std::string_view text, std::initializer_list<std::string_view> keywords) {
    return std::ranges::any_of(keywords, [&](std::string_view keyword) {
        return text.find(keyword) != std::string_view::npos;
    });
}

/// Returns the word after a keyword of ArcInfo's lines: "METERS" for "Units".
std::string_view word_after(std::string_view text, std::string_view keyword) {
    const std::size_t at = text.find(keyword);
    if (at == std::string_view::npos) return {};
    text.remove_prefix(at + keyword.size());
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    return text.substr(0, text.find_first_of(" \t;"));
}

/// Returns the number after the name of a unit: 0.3048 for `UNIT["foot",0.3048]` at `at`.
double factor_at(std::string_view wkt, std::size_t at) {
    const std::size_t open = wkt.find('"', at);
    const std::size_t close = open == wkt.npos ? open : wkt.find('"', open + 1);
    const std::size_t comma = close == wkt.npos ? close : wkt.find(',', close);
    if (comma == wkt.npos) return 1.0;
    std::string_view digits = wkt.substr(comma + 1);
    digits = digits.substr(0, digits.find_first_of(",]"));
    while (digits.starts_with(' ')) digits.remove_prefix(1);
    while (digits.ends_with(' ')) digits.remove_suffix(1);
    const double factor = text::parse_number(digits).value_or(1.0);
    return factor > 1e-6 && factor < 1e6 ? factor : 1.0;
}

/// Returns the position of a UNIT[ that belongs to the PROJCS or LOCAL_CS itself, not to its parts.
std::size_t own_unit(std::string_view wkt) {
    const std::size_t begin = std::min(wkt.find("PROJCS["), wkt.find("LOCAL_CS["));
    if (begin == wkt.npos) return wkt.npos;
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = wkt.find('[', begin); i < wkt.size(); ++i) {
        if (wkt[i] == '"') quoted = !quoted;
        if (quoted) continue;
        if (depth == 1 && wkt.substr(i).starts_with("UNIT[")) return i;
        if (wkt[i] == '[') ++depth;
        if (wkt[i] == ']' && --depth == 0) break;
    }
    return wkt.npos;
}

}  // namespace

std::string read_projection(const std::string& path) {
    for (const char* extension : {".prj", ".PRJ"}) {
        std::filesystem::path beside = utf8_path(path);
        beside.replace_extension(extension);
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(beside, ignored)) continue;
        std::string line = text::read_file(text::to_utf8(beside), kMaxProjectionBytes);
        std::ranges::replace_if(
            line, [](char c) { return c == '\r' || c == '\n' || c == '\t'; }, ' ');
        line.erase(line.find_last_not_of(' ') + 1);
        return text::printable(line, kMaxProjectionBytes);
    }
    return "";
}

std::string crs_name(const std::string& crs) {
    const std::size_t bracket = crs.find('[');
    const std::size_t open = bracket == crs.npos ? bracket : crs.find('"', bracket);
    const std::size_t close = open == crs.npos ? open : crs.find('"', open + 1);
    if (close == crs.npos) return text::printable(crs, 60);
    return text::printable(std::string_view(crs).substr(open + 1, close - open - 1), 80);
}

std::string without_local_names(const std::string& crs) {
    if (!crs.starts_with("LOCAL_CS[")) return crs;
    const std::string name = crs_name(crs);
    if (name == "metres") return "";
    return name.starts_with("EPSG:") ? name : crs;
}

std::optional<bool> is_geographic(const std::string& crs) {
    const std::string text = upper_case(crs);
    if (names_any_of(text, {"PROJCS[", "PROJCRS[", "PROJECTEDCRS[", "LOCAL_CS[", "ENGCRS["})) {
        return false;
    }
    if (names_any_of(text, {"GEOGCS[", "GEOGCRS[", "GEODCRS[", "GEODETICCRS[", "GEOGRAPHICCRS["})) {
        return true;
    }
    const std::string_view projection = word_after(text, "PROJECTION");
    if (projection.empty()) return std::nullopt;
    return projection == "GEOGRAPHIC";
}

bool is_mercator(const std::string& crs) {
    return names_any_of(upper_case(crs), {"PROJECTION[\"MERCATOR", "PROJECTION[\"POPULAR_VISUAL",
                                          "METHOD[\"MERCATOR", "METHOD[\"POPULAR VISUAL"});
}

double metres_per_unit(const std::string& crs) {
    const std::string text = upper_case(crs);
    if (const std::size_t own = own_unit(text); own != text.npos) return factor_at(text, own);
    if (names_any_of(text, {"PROJCRS[", "PROJECTEDCRS[", "ENGCRS["})) {
        const std::size_t last = text.rfind("LENGTHUNIT[");
        return last == text.npos ? 1.0 : factor_at(text, last);
    }
    const std::string_view units = word_after(text, "UNITS");
    if (units == "FEET") return 1200.0 / 3937.0;  // ArcInfo's feet are those of the US survey
    return 1.0;
}

}  // namespace ocean::elevation
