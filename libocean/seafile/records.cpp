// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Operations on the records of a spectrum file: chooses a record by time and place, summarises it,
// lists all.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/spreading.hpp"
#include "ocean/internal/utc_time.hpp"
#include "ocean/seafile.hpp"

namespace ocean {
namespace {

constexpr std::int64_t kTimeTolerance = 30;  // minutes
constexpr double kPlaceTolerance = 50.0;     // km
constexpr std::size_t kMaxWarnings = 50;     // for one file

struct Position {
    double latitude;
    double longitude;
};

/// Returns the distance along the great circle [km], by the haversine formula.
double distance_km(const Position& a, const Position& b) {
    constexpr double kEarthRadius = 6371.0;
    const double north = std::sin(0.5 * (b.latitude - a.latitude) * kDegree);
    const double east = std::sin(0.5 * (b.longitude - a.longitude) * kDegree);
    const double h = north * north +
                     std::cos(a.latitude * kDegree) * std::cos(b.latitude * kDegree) * east * east;
    return 2.0 * kEarthRadius * std::asin(std::min(1.0, std::sqrt(h)));
}

Position position_of(const SpectrumRecord& record) {
    return {record.latitude, record.longitude};
}

std::string position_text(const Position& position) {
    return fixed_text(position.latitude, 4) + "," + fixed_text(position.longitude, 4);
}

/// Parses "40.98,-71.12", with or without blanks around the numbers.
std::optional<Position> parse_position(std::string_view place) {
    const std::size_t comma = place.find(',');
    if (comma == std::string_view::npos) return std::nullopt;
    const auto number = [](std::string_view word) {
        const std::size_t first = std::min(word.find_first_not_of(' '), word.size());
        word.remove_prefix(first);
        return text::parse_number(word.substr(0, word.find_last_not_of(' ') + 1));
    };
    const std::optional<double> latitude = number(place.substr(0, comma));
    const std::optional<double> longitude = number(place.substr(comma + 1));
    const bool good = latitude && longitude && std::abs(*latitude) <= 90.0 &&
                      *longitude >= -180.0 && *longitude <= 360.0;
    return good ? std::optional(Position{*latitude, *longitude}) : std::nullopt;
}

using Candidates = std::vector<const SpectrumRecord*>;

Candidates at_station(const Candidates& records, const std::string& station,
                      const std::string& file) {
    Candidates chosen;
    std::vector<std::string_view> names;
    for (const SpectrumRecord* record : records) {
        if (record->station == station) chosen.push_back(record);
        const bool listed = std::find(names.begin(), names.end(), record->station) != names.end();
        if (!record->station.empty() && !listed && names.size() < 1000) {
            names.push_back(record->station);
        }
    }
    if (!chosen.empty()) return chosen;
    std::string message = "no station \"" + text::printable(station) + "\"";
    if (const std::string meant = did_you_mean(station, names); !meant.empty()) {
        message += text::printable(meant, 200);
    } else if (!names.empty()) {
        message += "; the first is " + text::printable(names.front());
    } else {
        message += "; its records have no station; a place may be LATITUDE,LONGITUDE";
    }
    throw text::error_at(ErrorKind::not_found, file, 0, message);
}

Candidates at_position(const Candidates& records, const Position& wanted, const std::string& file) {
    double least = std::numeric_limits<double>::infinity();
    Position nearest{};
    for (const SpectrumRecord* record : records) {
        if (std::isnan(record->latitude + record->longitude)) continue;
        const double distance = distance_km(position_of(*record), wanted);
        if (distance >= least) continue;
        least = distance;
        nearest = position_of(*record);
    }
    if (!(least <= kPlaceTolerance)) {
        throw text::error_at(
            ErrorKind::not_found, file, 0,
            "no record within 50 km of " + position_text(wanted) +
                (std::isinf(least) ? "; its records have no position"
                                   : "; the nearest is at " + position_text(nearest) + ", " +
                                         fixed_text(least, 0) + " km away"));
    }
    Candidates chosen;
    for (const SpectrumRecord* record : records) {
        if (record->latitude == nearest.latitude && record->longitude == nearest.longitude) {
            chosen.push_back(record);
        }
    }
    return chosen;
}

const SpectrumRecord& at_time(const Candidates& records, const std::string& time,
                              const std::string& file) {
    const std::optional<UtcTime> wanted = parse_utc_time(time);
    if (!wanted) {
        throw Error(ErrorKind::invalid_value, {.what = "is not a time",
                                               .parameter = "record",
                                               .value = "\"" + text::printable(time) + "\"",
                                               .allowed = "UTC like 2020-06-08T03:50"});
    }
    const SpectrumRecord* nearest = nullptr;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (const SpectrumRecord* record : records) {
        const std::optional<UtcTime> its = parse_utc_time(record->time);
        if (!its) continue;
        const std::int64_t distance = std::llabs(its->minutes() - wanted->minutes());
        if (distance < least) {
            least = distance;
            nearest = record;
        }
    }
    if (nearest != nullptr && least <= kTimeTolerance) return *nearest;
    throw text::error_at(ErrorKind::not_found, file, 0,
                         "no record within 30 minutes of " + wanted->text() +
                             (nearest != nullptr ? "; the nearest is " + nearest->time
                                                 : std::string("; its records have no time")));
}

/// Returns the width of a listed frequency in the trapezoid rule [Hz].
double trapezoid_weight(const SpectrumRecord& record, std::size_t i) {
    const std::vector<double>& f = record.frequency;
    const double below = i > 0 ? f[i] - f[i - 1] : 0.0;
    const double above = i + 1 < f.size() ? f[i + 1] - f[i] : 0.0;
    return 0.5 * (below + above);
}

/// Returns the first circular moment of one frequency; NaN if it is unknown.
std::complex<double> first_moment(const SpectrumRecord& record, std::size_t i) {
    if (record.has_moments()) return {record.a1[i], record.b1[i]};
    std::complex<double> sum = 0.0;
    double total = 0.0;
    const std::vector<double>& d = record.direction;
    for (std::size_t j = 0; j < d.size(); ++j) {
        const double before = j > 0 ? d[j - 1] : d.back() - 360.0;
        const double after = j + 1 < d.size() ? d[j + 1] : d.front() + 360.0;
        const double energy = record.directional_density[i * d.size() + j] * 0.5 * (after - before);
        sum += energy * std::polar(1.0, d[j] * kDegree);
        total += energy;
    }
    return sum / total;
}

std::string_view directions_name(const SpectrumRecord& record) {
    return record.has_moments() ? "moments" : record.is_directional() ? "full" : "none";
}

}  // namespace

const SpectrumRecord& choose_record(std::span<const SpectrumRecord> records,
                                    const RecordChoice& choice, const std::string& file) {
    if (records.empty()) throw text::error_at(ErrorKind::not_found, file, 0, "holds no record");
    Candidates candidates;
    for (const SpectrumRecord& record : records) candidates.push_back(&record);
    if (!choice.place.empty()) {
        const std::optional<Position> position = parse_position(choice.place);
        candidates = position ? at_position(candidates, *position, file)
                              : at_station(candidates, choice.place, file);
    }
    const auto other =
        std::find_if(candidates.begin(), candidates.end(),
                     [](const SpectrumRecord* record) { return record->fault.empty(); });
    // Without a requested time, the first usable record is chosen.
    if (choice.time.empty() && other != candidates.end()) return **other;
    const SpectrumRecord& chosen =
        choice.time.empty() ? *candidates.front() : at_time(candidates, choice.time, file);
    if (chosen.fault.empty()) return chosen;
    throw Error(ErrorKind::bad_file,
                chosen.fault + (other != candidates.end() && !(*other)->time.empty()
                                    ? "; a record that can be read is that of " + (*other)->time
                                    : std::string()));
}

RecordSummary summarize(const SpectrumRecord& record) {
    RecordSummary summary;
    double highest = 0.0;
    double m1 = 0.0;        // m^2 Hz
    double m_minus1 = 0.0;  // m^2 s
    double directed = 0.0;  // energy of bins whose direction is known
    std::complex<double> mean = 0.0;
    for (std::size_t i = 0; i < record.frequency.size(); ++i) {
        const double energy = record.density[i] * trapezoid_weight(record, i);
        summary.m0 += energy;
        m1 += energy * record.frequency[i];
        m_minus1 += energy / record.frequency[i];
        if (record.density[i] > highest) {
            highest = record.density[i];
            summary.peak_period = 1.0 / record.frequency[i];
        }
        if (!record.has_directions()) continue;
        const std::complex<double> c1 = first_moment(record, i);
        if (std::isnan(c1.real()) || !(energy > 0.0)) continue;
        mean += energy * c1;
        directed += energy;
    }
    // An energy of 1e-320 m^2 is above 0, but its first moment may be 0.
    if (summary.m0 > 0.0 && m1 > 0.0) {
        summary.energy_period = m_minus1 / summary.m0;
        summary.mean_period = summary.m0 / m1;
    }
    const bool known = mean != 0.0;
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    summary.mean_direction = known ? std::arg(mean) : unknown;
    summary.directional_spread =
        directed > 0.0 ? circular_spread(std::abs(mean) / directed) : unknown;
    return summary;
}

std::vector<std::string> records_warnings(std::span<const SpectrumRecord> records) {
    struct Said {
        std::string text;
        const SpectrumRecord* first;
        std::size_t count;
    };
    std::vector<Said> said;
    std::map<std::string, std::size_t> place;
    std::size_t left_out = 0;
    const auto say = [&](const std::string& text, const SpectrumRecord& record) {
        const auto [at, added] = place.try_emplace(text, said.size());
        if (!added) {
            ++said[at->second].count;
        } else if (said.size() < kMaxWarnings) {
            said.push_back({text, &record, 1});
        } else {
            place.erase(at);
            ++left_out;
        }
    };
    for (const SpectrumRecord& record : records) {
        for (const std::string& warning : record.warnings) say(warning, record);
        if (!record.fault.empty()) {
            say("cannot be read: " + record.fault, record);
        } else if (!record.has_directions()) {
            say("has no directions: its waves travel to the wind_direction of the wave "
                "system, by default 0, the east",
                record);
        }
    }
    std::vector<std::string> texts;
    for (const Said& one : said) {
        const std::string station = one.first->station.empty() ? "" : " " + one.first->station;
        const std::string who = records.size() == 1 ? "the record"
                                : one.count == 1    ? "record " + one.first->time + station
                                                    : std::to_string(one.count) + " of " +
                                                       std::to_string(records.size()) + " records";
        texts.push_back(who + ": " + one.text);
    }
    if (left_out > 0) texts.push_back(std::to_string(left_out) + " more warnings are left out");
    return texts;
}

std::string records_json(std::span<const SpectrumRecord> records) {
    JsonArray list(JsonLines{1});
    for (const SpectrumRecord& record : records) {
        if (!record.fault.empty()) continue;
        const RecordSummary summary = summarize(record);
        const double mean = summary.mean_direction / kDegree;
        JsonObject line;
        const auto number = [&line](std::string_view key, double value) {
            line.add(key, json_number_or_null(value, plain_text));
        };
        line.add("time", record.time).add("station", record.station);
        number("latitude", record.latitude);
        number("longitude", record.longitude);
        number("depth", record.depth);
        number("significant_wave_height", 4.0 * std::sqrt(summary.m0));
        number("peak_period", summary.peak_period);
        number("energy_period", summary.energy_period);
        number("mean_period", summary.mean_period);
        number("mean_direction", mean);
        number("coming_from", coming_from(mean));
        number("directional_spread", summary.directional_spread / kDegree);
        line.add("directions", directions_name(record));
        line.add("frequencies", record.frequency.size());
        line.add("warnings", json_array(record.warnings));
        list.add(line);
    }
    return list.text() + "\n";
}

}  // namespace ocean
