// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// SRTM tiles: see raster.hpp; the corner of a tile in its name: see elevation_import.hpp.
#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>

#include "ocean/internal/elevation_import.hpp"
#include "raster.hpp"

namespace ocean::elevation {
namespace {

struct TileSize {
    std::int64_t columns;
    std::int64_t rows;
};
/// Samples at 3 and 1 seconds of arc; of the latter also every second column, as beyond 50 degrees.
constexpr TileSize kTileSizes[] = {{1201, 1201}, {3601, 3601}, {1801, 3601}};
constexpr std::int16_t kVoid = -32768;

TileSize size_of(std::uint64_t bytes) {
    for (const TileSize& size : kTileSizes) {
        if (bytes == static_cast<std::uint64_t>(2 * size.columns * size.rows)) return size;
    }
    throw RasterFault(
        "has " + std::to_string(bytes) +
        " bytes; an SRTM tile has 1201 x 1201, 3601 x 3601 or 1801 x 3601 integers of "
        "2 bytes");
}

}  // namespace

void require_sides(std::int64_t columns, std::int64_t rows) {
    for (const std::int64_t side : {columns, rows}) {
        if (side >= kMinElevationSide && side <= kMaxElevationSide) continue;
        throw RasterFault("has " + std::to_string(columns) + " x " + std::to_string(rows) +
                          " cells; allowed: 2 .. 65536 along each side");
    }
}

void read_hgt(std::istream& stream, std::uint64_t bytes, const std::array<double, 2>& corner,
              const RasterReceiver& receiver) {
    const TileSize size = size_of(bytes);
    RasterFacts facts{.columns = size.columns,
                      .rows = size.rows,
                      .has_place = true,
                      .south_west_centre = corner,
                      .cell = {1.0 / static_cast<double>(size.columns - 1),
                               1.0 / static_cast<double>(size.rows - 1)},
                      .is_geographic = true,
                      .height_unit = 1.0,
                      .crs = "EPSG:4326",
                      .definition = {},
                      .notes = {}};
    receiver.begin(facts);
    std::vector<std::uint8_t> line(static_cast<std::size_t>(2 * size.columns));
    std::vector<float> row(static_cast<std::size_t>(size.columns));
    for (std::int64_t j = 0; j < size.rows; ++j) {
        stream.read(reinterpret_cast<char*>(line.data()),
                    static_cast<std::streamsize>(line.size()));
        if (!stream) throw RasterFault("cannot be read to its end");
        for (std::size_t i = 0; i < row.size(); ++i) {
            const auto height = static_cast<std::int16_t>(line[2 * i] << 8 | line[2 * i + 1]);
            row[i] = height == kVoid ? std::numeric_limits<float>::quiet_NaN()
                                     : static_cast<float>(height);
        }
        receiver.row(row);
    }
}

}  // namespace ocean::elevation

namespace ocean {

std::optional<std::array<double, 2>> corner_of_name(std::string_view name) {
    const auto degrees = [](std::string_view word, std::string_view letters, std::size_t digits,
                            double most) -> std::optional<double> {
        if (word.size() < digits + 1) return std::nullopt;
        const char letter = static_cast<char>(word[0] >= 'a' ? word[0] - 32 : word[0]);
        int value = 0;
        const char* const end = word.data() + 1 + digits;
        const auto [stop, error] = std::from_chars(word.data() + 1, end, value);
        const bool good =
            error == std::errc() && stop == end && letters.find(letter) != letters.npos;
        if (!good || value < 0 || value > most) return std::nullopt;
        return letter == letters[1] ? -value : value;
    };
    const auto north = degrees(name, "NS", 2, 90.0);
    const auto east = degrees(name.substr(std::min<std::size_t>(3, name.size())), "EW", 3, 180.0);
    if (!north || !east) return std::nullopt;
    return std::array{*east, *north};
}

}  // namespace ocean
