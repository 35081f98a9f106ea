// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What to do with the records of a spectrum file: choose one by time, sum one up, list all.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "json_text.hpp"
#include "ocean/error.hpp"
#include "ocean/grid.hpp"
#include "ocean/seafile.hpp"
#include "text.hpp"
#include "utc_time.hpp"

namespace ocean {
namespace {

constexpr std::int64_t kRecordTolerance = 30;  // minutes

/// Width that the trapezoid rule gives to one of the listed frequencies, Hz.
double trapezoid_weight(const SpectrumRecord& record, std::size_t i) {
    const std::vector<double>& f = record.frequency;
    const double below = i > 0 ? f[i] - f[i - 1] : 0.0;
    const double above = i + 1 < f.size() ? f[i + 1] - f[i] : 0.0;
    return 0.5 * (below + above);
}

}  // namespace

const SpectrumRecord& choose_record(std::span<const SpectrumRecord> records, std::string_view time,
                                    const std::string& file) {
    if (records.empty()) throw text::error_at(ErrorKind::not_found, file, 0, "holds no record");
    if (time.empty()) return records.front();
    const std::optional<UtcTime> wanted = parse_utc_time(time);
    if (!wanted) {
        throw Error(ErrorKind::invalid_value,
                    "record = \"" + text::printable(time) +
                        "\": is not a time; allowed: UTC like 2020-06-08T03:50");
    }
    const SpectrumRecord* nearest = nullptr;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (const SpectrumRecord& record : records) {
        const std::optional<UtcTime> its = parse_utc_time(record.time);
        if (!its) continue;
        const std::int64_t distance = std::llabs(its->minutes() - wanted->minutes());
        if (distance < least) {
            least = distance;
            nearest = &record;
        }
    }
    if (nearest != nullptr && least <= kRecordTolerance) return *nearest;
    throw text::error_at(ErrorKind::not_found, file, 0,
                         "no record within 30 minutes of " + wanted->text() +
                             (nearest != nullptr ? "; the nearest is " + nearest->time
                                                 : std::string("; its records have no time")));
}

RecordSummary summarize(const SpectrumRecord& record) {
    RecordSummary summary;
    double highest = 0.0;
    double east = 0.0;  // energy-weighted mean of the first moments
    double north = 0.0;
    for (std::size_t i = 0; i < record.frequency.size(); ++i) {
        const double energy = record.density[i] * trapezoid_weight(record, i);
        summary.m0 += energy;
        if (record.density[i] > highest) {
            highest = record.density[i];
            summary.peak_period = 1.0 / record.frequency[i];
        }
        if (!record.has_directions() || std::isnan(record.a1[i])) continue;
        east += energy * record.a1[i];
        north += energy * record.b1[i];
    }
    const bool directed = east != 0.0 || north != 0.0;
    summary.mean_direction =
        directed ? std::atan2(north, east) : std::numeric_limits<double>::quiet_NaN();
    return summary;
}

std::string records_json(std::span<const SpectrumRecord> records) {
    std::string out = "[";
    for (const SpectrumRecord& record : records) {
        const RecordSummary summary = summarize(record);
        out += out.size() > 1 ? ",\n " : "\n ";
        out += "{\"time\": " + json_string(record.time);
        out += ", \"station\": " + json_string(record.station);
        out += ", \"latitude\": " + json_number(record.latitude);
        out += ", \"longitude\": " + json_number(record.longitude);
        out += ", \"depth\": " + json_number(record.depth);
        out += ", \"significant_wave_height\": " + json_number(4.0 * std::sqrt(summary.m0));
        out += ", \"peak_period\": " + json_number(summary.peak_period);
        out += ", \"mean_direction\": " + json_number(summary.mean_direction * (180.0 / kPi)) + "}";
    }
    return out + "\n]\n";
}

}  // namespace ocean
