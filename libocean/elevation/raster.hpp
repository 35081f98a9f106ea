// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rasters of heights as their readers report them, facts first, then rows; and the bytes by which a
// child process sends them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <istream>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "ocean/internal/child_process.hpp"
#include "ocean/internal/elevation_rules.hpp"

namespace ocean::elevation {

/// The fault of a file, in words that follow its name: "has 3 bands".
struct RasterFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct RasterFacts {
    std::int64_t columns = 0;
    std::int64_t rows = 0;
    bool has_place = false;  // the file states origin and cell
    std::array<double, 2> south_west_centre{};
    std::array<double, 2> cell{1.0, 1.0};
    std::optional<bool> is_geographic;
    double metres_per_unit = 1.0;                  // of the horizontal coordinates
    std::array<double, 2> ground_scale{1.0, 1.0};  // see RawModel
    std::optional<double> height_unit;             // [m]
    std::array<double, 2> sample_scale{1.0, 0.0};
    bool rows_from_south = false;
    double full_scale = 0.0;  // of images: the value of white, 0 for heights in a unit
    std::string crs;
    std::string definition;  // of the system, in WKT 1
    std::vector<std::string> notes;
};

/// Receives a raster. A row has RasterFacts::columns values, NaN where a height is missing; the
/// first one lies in the north unless rows_from_south.
struct RasterReceiver {
    std::function<void(const RasterFacts&)> begin;
    std::function<void(std::span<const float>)> row;
};

/// The sides that a reader accepts; the program checks them again. Throws RasterFault.
void require_sides(std::int64_t columns, std::int64_t rows);

/// Reads an SRTM tile (.hgt) of `bytes` bytes whose south-west sample lies at `corner` [degrees
/// east, degrees north]: big-endian integers of 16 bits over one degree by one, without a header.
/// The size gives the sides. Throws RasterFault.
void read_hgt(std::istream& stream, std::uint64_t bytes, const std::array<double, 2>& corner,
              const RasterReceiver& receiver);

/// Reads the channel of an OpenEXR image whose name says height: `height` or `elevation`, else Z,
/// Y, `depth` or R, else the only one; never alpha. Throws RasterFault, also if several may be
/// meant and differ. Is called in a child process.
void read_exr(const std::string& path, const RasterReceiver& receiver);

// ---- A raster, or a fault, as bytes for a pipe between two processes. The reading side trusts no
// byte, because a hostile file may control the writing side.

/// Runs `read` with a receiver that writes to the sink, then a fault if it throws one.
void encode(const std::function<void(const RasterReceiver&)>& read, const sandbox::Sink& sink);

/// Returns the facts that `encode` wrote. Throws as decode.
RasterFacts decode_facts(const sandbox::Source& source);

/// Calls the receiver with what `encode` wrote: as many rows as the facts announce. Throws
/// RasterFault if the other side sent one, sandbox::WireError for invalid bytes.
void decode(const sandbox::Source& source, const RasterReceiver& receiver);

}  // namespace ocean::elevation
