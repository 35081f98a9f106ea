// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectra as CSV, for data without a format of its own, in the dialects that csv_rows.hpp lists:
// commas, semicolons, tabs or blanks, decimal points or commas, UTF-8 or UTF-16. Lines that begin
// with '#' and blank lines are skipped. The first remaining line names the columns, in any order
// and any case; each line after it is one value of the spectrum. A text may be in "double quotes".
//
//   frequency              (Hz) or (rad/s)                                        required
//   density                the value of a row; empty or nan = missing             required
//     without a direction: (m2/Hz), (m2 s), (m2/(rad/s)) and their kind: see density_units.hpp
//     with a direction:    (m2/Hz/deg), (m2/Hz/rad), or (m2 s/rad), per Hz and rad as in ERA5
//   direction              (deg) or (rad), coming from, clockwise from north
//   direction_to           travelling to, clockwise from north
//   direction_cartesian    travelling to, counter-clockwise from east             one of the three
//   mean_direction, mean_direction_to or mean_direction_cartesian, and spread
//                          (deg) or (rad) at a frequency: circular mean, standard deviation
//   a1 b1 a2 b2            moments of the travel direction, counter-clockwise from east
//   time                   UTC: 2020-06-08T03:50 or 2020-06-08; +02:00 after it is converted
//   station                a text
//   latitude longitude     (deg), both or none
//   depth                  (m), one for each record
//
// A unit is in () or [] after the name; without one it is the first in the list, but a density over
// rad/s must name its own. Columns without a name, such as row numbers, are skipped. Rows with
// equal time, station, latitude and longitude form one record. Its rows are in any order: one per
// frequency, or with a direction one for each of its frequencies and directions. Tables of another
// shape, a record per column or row, belong to csv_wide.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "csv_header.hpp"
#include "csv_wide.hpp"
#include "line_checks.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

using namespace csv;

struct Row {
    double frequency;
    double direction;  // degrees, as the file has it; 0 without directions
    double density;    // NaN = missing
    std::size_t line;
    std::size_t moments;  // place in Group::moments
};

/// By column - direction and by column - mean_direction.
constexpr std::array kConventions = {DirectionConvention::from_nautical,
                                     DirectionConvention::to_nautical,
                                     DirectionConvention::to_cartesian};

/// The rows of one record.
struct Group {
    SpectrumRecord record;  // without the spectrum
    std::vector<Row> rows;
    std::vector<std::array<double, 4>> moments;  // a1 b1 a2 b2, or mean and spread in degrees
};

/// A row that cannot be read costs its record.
struct RowFault {
    std::string text;
};

class CsvReader {
  public:
    explicit CsvReader(const SpectrumSource& source)
        : name_(source.name), table_(source.content, source.name), header_(table_) {
        direction_ = header_.any_of(direction);
        mean_ = header_.any_of(mean_direction);
    }

    std::vector<SpectrumRecord> read() {
        while (next_row()) {
            try {
                read_row();
            } catch (const RowFault& fault) {
                blame(fault.text);
            }
        }
        if (groups_.empty() && !lost_.empty()) throw Error(ErrorKind::bad_file, lost_);
        std::vector<SpectrumRecord> records;
        for (Group& group : groups_) {
            const auto known = [](const Row& row) { return !std::isnan(row.density); };
            const bool bad = !group.record.fault.empty();
            if (!bad && std::none_of(group.rows.begin(), group.rows.end(), known)) continue;
            SpectrumRecord record = group.record;
            if (!bad) {
                catch_fault(record.fault, [&] {
                    SpectrumRecord read =
                        direction_ == kNone ? over_frequency(group) : over_both(group);
                    clean_record(read);
                    const std::string fault = record_fault(read);
                    if (!fault.empty()) throw fail_record(group, fault);
                    record = std::move(read);
                });
            }
            records.push_back(std::move(record));
            group = {};
        }
        return records;
    }

  private:
    Error fail_at(std::size_t line, std::string_view message) const {
        return text::error_at(ErrorKind::bad_file, name_, line, message);
    }
    static std::size_t last_line(const Group& group) {
        return std::max_element(group.rows.begin(), group.rows.end(),
                                [](const Row& a, const Row& b) { return a.line < b.line; })
            ->line;
    }
    Error fail_record(const Group& group, const std::string& message) const {
        return fail_at(last_line(group), "in the record that ends here: " + message);
    }

