// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectra of TRIAXYS buoys, .DIRSPEC over frequency and direction and .NONDIRSPEC over frequency:
//   TRIAXYS BUOY DATA REPORT - TAS01970 - TAB01401 - 4857.6668S16631.6837W
//   TYPE = DIRECTIONAL SPECTRUM, or NON-DIRECTIONAL SPECTRUM
//   DATE = 2018-01-31 21:00(UTC), or 2018 Jan 31 21:00(UTC)
//   NUMBER OF FREQUENCIES, INITIAL FREQUENCY (Hz), FREQUENCY SPACING (Hz) = a number each
//   NUMBER OF DIRECTIONS, DIRECTION SPACING (DEG) = a number each
// and other keys, which are skipped. After the key ROWS follows a line for each frequency with the
// densities [m^2/Hz/deg] of all directions from 0 on: coming from, clockwise from north, with both
// 0 and 360. After the key COLUMN 2 follows a line for each frequency with the frequency and its
// density [m^2/Hz].
#include <cmath>
#include <optional>

#include "free_form.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

bool is_title(std::string_view line) {
    return line.starts_with("TRIAXYS BUOY DATA REPORT") || line.starts_with("TRIAXYS BUOY REPORT");
}

/// Returns an angle of "4857.6668S": degrees and minutes, and the letter of a hemisphere.
std::optional<double> next_angle(std::string_view& text, std::string_view letters) {
    const std::size_t end = text.find_first_of(letters);
    if (end == std::string_view::npos) return std::nullopt;
    const std::optional<double> read = text::parse_number(text.substr(0, end));
    if (!read || !(*read >= 0.0 && *read <= 18000.0)) return std::nullopt;
    const double degrees = std::floor(*read / 100.0);
    const double minutes = *read - 100.0 * degrees;
    if (minutes >= 60.0) return std::nullopt;
    const double sign = text[end] == letters[1] ? -1.0 : 1.0;
    text.remove_prefix(end + 1);
    return sign * (degrees + minutes / 60.0);
}

class TriaxysReader {
  public:
    explicit TriaxysReader(const SpectrumSource& source) : in_(source.content, source.name) {}

    std::vector<SpectrumRecord> read() {
        std::vector<SpectrumRecord> records;
        in_.need_line("the title TRIAXYS BUOY DATA REPORT");
        do {
            SpectrumRecord record;
            const std::size_t first = in_.line_number();
            catch_fault(record.fault, [&] { read_record(record); });
            if (!record.fault.empty()) in_.resume_after(first, is_title);
            require_room(in_.lines(), records.size(),
                         record.frequency.size() * (1 + record.direction.size()));
            records.push_back(std::move(record));
        } while (in_.next_line());
        return records;
    }

  private:
    struct Header {
        std::string time;
        bool directional = false;
        std::size_t frequencies = 0;
        std::size_t directions = 0;
        double initial = -1.0;  // Hz
        double spacing = 0.0;   // Hz
        double angle = 0.0;     // degrees, between directions
    };

    void read_record(SpectrumRecord& record) {
        if (!is_title(in_.rest())) {
            throw in_.fail("'" + FreeForm::shown(in_.rest()) +
                           "' where the title TRIAXYS BUOY DATA REPORT should be");
        }
        read_title(record, in_.rest());
        const Header header = read_header();
        record.time = header.time;
        if (header.directional) {
            read_table(record, header);
        } else {
            read_column(record, header);
        }
    }

    /// Names of the sensor and the buoy and their position, of which the last ones may be missing.
    static void read_title(SpectrumRecord& record, std::string_view line) {
        const std::vector<std::string> parts = split(line, " - ");
        if (parts.size() < 2) return;
        record.station = text::printable(trimmed(parts[1]));
        std::string_view position = trimmed(parts.back());
        const std::optional<double> latitude = next_angle(position, "NS");
        const std::optional<double> longitude = next_angle(position, "EW");
        const bool known = latitude && longitude && position.empty() &&
                           std::abs(*latitude) <= 90.0 && std::abs(*longitude) <= 180.0;
        if (known) {
            record.latitude = *latitude;
            record.longitude = *longitude;
        }
    }

    Header read_header() {
        Header header;
        bool typed = false;
        while (true) {
            in_.need_line("a line of the header, KEY = value,");
            if (in_.rest().find('=') == std::string_view::npos) {
                throw in_.fail("'" + FreeForm::shown(in_.rest()) +
                               "' where a line of the header, KEY = value, should be");
            }
            const auto [key, value] = split_entry(in_.rest());
            if (key == "ROWS" || key == "COLUMN 2") break;
            if (key == "TYPE") {
                header.directional = is_directional(value);
                typed = true;
            } else if (key == "DATE") {
                header.time = read_time(value);
            } else if (key == "NUMBER OF FREQUENCIES") {
                header.frequencies = count(value, "frequencies", 2, kMaxFrequencies);
            } else if (key == "INITIAL FREQUENCY (Hz)") {
                header.initial = number(value, 0.0, kMaxFrequency, "an initial frequency");
            } else if (key == "FREQUENCY SPACING (Hz)") {
                header.spacing = number(value, kMinFrequency, kMaxFrequency, "a spacing");
            } else if (key == "NUMBER OF DIRECTIONS") {
                header.directions = count(value, "directions", 3, kMaxDirections);
            } else if (key == "DIRECTION SPACING (DEG)") {
                header.angle = number(value, 0.1, 120.0, "a spacing");
            }
        }
        in_.leave_line();
        check(header, typed);
        return header;
    }

