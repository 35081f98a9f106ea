// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Keys and values of ESRI grids: see grid_header.hpp.
#include "grid_header.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::elevation {
namespace {

constexpr std::array<std::string_view, 21> kNumberKeys = {
    "ncols",  "nrows", "xllcorner", "xllcenter", "yllcorner",    "yllcenter",     "cellsize",
    "dx",     "dy",    "xdim",      "ydim",      "ulxmap",       "ulymap",        "nodata_value",
    "nodata", "nbits", "nbands",    "skipbytes", "bandrowbytes", "totalrowbytes", "bandgapbytes"};
constexpr std::array<std::string_view, 3> kWordKeys = {"byteorder", "pixeltype", "layout"};

/// Returns the one spelling for keys with several spellings.
std::string key_of(std::string_view word) {
    std::string key = lower_case(word);
    if (key == "xllcentre" || key == "yllcentre") key.replace(4, 5, "enter");
    if (key == "nodata_value" || key == "nodatavalue") return "nodata";
    return key;
}

bool is_number_key(std::string_view key) {
    return std::ranges::find(kNumberKeys, key) != kNumberKeys.end();
}

bool is_whole(double value) {
    return value == std::floor(value) && std::abs(value) <= 1e15;
}

}  // namespace

std::optional<double> grid_number(std::string_view word) {
    if (word.find('#') != word.npos) {
        const std::string lower = lower_case(word);
        const bool is_nan = lower.find(".#qnan") != lower.npos || lower.find(".#ind") != lower.npos;
        if (is_nan) return std::numeric_limits<double>::quiet_NaN();
    }
    if (const std::optional<double> value = text::parse_number(word)) return value;
    const std::size_t comma = word.find(',');
    if (comma == word.npos || word.find('.') != word.npos) return std::nullopt;
    std::string spelled(word);
    spelled[comma] = '.';
    return text::parse_number(spelled);
}

RawModel make_raw_model(const GridHeader& header, const std::string& name, const std::string& crs) {
    RawModel raw;
    raw.model.domain =
        make_domain(name, header.columns, header.rows, header.south_west_centre, header.cell);
    allocate_heights(raw.model, name);
    raw.model.crs = crs;
    raw.is_geographic = is_geographic(crs);
    raw.metres_per_unit = metres_per_unit(crs);
    return raw;
}

bool GridHeaderReader::knows(std::string_view word) {
    const std::string key = key_of(word);
    return is_number_key(key) || std::ranges::find(kWordKeys, key) != kWordKeys.end();
}

void GridHeaderReader::add(std::string_view word, std::string_view value, std::size_t line) {
    const std::string key = key_of(word);
    const auto fail = [&](const std::string& message) {
        return text::error_at(ErrorKind::bad_file, name_, line, message);
    };
    if (find(key) != nullptr) throw fail("the key " + key + " is repeated");
    const std::optional<double> number = is_number_key(key) ? grid_number(value) : 0.0;
    if (!number || (!std::isfinite(*number) && key != "nodata")) {
        throw fail(key + " = '" + text::printable(value, 30) + "'; allowed is a number");
    }
    const bool is_count = key.starts_with('n') && key != "nodata";
    if (is_count && !is_whole(*number)) {
        throw fail(key + " = " + text::printable(value, 30) + "; allowed is a whole number");
    }
    values_[key] = {*number, lower_case(value), line};
}

const GridHeaderReader::Value* GridHeaderReader::find(std::string_view key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? nullptr : &found->second;
}

std::optional<double> GridHeaderReader::number(std::initializer_list<std::string_view> keys) const {
    for (const std::string_view key : keys) {
        if (const Value* value = find(key)) return value->number;
    }
    return std::nullopt;
}

std::array<double, 2> GridHeaderReader::cell(std::size_t line) const {
    const std::optional<double> both = number({"cellsize"});
    const std::optional<double> x = both ? both : number({"dx", "xdim"});
    const std::optional<double> y = both ? both : number({"dy", "ydim"});
    if (!x || !y) {
        throw text::error_at(ErrorKind::bad_file, name_, line,
                             "the header lacks the size of a cell (cellsize)");
    }
    return {*x, *y};
}

/// Returns a coordinate of the centre of the south-west cell.
double GridHeaderReader::origin(std::size_t axis, const GridHeader& header,
                                std::size_t line) const {
    const std::string letter(1, axis == 0 ? 'x' : 'y');
    if (const auto centre = number({letter + "llcenter"})) return *centre;
    if (const auto corner = number({letter + "llcorner"})) return *corner + 0.5 * header.cell[axis];
    // ulxmap and ulymap state the centre of the north-west cell.
    if (const auto upper = number({axis == 0 ? "ulxmap" : "ulymap"})) {
        return axis == 0 ? *upper : *upper - header.cell[1] * static_cast<double>(header.rows - 1);
    }
    throw text::error_at(ErrorKind::bad_file, name_, line,
                         "the header lacks " + letter + "llcorner or " + letter + "llcenter");
}

/// Throws for rasters that are not one band of 32-bit floats.
void GridHeaderReader::require_floats(const GridHeader& header) const {
    const auto require = [&](std::string_view key, bool good, const std::string& allowed) {
        const Value* value = find(key);
        if (value == nullptr || good) return;
        const bool is_word = !is_number_key(key);
        throw text::error_at(ErrorKind::bad_file, name_, value->line,
                             std::string(key) + " = " +
                                 (is_word ? "'" + text::printable(value->word, 30) + "'"
                                          : shortest_text(value->number)) +
                                 "; allowed: " + allowed);
    };
    require("nbits", number({"nbits"}) == 32.0, "32, the bits of a float");
    require("nbands", number({"nbands"}) == 1.0, "1");
    const Value* type = find("pixeltype");
    require("pixeltype", type != nullptr && type->word.starts_with("float"), "FLOAT");
    const double row_bytes = 4.0 * static_cast<double>(header.columns);
    for (const std::string_view key : {"bandrowbytes", "totalrowbytes"}) {
        require(key, number({key}) == row_bytes, shortest_text(row_bytes) + ", 4 for each column");
    }
    const double skipped = number({"skipbytes"}).value_or(0.0);
    require("skipbytes", is_whole(skipped) && skipped >= 0.0, "a whole number of at least 0");
    const Value* order = find("byteorder");
    constexpr std::array<std::string_view, 4> kOrders = {"lsbfirst", "i", "msbfirst", "m"};
    require("byteorder",
            order != nullptr && std::ranges::find(kOrders, order->word) != kOrders.end(),
            "LSBFIRST, MSBFIRST");
}

GridHeader GridHeaderReader::finish(std::size_t line) const {
    for (const std::string_view key : {"ncols", "nrows"}) {
        if (find(key) != nullptr) continue;
        throw text::error_at(ErrorKind::bad_file, name_, line,
                             "the header lacks " + std::string(key));
    }
    GridHeader header;
    header.columns = static_cast<std::int64_t>(number({"ncols"}).value());
    header.rows = static_cast<std::int64_t>(number({"nrows"}).value());
    header.cell = cell(line);
    header.south_west_centre = {origin(0, header, line), origin(1, header, line)};
    if (const Value* missing = find("nodata")) {
        header.missing = {missing->number, rounding_of(missing->word)};
    }
    require_floats(header);
    header.skipped_bytes = static_cast<std::int64_t>(number({"skipbytes"}).value_or(0.0));
    if (const Value* order = find("byteorder")) {
        header.names_byte_order = true;
        header.little_endian = order->word == "lsbfirst" || order->word == "i";
    }
    return header;
}

}  // namespace ocean::elevation
