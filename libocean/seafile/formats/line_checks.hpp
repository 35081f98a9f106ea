// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks that several readers of spectra share, with one sentence each: numbers within limits,
// fields of a line, frequencies and directions, and the size of a file.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/csv_rows.hpp"
#include "ocean/internal/directional_record.hpp"
#include "ocean/internal/line_reader.hpp"
#include "spectrum_format.hpp"

namespace ocean {

/// The max of values in all records of a file: a word as short as SWAN's ZERO may stand for a whole
/// spectrum.
inline constexpr std::size_t kMaxFileValues = std::size_t{1} << 26;
/// Max density of a bin, so that no sum over the circle exceeds the limit of a record: 1e6 m^2/Hz.
inline constexpr double kMaxBinDensity = 2500.0;  // [m^2/Hz/degree]

/// "key = value"; the key is the whole text without a sign of equality.
struct Entry {
    std::string_view key;
    std::string_view value;
};
inline Entry split_entry(std::string_view text) {
    const std::size_t sign = std::min(text.find('='), text.size());
    return {trimmed(text.substr(0, sign)), trimmed(text.substr(std::min(sign + 1, text.size())))};
}

// All functions below throw Error bad_file at the reader's line.

/// Returns the number within [low, high] that all of `word` spells. `what` names it: "a density".
double number_within(const LineReader& lines, std::string_view word, double low, double high,
                     std::string_view what);
/// Returns the fields of the line, which must be `count`; `than` names them: "the 6 numbers of a
/// frequency", or begins with their noun: "values than the 36 directions".
std::vector<std::string_view> exact_fields(const LineReader& lines, std::size_t count,
                                           const std::string& than);

/// Appends a frequency [Hz], which must be higher than those before.
void append_frequency(const LineReader& lines, double frequency, std::vector<double>& frequencies);
/// Returns the axis of a file's bins of direction.
DirectionAxis direction_axis(const LineReader& lines, std::span<const double> degrees,
                             DirectionConvention convention);
/// Checks the size of a spectrum over frequency and direction.
void require_directional_size(const LineReader& lines, std::size_t values);
/// Checks that another record of `values_of_each` values fits into the limits of a file.
void require_room(const LineReader& lines, std::size_t records, std::size_t values_of_each = 0);

/// Reads by a class whose objects read one source.
template <typename Reader>
std::vector<SpectrumRecord> read_by(const SpectrumSource& source) {
    return Reader(source).read();
}

}  // namespace ocean
