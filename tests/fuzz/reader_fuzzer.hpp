// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What every reader of spectra must do with any bytes: give records that keep the promises of
// record_fault or say why they do not, or throw one Error; all of it safe to print. Anything else
// is a finding. A form feed ends the file and begins the next of its companions.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/seafile.hpp"
#include "require.hpp"
#include "spectrum_format.hpp"

namespace ocean::fuzz {

inline void check(const SpectrumRecord& record) {
    require(record.warnings.size() <= kMaxRecordWarnings);
    for (const std::string& warning : record.warnings) {
        check_message(warning);
        require(warning.size() <= kMaxRecordWarningBytes);
    }
    if (!record.fault.empty()) {
        check_message(record.fault);
        require(record.frequency.empty() && record.density.empty());
        return;
    }
    require(record_fault(record).empty());
    const RecordSummary summary = summarize(record);
    require(std::isfinite(summary.m0) && summary.m0 >= 0.0);
    require(std::isfinite(summary.peak_period) && summary.peak_period >= 0.0);
    require(std::isfinite(summary.energy_period) && summary.energy_period >= 0.0);
    require(std::isfinite(summary.mean_period) && summary.mean_period >= 0.0);
    require(std::isnan(summary.mean_direction) || std::abs(summary.mean_direction) < 4.0);
    require(std::isnan(summary.directional_spread) || summary.directional_spread < 1.5);
}

inline void check_all(const std::vector<SpectrumRecord>& records) {
    for (const SpectrumRecord& record : records) check(record);
    records_json(records);
    for (const std::string& warning : records_warnings(records)) check_message(warning);
    const auto readable = [](const SpectrumRecord& record) { return record.fault.empty(); };
    require(std::any_of(records.begin(), records.end(), readable));
    try {
        const RecordChoice choice{records.back().time, ""};
        require(choose_record(records, choice, "fuzz").frequency.size() >= 2);
    } catch (const Error& error) {
        require(!std::all_of(records.begin(), records.end(), readable));
        check_message(error.what());
    }
}

/// `files`: the name of the file and of its companions, if its format has some.
inline void run_reader(const SpectrumFormat& format, const std::vector<std::string>& files,
                       const std::uint8_t* data, std::size_t size) {
    std::string_view bytes(reinterpret_cast<const char*>(data), size);
    std::vector<std::string_view> parts;
    for (std::size_t i = 0; i < files.size(); ++i) {
        parts.push_back(bytes.substr(0, i + 1 < files.size() ? bytes.find('\f') : bytes.size()));
        bytes.remove_prefix(std::min(parts.back().size() + 1, bytes.size()));
    }
    const auto companion = [&](const std::string& path) -> std::optional<std::string> {
        const auto found = std::find(files.begin() + 1, files.end(), path);
        if (found == files.end()) return std::nullopt;
        const std::string_view part = parts[static_cast<std::size_t>(found - files.begin())];
        if (part.empty()) return std::nullopt;
        return std::string(part);
    };
    format.recognises(parts[0]);
    try {
        check_all(read_format(format, {parts[0], files[0], companion}));
    } catch (const Error& error) {
        check_message(error.what());
    }
}

}  // namespace ocean::fuzz
