// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables of spectra with a record in each column or row: see csv_wide.hpp. Two shapes are known.
//   Frequency,"JONSWAP (2m,8s)"     as MHKiT names its spectra; or the times of records, or the
//   0.04,0.0001                     names of stations. The frequency may have no title, as an
//   0.05,0.0123                     index of pandas.
//
//   ,0.04,0.05,0.06                 times in the first column, and in others further data of the
//   2024-03-01 12:00:00,0.1,0.2,0.1 record; the titles of the remaining columns are frequencies
//                                   in Hz.
#include "csv_wide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "csv_header.hpp"
#include "line_checks.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/density_units.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::csv {
namespace {

/// Columns beside a frequency that are no density, by how their names begin.
constexpr std::array<std::string_view, 10> kNoDensity = {
    "amp", "phase", "coh", "period", "height", "elev", "time", "dir", "theta", "spread"};

bool is_density_name(std::string_view title) {
    const std::string name = parse_title(title).name;
    return std::none_of(kNoDensity.begin(), kNoDensity.end(),
                        [&](std::string_view word) { return name.starts_with(word); });
}

bool is_record_column(Column column) {
    return column == time || column == station || column == latitude || column == longitude ||
           column == depth;
}

/// Returns a title's frequency [Hz]; nothing for a title that is not a number.
std::optional<double> frequency_title(std::string_view title) {
    if (title.find(',') == std::string_view::npos) return text::parse_number(title);
    std::string point(title);
    std::replace(point.begin(), point.end(), ',', '.');
    return text::parse_number(point);
}

/// Returns the position where the last brackets begin that are not within others; the end without
/// any.
std::size_t last_brackets(std::string_view title) {
    std::size_t last = title.size();
    int depth = 0;
    for (std::size_t i = 0; i < title.size(); ++i) {
        const bool open = title[i] == '(' || title[i] == '[';
        if (open && depth++ == 0) last = i;
        if (title[i] == ')' || title[i] == ']') --depth;
    }
    return last;
}

bool has_record_a_row(std::span<const std::string> titles) {
    std::size_t frequencies = 0;
    double below = -1.0;
    for (const std::string& title : titles) {
        if (const std::optional<double> f = frequency_title(title)) {
            if (!(*f > below)) return false;
            below = *f;
            ++frequencies;
        } else if (frequencies > 0 ||
                   (!is_row_index(title) && !is_record_column(column_of(title)))) {
            return false;
        }
    }
    return frequencies >= 2 && frequencies < titles.size() && below <= kMaxFrequency;
}

bool has_record_a_column(std::span<const std::string> titles) {
    if (titles.size() < 2) return false;
    const auto is_index = [](const std::string& title) { return is_row_index(title); };
    const auto axis = std::find_if_not(titles.begin(), titles.end(), is_index);
    const bool named = axis != titles.end() && column_of(*axis) == frequency;
    // Without a name the first column may be the frequency: its values decide.
    const auto first = named ? axis + 1 : titles.begin() + 1;
    if (first == titles.end()) return false;
    return (named || is_row_index(titles.front())) &&
           std::all_of(first, titles.end(), [](const std::string& title) {
               return !is_row_index(title) && column_of(title) == kNone && is_density_name(title) &&
                      mistyped_column(title).empty();
           });
}

class WideReader {
  public:
    explicit WideReader(const SpectrumSource& source) : table_(source.content, source.name) {}

    std::vector<SpectrumRecord> read_columns() {
        const auto& titles = table_.titles();
        std::size_t axis = 0;
        while (axis + 1 < titles.size() && is_row_index(titles[axis])) ++axis;
        const bool named = column_of(titles[axis]) == frequency;
        if (!named) axis = 0;
        const double to_hz =
            named ? frequency_factor(table_.lines(), parse_title(titles[axis]).unit) : 1.0;
        std::vector<double> factors;
        std::vector<SpectrumRecord> records;
        for (std::size_t i = axis + 1; i < titles.size(); ++i) {
            require_room(table_.lines(), records.size());
            records.emplace_back();
            factors.push_back(describe(titles[i], to_hz != 1.0, records.back()));
            if (!named) {
                records.back().warnings.push_back(
                    "the first column of the table has no title: it is taken as the frequency in "
                    "Hz");
            }
        }
        while (next_row(records)) {
            const double f = frequency_cell(axis, to_hz);
            for (std::size_t i = 0; i < records.size(); ++i) {
                add(records[i], f, axis + 1 + i, factors[i]);
            }
        }
        check_axis(records.front().frequency, named);
        return records;
    }

    std::vector<SpectrumRecord> read_rows() {
        const auto& titles = table_.titles();
        std::array<std::size_t, kColumns> place{};
        place.fill(kNone);
        std::size_t first = 0;
        for (; !frequency_title(titles[first]); ++first) {
            const Column column = column_of(titles[first]);
            if (column != kNone) place[column] = first;
            if (column == kNone && place[time] == kNone) place[time] = first;  // pandas' index
        }
        std::vector<SpectrumRecord> records;
        while (true) {
            SpectrumRecord record;
            bool more = true;
            const std::size_t before = table_.lines().number();
            catch_fault(record.fault, [&] {
                more = table_.next();
                if (more) read_row(record, place, first);
            });
            if (!more) break;
            if (table_.lines().number() == before) throw Error(ErrorKind::bad_file, record.fault);
            if (record.fault.empty() && record.frequency.size() < 2) continue;
            require_room(table_.lines(), records.size());
            record.warnings.push_back(
                "the titles of the table are taken as frequencies in Hz, its values as densities "
                "in m^2/Hz");
            records.push_back(std::move(record));
        }
        return records;
    }

