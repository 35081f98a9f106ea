// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// NDBC spectra of the last five days, 41010_5day.spectral: the density and all directional
// quantities in one table. A line of time and number of bands, then a line for each band:
//   YYYY MM DD hh mm bands
//   freq bandwidth energy r1 r2 alpha1 alpha2
//   2024 03 01 11 00 20
//   0.0400 0.0040 0.0000 0.91 0.68 90.0 90.0
#include <algorithm>
#include <array>
#include <cmath>

#include "ndbc.hpp"

namespace ocean {
namespace {

using ndbc::Bin;
using ndbc::Quantity;

/// By quantity, as the second line names the columns.
constexpr std::string_view kColumnNames[] = {"energy", "alpha1", "alpha2", "r1", "r2"};
static_assert(std::size(kColumnNames) == enum_count<Quantity>());
constexpr std::size_t kMaxColumns = 64;

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (auto word = next_word(line); !word.empty() && words.size() < kMaxColumns;
         word = next_word(line)) {
        words.push_back(word);
    }
    return words;
}

/// Recognises "YYYY MM DD hh mm bands".
bool names_times(std::string_view line) {
    if (line.starts_with('#')) line.remove_prefix(1);
    const std::vector<std::string_view> words = words_of(line);
    return words.size() == 6 && words[0].starts_with("YY") && words[5] == "bands";
}

class FiveDayReader {
  public:
    explicit FiveDayReader(const SpectrumSource& source) : lines_(source.content, source.name) {}

    std::vector<SpectrumRecord> read(const std::string& station) {
        std::vector<SpectrumRecord> records;
        bool more = next_data_line();
        while (more) {
            require_room(lines_, records.size());
            SpectrumRecord record;
            record.station = station;
            const std::size_t first = lines_.number();
            catch_fault(record.fault, [&] { read_record(record); });
            const bool nothing_measured = record.fault.empty() && record.frequency.size() < 2;
            const bool bad = !record.fault.empty();
            const bool early = bad && lines_.number() > first && begins_record();
            if (!early) more = next_data_line();
            while (more && bad && !begins_record()) more = next_data_line();
            if (!nothing_measured) records.push_back(std::move(record));
        }
        return records;
    }

  private:
    /// Skips comments and header lines, which name the columns.
    bool next_data_line() {
        while (lines_.next_filled()) {
            if (names_times(lines_.line())) continue;
            const std::vector<std::string_view> words = words_of(lines_.line());
            if (words[0].ends_with("freq")) {
                read_columns(words);
            } else if (!words[0].starts_with('#')) {
                return true;
            }
        }
        return false;
    }

    void read_columns(const std::vector<std::string_view>& words) {
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const auto found = std::find(words.begin(), words.end(), kColumnNames[i]);
            if (found == words.end()) {
                throw lines_.fail("the column " + std::string(kColumnNames[i]) + " is missing");
            }
            columns_[i] = static_cast<std::size_t>(found - words.begin());
        }
        width_ = words.size();
    }

    /// Returns true for a line with a time and a number, which no band has.
    bool begins_record() const {
        bool good = words_of(lines_.line()).size() == 6;
        std::string fault;
        std::string_view line = lines_.line();
        catch_fault(fault, [&] { ndbc::next_time(lines_, line, true); });
        return good && fault.empty();
    }

    void read_record(SpectrumRecord& record) {
        if (width_ == 0) throw lines_.fail("values before the line that names their columns");
        std::string_view line = lines_.line();
        record.time = ndbc::next_time(lines_, line, true);
        const double bands = ndbc::number(lines_, next_word(line), "a number of bands");
        if (!(bands >= 2.0 && bands <= kMaxFrequencies && bands == std::floor(bands))) {
            throw lines_.fail("the number of bands is not within 2 .. 4096");
        }
        std::vector<Bin> listed;
        for (double i = 0.0; i < bands; ++i) {
            if (!lines_.next_filled()) throw lines_.fail("the file ends within this record");
            read_band(record, listed);
        }
        drop_unknown_moments(record);
    }

    void read_band(SpectrumRecord& record, std::vector<Bin>& listed) const {
        const std::vector<std::string_view> words = words_of(lines_.line());
        if (words.size() != width_) {
            throw lines_.fail(lines_.cut_off()
                                  ? "the file ends within this line"
                                  : std::to_string(words.size()) + " values where a band has " +
                                        std::to_string(width_));
        }
        listed.push_back({ndbc::next_frequency(lines_, words[0], listed), kMissing});
        std::array<double, enum_count<Quantity>()> values{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = ndbc::value(lines_, words[columns_[i]], static_cast<Quantity>(i), 1.0);
        }
        const auto& [density, alpha1, alpha2, r1, r2] = values;
        if (std::isnan(density)) return;
        record.frequency.push_back(listed.back().frequency);
        record.density.push_back(density);
        append_mean_and_principal(
            record, travel_direction(alpha1, DirectionConvention::from_nautical),
            travel_direction(alpha2, DirectionConvention::from_nautical), r1, r2);
    }

    LineReader lines_;
    std::size_t width_ = 0;  // words of a band; 0 before the line that names them
    std::array<std::size_t, enum_count<Quantity>()> columns_{};
};

bool recognises(std::string_view content) {
    return ndbc::begins_with_header(content, names_times);
}

std::vector<SpectrumRecord> read(const SpectrumSource& source) {
    std::string_view stem = source.name;
    stem.remove_prefix(stem.find_last_of("/\\") + 1);
    stem = stem.substr(0, stem.find('.'));
    return FiveDayReader(source).read(ndbc::station_of(stem));
}

}  // namespace

const SpectrumFormat kNdbcFiveDay = {"NDBC of five days (.spectral)", recognises, read};

}  // namespace ocean
