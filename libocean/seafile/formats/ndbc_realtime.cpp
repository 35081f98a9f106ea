// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// NDBC real-time spectra: a table of densities (.data_spec) and, beside it under the same stem,
// four tables of directional quantities (.swdir .swdir2 .swr1 .swr2). One line is one time:
//   #YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) ... >
//   2020 06 08 03 50 0.225 0.000 (0.033) 0.000 (0.038) ...
// The hourly tables of all stations (hour_12.data_spec) begin with the station: #STN YYYY MM ...
// Lines of metadata, with a '#', may precede the header.
#include <algorithm>

#include "ndbc.hpp"

namespace ocean {
namespace {

using ndbc::Bin;
using ndbc::Quantity;
using ndbc::Row;

/// By quantity, as the headers name the first column.
constexpr std::string_view kColumnNames[] = {"spec_1", "alpha1_1", "alpha2_1", "r1_1", "r2_1"};
constexpr std::string_view kSuffixes[] = {".data_spec", ".swdir", ".swdir2", ".swr1", ".swr2"};
static_assert(std::size(kColumnNames) == enum_count<Quantity>());
static_assert(std::size(kSuffixes) == enum_count<Quantity>());

/// The columns before the first value. Old files have no minutes, companion tables no separation
/// frequency.
struct Header {
    bool station = false;
    bool minutes = false;
    bool separation = false;
    Quantity quantity = Quantity::density;
};

/// One line, read from its front.
class Cursor {
  public:
    explicit Cursor(std::string_view line) : rest_(line) {}
    bool at_end() { return skip_blanks().empty(); }
    bool accept(char c) {
        if (!skip_blanks().starts_with(c)) return false;
        rest_.remove_prefix(1);
        return true;
    }
    /// Returns the text up to the next blank or parenthesis.
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
    cursor.accept('#');
    Header header;
    std::string_view first = cursor.word();
    if (first == "STN") {
        header.station = true;
        first = cursor.word();
    }
    if (!first.starts_with("YY")) return std::nullopt;
    for (std::string_view word = cursor.word(); !word.empty(); word = cursor.word()) {
        header.minutes |= word == "mm";
        header.separation |= word == "Sep_Freq";
        const auto name = std::find(std::begin(kColumnNames), std::end(kColumnNames), word);
        if (name == std::end(kColumnNames)) continue;
        header.quantity = static_cast<Quantity>(name - kColumnNames);
        return header;
    }
    return std::nullopt;
}

class TableReader {
  public:
    TableReader(std::string_view content, std::string_view name) : lines_(content, name) {}

    std::vector<Row> read(Quantity expected) {
        const auto read_header = [&](std::string_view line) {
            const std::optional<Header> header = parse_header(line);
            if (!header) return false;
            if (header->quantity != expected) {
                throw lines_.fail(wrong_table(header->quantity, expected));
            }
            header_ = header;
            return true;
        };
        return ndbc::read_rows(lines_, read_header,
                               [this](Row& row, const auto& before) { read_row(row, before); });
    }

  private:
    static std::string wrong_table(Quantity found, Quantity expected) {
        const auto suffix = [](Quantity q) {
            return std::string(kSuffixes[static_cast<std::size_t>(q)]);
        };
        return "this is a " + suffix(found) + " table where " + suffix(expected) + " is needed";
    }

    void read_row(Row& row, const std::vector<Row>& before) const {
        if (!header_) throw lines_.fail("values before the header line that names the columns");
        std::string_view line = lines_.line();
        if (header_->station) row.station = text::printable(next_word(line), 40);
        row.time = ndbc::next_time(lines_, line, header_->minutes);
        Cursor cursor(line);
        if (header_->separation) ndbc::number(lines_, cursor.word(), "a separation frequency");
        while (!cursor.at_end()) row.bins.push_back(read_bin(cursor, row.bins));
        if (row.bins.size() < 2) throw lines_.fail("fewer than 2 frequencies");
        if (before.empty() || row.station != before.back().station) return;
        check_length(row, before.back().bins);
    }

    /// Checks a line's length. A line shorter than the one before it is cut off, or a warning says
    /// so.
    void check_length(Row& row, const std::vector<Bin>& before) const {
        if (row.bins.size() >= before.size()) return;
        if (lines_.cut_off()) throw lines_.fail("the file ends within this line");
        if (row.bins.back().frequency != before[row.bins.size() - 1].frequency) return;
        row.warning = "line " + std::to_string(lines_.number()) + " has " +
                      std::to_string(row.bins.size()) + " frequencies where the line before has " +
                      std::to_string(before.size());
    }

    Bin read_bin(Cursor& cursor, const std::vector<Bin>& before) const {
        const std::string_view word = cursor.word();
        if (word.empty() || !cursor.accept('(')) throw not_pairs();
        const std::string_view frequency = cursor.word();
        if (!cursor.accept(')')) throw not_pairs();
        return {ndbc::next_frequency(lines_, frequency, before),
                ndbc::value(lines_, word, header_->quantity, 1.0)};
    }
    Error not_pairs() const { return lines_.fail("expected 'value (frequency)' pairs"); }

    LineReader lines_;
    std::optional<Header> header_;
};

/// Returns the four companions, or nothing if one of them is missing.
std::optional<ndbc::Companions> read_companions(const SpectrumSource& source) {
    if (!source.name.ends_with(kSuffixes[0]) || !source.companion) return std::nullopt;
    const std::string stem = source.name.substr(0, source.name.size() - kSuffixes[0].size());
    return ndbc::read_companions([&](Quantity quantity) -> std::optional<std::vector<Row>> {
        const std::string path = stem + std::string(kSuffixes[static_cast<std::size_t>(quantity)]);
        const std::optional<std::string> content = source.companion(path);
        if (!content) return std::nullopt;
        return TableReader(*content, path).read(quantity);
    });
}

/// Returns "41010" of ".../ndbc_41010.data_spec".
std::string station_of(std::string_view path) {
    if (!path.ends_with(kSuffixes[0])) return "";
    path.remove_suffix(kSuffixes[0].size());
    return ndbc::station_of(path.substr(path.find_last_of("/\\") + 1));
}

bool recognises(std::string_view content) {
    return ndbc::begins_with_header(content, parse_header);
}

std::vector<SpectrumRecord> read(const SpectrumSource& source) {
    const std::vector<Row> rows = TableReader(source.content, source.name).read(Quantity::density);
    return ndbc::make_records(station_of(source.name), rows, read_companions(source));
}

}  // namespace

const SpectrumFormat kNdbcRealtime = {"NDBC real-time (.data_spec with .swdir .swdir2 .swr1 .swr2)",
                                      recognises, read};

}  // namespace ocean
