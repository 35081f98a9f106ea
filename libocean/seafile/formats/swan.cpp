// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Standard spectral files of SWAN, over frequency or over frequency and direction (SWAN user
// manual, appendix on spectrum files). A header of keywords, each with its numbers on the lines
// below:
//   SWAN 1;  TIME, or ITER in test output (none: stationary);  LONLAT or LOCATIONS (metres);
//   AFREQ or RFREQ [Hz];  NDIR or CDIR [degrees] (none: a spectrum over frequency only);
//   QUANT: name, unit and exception value of each quantity: VaDens, EnDens, or AcDens in hotfiles
// then for each time (or iteration, of which the last is the result) a line with it, and for each
// location
//   FACTOR, a number, and a line of numbers for each frequency; or ZERO; or NODATA
// or, over frequency only, LOCATION k and a line of all quantities for each frequency; or NODATA. A
// line that begins with $ is a comment, and so is any text after the values of the header. A reader
// of spectra: turns such a file into records in libocean's conventions.
#include "free_form.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/spreading.hpp"
#include "swan_header.hpp"

namespace ocean {
namespace {

/// The first year of two digits: SWAN is of 1993 and rarely computes times before 1950.
constexpr int kFirstYear = 1950;

/// Returns the circular standard deviation [degrees] of cos^m about the mean, over a half circle:
/// with r1 = G(m/2 + 1)^2 / (G(m/2 + 1/2) G(m/2 + 3/2)), G the gamma function, it is sqrt(2 (1 -
/// r1)); 31.5 degrees for m = 2.
double spread_of_power(double m) {
    const double r1 = std::exp(2.0 * std::lgamma(0.5 * m + 1.0) - std::lgamma(0.5 * m + 0.5) -
                               std::lgamma(0.5 * m + 1.5));
    return circular_spread(r1) * (180.0 / kPi);
}

class SwanReader {
  public:
    explicit SwanReader(const SpectrumSource& source)
        : in_(source.content, source.name, '$'), header_(read_swan_header(in_)) {
        values_.resize(header_.directions * header_.frequency.size());
    }

    std::vector<SpectrumRecord> read() {
        if (header_.stationary()) {
            read_places("");
            if (in_.next_line()) {
                add_fault("", in_.fail("'" + FreeForm::shown(in_.rest()) +
                                       "' after the last location of a stationary file"));
            }
            return std::move(records_);
        }
        while (in_.next_line()) {
            const std::size_t first = in_.line_number();
            std::string time;
            std::string fault;
            catch_fault(fault, [&] { time = header_.iterations ? read_iteration() : read_time(); });
            if (fault.empty()) {
                read_places(time);
            } else {
                add_fault("", Error(ErrorKind::bad_file, fault));
                in_.resume_after(first, [&](std::string_view line) { return begins_time(line); });
            }
        }
        return std::move(records_);
    }

  private:
    std::string read_time() {
        std::string_view text = in_.rest();
        if (text.starts_with('\'')) text.remove_prefix(1);
        std::optional<UtcTime> time = match_time(text, header_.time_pattern);
        if (time && time->year < 100) time->year += time->year < kFirstYear % 100 ? 2000 : 1900;
        const std::string_view after = time ? text.substr(header_.time_pattern.size()) : "";
        const bool ends = after.empty() || after.find_first_of(" \t'") == 0;
        if (!time || !time->valid() || !ends) {
            throw in_.fail("'" + FreeForm::shown(text) + "' where a time like " +
                           std::string(header_.time_pattern) + " should be");
        }
        return time->text();
    }

    /// Reads the number before each iteration, and returns an empty time.
    std::string read_iteration() {
        const double number = in_.number_here("the number of an iteration");
        if (number < 0.0 || number != std::floor(number)) {
            throw in_.fail(in_.last_number() + " is not the number of an iteration");
        }
        iteration_ = in_.last_number();
        ++iterations_read_;
        in_.leave_line();
        return "";
    }

