// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectra in tables with a record in each column or in each row, as pandas writes a DataFrame of
// densities. csv.cpp reads tables with one value in each row.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "spectrum_format.hpp"

namespace ocean::csv {

enum class WideShape {
    none,             // not such a table
    record_a_column,  // frequency, then a column for each record, whose title is its name or time
    record_a_row,     // time or place, then a column for each frequency, whose title is that in Hz
};

/// Recognises the shape by the titles of a table.
WideShape shape_of(std::span<const std::string> titles);
/// Throws Error bad_file. What the titles do not say is a warning of each record.
std::vector<SpectrumRecord> read_wide(const SpectrumSource& source, WideShape shape);

}  // namespace ocean::csv
