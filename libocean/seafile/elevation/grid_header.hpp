// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The header of ESRI grids: the keys at the start of .asc files and in .hdr files, and the keys of
// the raster headers (BIL) that GDAL and ArcGIS write beside .flt files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "ocean/internal/elevation_rules.hpp"

namespace ocean::elevation {

/// A header without contradictions.
struct GridHeader {
    std::int64_t columns = 0;
    std::int64_t rows = 0;
    std::array<double, 2> south_west_centre{};  // in the file's units
    std::array<double, 2> cell{};
    MissingMark missing;
    bool little_endian = true;
    bool names_byte_order = false;
    std::int64_t skipped_bytes = 0;
};

/// Collects the keys and values of a header, each at its line.
class GridHeaderReader {
  public:
    /// `name` stands for the file's path in messages and must outlive the reader.
    explicit GridHeaderReader(const std::string& name) : name_(name) {}

    /// Returns true for a key of a grid's header, in any case.
    static bool knows(std::string_view key);
    /// Adds a key of `knows` with its value. Throws Error bad_file for a repeated key and for a
    /// value that is not a number or word of the key.
    void add(std::string_view key, std::string_view value, std::size_t line);
    /// Returns the header. Throws Error bad_file, at `line`, for missing keys, and for rasters that
    /// are not one band of 32-bit floats.
    GridHeader finish(std::size_t line) const;

  private:
    struct Value {
        double number;
        std::string word;
        std::size_t line;
    };

    const Value* find(std::string_view key) const;
    std::optional<double> number(std::initializer_list<std::string_view> keys) const;
    std::array<double, 2> cell(std::size_t line) const;
    double origin(std::size_t axis, const GridHeader& header, std::size_t line) const;
    void require_floats(const GridHeader& header) const;

    const std::string& name_;
    std::map<std::string, Value, std::less<>> values_;
};

/// Returns a model of the header with heights to be filled in, in the system of a .prj file. Throws
/// as make_domain and allocate_heights.
RawModel make_raw_model(const GridHeader& header, const std::string& name, const std::string& crs);

/// Returns the number that a word of a GIS spells, with a decimal point or comma; NaN for "nan" and
/// for the "1.#QNAN" of Windows; nothing for another word.
std::optional<double> grid_number(std::string_view word);

}  // namespace ocean::elevation
