// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Forecast spectra for Octopus, the motion program of ship operators. Six lines of a header,
//   Forecast valid for 11-Mar-2018 00:00:00
//   nfreqs,24;  ndir,36;  nrecs,5;  Latitude, -39.9723;  Longitude, 173.3090;  Depth,102.33
// (one a line), then for each time a line of names, one of values that begins
//   201803,'110000,maari_20180311_00z   year and month, 'day, hour and minute, point
// one with the frequencies [Hz], freq,0.04,...,anspec, and one for each direction [degrees, coming
// from, clockwise from north] with the energies [m^2] of its bins and their sum; sums of the
// frequencies, fSpec and den, end the record.
#include <cmath>
#include <optional>

#include "free_form.hpp"

namespace ocean {
namespace {

/// Max energy of a bin, so that no sum over the circle exceeds the limit of a record.
constexpr double kMaxEnergy = 1e4;

bool begins_record(std::string_view line) {
    return line.starts_with("CCYYMM,");
}

/// Returns "maari" of "maari_20180311_00z": the forecast does not identify the place.
std::string_view without_run(std::string_view point) {
    constexpr std::string_view kPattern = "_00000000_00z";
    if (point.size() <= kPattern.size()) return point;
    const std::size_t at = point.size() - kPattern.size();
    for (std::size_t i = 0; i < kPattern.size(); ++i) {
        const char c = point[at + i];
        const bool digit = c >= '0' && c <= '9';
        if (kPattern[i] == '0' ? !digit : c != kPattern[i]) return point;
    }
    return point.substr(0, at);
}

class OctopusReader {
  public:
    explicit OctopusReader(const SpectrumSource& source) : lines_(source.content, source.name) {}

    std::vector<SpectrumRecord> read() {
        read_header();
        std::vector<SpectrumRecord> records;
        bool more = next_record();
        while (more) {
            require_room(lines_, records.size(), frequencies_ * directions_);
            SpectrumRecord record = place_;
            const std::size_t first = lines_.number();
            catch_fault(record.fault, [&] { read_record(record); });
            records.push_back(std::move(record));
            const bool early = lines_.number() > first && begins_record(lines_.line());
            more = early || next_record();
        }
        return records;
    }

  private:
    bool next_record() {
        while (lines_.next()) {
            if (begins_record(lines_.line())) return true;
        }
        return false;
    }

    void read_header() {
        need_line("a title");
        frequencies_ = count("nfreqs", 2, kMaxFrequencies);
        directions_ = count("ndir", 3, kMaxDirections);
        require_directional_size(lines_, frequencies_ * directions_);
        count("nrecs", 1, kMaxRecords);
        place_.latitude = entry("Latitude", -90.0, 90.0);
        place_.longitude = entry("Longitude", -180.0, 360.0);
        const double depth = entry("Depth", -20000.0, 20000.0);
        if (depth >= 0.01) place_.depth = depth;
    }

    void need_line(const std::string& what) {
        if (!lines_.next_filled()) throw lines_.fail("the file ends where " + what + " should be");
    }
    double entry(std::string_view key, double low, double high) {
        need_line(std::string(key));
        const std::string_view line = lines_.line();
        const std::size_t comma = line.find(',');
        if (comma == std::string_view::npos || trimmed(line.substr(0, comma)) != key) {
            throw lines_.fail("'" + text::printable(line, 30) + "' where " + std::string(key) +
                              " should be");
        }
        return number_within(lines_, trimmed(line.substr(comma + 1)), low, high, key);
    }
    std::size_t count(std::string_view key, std::size_t least, std::size_t most) {
        const double value = entry(key, static_cast<double>(least), static_cast<double>(most));
        if (value != std::floor(value)) {
            throw lines_.fail(std::string(key) + " is not a whole number");
        }
        return static_cast<std::size_t>(value);
    }
    /// Reads the fields of the next line, without those after a final comma.
    void next_fields(const std::string& what, std::size_t least) {
        need_line(what);
        fields_ = csv::fields_of(lines_, ',', 2 * kMaxFrequencies);
        if (fields_.size() >= least) return;
        throw lines_.fail(lines_.cut_off() ? "the file ends within this line"
                                           : "fewer fields than " + what + " has");
    }

    void read_record(SpectrumRecord& record) {
        next_fields("the time and the point", 3);
        record.time = read_time();
        record.station = text::printable(without_run(fields_[2]));
        next_fields("the frequencies", frequencies_ + 1);
        if (fields_[0] != "freq") throw lines_.fail("the line of the frequencies is missing");
        for (std::size_t i = 0; i < frequencies_; ++i) {
            const double f =
                number_within(lines_, fields_[i + 1], 0.0, kMaxFrequency, "a frequency");
            append_frequency(lines_, f, record.frequency);
        }
        read_energies(record);
    }

    std::string read_time() const {
        std::string_view day = fields_[1];
        if (day.starts_with('\'')) day.remove_prefix(1);
        const std::string text = std::string(fields_[0]) + std::string(day);
        const std::optional<UtcTime> time = match_time(text, "YYYYMMDDhhmm");
        if (time && time->valid() && text.size() == 12) return time->text();
        throw lines_.fail("'" + text::printable(text, 20) +
                          "' where a time like 201803,'110000 "
                          "should be");
    }

    /// Reads energies. Each is divided by the width that the trapezoid gives to its frequency and
    /// by the angle of its direction, so that the sum over a record is the height that the file
    /// states.
    void read_energies(SpectrumRecord& record) {
        std::vector<double> degrees;
        std::vector<double> energies(frequencies_ * directions_);
        for (std::size_t j = 0; j < directions_; ++j) {
            next_fields("a direction", frequencies_ + 1);
            degrees.push_back(number_within(lines_, fields_[0], -360.0, 720.0, "a direction"));
            for (std::size_t i = 0; i < frequencies_; ++i) {
                energies[i * directions_ + j] =
                    number_within(lines_, fields_[i + 1], -kMaxEnergy, kMaxEnergy, "an energy");
            }
        }
        const DirectionAxis axis =
            direction_axis(lines_, degrees, DirectionConvention::from_nautical);
        const double angle = 360.0 / static_cast<double>(directions_);
        const std::vector<double>& f = record.frequency;
        for (std::size_t i = 0; i < frequencies_; ++i) {
            const double below = i > 0 ? f[i] - f[i - 1] : 0.0;
            const double above = i + 1 < frequencies_ ? f[i + 1] - f[i] : 0.0;
            for (std::size_t j = 0; j < directions_; ++j) {
                energies[i * directions_ + j] /= 0.5 * (below + above) * angle;
            }
        }
        axis.fill(record, energies, 1.0);
    }

    LineReader lines_;
    std::size_t frequencies_ = 0;
    std::size_t directions_ = 0;
    SpectrumRecord place_;  // the data of all records
    std::vector<std::string_view> fields_;
};

bool recognises(std::string_view content) {
    LineReader lines(content, "");
    return lines.next_filled() && lines.next_filled() && lines.line().starts_with("nfreqs,");
}

}  // namespace

const SpectrumFormat kOctopus = {"Octopus (.oct)", recognises, read_by<OctopusReader>};

}  // namespace ocean
