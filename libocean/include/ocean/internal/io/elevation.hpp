// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes elevation models as raw floats: NAME.flt with its header NAME.hdr and the coordinate
// reference system NAME.prj, which GIS programs and read_elevation() read.
#pragma once

#include <string>

#include "ocean/internal/elevation.hpp"

namespace ocean::io {

/// Writes the three files; each of them is replaced as a whole. Holes become -9999. Throws Error
/// invalid_value unless `path` ends in ".flt", output if a file cannot be written.
void write_elevation(const ElevationModel& model, const std::string& path);

/// Returns the text of the .hdr file: the same numbers read back to the same domain.
std::string elevation_header(const ElevationModel& model);

/// Returns the text of the .prj file, WKT 1 in metres: the model's own definition if its lengths
/// are metres, else a local system named after the model's.
std::string elevation_projection(const ElevationModel& model);

/// Returns true if the file's header states that write_elevation wrote it.
bool is_written_elevation(const std::string& path);

}  // namespace ocean::io
