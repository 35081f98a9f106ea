// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Point output of WAVEWATCH III, the ASCII transfer file of its program ww3_outp:
//   'WAVEWATCH III SPECTRA'     50    36     1 'spectral resolution for points'
//   frequencies [Hz], then directions [rad, clockwise from north, travelling to]; for each time
//   20220912 060000
//   and each point
//   '44097     '  40.98 -71.12      46.6   1.45 225.6   0.18  94.1
//   (latitude, longitude, depth, speed and direction of wind and current) and the densities
//   [m^2/Hz/rad], frequency fastest.
// Programs that copy such files write texts without their quotes, or with double ones.
// A reader of spectra: turns such a file into records in libocean's conventions.
#include <cctype>

#include "free_form.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean {
namespace {

constexpr std::string_view kMagic = "WAVEWATCH III SPECTRA";
constexpr std::string_view kQuotes = "'\"";
constexpr std::string_view kTime = "YYYYMMDD hhmmss";
/// After the name of a point: its place, depth, wind and current.
constexpr std::size_t kPointNumbers = 7;
/// Half a unit of the third digit of 6.28, the max error of the smallest direction.
constexpr double kRounding = 0.0055;
/// Max density, so that no sum over the circle exceeds the limit of a record: 1e6 m^2/Hz.
constexpr double kMaxDensity = 1e5;

/// Returns even directions. The model's are even, but 85 degrees is printed as 1.48; used as
/// printed, the weights of the bins would be off by some percent, each differently. Directions that
/// differ from an even circle by rounding alone are therefore moved to it, starting at the smallest
/// one, which is printed with the most digits; others stay as printed.
std::vector<double> even_circle(const std::vector<double>& printed) {
    const auto count = static_cast<double>(printed.size());
    const auto smallest = std::min_element(printed.begin(), printed.end());
    for (const double step : {2.0 * kPi / count, -2.0 * kPi / count}) {
        std::vector<double> even;
        bool close = true;
        for (std::size_t j = 0; j < printed.size(); ++j) {
            const auto from_smallest =
                static_cast<double>(j) - static_cast<double>(smallest - printed.begin());
            const double direction = *smallest + from_smallest * step;
            const double off = std::remainder(printed[j] - direction, 2.0 * kPi);
            close = close && std::abs(off) <= kRounding;
            even.push_back(direction);
        }
        if (close) return even;
    }
    return printed;
}

/// Returns the bytes of the magic words that `line` begins with, quotes included; 0 if it does not.
std::size_t magic_bytes(std::string_view line) {
    const bool quoted = !line.empty() && kQuotes.find(line[0]) != std::string_view::npos;
    std::size_t bytes = quoted ? 1 : 0;
    if (!line.substr(bytes).starts_with(kMagic)) return 0;
    bytes += kMagic.size();
    if (!quoted) return bytes;
    const std::size_t close = line.find_first_not_of(' ', bytes);
    return close != std::string_view::npos && line[close] == line[0] ? close + 1 : 0;
}

bool begins_time(std::string_view line) {
    const std::optional<UtcTime> time = match_time(line, kTime);
    return time && time->valid() &&
           line.find_first_not_of(" \t", kTime.size()) == std::string_view::npos;
}

/// Returns the bytes of a point's name, quotes included: the text before the seven numbers.
std::size_t name_bytes(std::string_view line) {
    for (const char quote : kQuotes) {
        if (!line.starts_with(quote)) continue;
        const std::size_t last = line.rfind(quote);  // a name may contain quotes
        return last > 0 ? last + 1 : 0;
    }
    std::size_t end = line.size();
    for (std::size_t i = 0; i < kPointNumbers && end != std::string_view::npos && end > 0; ++i) {
        const std::size_t last = line.find_last_not_of(" \t", end - 1);
        if (last == std::string_view::npos) return 0;
        const std::size_t before = line.find_last_of(" \t", last);
        const std::size_t first = before == std::string_view::npos ? 0 : before + 1;
        std::string_view word = line.substr(first, last + 1 - first);
        if (!text::next_fortran_number(word) || !word.empty()) return 0;
        end = first;
    }
    return end;
}

bool begins_point(std::string_view line) {
    return !line.empty() && (kQuotes.find(line[0]) != std::string_view::npos ||
                             std::isalpha(static_cast<unsigned char>(line[0])) != 0);
}

class WavewatchReader {
  public:
    explicit WavewatchReader(const SpectrumSource& source) : in_(source.content, source.name) {}

    std::vector<SpectrumRecord> read() {
        read_header();
        const DirectionAxis axis = read_directions();
        std::vector<SpectrumRecord> records;
        while (in_.next_line()) {
            SpectrumRecord record;
            const std::size_t first = in_.line_number();
            catch_fault(record.fault, [&] { record.time = read_time(); });
            if (record.fault.empty()) {
                read_points(record.time, axis, records);
            } else {
                add(records, std::move(record));
                in_.resume_after(first, begins_time);
            }
        }
        return records;
    }

  private:
    void add(std::vector<SpectrumRecord>& records, SpectrumRecord record) const {
        require_room(in_.lines(), records.size(), values_.size());
        records.push_back(std::move(record));
    }

