// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// NDBC historical spectra: a table of densities for a year (or month), 41010w2019.txt, and beside
// it four of directional quantities: d (alpha1), i (alpha2), j (r1), k (r2) in place of the w. The
// header contains the frequencies, one line is one time:
//   #YY  MM DD hh mm   .0200   .0325   .0375 ...
//   2019 01 01 00 00    0.00    0.00    0.12 ...
// Old files have no minutes, no '#' or YYYY; some have a second line of units. Lines of metadata,
// with a '#', may precede the header.
#include <algorithm>
#include <set>

#include "ndbc.hpp"

namespace ocean {
namespace {

using ndbc::Bin;
using ndbc::Quantity;
using ndbc::Row;

/// By quantity, as the names of the files have them.
constexpr std::string_view kLetters = "wdijk";

/// The text after the names of the columns of time, and whether minutes are among these columns.
struct Header {
    bool minutes = false;
    std::string_view frequencies;
};

/// Returns the words after the '#', if the line begins with a year.
std::optional<std::string_view> header_words(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.starts_with('#')) line.remove_prefix(1);
    std::string_view rest = line;
    const std::string_view year = next_word(rest);
    return year == "YY" || year == "YYYY" ? std::optional(rest) : std::nullopt;
}

std::optional<Header> parse_header(std::string_view words) {
    for (const std::string_view name : {"MM", "DD", "hh"}) {
        if (next_word(words) != name) return std::nullopt;
    }
    Header header{false, words};
    header.minutes = next_word(words) == "mm";
    if (header.minutes) header.frequencies = words;
    return header;
}

class TableReader {
  public:
    TableReader(std::string_view content, std::string_view name) : lines_(content, name) {}

    std::vector<Row> read(Quantity quantity) {
        const auto read_header_line = [this](std::string_view line) {
            const auto words = header_words(line);
            if (words) read_header(*words);
            return words.has_value();
        };
        return ndbc::read_rows(lines_, read_header_line,
                               [&](Row& row, const std::vector<Row>&) { read_row(row, quantity); });
    }

  private:
    void read_header(std::string_view words) {
        const std::optional<Header> header = parse_header(words);
        if (!header) {
            throw lines_.fail("the header line begins with other columns than YY MM DD hh [mm]");
        }
        minutes_ = header->minutes;
        bins_.clear();
        std::string_view rest = header->frequencies;
        for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) {
            bins_.push_back({ndbc::next_frequency(lines_, word, bins_), kMissing});
        }
        if (bins_.size() < 2) throw lines_.fail("fewer than 2 frequencies");
    }

    void read_row(Row& row, Quantity quantity) const {
        if (bins_.empty()) throw lines_.fail("values before the header line");
        std::string_view rest = lines_.line();
        row.time = ndbc::next_time(lines_, rest, minutes_);
        row.bins = bins_;
        std::size_t count = 0;
        for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) {
            if (count == bins_.size()) {
                throw lines_.fail("more values than the " + std::to_string(count) +
                                  " frequencies of the header line");
            }
            row.bins[count++].value = ndbc::value(lines_, word, quantity, 100.0);
        }
        if (count == bins_.size()) return;
        if (lines_.cut_off()) throw lines_.fail("the file ends within this line");
        throw lines_.fail(std::to_string(count) + " values for the " +
                          std::to_string(bins_.size()) + " frequencies of the header line");
    }

    LineReader lines_;
    bool minutes_ = false;
    std::vector<Bin> bins_;  // of the header line, without values
};

/// Converts r1 and r2 to fractions. Historical ones are in hundredths, but some tables have
/// fractions of one, where 99 means missing. No sea has an r1 below a hundredth everywhere, so a
/// value above one decides.
void make_fractions(std::vector<Row>& rows) {
    const auto is_hundredths = [](const Bin& bin) {
        return bin.value > ndbc::kMaxSpread && bin.value != 99.0;
    };
    const bool hundredths = std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
        return std::any_of(row.bins.begin(), row.bins.end(), is_hundredths);
    });
    for (Row& row : rows) {
        for (Bin& bin : row.bins) {
            if (hundredths) {
                bin.value /= 100.0;
            } else {
                bin.value = bin.value == 99.0 ? kMissing : std::min(bin.value, 1.0);
            }
        }
    }
}