    /// Returns true for a line that begins a time. Does not check the year, since no other line
    /// looks alike.
    bool begins_time(std::string_view line) const {
        if (header_.iterations) return false;
        if (line.starts_with('\'')) line.remove_prefix(1);
        const std::optional<UtcTime> time = match_time(line, header_.time_pattern);
        if (!time) return false;
        const std::string_view after = line.substr(header_.time_pattern.size());
        return after.empty() || after.find_first_of(" \t'") == 0;
    }
    bool begins_place(std::string_view line) const {
        for (const std::string_view word : {"FACTOR", "ZERO", "NODATA", "LOCATION"}) {
            if (line.starts_with(word)) return true;
        }
        return false;
    }

    void add_fault(const std::string& time, const Error& fault) {
        require_room(in_.lines(), records_.size(), 1);
        SpectrumRecord record;
        record.time = time;
        record.fault = fault.what();
        records_.push_back(std::move(record));
    }

    /// Reads all locations of one time. The file does not name them: after one that cannot be read,
    /// the others can be assigned to their places only if all are present.
    void read_places(const std::string& time) {
        std::vector<SpectrumRecord> before;
        if (header_.iterations) before.swap(records_);  // the last one is the result
        std::size_t found = 0;
        std::optional<std::size_t> first_fault;  // index in records_
        for (std::size_t k = 0; k < header_.places.size(); ++k) {
            SpectrumRecord record;
            record.station = header_.places[k].station;
            record.latitude = header_.places[k].latitude;
            record.longitude = header_.places[k].longitude;
            record.time = time;
            bool ends = false;
            bool known = true;
            std::size_t first = in_.line_number() + 1;
            catch_fault(record.fault, [&] {
                ends = true;
                in_.need_line("location " + std::to_string(k + 1) + " of " +
                              std::to_string(header_.places.size()));
                if (!header_.stationary() && begins_time(in_.rest())) {
                    in_.hold_line();
                    throw in_.fail("a time where location " + std::to_string(k + 1) + " of " +
                                   std::to_string(header_.places.size()) + " should be");
                }
                ends = false;
                first = in_.line_number();
                known = read_place(k, record);
            });
            const bool bad = !record.fault.empty();
            found += ends ? 0 : 1;
            if (bad && !first_fault) first_fault = records_.size();
            if (bad || known) {
                require_room(in_.lines(), records_.size(),
                             header_.frequency.size() + values_.size());
                records_.push_back(std::move(record));
            }
            if (ends) break;
            if (!bad) continue;
            in_.resume_after(first, [&](std::string_view line) {
                return begins_place(line) || (!header_.stationary() && begins_time(line));
            });
        }
        if (first_fault && found != header_.places.size()) distrust(*first_fault);
        if (header_.iterations) tell_iteration(first_fault.has_value(), std::move(before));
    }

    void distrust(std::size_t first) {
        for (std::size_t i = first; i < records_.size(); ++i) {
            if (!records_[i].fault.empty()) continue;
            records_[i].fault = in_.fail(
                                       "fewer locations than the header has, so that the place of "
                                       "this one is not known")
                                    .what();
        }
    }

    /// Keeps the iteration before where the last one cannot be read as a whole.
    void tell_iteration(bool bad, std::vector<SpectrumRecord> before) {
        if (iterations_read_ < 2) return;
        const bool keep = bad && !before.empty() &&
                          std::all_of(before.begin(), before.end(),
                                      [](const SpectrumRecord& r) { return r.fault.empty(); });
        const std::string warning =
            "the file has " + std::to_string(iterations_read_) + " iterations of one state: " +
            (keep ? "number " + iteration_ + " cannot be read whole, and the one before it is taken"
                  : "the last, number " + iteration_ + ", is the result");
        if (keep) records_ = std::move(before);
        for (SpectrumRecord& record : records_) record.warnings = {warning};
    }

    /// Reads the spectrum of location k. Returns false if it has none.
    bool read_place(std::size_t k, SpectrumRecord& record) {
        const std::string_view word = in_.word();
        if (word == "NODATA") return false;
        record.frequency = header_.frequency;
        if (!header_.directional()) return read_rows(word, k + 1, record);
        read_directional(word, record);
        return true;
    }

    void read_directional(std::string_view word, SpectrumRecord& record) {
        if (word == "ZERO") {
            std::fill(values_.begin(), values_.end(), 0.0);
        } else if (word == "FACTOR") {
            const double factor = in_.header_number("a factor");
            in_.require_within(factor, 0.0, 1e300, "a factor", "0 or more");
            in_.leave_line();
            read_values(factor);
        } else {
            throw in_.fail("'" + FreeForm::shown(word) +
                           "' where FACTOR, ZERO or NODATA should be");
        }
        header_.axis->fill(record, values_, 1.0);
    }

