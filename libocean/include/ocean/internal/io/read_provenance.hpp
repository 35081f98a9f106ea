// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The header and provenance of a file of any format, which is recognised by its content instead of
// its name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ocean/internal/io/provenance.hpp"

namespace ocean::io {

/// Returns the header strings of an EXR, VDB, USD, PLY, OBJ or PNG file that libocean wrote;
/// nothing for a file of another kind, such as a sea file. Throws Error bad_file for a file of one
/// of these formats that is damaged or that another program wrote.
std::optional<std::vector<HeaderString>> read_header(const std::string& path);

/// Returns the provenance of a file; nothing for a file of another kind. Throws Error bad_file as
/// read_header does, and for a header that names no subject.
std::optional<Provenance> read_provenance(const std::string& path);

}  // namespace ocean::io