    /// Reads all points of one time. A point that cannot be read invalidates those after it only if
    /// the file ends there.
    void read_points(const std::string& time, const DirectionAxis& axis,
                     std::vector<SpectrumRecord>& records) {
        for (std::size_t point = 1; point <= points_; ++point) {
            SpectrumRecord record;
            record.time = time;
            std::size_t first = in_.line_number() + 1;
            bool ends = false;
            catch_fault(record.fault, [&] {
                ends = true;
                in_.need_line("point " + std::to_string(point) + " of " + std::to_string(points_));
                if (begins_time(in_.rest())) {
                    in_.hold_line();
                    throw in_.fail("a time where point " + std::to_string(point) + " of " +
                                   std::to_string(points_) + " should be");
                }
                ends = false;
                first = in_.line_number();
                read_point(record);
                record.frequency = frequency_;
                read_values();
                axis.fill(record, values_, kPi / 180.0);
            });
            const bool bad = !record.fault.empty();
            add(records, std::move(record));
            if (ends) return;
            if (!bad) continue;
            in_.resume_after(first, [](std::string_view line) {
                return begins_time(line) || begins_point(line);
            });
        }
    }

    void read_header() {
        in_.need_line("a header");
        const std::size_t magic = magic_bytes(in_.rest());
        if (magic == 0) throw in_.fail("does not begin with '" + std::string(kMagic) + "'");
        in_.skip(magic);
        const std::size_t frequencies = in_.count("frequencies", 2, kMaxFrequencies);
        directions_ = in_.count("directions", 3, kMaxDirections);
        require_directional_size(in_.lines(), frequencies * directions_);
        points_ = in_.count("points", 1, kMaxRecords);
        in_.leave_line();  // the name of the grid
        frequency_ = read_frequencies(in_, frequencies);
        in_.end_line("the frequencies");
        values_.resize(frequencies * directions_);
    }

    DirectionAxis read_directions() {
        std::vector<double> radians;
        while (radians.size() < directions_) {
            radians.push_back(in_.number("a direction"));
            in_.require_within(radians.back(), -7.0, 7.0, "a direction", "0 .. 2 pi (radians)");
        }
        in_.end_line("the directions");
        std::vector<double> degrees = even_circle(radians);
        for (double& d : degrees) d *= 180.0 / kPi;
        return direction_axis(in_.lines(), degrees, DirectionConvention::to_nautical);
    }

    std::string read_time() {
        const std::optional<UtcTime> time = match_time(in_.rest(), kTime);
        if (!time || !time->valid()) {
            throw in_.fail("'" + FreeForm::shown(in_.rest()) +
                           "' where a time like 20220912 060000 should be");
        }
        in_.skip(kTime.size());
        in_.end_line("the time");
        return time->text();
    }

    void read_point(SpectrumRecord& record) {
        const std::string_view line = in_.rest();
        const std::size_t bytes = name_bytes(line);
        if (bytes == 0) {
            throw in_.fail("'" + FreeForm::shown(line) +
                           "' where the name of a point, its place, depth, wind and current "
                           "should be");
        }
        std::string_view name = line.substr(0, bytes);
        const bool quoted = kQuotes.find(name[0]) != std::string_view::npos;
        if (quoted) name = name.substr(1, bytes - 2);
        record.station = text::printable(name.substr(0, name.find_last_not_of(" \t") + 1));
        in_.skip(bytes);
        record.latitude = in_.number_here("a latitude");
        in_.require_within(record.latitude, -90.0, 90.0, "a latitude", "-90 .. 90");
        record.longitude = in_.number_here("a longitude");
        in_.require_within(record.longitude, -180.0, 360.0, "a longitude", "-180 .. 360");
        const double depth = in_.number_here("a depth");
        in_.require_within(depth, -20000.0, 20000.0, "a depth", "at most 20000 m");
        if (depth >= 0.01) record.depth = depth;  // else not known, or land
        for (const char* what :
             {"a wind speed", "a wind direction", "a current speed", "a current direction"}) {
            in_.number_here(what);
        }
        in_.end_line("the current");
    }

    void read_values() {
        for (std::size_t j = 0; j < directions_; ++j) {
            for (std::size_t i = 0; i < frequency_.size(); ++i) {
                const double value = in_.number("a density");
                in_.require_within(value, -kMaxDensity, kMaxDensity, "a density",
                                   "0 .. 1e5 m^2/Hz/rad");
                values_[i * directions_ + j] = value;
            }
        }
        in_.end_line("the densities");
    }

    FreeForm in_;
    std::size_t directions_ = 0;
    std::size_t points_ = 0;
    std::vector<double> frequency_;
    std::vector<double> values_;  // [frequency][direction]
};

bool recognises(std::string_view content) {
    FreeForm in(content, "");
    return in.next_line() && magic_bytes(in.rest()) > 0;
}

}  // namespace

const SpectrumFormat kWavewatch = {"WAVEWATCH III point output", recognises,
                                   read_by<WavewatchReader>};

}  // namespace ocean