    /// Steps to the next row; false at the end. A line that is not a row invalidates the record
    /// before it and the one after it: it may have belonged to either.
    bool next_row() {
        while (true) {
            const std::size_t before = table_.lines().number();
            try {
                return table_.next();
            } catch (const Error& error) {
                if (table_.lines().number() == before) throw;  // a fault of the table as a whole
                lost_ = error.what();
                if (!groups_.empty()) blame(lost_);
            }
        }
    }
    void blame(const std::string& fault) {
        std::string& of_group = groups_[current_].record.fault;
        if (of_group.empty()) of_group = fault;
        groups_[current_].rows = {};
        groups_[current_].moments = {};
    }
    RowFault bad_row(std::string_view message) const {
        return {table_.lines().fail(message).what()};
    }

    void read_row() {
        Group& group = group_of_row();
        if (!lost_.empty()) blame(std::exchange(lost_, std::string()));
        if (!group.record.fault.empty()) return;
        check_depth(group);
        if (group.rows.size() == (direction_ == kNone ? kMaxFrequencies : kMaxDirectionalValues)) {
            throw bad_row("more rows than the 4096 frequencies or 131072 values of a record");
        }
        Row row{number(frequency, 0.0, kMaxFrequency), 0.0, optional_number(density, -1e6, 1e6),
                table_.lines().number(), group.moments.size()};
        if (direction_ != kNone) row.direction = number(direction_, -360.0, 720.0);
        if (mean_ != kNone) {
            const double mean = optional_number(mean_, -360.0, 720.0);
            group.moments.push_back({travel_direction(mean, kConventions[mean_ - mean_direction]),
                                     optional_number(spread, 0.0, 180.0)});
        } else if (header_.has(a1)) {
            group.moments.push_back({optional_number(a1, -1.0, 1.0), optional_number(b1, -1.0, 1.0),
                                     optional_number(a2, -1.0, 1.0),
                                     optional_number(b2, -1.0, 1.0)});
        }
        group.rows.push_back(row);
    }

    std::string_view field(Column column) const {
        return header_.has(column) ? table_.cell(header_.place(column)) : std::string_view();
    }
    /// Returns a number; NaN for an empty cell or nan. The limits are in the record's unit.
    double optional_number(Column column, double low, double high) {
        const std::string_view word = field(column);
        if (word.empty()) return kMissing;
        const std::optional<double> read = table_.number(header_.place(column));
        if (!read && is_missing(word)) return kMissing;
        const auto named = [&] {
            return "the " + std::string(name_of(column)) + " '" + text::printable(word, 20) + "'";
        };
        if (!read) throw bad_row(named() + " is not a number");
        const double value = *read * header_.factor(column);
        if (std::isnan(value) || (value >= low && value <= high)) return value;
        throw bad_row(named() + " is not within " + shortest_text(std::max(low, min_of(column))) +
                      " .. " + shortest_text(high));
    }
    /// Returns the min that a message states: noise below 0 is accepted, see clean_record.
    static double min_of(Column column) {
        return column == density ? 0.0 : -std::numeric_limits<double>::infinity();
    }
    double number(Column column, double low, double high) {
        const double value = optional_number(column, low, high);
        if (!std::isnan(value)) return value;
        throw bad_row("the " + std::string(name_of(column)) + " is missing");
    }

    /// Returns the group of a row. Rows of one record usually follow each other: only a change is
    /// looked up.
    Group& group_of_row() {
        std::string key;
        for (const Column column : {time, station, latitude, longitude}) {
            key += std::string(field(column)) + '\n';
        }
        if (!groups_.empty() && key == key_) return groups_[current_];
        key_ = std::move(key);
        SpectrumRecord record;
        std::string name;
        try {
            record.station = read_station();
            record.time = read_time();
            record.latitude = optional_number(latitude, -90.0, 90.0);
            record.longitude = optional_number(longitude, -180.0, 360.0);
            record.depth = optional_number(depth, 0.01, 20000.0);
            const auto text = [](double value) { return format_text("%f\n", value); };
            name = record.time + '\n' + record.station + '\n' + text(record.latitude) +
                   text(record.longitude);
        } catch (const RowFault& fault) {
            record.fault = fault.text;
            name = '\n' + key_;
        }
        const auto [found, added] = group_by_key_.emplace(std::move(name), groups_.size());
        if (added) {
            require_room(table_.lines(), groups_.size());
            groups_.push_back({std::move(record), {}, {}});
        }
        current_ = found->second;
        return groups_[current_];
    }
    void check_depth(const Group& group) {
        const double here = optional_number(depth, 0.01, 20000.0);
        const bool same =
            here == group.record.depth || (std::isnan(here) && std::isnan(group.record.depth));
        if (!same) throw bad_row("the depth differs from that of the record's first row");
    }
    std::string read_time() const {
        const std::string_view word = field(time);
        if (is_missing(word)) return "";
        const std::optional<std::string> read = time_text(word);
        if (read) return *read;
        throw bad_row("the time '" + text::printable(word, 30) +
                      "' is not UTC like 2020-06-08T03:50");
    }
    std::string read_station() const {
        std::string text(field(station).substr(0, 256));
        for (std::size_t at = 0; (at = text.find("\"\"", at)) < text.size(); ++at)
            text.erase(at, 1);
        return text::printable(text);
    }

