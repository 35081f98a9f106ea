// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// NDBC real-time spectra: a table of densities (.data_spec) and, beside it under the same stem,
// four tables of directional quantities (.swdir .swdir2 .swr1 .swr2). One line is one time:
//   #YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) ... >
//   2020 06 08 03 50 0.225 0.000 (0.033) 0.000 (0.038) ...
// First link of a measured sea: buoy's degrees become libocean's directions here, and only here.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>

#include "ocean/grid.hpp"
#include "spectrum_format.hpp"
#include "text.hpp"
#include "utc_time.hpp"

namespace ocean {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// What the five tables hold, named as their headers name the columns.
enum class Quantity { density, direction1, direction2, spread1, spread2 };
constexpr std::array<std::string_view, 5> kColumnNames = {"spec_1", "alpha1_1", "alpha2_1", "r1_1",
                                                          "r2_1"};
constexpr std::array<std::string_view, 5> kSuffixes = {".data_spec", ".swdir", ".swdir2", ".swr1",
                                                       ".swr2"};

struct Bin {
    double frequency;
    double value;  // NaN = missing
};

struct Row {
    std::string time;
    std::vector<Bin> bins;  // ascending in frequency
};

/// Which columns stand before the first value. Old files have no minutes, companions no separation
/// frequency.
struct Header {
    bool minutes = false;
    bool separation = false;
    Quantity quantity = Quantity::density;
};

/// One line, read from its front.
class Cursor {
  public:
    explicit Cursor(std::string_view line) : rest_(line) {}
    bool at_end() { return skip_blanks().empty(); }
    bool take(char c) {
        if (!skip_blanks().starts_with(c)) return false;
        rest_.remove_prefix(1);
        return true;
    }
    /// Up to the next blank or parenthesis.
    std::string_view word() {
        skip_blanks();
        const std::string_view result = rest_.substr(0, rest_.find_first_of(" \t()"));
        rest_.remove_prefix(result.size());
        return result;
    }

  private:
    std::string_view skip_blanks() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
        return rest_;
    }
    std::string_view rest_;
};

std::optional<Header> parse_header(std::string_view line) {
    Cursor cursor(line);
    cursor.take('#');
    if (!cursor.word().starts_with("YY")) return std::nullopt;
    Header header;
    for (std::string_view word = cursor.word(); !word.empty(); word = cursor.word()) {
        header.minutes |= word == "mm";
        header.separation |= word == "Sep_Freq";
        const auto name = std::find(kColumnNames.begin(), kColumnNames.end(), word);
        if (name == kColumnNames.end()) continue;
        header.quantity = static_cast<Quantity>(name - kColumnNames.begin());
        return header;
    }
    return std::nullopt;
}

class TableReader {
  public:
    TableReader(std::string_view content, std::string_view name) : rest_(content), name_(name) {
        if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    }

    std::vector<Row> read(Quantity expected) {
        std::vector<Row> rows;
        while (next_line()) {
            if (Cursor(line_).at_end()) continue;
            if (const std::optional<Header> header = parse_header(line_)) {
                if (header->quantity != expected)
                    throw fail(wrong_table(header->quantity, expected));
                header_ = header;
                continue;
            }
            if (line_.starts_with('#')) continue;
            if (rows.size() == kMaxRecords) throw fail("more than 100000 records");
            Row row = read_row();
            const bool shorter = !rows.empty() && row.bins.size() < rows.back().bins.size();
            if (shorter && cut_off_) throw fail("the file ends within this line");
            rows.push_back(std::move(row));
        }
        return rows;
    }

  private:
    Error fail(std::string_view message) const {
        return text::error_at(ErrorKind::bad_file, name_, line_number_, message);
    }
    static std::string wrong_table(Quantity found, Quantity expected) {
        const auto suffix = [](Quantity q) {
            return std::string(kSuffixes[static_cast<std::size_t>(q)]);
        };
        return "this is a " + suffix(found) + " table where " + suffix(expected) + " is needed";
    }

    bool next_line() {
        if (rest_.empty()) return false;
        const std::size_t end = rest_.find('\n');
        cut_off_ = end == std::string_view::npos;
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(cut_off_ ? rest_.size() : end + 1);
        if (line_.ends_with('\r')) line_.remove_suffix(1);
        ++line_number_;
        return true;
    }

