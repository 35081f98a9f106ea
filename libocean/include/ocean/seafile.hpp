// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sea files: strict reading, writing that round-trips, presets, and spectra of buoys and models.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/sea.hpp"
#include "ocean/spectrum_record.hpp"

namespace ocean {

/// The format version that this library reads and writes.
inline constexpr int kSeaFileVersion = 1;

/// Reads a sea file. A relative `file` is relative to it. Throws Error with
/// "PATH:LINE: section.key = VALUE: what is wrong; allowed: RANGE".
Sea read_sea(const std::string& path);
/// The same from text; `name` stands for the path in messages, `base_dir` is where a relative
/// `file` starts (empty: the current directory).
Sea parse_sea(std::string_view toml, const std::string& name, const std::string& base_dir);
/// Reads the record of each measured system that has none yet: after `file` or `record` was
/// assigned anew and `measured` reset. Throws as read_spectra and choose_record.
void resolve_records(Parameters& parameters, const std::string& base_dir);
/// The resolved sea as text: every key of the table, the chosen records inlined as
/// [waves.measured_record], which a reader takes before any `file`. parse_sea(write_sea(s)) gives
/// the same parameters in every bit. Throws Error invalid_value for a text that is not UTF-8.
std::string write_sea(const Sea& sea);

struct Preset {
    std::string name;
    std::string description;  // one line
    std::string toml;         // a whole sea file with comments
};
std::span<const Preset> presets();
/// Throws Error not_found naming the nearest.
const Preset& find_preset(std::string_view name);

/// All records of a spectrum file, in file order, whatever its format: it is recognised by content.
/// Throws Error bad_file "PATH:LINE: ...".
std::vector<SpectrumRecord> read_spectra(const std::string& path);
/// The record at `time` (ISO 8601): the nearest within 30 minutes; "" = the first. Throws Error
/// not_found that names the nearest.
const SpectrumRecord& choose_record(std::span<const SpectrumRecord> records, std::string_view time,
                                    const std::string& file);
/// JSON, one object a record: time, station, latitude, longitude, depth, significant_wave_height
/// [m], peak_period [s], mean_direction [degrees counter-clockwise from +x, travelling to]; null
/// where it is not known.
std::string records_json(std::span<const SpectrumRecord> records);

/// m0 [m^2] by the trapezoid over the listed frequencies, Tp [s] and mean direction [rad].
struct RecordSummary {
    double m0 = 0.0;
    double peak_period = 0.0;
    double mean_direction = 0.0;  // NaN without directions
};
RecordSummary summarize(const SpectrumRecord& record);

}  // namespace ocean
