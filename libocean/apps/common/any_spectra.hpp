// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectrum files as the `ocean` command reads them: all formats of ocean::seafile, and those that
// need a library which libocean.so does without.
#pragma once

#include <string>
#include <vector>

#include "ocean/spectrum_record.hpp"

namespace ocean::app {

/// An ocean::SpectrumReader. Throws Error bad_file.
std::vector<SpectrumRecord> read_any_spectra(const std::string& path);

/// "41010, 2020-06-08T03:50 UTC, 28.878 N 78.485 W": what is known of it.
std::string origin_text(const SpectrumRecord& record);

}  // namespace ocean::app