    double number(std::string_view word, std::string_view what) const {
        const std::optional<double> value = text::parse_number(word);
        if (!value || !std::isfinite(*value)) {
            throw fail("'" + text::printable(word, 20) + "' is not " + std::string(what));
        }
        return *value;
    }
    int integer(std::string_view word) const {
        const double value = number(word, "a whole number of a date");
        if (value != std::floor(value) || std::abs(value) > 9999.0) {
            throw fail("'" + text::printable(word, 20) + "' is not a whole number of a date");
        }
        return static_cast<int>(value);
    }

    Row read_row() const {
        if (!header_) throw fail("values before the header line that names the columns");
        Cursor cursor(line_);
        Row row;
        row.time = read_time(cursor);
        if (header_->separation) number(cursor.word(), "a separation frequency");
        while (!cursor.at_end()) {
            if (row.bins.size() == kMaxFrequencies) throw fail("more than 4096 frequencies");
            row.bins.push_back(read_bin(cursor));
            const std::size_t count = row.bins.size();
            if (count > 1 && !(row.bins[count - 2].frequency < row.bins[count - 1].frequency)) {
                throw fail("the frequencies do not ascend at bin " + std::to_string(count));
            }
        }
        if (row.bins.size() < 2) throw fail("fewer than 2 frequencies");
        return row;
    }

    std::string read_time(Cursor& cursor) const {
        UtcTime time;
        time.year = integer(cursor.word());
        if (time.year >= 0 && time.year < 100) time.year += 1900;  // written before 1999
        time.month = integer(cursor.word());
        time.day = integer(cursor.word());
        time.hour = integer(cursor.word());
        if (header_->minutes) time.minute = integer(cursor.word());
        if (!time.valid()) throw fail("the line does not begin with a date and time");
        return time.text();
    }

    Bin read_bin(Cursor& cursor) const {
        const std::string_view word = cursor.word();
        if (word.empty() || !cursor.take('(')) throw fail("expected 'value (frequency)' pairs");
        Bin result{};
        const std::string_view frequency = cursor.word();
        result.frequency = number(frequency, "a frequency");
        if (!cursor.take(')')) throw fail("expected 'value (frequency)' pairs");
        if (!(result.frequency > 0.0 && result.frequency <= 100.0)) {
            throw fail("a frequency of " + text::printable(frequency, 20) +
                       "; allowed: above 0, at most 100 Hz");
        }
        result.value = word == "MM" ? kMissing : checked(number(word, "a number"), word);
        return result;
    }

    /// Nines mean missing: 999 in every table, 99 too where it is no possible value (a direction of
    /// 99 degrees is; its bin is missing all the same if the spread beside it is).
    double checked(double value, std::string_view word) const {
        const auto require = [&](double low, double high, std::string_view what) {
            if (value >= low && value <= high) return value;
            throw fail(std::string(what) + " " + text::printable(word, 20));
        };
        if (value == 999.0) return kMissing;
        switch (header_->quantity) {
            case Quantity::direction1:
            case Quantity::direction2:
                return require(0.0, 360.0, "directions are 0 .. 360 degrees, not");
            case Quantity::spread1:
            case Quantity::spread2:
                if (value == 99.0) return kMissing;
                return std::min(require(0.0, 1.05, "r1 and r2 are 0 .. 1, not"), 1.0);
            case Quantity::density:
                break;
        }
        if (value == 99.0) return kMissing;
        return require(0.0, 1e6, "densities are 0 .. 1e6 m^2/Hz, not");
    }

    std::string_view rest_;
    std::string_view name_;
    std::string_view line_;
    std::size_t line_number_ = 0;
    bool cut_off_ = false;  // the line has no end: the file was cut there
    std::optional<Header> header_;
};

/// Rows of one companion by their time.
using Companion = std::map<std::string, std::vector<Bin>>;