    SpectrumRecord over_frequency(Group& group) const {
        std::sort(group.rows.begin(), group.rows.end(),
                  [](const Row& a, const Row& b) { return a.frequency < b.frequency; });
        SpectrumRecord record = group.record;
        for (std::size_t i = 0; i < group.rows.size(); ++i) {
            const Row& row = group.rows[i];
            if (i > 0 && group.rows[i - 1].frequency == row.frequency) {
                throw fail_at(std::max(group.rows[i - 1].line, row.line),
                              "this frequency appears twice in one record");
            }
            if (std::isnan(row.density)) continue;
            record.frequency.push_back(row.frequency);
            record.density.push_back(row.density);
            if (group.moments.empty()) continue;
            const std::array<double, 4>& values = group.moments[row.moments];
            if (mean_ != kNone) append_mean_and_spread(record, values[0], values[1]);
            if (mean_ == kNone) append_moments(record, values);
        }
        drop_unknown_moments(record);
        return record;
    }

    SpectrumRecord over_both(Group& group) const {
        std::sort(group.rows.begin(), group.rows.end(), [](const Row& a, const Row& b) {
            return std::tie(a.frequency, a.direction, a.line) <
                   std::tie(b.frequency, b.direction, b.line);
        });
        SpectrumRecord record = group.record;
        std::vector<double> directions;
        for (const Row& row : group.rows) {
            directions.push_back(row.direction);
            if (record.frequency.empty() || record.frequency.back() != row.frequency) {
                record.frequency.push_back(row.frequency);
            }
        }
        std::sort(directions.begin(), directions.end());
        directions.erase(std::unique(directions.begin(), directions.end()), directions.end());
        check_grid(group, record.frequency, directions);
        const std::string fault = DirectionAxis::fault(directions);
        if (!fault.empty()) throw fail_record(group, fault);
        std::vector<double> values;
        for (const Row& row : group.rows) values.push_back(row.density);
        DirectionAxis(directions, kConventions[direction_ - direction]).fill(record, values, 1.0);
        return record;
    }

    /// Checks that the rows are a grid: sorted, each must have the frequency and direction of its
    /// position.
    void check_grid(const Group& group, const std::vector<double>& frequencies,
                    const std::vector<double>& directions) const {
        for (std::size_t i = 0; i < frequencies.size() * directions.size(); ++i) {
            const double f = frequencies[i / directions.size()];
            const double d = directions[i % directions.size()];
            if (i < group.rows.size() && group.rows[i].frequency == f &&
                group.rows[i].direction == d) {
                continue;
            }
            const bool twice = i > 0 && i < group.rows.size() &&
                               group.rows[i].frequency == group.rows[i - 1].frequency &&
                               group.rows[i].direction == group.rows[i - 1].direction;
            if (twice) {
                throw fail_at(group.rows[i].line,
                              "this frequency and direction appear twice in one record");
            }
            throw fail_record(group, format_text("no row for %.6g Hz and %.6g degrees", f, d));
        }
        const std::size_t cells = frequencies.size() * directions.size();
        if (group.rows.size() > cells) {
            throw fail_at(group.rows[cells].line,
                          "this frequency and direction appear twice in one record");
        }
    }

    std::string_view name_;
    TableReader table_;
    Header header_;
    Column direction_ = kNone;
    Column mean_ = kNone;
    std::string lost_;  // the fault of a line that may belong to the next row's record
    std::vector<Group> groups_;
    std::map<std::string, std::size_t> group_by_key_;
    std::string key_;  // of the previous row
    std::size_t current_ = 0;
};

bool recognises(std::string_view content) {
    const std::vector<std::string> titles = titles_of(content);
    if (titles.size() < 2) return false;
    return shape_of(titles) != WideShape::none ||
           std::any_of(titles.begin(), titles.end(), [](const std::string& title) {
               const Column column = column_of(title);
               return column == frequency || column == density;
           });
}

std::vector<SpectrumRecord> read(const SpectrumSource& source) {
    const WideShape shape = shape_of(titles_of(source.content));
    return shape == WideShape::none ? CsvReader(source).read() : read_wide(source, shape);
}

}  // namespace

const SpectrumFormat kCsv = {"CSV with the columns frequency and density", recognises, read};

}  // namespace ocean