    void check(const Header& header, bool typed) const {
        const auto need = [&](bool condition, std::string_view key) {
            if (!condition) throw in_.fail("the header before has no " + std::string(key));
        };
        need(typed, "TYPE");
        need(!header.time.empty(), "DATE");
        need(header.frequencies > 0, "NUMBER OF FREQUENCIES");
        need(!header.directional || header.initial >= 0.0, "INITIAL FREQUENCY (Hz)");
        need(!header.directional || header.spacing > 0.0, "FREQUENCY SPACING (Hz)");
        need(!header.directional || header.directions > 0, "NUMBER OF DIRECTIONS");
        need(!header.directional || header.angle > 0.0, "DIRECTION SPACING (DEG)");
        require_directional_size(in_.lines(), header.frequencies * (header.directions + 2));
        const auto last = static_cast<double>(header.frequencies - 1);
        if (header.directional && header.initial + last * header.spacing > kMaxFrequency) {
            throw in_.fail("the last frequency is beyond 100 Hz");
        }
    }

    bool is_directional(std::string_view type) const {
        if (type == "DIRECTIONAL SPECTRUM") return true;
        if (type == "NON-DIRECTIONAL SPECTRUM") return false;
        throw in_.fail("TYPE '" + text::printable(type, 40) +
                       "'; known: DIRECTIONAL SPECTRUM, NON-DIRECTIONAL SPECTRUM");
    }

    std::string read_time(std::string_view value) const {
        for (const std::string_view pattern : {"YYYY-MM-DD hh:mm", "YYYY bbb DD hh:mm"}) {
            const std::optional<UtcTime> time = match_time(value, pattern);
            if (!time || !time->valid()) continue;
            const std::string_view zone = trimmed(value.substr(pattern.size()));
            if (zone.empty() || zone == "(UTC)" || zone == "(GMT)") return time->text();
        }
        throw in_.fail("the DATE '" + text::printable(value, 30) +
                       "' is not like 2018-01-31 21:00(UTC)");
    }

    double number(std::string_view value, double low, double high, std::string_view what) const {
        const std::optional<double> read = text::parse_number(value);
        if (read && *read >= low && *read <= high) return *read;
        throw in_.fail(std::string(what) + " of '" + text::printable(value, 20) +
                       "'; allowed: " + shortest_text(low) + " .. " + shortest_text(high));
    }
    std::size_t count(std::string_view value, std::string_view what, std::size_t least,
                      std::size_t most) const {
        const std::optional<double> read = text::parse_number(value);
        if (read && *read >= static_cast<double>(least) && *read <= static_cast<double>(most) &&
            *read == std::floor(*read)) {
            return static_cast<std::size_t>(*read);
        }
        throw in_.fail("'" + text::printable(value, 20) + "' " + std::string(what) +
                       "; allowed: " + std::to_string(least) + " .. " + std::to_string(most));
    }

    /// Reads the rows of all frequencies. The first one, 0 Hz, is not a wave: it is read and left
    /// out.
    void read_table(SpectrumRecord& record, const Header& header) {
        std::vector<double> degrees;
        while (degrees.size() < header.directions) {
            degrees.push_back(static_cast<double>(degrees.size()) * header.angle);
        }
        const std::string fault = DirectionAxis::fault(degrees);
        if (!fault.empty()) throw in_.fail("of the directions of the header: " + fault);
        std::vector<double> values;
        for (std::size_t i = 0; i < header.frequencies; ++i) {
            in_.need_line("row " + std::to_string(i + 1) + " of " +
                          std::to_string(header.frequencies));
            const double frequency = header.initial + static_cast<double>(i) * header.spacing;
            const bool wave = frequency >= kMinFrequency;
            if (wave) record.frequency.push_back(frequency);
            for (std::size_t j = 0; j < header.directions; ++j) {
                const double value = in_.number_here("a density");
                in_.require_within(value, -kMaxBinDensity, kMaxBinDensity, "a density",
                                   "0 .. 2500 m^2/Hz/deg");
                if (wave) values.push_back(value);
            }
            in_.end_line("the densities of all directions");
        }
        DirectionAxis(degrees, DirectionConvention::from_nautical).fill(record, values, 1.0);
    }

    void read_column(SpectrumRecord& record, const Header& header) {
        for (std::size_t i = 0; i < header.frequencies; ++i) {
            in_.need_line("row " + std::to_string(i + 1) + " of " +
                          std::to_string(header.frequencies));
            const double frequency = in_.number_here("a frequency");
            in_.require_within(frequency, 0.0, kMaxFrequency, "a frequency", "0 .. 100 Hz");
            const double density = in_.number_here("a density");
            in_.require_within(density, -1e6, 1e6, "a density", "0 .. 1e6 m^2/Hz");
            in_.end_line("the density");
            if (frequency < kMinFrequency) continue;
            if (!record.frequency.empty() && !(frequency > record.frequency.back())) {
                throw in_.fail("the frequencies do not ascend at row " + std::to_string(i + 1));
            }
            record.frequency.push_back(frequency);
            record.density.push_back(density);
        }
    }

    FreeForm in_;
};

bool recognises(std::string_view content) {
    FreeForm in(content, "");
    return in.next_line() && is_title(in.rest());
}

}  // namespace

const SpectrumFormat kTriaxys = {"TRIAXYS spectra (.DIRSPEC, .NONDIRSPEC)", recognises,
                                 read_by<TriaxysReader>};

}  // namespace ocean