/// The four companions, or nothing if one of them is missing.
std::optional<std::array<Companion, 4>> read_companions(const SpectrumSource& source) {
    if (!source.name.ends_with(kSuffixes[0]) || !source.companion) return std::nullopt;
    const std::string stem = source.name.substr(0, source.name.size() - kSuffixes[0].size());
    std::array<Companion, 4> companions;
    for (std::size_t i = 0; i < companions.size(); ++i) {
        const std::string path = stem + std::string(kSuffixes[i + 1]);
        const std::optional<std::string> content = source.companion(path);
        if (!content) return std::nullopt;
        for (Row& row : TableReader(*content, path).read(static_cast<Quantity>(i + 1))) {
            companions[i].emplace(std::move(row.time), std::move(row.bins));
        }
    }
    return companions;
}

/// The value at a frequency. Tables print the same frequency alike: a tolerance only for other
/// digits of the same number.
double value_at(const std::vector<Bin>& bins, double frequency) {
    constexpr double kTolerance = 1e-6;  // Hz; bins lie 5e-3 apart
    const auto found =
        std::lower_bound(bins.begin(), bins.end(), frequency - kTolerance,
                         [](const Bin& bin, double wanted) { return bin.frequency < wanted; });
    const bool hit = found != bins.end() && found->frequency <= frequency + kTolerance;
    return hit ? found->value : kMissing;
}

/// Where the waves travel, in radians counter-clockwise from east, from where they come, in degrees
/// clockwise from north: theta = 270 deg - alpha.
double travel_direction(double alpha) {
    return (270.0 - alpha) * (kPi / 180.0);
}

/// a_n = r_n cos(n theta_n), b_n = r_n sin(n theta_n) [Longuet-Higgins 1963]. A bin that lacks one
/// of the four quantities lacks all four moments.
void add_directions(SpectrumRecord& record, const std::array<Companion, 4>& companions) {
    std::array<const std::vector<Bin>*, 4> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto found = companions[i].find(record.time);
        if (found == companions[i].end()) return;
        rows[i] = &found->second;
    }
    SpectrumRecord with = record;
    bool any = false;
    for (double f : record.frequency) {
        const double theta1 = travel_direction(value_at(*rows[0], f));
        const double theta2 = travel_direction(value_at(*rows[1], f));
        const double r1 = value_at(*rows[2], f);
        const double r2 = value_at(*rows[3], f);
        const bool whole = !std::isnan(theta1 + theta2 + r1 + r2);
        any |= whole;
        with.a1.push_back(whole ? r1 * std::cos(theta1) : kMissing);
        with.b1.push_back(whole ? r1 * std::sin(theta1) : kMissing);
        with.a2.push_back(whole ? r2 * std::cos(2.0 * theta2) : kMissing);
        with.b2.push_back(whole ? r2 * std::sin(2.0 * theta2) : kMissing);
    }
    if (any) record = std::move(with);
}

/// NDBC's identifiers have five characters: "41010" of ".../ndbc_41010.data_spec".
std::string station_of(std::string_view path) {
    if (!path.ends_with(kSuffixes[0])) return "";
    path.remove_suffix(kSuffixes[0].size());
    const std::string_view stem = path.substr(path.find_last_of("/\\") + 1);
    std::size_t first = stem.size();
    while (first > 0 && std::isalnum(static_cast<unsigned char>(stem[first - 1])) != 0) --first;
    return std::string(stem.size() - first == 5 ? stem.substr(first) : stem);
}

bool recognises(std::string_view content) {
    if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
    const std::size_t first = content.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return false;
    content.remove_prefix(first);
    return parse_header(content.substr(0, content.find_first_of("\r\n"))).has_value();
}

std::vector<SpectrumRecord> read(const SpectrumSource& source) {
    std::vector<Row> rows = TableReader(source.content, source.name).read(Quantity::density);
    const auto companions = read_companions(source);
    std::vector<SpectrumRecord> records;
    for (const Row& row : rows) {
        SpectrumRecord record;
        record.station = station_of(source.name);
        record.time = row.time;
        for (const Bin& bin : row.bins) {
            if (std::isnan(bin.value)) continue;  // no density: as if the bin were not listed
            record.frequency.push_back(bin.frequency);
            record.density.push_back(bin.value);
        }
        if (record.frequency.size() < 2) continue;  // nothing was measured at that time
        if (companions) add_directions(record, *companions);
        records.push_back(std::move(record));
    }
    return records;
}

}  // namespace

const SpectrumFormat kNdbcRealtime = {"NDBC real-time (.data_spec with .swdir .swdir2 .swr1 .swr2)",
                                      recognises, read};

}  // namespace ocean
