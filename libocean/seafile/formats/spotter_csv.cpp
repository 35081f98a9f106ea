// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The CSV that the dashboard of Spotter buoys offers for download. A header line names the columns,
// padded with blanks; each line after it is one spectrum. These of its columns are read:
//   Epoch Time                          seconds since 1970, UTC
//   Latitude (deg), Longitude (deg)
//   f_0 f_1 ...                         centres of the bins, Hz
//   varianceDensity_0 ...               m^2/Hz
//   a1_0 ... b1_0 ... a2_0 ... b2_0 ... moments of the travel direction, from east
//   direction_0 ... directionalSpread_0 ...   degrees, coming from; if moments are missing
// A minus sign alone is a missing value: the buoy reports spectra in one of its modes only.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "line_checks.hpp"
#include "ocean/internal/utc_time.hpp"
#include "spotter.hpp"

namespace ocean {
namespace {

using spotter::Quantity;

constexpr std::string_view kTime = "Epoch Time";
constexpr std::string_view kLatitude = "Latitude (deg)";
constexpr std::string_view kLongitude = "Longitude (deg)";
/// All quantities of all bins, and some hundred beside.
constexpr std::size_t kMaxColumns = (spotter::kQuantities + 2) * kMaxFrequencies;
constexpr std::size_t kNone = kMaxColumns + 1;

/// "varianceDensity_12": a quantity and its bin.
struct BinColumn {
    Quantity quantity;
    std::size_t bin;
};

std::optional<std::size_t> parse_bin(std::string_view digits) {
    if (digits.empty() || digits.size() > 4) return std::nullopt;
    std::size_t bin = 0;
    for (const char c : digits) {
        if (c < '0' || c > '9') return std::nullopt;
        bin = 10 * bin + static_cast<std::size_t>(c - '0');
    }
    return bin < kMaxFrequencies ? std::optional(bin) : std::nullopt;
}

std::optional<BinColumn> parse_bin_column(std::string_view title) {
    const std::size_t line = title.rfind('_');
    if (line == std::string_view::npos) return std::nullopt;
    const std::string_view name = title.substr(0, line);
    const std::optional<std::size_t> bin = parse_bin(title.substr(line + 1));
    const auto found =
        std::find(spotter::kNames.begin(), spotter::kNames.end(), name == "f" ? "frequency" : name);
    if (!bin || name == "frequency" || found == spotter::kNames.end()) return std::nullopt;
    return BinColumn{static_cast<Quantity>(found - spotter::kNames.begin()), *bin};
}

class SpotterCsvReader {
  public:
    explicit SpotterCsvReader(const SpectrumSource& source) : lines_(source.content, source.name) {}

    std::vector<SpectrumRecord> read() {
        read_header();
        std::vector<SpectrumRecord> records;
        std::size_t values = 0;
        while (lines_.next_filled()) {
            SpectrumRecord record;
            spotter::Bins bins;
            catch_fault(record.fault, [&] {
                fields_ = exact_fields(lines_, width_, "fields than the header line has columns");
                describe(record);
                bins = read_bins();
                const std::string fault = spotter::fault(bins);
                if (!fault.empty()) throw lines_.fail(fault);
            });
            if (record.fault.empty() && !spotter::has_spectrum(bins)) continue;
            require_room(lines_, records.size());
            values += 6 * bins[0].size();
            if (values > kMaxFileValues) {
                throw lines_.fail("more than 67108864 values over all records");
            }
            if (record.fault.empty()) spotter::set_spectrum(record, bins);
            records.push_back(std::move(record));
        }
        return records;
    }

