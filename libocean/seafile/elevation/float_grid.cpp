// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Raw floats with a header: see float_grid.hpp.
#include "float_grid.hpp"

#include <bit>
#include <limits>
#include <span>
#include <utility>

#include "ocean/internal/elevation_rules.hpp"
#include "ocean/internal/line_reader.hpp"

namespace ocean::elevation {
namespace {

std::uint32_t swapped(std::uint32_t bits) {
    return bits >> 24 | (bits >> 8 & 0xFF00) | (bits << 8 & 0xFF0000) | bits << 24;
}

/// Converts floats of the file to heights, with NaN for a missing one.
void decode(std::span<float> row, const GridHeader& header) {
    const bool swap = header.little_endian != (std::endian::native == std::endian::little);
    for (float& height : row) {
        if (swap) height = std::bit_cast<float>(swapped(std::bit_cast<std::uint32_t>(height)));
        if (header.missing.matches(double{height}) || is_fill_value(double{height})) {
            height = std::numeric_limits<float>::quiet_NaN();
        }
    }
}

}  // namespace

GridHeader parse_float_header(std::string_view text, const std::string& name) {
    LineReader lines(text, name);
    GridHeaderReader header(name);
    while (lines.next_filled()) {
        std::string_view rest = lines.line();
        const std::string_view key = next_word(rest);
        if (!GridHeaderReader::knows(key)) continue;
        header.add(key, next_word(rest), lines.number());
    }
    return header.finish(lines.number());
}

ElevationModel read_float_grid(const GridHeader& header, std::istream& floats, std::uint64_t bytes,
                               const std::string& name, const std::string& crs,
                               const ElevationOptions& options) {
    require_sides(name, header.columns, header.rows);
    const auto columns = static_cast<std::size_t>(header.columns);
    const int rows = static_cast<int>(header.rows);
    const std::uint64_t needed = 4 * static_cast<std::uint64_t>(header.columns * header.rows) +
                                 static_cast<std::uint64_t>(header.skipped_bytes);
    if (bytes != needed) {
        throw text::error_at(ErrorKind::bad_file, name, 0,
                             "has " + std::to_string(bytes) + " bytes, its header says " +
                                 std::to_string(columns) + " x " + std::to_string(rows) +
                                 " floats, which are " + std::to_string(needed));
    }
    RawModel raw = make_raw_model(header, name, crs);
    raw.hint = "; or the byteorder of the header is wrong";
    if (!header.names_byte_order) {
        raw.model.notes.push_back("the header does not name the byte order; LSBFIRST is assumed");
    }
    floats.ignore(header.skipped_bytes);
    for (int row = 0; row < rows; ++row) {
        float* const heights =
            raw.model.heights.data() + static_cast<std::size_t>(rows - 1 - row) * columns;
        floats.read(reinterpret_cast<char*>(heights), static_cast<std::streamsize>(4 * columns));
        if (!floats)
            throw text::error_at(ErrorKind::bad_file, name, 0, "cannot be read to its end");
        decode({heights, columns}, header);
        if (options.progress && row % 64 == 0) options.progress(row, rows);
    }
    return finish(std::move(raw), name, options);
}

}  // namespace ocean::elevation
