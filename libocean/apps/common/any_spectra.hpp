// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The reader of spectrum files for the `ocean` command: all formats of ocean::seafile, and those
// that need a library which libocean.so does not link.
#pragma once

#include <string>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean::app {

/// Returns the records of a file; an ocean::SpectrumReader. Throws Error bad_file.
std::vector<SpectrumRecord> read_any_spectra(const std::string& path);

/// Returns the known station, time and position: "41010, 2020-06-08T03:50 UTC, 28.878 N 78.485 W".
std::string origin_text(const SpectrumRecord& record);

}  // namespace ocean::app
