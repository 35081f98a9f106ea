// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectra of Obscape buoys, as their portal offers them for download: one record a file. Lines of
// metadata, # key = value, then a line of densities for each frequency:
//   # Station name = Example file
//   # Latitude [deg] = 12.123
//   # Longitude [deg] = 1.234
//   # Timestamp = 1712136600              seconds since 1970, UTC
//   # Columns [deg] = 0,3,6,... 357       or all of them: coming from, clockwise from north
//   # Rows [Hz] = 0.048828,0.054932,...
//   # Variance-density [m2/Hz/rad]
#include <algorithm>
#include <cmath>
#include <optional>

#include "line_checks.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/density_units.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/internal/utc_time.hpp"

namespace ocean {
namespace {

constexpr std::string_view kColumns = "Columns [deg]";
constexpr std::string_view kRows = "Rows [Hz]";
constexpr std::string_view kDensity = "Variance-density";
constexpr std::size_t kMaxMetadataLines = 200;

/// Returns the parts of "# key = value".
std::optional<Entry> parse_entry(std::string_view line) {
    return line.starts_with('#') ? std::optional(split_entry(line.substr(1))) : std::nullopt;
}

class ObscapeReader {
  public:
    explicit ObscapeReader(const SpectrumSource& source) : lines_(source.content, source.name) {}

    SpectrumRecord read() {
        SpectrumRecord record;
        bool row = read_metadata(record);
        if (degrees_.empty())
            throw lines_.fail("the header before has no " + std::string(kColumns));
        if (record.frequency.empty()) {
            throw lines_.fail("the header before has no " + std::string(kRows));
        }
        require_directional_size(lines_, record.frequency.size() * degrees_.size());
        std::vector<double> values;
        for (std::size_t i = 0; i < record.frequency.size(); ++i) {
            if (!row) {
                throw lines_.fail("the file ends where row " + std::to_string(i + 1) + " of " +
                                  std::to_string(record.frequency.size()) + " should be");
            }
            read_row(values);
            row = csv::next_row(lines_);
        }
        if (row) throw lines_.fail("more rows than the header has frequencies");
        DirectionAxis(degrees_, DirectionConvention::from_nautical).fill(record, values, factor_);
        return record;
    }

  private:
    /// Reads the metadata. Returns false if no rows follow.
    bool read_metadata(SpectrumRecord& record) {
        while (lines_.next_filled()) {
            const std::optional<Entry> entry = parse_entry(lines_.line());
            if (!entry) return true;
            const auto [key, value] = *entry;
            if (key == "Station name") record.station = text::printable(value);
            if (key == "Latitude [deg]") record.latitude = number(value, -90.0, 90.0, key);
            if (key == "Longitude [deg]") record.longitude = number(value, -180.0, 360.0, key);
            if (key == "Timestamp") record.time = read_time(value);
            if (key == kRows) read_frequencies(value, record.frequency);
            if (key == kColumns) read_directions(value);
            if (key.starts_with(kDensity)) read_unit(key);
        }
        return false;
    }

    double number(std::string_view word, double low, double high, std::string_view what) const {
        return number_within(lines_, word, low, high, "a number of " + std::string(what));
    }
    std::string read_time(std::string_view word) const {
        const double seconds = number(word, -1e11, 1e11, "Timestamp");
        const auto time = utc_time_at(static_cast<std::int64_t>(std::floor(seconds / 60.0)));
        if (!time) throw lines_.fail("the Timestamp is not of the years 1800 .. 2999");
        return time->text();
    }
    void read_unit(std::string_view title) {
        const DensityUnit unit =
            parse_density_unit(csv::parse_title(title).unit, DensityOver::frequency_and_direction);
        if (!unit.fault.empty()) throw lines_.fail(unit.fault);
        factor_ = unit.factor;
    }

    void read_frequencies(std::string_view list, std::vector<double>& frequency) const {
        for (const std::string& word : split(list, ',')) {
            append_frequency(lines_, number(trimmed(word), 0.0, kMaxFrequency, kRows), frequency);
        }
    }

    /// Expands "0,3,6,... 357", which omits values that continue the pattern of the first.
    void read_directions(std::string_view list) {
        std::string blanks(list);
        std::replace(blanks.begin(), blanks.end(), ',', ' ');
        std::string_view rest = blanks;
        degrees_.clear();
        for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) {
            if (word == "...") {
                go_on(number(next_word(rest), -360.0, 720.0, kColumns));
                break;
            }
            if (degrees_.size() == kMaxDirections) throw lines_.fail("more than 720 directions");
            degrees_.push_back(number(word, -360.0, 720.0, kColumns));
        }
        const std::string fault = DirectionAxis::fault(degrees_);
        if (!fault.empty()) throw lines_.fail(fault);
    }
    void go_on(double last) {
        const std::size_t count = degrees_.size();
        const double step = count >= 2 ? degrees_[count - 1] - degrees_[count - 2] : 0.0;
        const double steps = step > 0.0 ? std::round((last - degrees_.back()) / step) : 0.0;
        if (!(steps >= 1.0 && steps <= kMaxDirections) ||
            std::abs(degrees_.back() + steps * step - last) > 1e-6) {
            throw lines_.fail("the meaning of '...' in the directions is unclear");
        }
        const double begin = degrees_.back();
        for (double i = 1.0; i <= steps; ++i) degrees_.push_back(begin + i * step);
    }

    void read_row(std::vector<double>& values) const {
        const std::string than =
            "values than the " + std::to_string(degrees_.size()) + " directions";
        const auto fields = exact_fields(lines_, degrees_.size(), than);
        for (const std::string_view field : fields) {
            values.push_back(
                number(field, -kMaxBinDensity / factor_, kMaxBinDensity / factor_, "a density"));
        }
    }

    LineReader lines_;
    std::vector<double> degrees_;
    double factor_ = 1.0;  // to m^2/Hz/degree
};

bool recognises(std::string_view content) {
    LineReader lines(content, "");
    bool columns = false;
    bool rows = false;
    for (std::size_t i = 0; i < kMaxMetadataLines && lines.next_filled(); ++i) {
        const std::optional<Entry> entry = parse_entry(lines.line());
        if (!entry) return false;
        columns = columns || entry->key == kColumns;
        rows = rows || entry->key == kRows;
        if (columns && rows) return true;
    }
    return false;
}

std::vector<SpectrumRecord> read(const SpectrumSource& source) {
    return {ObscapeReader(source).read()};
}

}  // namespace

const SpectrumFormat kObscape = {"Obscape CSV", recognises, read};

}  // namespace ocean
