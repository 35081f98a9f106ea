// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What every reader of spectra keeps to and every consumer of records relies on.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "ocean/spectrum_record.hpp"

namespace ocean {

inline constexpr std::size_t kMaxFrequencies = 4096;
inline constexpr std::size_t kMaxDirections = 720;
/// A value that a file does not have.
inline constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
/// Waves of a day to capillaries: periods stay finite.
inline constexpr double kMinFrequency = 1e-5;  // Hz
inline constexpr double kMaxFrequency = 100.0;
inline constexpr std::string_view kFrequencyRange = "1e-5 .. 100 Hz";
/// Of one record: frequencies times directions, some 2 MB as text in a sea file.
inline constexpr std::size_t kMaxDirectionalValues = std::size_t{1} << 17;
inline constexpr std::size_t kMaxRecords = 100000;
inline constexpr std::size_t kMaxRecordWarnings = 16;
inline constexpr std::size_t kMaxRecordWarningBytes = 500;

/// Takes from a record what estimators leave in it and no sea has, before record_fault judges it: a
/// bin of 0 Hz, and densities below 0 down to kMostNoise of the peak. Those count as 0; the others
/// of their frequency shrink by as much as keeps its energy, and all shrink to keep m0. Adds a
/// warning with how much it was. Frequencies ascend already.
void clean_record(SpectrumRecord& record);
/// Of the highest density: what lies further below 0 is no noise.
inline constexpr double kMostNoise = 0.1;

/// What is wrong with a record, as the end of a sentence; empty for a good one. The rules that
/// every consumer of records relies on: at least two ascending positive frequencies, finite
/// densities that are not negative, all moments or none, each within the unit circle or missing.
std::string record_fault(const SpectrumRecord& record);
/// Throws Error bad_file with the first fault if every record has one.
void require_readable(std::span<const SpectrumRecord> records);

}  // namespace ocean
