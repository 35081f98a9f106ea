// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Common parts of the tables of the National Data Buoy Center: see ndbc.hpp.
#include "ndbc.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "ocean/internal/utc_time.hpp"

namespace ocean::ndbc {
namespace {

int date_part(const LineReader& lines, std::string_view word) {
    constexpr std::string_view kWhat = "a whole number of a date";
    const double value = number(lines, word, kWhat);
    if (value != std::floor(value) || std::abs(value) > 9999.0) {
        throw lines.fail("'" + text::printable(word, 20) + "' is not " + std::string(kWhat));
    }
    return static_cast<int>(value);
}

/// Returns the value at a frequency. Tables print the same frequency alike: the tolerance is for
/// other digits of the same number.
double value_at(const std::vector<Bin>& bins, double frequency) {
    constexpr double kTolerance = 1e-6;  // Hz; bins lie 5e-3 apart
    const auto found =
        std::lower_bound(bins.begin(), bins.end(), frequency - kTolerance,
                         [](const Bin& bin, double wanted) { return bin.frequency < wanted; });
    const bool hit = found != bins.end() && found->frequency <= frequency + kTolerance;
    return hit ? found->value : kMissing;
}

/// Adds the directions. A bin that lacks one of the four quantities lacks all four moments.
void add_directions(SpectrumRecord& record, const Row& row, const Companions& companions) {
    std::array<const std::vector<Bin>*, kCompanions> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto found = companions[i].find({row.station, row.time});
        if (found == companions[i].end()) return;
        if (const std::string& fault = found->second.fault; !fault.empty()) {
            record.warnings.push_back("its directions are left out: " +
                                      text::printable(fault, 400));
            return;
        }
        rows[i] = &found->second.bins;
    }
    const auto travel = [](double alpha) {
        return travel_direction(alpha, DirectionConvention::from_nautical);
    };
    for (const double f : record.frequency) {
        append_mean_and_principal(record, travel(value_at(*rows[0], f)),
                                  travel(value_at(*rows[1], f)), value_at(*rows[2], f),
                                  value_at(*rows[3], f));
    }
    drop_unknown_moments(record);
}

}  // namespace

double number(const LineReader& lines, std::string_view word, std::string_view what) {
    const std::optional<double> value = text::parse_number(word);
    if (!value || !std::isfinite(*value)) {
        throw lines.fail("'" + text::printable(word, 20) + "' is not " + std::string(what));
    }
    return *value;
}

std::string next_time(const LineReader& lines, std::string_view& line, bool minutes) {
    UtcTime time;
    time.year = date_part(lines, next_word(line));
    if (time.year >= 0 && time.year < 100) time.year += 1900;  // written before 1999
    time.month = date_part(lines, next_word(line));
    time.day = date_part(lines, next_word(line));
    time.hour = date_part(lines, next_word(line));
    if (minutes) time.minute = date_part(lines, next_word(line));
    if (!time.valid()) throw lines.fail("the line does not begin with a date and time");
    return time.text();
}

double next_frequency(const LineReader& lines, std::string_view word,
                      const std::vector<Bin>& bins) {
    if (bins.size() == kMaxFrequencies) throw lines.fail("more than 4096 frequencies");
    const double frequency = number(lines, word, "a frequency");
    if (!(frequency >= 0.0 && frequency <= kMaxFrequency)) {
        throw lines.fail("a frequency of " + text::printable(word, 20) +
                         "; allowed: " + std::string(kFrequencyRange));
    }
    if (!bins.empty() && !(bins.back().frequency < frequency)) {
        throw lines.fail("the frequencies do not ascend at bin " + std::to_string(bins.size() + 1));
    }
    return frequency;
}

double value(const LineReader& lines, std::string_view word, Quantity quantity, double full) {
    if (word == "MM") return kMissing;
    const double value = number(lines, word, "a number");
    const auto require = [&](double low, double high, const std::string& what) {
        if (value >= low && value <= high) return value;
        throw lines.fail(what + ", not " + text::printable(word, 20));
    };
    if (value == 999.0) return kMissing;
    switch (quantity) {
        case Quantity::direction1:
        case Quantity::direction2:
            return require(0.0, 360.0, "directions are 0 .. 360 degrees");
        case Quantity::spread1:
        case Quantity::spread2:
            if (value == 99.0 && full < 99.0) return kMissing;
            return std::min(full, require(0.0, kMaxSpread * full,
                                          full > 1.0 ? "r1 and r2 are 0 .. 100 hundredths"
                                                     : "r1 and r2 are 0 .. 1"));
        case Quantity::density:
            break;
    }
    if (value == 99.0) return kMissing;
    return require(-1e6, 1e6, "densities are 0 .. 1e6 m^2/Hz");
}

Companion by_time(std::vector<Row> rows) {
    Companion companion;
    const bool lost =
        std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.time.empty(); });
    if (lost && !rows.empty()) throw Error(ErrorKind::bad_file, rows.front().fault);
    for (Row& row : rows) {
        if (row.time.empty()) continue;
        std::pair key{row.station, row.time};
        companion.emplace(std::move(key), std::move(row));
    }
    return companion;
}

std::optional<Companions> read_companions(
    const std::function<std::optional<std::vector<Row>>(Quantity)>& read) {
    Companions companions;
    for (std::size_t i = 0; i < companions.size(); ++i) {
        auto rows = read(static_cast<Quantity>(i + 1));
        if (!rows) return std::nullopt;
        companions[i] = by_time(*std::move(rows));
    }
    return companions;
}

std::string station_of(std::string_view stem) {
    constexpr std::string_view kFiveDays = "_5day";
    if (stem.ends_with(kFiveDays)) stem.remove_suffix(kFiveDays.size());
    std::size_t first = stem.size();
    while (first > 0 && std::isalnum(static_cast<unsigned char>(stem[first - 1])) != 0) --first;
    return text::printable(stem.size() - first == 5 ? stem.substr(first) : stem);
}

std::vector<SpectrumRecord> make_records(const std::string& station, const std::vector<Row>& rows,
                                         const std::optional<Companions>& companions) {
    std::vector<SpectrumRecord> records;
    for (const Row& row : rows) {
        SpectrumRecord record;
        record.station = row.station.empty() ? station : row.station;
        record.time = row.time;
        record.fault = row.fault;
        if (!row.warning.empty()) record.warnings.push_back(row.warning);
        for (const Bin& bin : row.bins) {
            if (std::isnan(bin.value)) continue;  // no density: as if the bin were not listed
            record.frequency.push_back(bin.frequency);
            record.density.push_back(bin.value);
        }
        if (record.fault.empty() && record.frequency.size() < 2) continue;  // nothing was measured
        if (companions) add_directions(record, row, *companions);
        records.push_back(std::move(record));
    }
    return records;
}

}  // namespace ocean::ndbc