    /// Returns the factor to variance density. Action density is variance density over the angular
    /// frequency [SWAN, scientific manual, eq. 2.6]: N = E / (2 pi f).
    double scale_at(const SwanQuantity& quantity, std::size_t i) const {
        return quantity.action ? quantity.scale * 2.0 * kPi * header_.frequency[i] : quantity.scale;
    }

    void read_values(double factor) {
        const SwanQuantity& quantity = header_.quantities.front();
        const std::size_t bins = values_.size() / header_.frequency.size();
        for (std::size_t i = 0; i < header_.frequency.size(); ++i) {
            const double scale = factor * scale_at(quantity, i);
            for (std::size_t j = 0; j < bins; ++j) {
                const double digits = in_.number("a density");
                const bool missing = digits == quantity.exception;
                const double density = digits * scale;
                if (!missing && !(std::abs(density) <= kMaxBinDensity)) {
                    throw in_.fail(in_.last_number() + " times the factor is not within 0 .. " +
                                   "2500 m2/Hz/degr");
                }
                values_[i * bins + j] = missing ? kMissing : density;
            }
            in_.end_line("the values of all directions");
        }
    }

    /// Reads the rows of a spectrum over frequency. Returns false if it has none.
    bool read_rows(std::string_view word, std::size_t location, SpectrumRecord& record) {
        if (word != "LOCATION") {
            throw in_.fail("'" + FreeForm::shown(word) + "' where LOCATION or NODATA should be");
        }
        if (in_.number_here("the number of the location") != static_cast<double>(location)) {
            throw in_.fail("LOCATION " + in_.last_number() + " where LOCATION " +
                           std::to_string(location) + " should be");
        }
        in_.need_line("the first frequency");
        if (in_.rest().starts_with("NODATA")) return false;
        bool directions = false;
        for (std::size_t i = 0; i < header_.frequency.size(); ++i) directions |= read_row(record);
        if (!directions) record.a1 = record.b1 = record.a2 = record.b2 = {};
        return true;
    }

    /// Reads a row. Returns true if its direction and spread are known.
    bool read_row(SpectrumRecord& record) {
        double mean = kMissing;
        double spread = kMissing;
        for (const SwanQuantity& quantity : header_.quantities) {
            const double value = in_.number("a number");
            const bool missing = value == quantity.exception;
            switch (quantity.meaning) {
                case SwanMeaning::density:
                    record.density.push_back(
                        missing ? 0.0 : value * scale_at(quantity, record.density.size()));
                    if (missing) break;
                    in_.require_within(record.density.back(), -1e6, 1e6, "a density",
                                       "0 .. 1e6 m2/Hz");
                    break;
                case SwanMeaning::direction:
                    if (missing) break;
                    in_.require_within(value, -360.0, 720.0, "a direction", "-360 .. 720");
                    mean = travel_direction(value, quantity.convention);
                    break;
                case SwanMeaning::spread:
                    if (missing) break;
                    in_.require_within(value, 0.0, quantity.spread_is_power ? 1e4 : 180.0,
                                       "a spread", "0 .. 180 degrees, powers 0 .. 1e4");
                    spread = quantity.spread_is_power ? spread_of_power(value) : value;
                    break;
            }
        }
        in_.end_line("the quantities of a frequency");
        append_mean_and_spread(record, mean, spread);
        return !std::isnan(mean) && !std::isnan(spread);
    }

    FreeForm in_;
    const SwanHeader header_;
    std::size_t iterations_read_ = 0;
    std::string iteration_;       // the number of the last
    std::vector<double> values_;  // [frequency][direction]
    std::vector<SpectrumRecord> records_;
};

bool recognises(std::string_view content) {
    FreeForm in(content, "");
    if (!in.next_line() || in.word() != "SWAN") return false;
    return in.word().find_first_of("0123456789") == 0;
}

}  // namespace

const SpectrumFormat kSwan = {"SWAN spectra", recognises, read_by<SwanReader>};

}  // namespace ocean
