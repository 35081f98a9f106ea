// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads elevation models from the two formats that need no library and that every GIS writes: ESRI
// ASCII grids (.asc) and raw floats (.flt with .hdr). `ocean terrain import` converts others.
#pragma once

#include <functional>
#include <istream>
#include <optional>
#include <string>

#include "ocean/internal/elevation.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

using HeightUnit = BedUnit;
using HeightSign = BedSign;  // down: a depth is positive
enum class HolePolicy {
    refuse,  // throw
    fill,    // see fill_holes()
    keep,    // NaN
};
enum class CellsInDegrees {
    automatic,  // by the coordinate reference system, else by the numbers of the header
    yes,
    no,
};

struct ElevationOptions {
    std::optional<HeightUnit> unit = {};  // default: the unit that the file states, else metres
    HeightSign sign = HeightSign::up;
    HolePolicy holes = HolePolicy::refuse;
    CellsInDegrees degrees = CellsInDegrees::automatic;
    /// West, south, east and north edges: cells whose centres lie within them are kept. They are
    /// places of the whole model [m], before a map that stretches the ground is scaled.
    std::optional<std::array<double, 4>> crop = {};
    bool crop_in_degrees = false;  // the edges are longitudes and latitudes
    /// Is called with the rows that have been read, now and then, on the calling thread. If it
    /// throws, the reader ends with that exception.
    std::function<void(int rows, int of_rows)> progress = {};
};

/// Reads an elevation model. Recognises .asc by its first word and .flt, or its .hdr, by its name.
/// Needs 4 bytes a cell, which are compared with the available memory before they are allocated.
/// Throws Error bad_file "PATH:LINE: ..." for a file that is not what it claims, has a side outside
/// kMinElevationSide .. kMaxElevationSide, heights beyond kMaxElevation or, with
/// HolePolicy::refuse, holes; invalid_value for a crop that leaves fewer than 2 x 2 cells;
/// unsupported for a format that `ocean terrain import` converts; out_of_memory.
ElevationModel read_elevation(const std::string& path, const ElevationOptions& options = {});

/// Reads the text of an ESRI ASCII grid. `name` stands for the path in messages, `crs` is the text
/// of the .prj file beside it. `bytes` is the size of the text. Throws as read_elevation.
ElevationModel parse_ascii_grid(std::istream& text, std::size_t bytes, const std::string& name,
                                const std::string& crs = "", const ElevationOptions& options = {});

}  // namespace ocean