/// ".../41010w2019.txt.gz" in parts: a station, the letter of a table, a year of four digits, of a
/// monthly table with the month before them.
struct TableName {
    std::string_view front;    // ".../41010"
    std::string_view station;  // "41010"
    char letter;
    std::string_view back;  // "2019.txt"
};

std::optional<TableName> parse_name(std::string_view path) {
    if (path.ends_with(".gz")) path.remove_suffix(3);
    const std::size_t base = path.find_last_of("/\\") + 1;
    const std::string_view stem = path.substr(base, path.substr(base).find('.'));
    for (const std::size_t digits : {4u, 5u}) {
        if (stem.size() < 5 + 1 + digits) continue;
        const std::size_t at = stem.size() - digits - 1;
        const std::string_view year = stem.substr(stem.size() - 4);
        const bool dated = year.find_first_not_of("0123456789") == std::string_view::npos;
        if (!dated || kLetters.find(stem[at]) == std::string_view::npos) continue;
        return TableName{path.substr(0, base + at), stem.substr(0, at), stem[at],
                         path.substr(base + at + 1)};
    }
    return std::nullopt;
}

/// Reads a companion table, gzipped or not.
std::optional<std::vector<Row>> read_companion(const SpectrumSource& source, const TableName& name,
                                               Quantity quantity) {
    const std::string plain = std::string(name.front) +
                              kLetters[static_cast<std::size_t>(quantity)] + std::string(name.back);
    for (const std::string& path : {plain, plain + ".gz"}) {
        const std::optional<std::string> content = source.companion(path);
        if (content) return TableReader(*content, path).read(quantity);
    }
    return std::nullopt;
}

/// Returns the four companions, or nothing if one of them is missing.
std::optional<ndbc::Companions> read_companions(const SpectrumSource& source,
                                                const std::optional<TableName>& name) {
    if (!name || !source.companion) return std::nullopt;
    return ndbc::read_companions([&](Quantity quantity) {
        auto rows = read_companion(source, *name, quantity);
        const bool is_spread = quantity == Quantity::spread1 || quantity == Quantity::spread2;
        if (rows && is_spread) make_fractions(*rows);
        return rows;
    });
}

/// Recognises the header. Tables of meteorology begin alike, but no word of their header is a
/// number.
bool recognises(std::string_view content) {
    LineReader lines(content, "");
    for (std::size_t i = 0; i < ndbc::kMaxMetadataLines && lines.next_filled(); ++i) {
        std::optional<std::string_view> words = header_words(lines.line());
        if (!words && !lines.line().starts_with('#')) return false;
        if (!words) continue;
        for (auto word = next_word(*words); !word.empty(); word = next_word(*words)) {
            if (text::parse_number(word)) return true;
        }
        return false;
    }
    return false;
}

std::vector<SpectrumRecord> read(const SpectrumSource& source) {
    const std::optional<TableName> name = parse_name(source.name);
    if (name && name->letter != kLetters[0]) {
        throw text::error_at(ErrorKind::bad_file, source.name, 1,
                             std::string("a table of directions, by the '") + name->letter +
                                 "' in its name; the densities are in the table with 'w'");
    }
    std::vector<Row> rows = TableReader(source.content, source.name).read(Quantity::density);
    std::set<std::string> times;
    std::erase_if(
        rows, [&](const Row& row) { return row.fault.empty() && !times.insert(row.time).second; });
    return ndbc::make_records(name ? ndbc::station_of(name->station) : "", rows,
                              read_companions(source, name));
}

}  // namespace

const SpectrumFormat kNdbcHistorical = {"NDBC historical (41010w2019.txt with d, i, j and k)",
                                        recognises, read};

}  // namespace ocean
