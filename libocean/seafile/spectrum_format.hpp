// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The definition of a spectrum format: its name, a function that recognises content, a function
// that reads it. A format is one file under formats/ and one line in the table of spectra.cpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/record_rules.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

/// No format reads more than this, so that a hostile file ends in an error instead of swap.
inline constexpr std::size_t kMaxSpectrumFileBytes = std::size_t{512} << 20;

/// Content to read, and access to further files that belong to it.
struct SpectrumSource {
    std::string_view content;
    std::string name;  // the path, for messages and for the names of companions
    /// Returns the unpacked content of another file by its path; nothing if the file does not
    /// exist.
    std::function<std::optional<std::string>(const std::string& path)> companion;
};

struct SpectrumFormat {
    std::string_view name;
    bool (*recognises)(std::string_view content);
    /// Returns the records. A record that cannot be read has its `fault` set and does not affect
    /// the others. Throws Error bad_file "NAME:LINE: ..." for a fault of the whole file.
    std::vector<SpectrumRecord> (*read)(const SpectrumSource& source);
};

extern const SpectrumFormat kNdbcRealtime;    // formats/ndbc_realtime.cpp
extern const SpectrumFormat kNdbcHistorical;  // formats/ndbc_historical.cpp
extern const SpectrumFormat kNdbcFiveDay;     // formats/ndbc_five_day.cpp
extern const SpectrumFormat kWavewatch;       // formats/wavewatch.cpp
extern const SpectrumFormat kSwan;            // formats/swan.cpp
extern const SpectrumFormat kSpotterCsv;      // formats/spotter_csv.cpp
extern const SpectrumFormat kSpotterJson;     // formats/spotter_json.cpp
extern const SpectrumFormat kDatawell;        // formats/datawell.cpp
extern const SpectrumFormat kTriaxys;         // formats/triaxys.cpp
extern const SpectrumFormat kAwac;            // formats/awac.cpp
extern const SpectrumFormat kObscape;         // formats/obscape.cpp
extern const SpectrumFormat kOctopus;         // formats/octopus.cpp
extern const SpectrumFormat kCsv;             // formats/csv.cpp

/// Calls `read`, and turns an Error bad_file that it throws into the `fault`, "NAME:LINE: ...", of
/// the record that it reads.
template <typename Read>
void catch_fault(std::string& fault, const Read& read) {
    try {
        read();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_file) throw;
        fault = error.what();
    }
}

/// Reads with one format. At least one spectrum must have no fault; faulty ones have `fault` set.
std::vector<SpectrumRecord> read_format(const SpectrumFormat& format, const SpectrumSource& source);
/// Reads spectra as read_spectra does, from content in memory.
std::vector<SpectrumRecord> read_spectra_from(const SpectrumSource& source);

}  // namespace ocean