  private:
    static DensityUnit unit_of(std::string_view title) {
        return parse_density_unit(parse_title(title).unit, DensityOver::frequency);
    }
    /// Returns the factor of its densities. Sets time or station, and a warning for an assumption.
    double describe(std::string_view title, bool radians, SpectrumRecord& record) const {
        // "S(f) [m2/Hz]" has its unit in the last brackets, "S (m2/(rad/s))" in the first.
        DensityUnit unit = unit_of(title);
        if (!unit.fault.empty()) unit = unit_of(title.substr(last_brackets(title)));
        const bool has_unit = unit.fault.empty();
        if (radians && !has_unit) {
            throw table_.lines().fail(
                "over rad/s the density needs a unit in its title, like 'density (m2/Hz)'");
        }
        const std::string_view name =
            has_unit ? trimmed(title.substr(0, title.find_first_of("(["))) : title;
        const std::optional<std::string> when = time_text(name);
        if (when) record.time = *when;
        if (!when) record.station = text::printable(name);
        if (!has_unit) {
            record.warnings.push_back("the column '" + text::printable(title, 40) +
                                      "' is taken as a density in m^2/Hz");
        }
        return has_unit ? unit.factor : 1.0;
    }

    /// Steps to the next row. A line that is not a row invalidates the whole table: each record has
    /// a value in it.
    bool next_row(const std::vector<SpectrumRecord>& records) {
        if (!table_.next()) return false;
        if (records.front().frequency.size() + 1 > kMaxFrequencies) {
            throw table_.lines().fail("more than 4096 frequencies");
        }
        return true;
    }
    double frequency_cell(std::size_t column, double to_hz) {
        const std::optional<double> read = table_.number(column);
        if (read && *read * to_hz >= 0.0 && *read * to_hz <= kMaxFrequency) return *read * to_hz;
        throw table_.lines().fail("'" + text::printable(table_.cell(column), 20) +
                                  "' is not a frequency within " + std::string(kFrequencyRange));
    }
    /// Appends a value; one that is missing counts as 0.
    void add(SpectrumRecord& record, double f, std::size_t column, double factor) {
        record.frequency.push_back(f);
        record.density.push_back(0.0);
        if (!record.fault.empty()) return;
        catch_fault(record.fault, [&] { record.density.back() = value(column) * factor; });
    }
    double value(std::size_t column) {
        const std::optional<double> read = table_.number(column);
        const std::string_view cell = table_.cell(column);
        if (read ? std::isnan(*read) : is_missing(cell)) return 0.0;
        if (read && std::abs(*read) <= 1e6) return *read;
        throw table_.lines().fail("'" + text::printable(cell, 20) + "' is not a density");
    }

    /// Refuses row numbers without a title, which look like frequencies of whole Hz.
    void check_axis(const std::vector<double>& f, bool named) const {
        bool numbers = !named && f.size() >= 2;
        for (std::size_t i = 1; i < f.size(); ++i) {
            numbers = numbers && f[i] - f[i - 1] == 1.0 && f[i] == std::floor(f[i]);
        }
        if (numbers) {
            throw table_.lines().fail(
                "the first column numbers the rows, and none is named frequency");
        }
    }

    void read_row(SpectrumRecord& record, const std::array<std::size_t, kColumns>& place,
                  std::size_t first) {
        const auto cell = [&](Column column) {
            return place[column] == kNone ? std::string_view() : table_.cell(place[column]);
        };
        record.station = text::printable(cell(station));
        if (!is_missing(cell(time))) {
            const std::optional<std::string> when = time_text(cell(time));
            if (!when) {
                throw table_.lines().fail("the time '" + text::printable(cell(time), 30) +
                                          "' is not UTC like 2020-06-08T03:50");
            }
            record.time = *when;
        }
        for (const auto& [column, member] : {std::pair{latitude, &SpectrumRecord::latitude},
                                             std::pair{longitude, &SpectrumRecord::longitude},
                                             std::pair{depth, &SpectrumRecord::depth}}) {
            if (is_missing(cell(column))) continue;
            record.*member = table_.number(place[column]).value_or(kMissing);
        }
        for (std::size_t i = first; i < table_.titles().size(); ++i) {
            if (is_missing(table_.cell(i))) continue;
            const double density = value(i);
            record.frequency.push_back(*frequency_title(table_.titles()[i]));
            record.density.push_back(density);
        }
    }

    TableReader table_;
};

}  // namespace

WideShape shape_of(std::span<const std::string> titles) {
    if (has_record_a_row(titles)) return WideShape::record_a_row;
    if (has_record_a_column(titles)) return WideShape::record_a_column;
    return WideShape::none;
}

std::vector<SpectrumRecord> read_wide(const SpectrumSource& source, WideShape shape) {
    WideReader reader(source);
    return shape == WideShape::record_a_row ? reader.read_rows() : reader.read_columns();
}

}  // namespace ocean::csv