  private:
    void read_header() {
        if (!lines_.next_filled()) throw lines_.fail("the header line is missing");
        const auto titles = csv::fields_of(lines_, ',', kMaxColumns);
        width_ = titles.size();
        if (width_ > kMaxColumns) throw lines_.fail("more than 40960 columns");
        for (std::size_t i = 0; i < width_; ++i) {
            if (titles[i] == kTime) place(time_, i, titles[i]);
            if (titles[i] == kLatitude) place(latitude_, i, titles[i]);
            if (titles[i] == kLongitude) place(longitude_, i, titles[i]);
            if (const auto column = parse_bin_column(titles[i])) {
                auto& places = places_[static_cast<std::size_t>(column->quantity)];
                if (places.size() <= column->bin) places.resize(column->bin + 1, kNone);
                place(places[column->bin], i, titles[i]);
            }
        }
        check_columns();
    }
    void place(std::size_t& column, std::size_t i, std::string_view title) const {
        if (column != kNone) {
            throw lines_.fail("the column " + text::printable(title, 40) + " appears twice");
        }
        column = i;
    }
    void check_columns() const {
        if (time_ == kNone) throw lines_.fail("the column Epoch Time is missing");
        if ((latitude_ == kNone) != (longitude_ == kNone)) {
            throw lines_.fail("latitude and longitude need each other");
        }
        for (std::size_t q = 0; q < spotter::kQuantities; ++q) {
            const auto gap = std::find(places_[q].begin(), places_[q].end(), kNone);
            if (gap == places_[q].end()) continue;
            throw lines_.fail("the column " + std::string(q == 0 ? "f" : spotter::kNames[q]) + "_" +
                              std::to_string(gap - places_[q].begin()) + " is missing");
        }
    }

    /// Returns a number; NaN for an empty field or a minus sign.
    double number(std::size_t column) const {
        const std::string_view word = column == kNone ? "" : fields_[column];
        if (word.empty() || word == "-" || word == "nan" || word == "NaN") return kMissing;
        const std::optional<double> value = text::parse_number(word);
        if (value && std::isfinite(*value)) return *value;
        throw lines_.fail("'" + text::printable(word, 20) + "' is not a number");
    }

    spotter::Bins read_bins() const {
        spotter::Bins bins;
        for (std::size_t q = 0; q < spotter::kQuantities; ++q) {
            for (const std::size_t column : places_[q]) {
                const double value = number(column);
                const std::string fault =
                    spotter::fault(static_cast<Quantity>(q), value, fields_[column]);
                if (!fault.empty()) throw lines_.fail(fault);
                bins[q].push_back(value);
            }
        }
        return bins;
    }

    void describe(SpectrumRecord& record) const {
        record.time = read_time();
        const auto within = [&](double value, const std::string& fault) {
            if (!fault.empty()) throw lines_.fail(fault);
            return value;
        };
        const double latitude = number(latitude_);
        record.latitude = within(latitude, spotter::latitude_fault(latitude, spelled(latitude_)));
        const double longitude = number(longitude_);
        record.longitude =
            within(longitude, spotter::longitude_fault(longitude, spelled(longitude_)));
    }
    std::string_view spelled(std::size_t column) const {
        return column == kNone ? "" : fields_[column];
    }
    /// Returns the time. The seconds of a minute are dropped, as in spelled times.
    std::string read_time() const {
        constexpr double kFarthest = 1e11;  // seconds; beyond every valid time
        const double seconds = number(time_);
        std::optional<UtcTime> time;
        if (std::abs(seconds) < kFarthest) {
            time = utc_time_at(static_cast<std::int64_t>(std::floor(seconds / 60.0)));
        }
        if (time) return time->text();
        throw lines_.fail("an Epoch Time of '" + text::printable(fields_[time_], 20) +
                          "'; allowed: seconds since 1970 of the years 1800 .. 2999");
    }

    LineReader lines_;
    std::size_t width_ = 0;
    std::size_t time_ = kNone;
    std::size_t latitude_ = kNone;
    std::size_t longitude_ = kNone;
    std::array<std::vector<std::size_t>, spotter::kQuantities> places_;  // by quantity and bin
    std::vector<std::string_view> fields_;                               // of the line
};

bool recognises(std::string_view content) {
    LineReader lines(content, "");
    if (!lines.next_filled()) return false;
    const auto titles = csv::split(lines.line(), ',', kMaxColumns);
    if (!titles) return false;
    const auto is_density = [](std::string_view title) {
        return title.starts_with(spotter::kNames[1]) && parse_bin_column(title).has_value();
    };
    return std::any_of(titles->begin(), titles->end(), is_density);
}

}  // namespace

const SpectrumFormat kSpotterCsv = {"Sofar Spotter as CSV", recognises, read_by<SpotterCsvReader>};

}  // namespace ocean
