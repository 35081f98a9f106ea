// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules of spectrum records, which every reader keeps and every consumer relies on.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "ocean/parameters.hpp"

namespace ocean {

inline constexpr std::size_t kMaxFrequencies = 4096;
inline constexpr std::size_t kMaxDirections = 720;
/// A missing value.
inline constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
/// The range reaches from waves of a day to capillaries, so that periods stay finite.
inline constexpr double kMinFrequency = 1e-5;  // [Hz]
inline constexpr double kMaxFrequency = 100.0;
inline constexpr std::string_view kFrequencyRange = "1e-5 .. 100 Hz";
/// Max number of values (frequencies times directions) in one record, about 2 MB as text in a sea
/// file.
inline constexpr std::size_t kMaxDirectionalValues = std::size_t{1} << 17;
inline constexpr std::size_t kMaxRecords = 100000;
inline constexpr std::size_t kMaxRecordWarnings = 16;
inline constexpr std::size_t kMaxRecordWarningBytes = 500;

/// Removes artefacts of estimators that no sea has, before record_fault judges the record: a bin of
/// 0 Hz, and densities from -kMaxNoise of the peak to 0. These become 0; the other densities of
/// their frequency shrink to keep its energy, and all shrink to keep m0. Adds a warning with the
/// amount removed. Frequencies must ascend already.
void clean_record(SpectrumRecord& record);
/// Negative densities down to this share of the highest density count as noise; lower ones are a
/// fault.
inline constexpr double kMaxNoise = 0.1;

/// Returns the fault of a record as the end of a sentence; empty for a good one. Every consumer of
/// records relies on these rules: at least two ascending positive frequencies, finite densities
/// that are not negative, all moments or none, each within the unit circle or missing.
std::string record_fault(const SpectrumRecord& record);
/// Throws Error bad_file with the first fault if every record has one.
void require_readable(std::span<const SpectrumRecord> records);

}  // namespace ocean
