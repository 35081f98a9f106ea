// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rows of untrusted CSV text; see csv_rows.hpp.
#include "ocean/internal/csv_rows.hpp"

#include <algorithm>
#include <utility>

#include "ocean/internal/text.hpp"

namespace ocean::csv {
namespace {

constexpr std::string_view kBlanks = " \t";
constexpr std::size_t kMaxNumberBytes = 64;

bool is_separator(char c, char separator) {
    return c == separator || (separator == ' ' && c == '\t');
}

/// Returns the end of the quoted text at the front of `text`; npos if it is not closed. "" within a
/// text ends it and begins it again.
std::size_t quoted_end(std::string_view text) {
    std::size_t end = 0;
    while (end < text.size() && text[end] == '"') {
        end = text.find('"', end + 1);
        if (end == std::string_view::npos) return end;
        ++end;
    }
    return end;
}

std::optional<std::string_view> unquoted(std::string_view cell) {
    if (!cell.starts_with('"')) return cell;
    if (cell.size() < 2 || !cell.ends_with('"')) return std::nullopt;
    return cell.substr(1, cell.size() - 2);
}

/// Splits a line into `fields`, as split() does; returns false if a quote is not closed.
bool split_into(std::vector<std::string_view>& fields, std::string_view line, char separator,
                std::size_t limit) {
    fields.clear();
    if (separator == ' ') line = trimmed(line);
    while (fields.size() <= limit) {
        const std::string_view blanks = separator == ' ' ? kBlanks : " ";
        const std::size_t start = std::min(line.find_first_not_of(blanks), line.size());
        std::size_t end = start;
        if (end < line.size() && line[end] == '"') {
            const std::size_t length = quoted_end(line.substr(start));
            if (length == std::string_view::npos) return false;
            end += length;
        }
        end = separator == ' ' ? line.find_first_of(kBlanks, end) : line.find(separator, end);
        const auto field = unquoted(trimmed(line.substr(start, end - start)));
        if (!field) return false;
        fields.push_back(*field);
        if (end == std::string_view::npos) break;
        line.remove_prefix(end + 1);
    }
    return true;
}

/// Returns the position of the bracket that closes the bracket at `open`, across nested brackets;
/// npos if there is none.
std::size_t closing_bracket(std::string_view line, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < line.size(); ++i) {
        if (line[i] == '(' || line[i] == '[') ++depth;
        if ((line[i] == ')' || line[i] == ']') && --depth == 0) return i;
    }
    return std::string_view::npos;
}

/// Splits a header line, where brackets hold a unit. Separators within brackets do not count, and
/// brackets after a blank belong to the preceding title. Returns nothing if a quote is not closed.
std::optional<std::vector<std::string_view>> split_header(std::string_view line, char separator) {
    std::vector<std::string_view> titles;
    line = separator == ' ' ? trimmed(line) : line;
    const std::string_view blanks = separator == ' ' ? kBlanks : " ";
    bool closed = true;  // false once a bracket had no end; then none is searched
    while (titles.size() <= TableReader::kMaxColumns) {
        const std::size_t start = std::min(line.find_first_not_of(blanks), line.size());
        std::size_t end = start;
        if (end < line.size() && line[end] == '"') {
            const std::size_t length = quoted_end(line.substr(start));
            if (length == std::string_view::npos) return std::nullopt;
            end += length;
        }
        for (; end < line.size(); ++end) {
            if (closed && (line[end] == '(' || line[end] == '[')) {
                const std::size_t close = closing_bracket(line, end);
                closed = close != std::string_view::npos;
                if (closed) end = close;
            } else if (is_separator(line[end], separator)) {
                const std::size_t next = line.find_first_not_of(kBlanks, end);
                const bool unit = separator == ' ' && next != std::string_view::npos &&
                                  (line[next] == '(' || line[next] == '[');
                if (!unit) break;
                end = next - 1;
            }
        }
        const auto title = unquoted(trimmed(line.substr(start, end - start)));
        if (!title) return std::nullopt;
        titles.push_back(*title);
        if (end >= line.size()) break;
        line.remove_prefix(end + 1);
    }
    return titles;
}

struct Separators {
    char chosen = ',';
    char rival = '\0';  // another separator that suits as well
};

/// Chooses, among the separators in the header line, the one that gives the first row as many cells
/// as the header line has titles; if there is no such row, the first of tab, semicolon, comma, else
/// blanks.
Separators separators_of(std::string_view header, std::string_view row) {
    const auto suits = [&](char c, std::size_t titles) {
        const auto cells = split(row, c, TableReader::kMaxColumns);
        return cells && cells->size() == titles;
    };
    std::vector<char> present;
    std::vector<char> suitable;
    for (const char c : {'\t', ';', ','}) {
        if (header.find(c) == std::string_view::npos) continue;
        const auto titles = split_header(header, c);
        if (titles && titles->size() == 1) continue;  // appears only within brackets or quotes
        present.push_back(c);
        if (titles && suits(c, titles->size())) suitable.push_back(c);
    }
    if (suitable.size() > 1) return {suitable[0], suitable[1]};
    if (suitable.size() == 1) return {suitable[0]};
    if (present.empty() || present[0] == '\t') {  // several tabs and blanks may align the columns
        const auto titles = split_header(header, ' ');
        const bool several = titles && titles->size() > 1;
        if (several && (present.empty() || suits(' ', titles->size()))) return {' '};
    }
    return {present.empty() ? ',' : present[0]};
}

/// Returns the separator of a line "sep=;", as Excel writes it.
std::optional<char> told_separator(std::string_view line) {
    line = trimmed(line);
    const bool tells = line.size() == 5 && lower_case(line).starts_with("sep=");
    return tells ? std::optional(line[4]) : std::nullopt;
}

std::string name_of(char separator) {
    if (separator == '\t') return "a tab";
    if (separator == ';') return "a semicolon";
    return separator == ',' ? "a comma" : "a blank";
}

/// Returns true for a comma that may separate thousands: 1,500 and 12,345,678, but neither 0,500
/// nor 1500,250.
bool may_separate_thousands(std::string_view number) {
    if (number.starts_with('-') || number.starts_with('+')) number.remove_prefix(1);
    const std::size_t comma = number.find(',');
    return comma >= 1 && comma <= 3 && number[0] != '0' && number.size() == comma + 4;
}

}  // namespace

bool next_row(LineReader& lines) {
    while (lines.next_filled()) {
        if (!lines.line().starts_with('#')) return true;
    }
    return false;
}

std::optional<std::vector<std::string_view>> split(std::string_view line, char separator,
                                                   std::size_t limit) {
    std::vector<std::string_view> fields;
    if (!split_into(fields, line, separator, limit)) return std::nullopt;
    return fields;
}

std::vector<std::string_view> fields_of(const LineReader& lines, char separator,
                                        std::size_t limit) {
    auto fields = split(lines.line(), separator, limit);
    if (!fields) throw lines.fail("a quote is not closed");
    return std::move(*fields);
}

std::optional<std::string> converted(std::string_view bytes) {
    const bool little_mark = bytes.starts_with("\xFF\xFE");
    const bool big_mark = bytes.starts_with("\xFE\xFF");
    const bool wide = bytes.size() >= 2 && (bytes[0] == '\0') != (bytes[1] == '\0');
    std::optional<std::string> text;
    if (little_mark || big_mark) {
        text = text::utf8_of_utf16(bytes.substr(2), big_mark).text;
    } else if (wide) {
        text = text::utf8_of_utf16(bytes, bytes[0] == '\0').text;
    }
    const std::string_view result = text ? std::string_view(*text) : bytes;
    if (result.find('\n') == std::string_view::npos && result.find('\r') != result.npos) {
        if (!text) text = std::string(bytes);
        std::replace(text->begin(), text->end(), '\r', '\n');
    }
    return text;
}

Title parse_title(std::string_view cell) {
    cell = cell.substr(0, 64);
    const std::size_t open = cell.find_first_of("([");
    Title title;
    title.name = lower_case(trimmed(cell.substr(0, open)));
    if (open == std::string_view::npos) return title;
    const std::string_view unit = cell.substr(open + 1);
    const std::size_t close = closing_bracket(cell, open);  // "m2/(rad/s)" contains brackets
    title.unit = unit.substr(0, close == std::string_view::npos ? close : close - open - 1);
    if (title.unit.empty()) title.unit = "()";
    return title;
}

TableReader::TableReader(std::string_view content, std::string_view name)
    : storage_(converted(content).value_or("")),
      name_(name),
      lines_(storage_.empty() ? content : std::string_view(storage_), name) {
    if (!next_row(lines_)) return;
    const std::optional<char> told = told_separator(lines_.line());
    if (told && !next_row(lines_)) return;
    const std::string_view header = lines_.line();
    LineReader ahead = lines_;
    const std::string_view row = next_row(ahead) ? ahead.line() : std::string_view();
    const Separators separators = told ? Separators{*told} : separators_of(header, row);
    if (separators.rival != '\0') {
        throw lines_.fail("the separator of the cells is ambiguous: " + name_of(separators.chosen) +
                          " and " + name_of(separators.rival) +
                          " both give the first row a cell for each title");
    }
    separator_ = separators.chosen;
    auto titles = split_header(header, separator_);
    if (!titles) throw lines_.fail("a quote is not closed");
    if (titles->size() > kMaxColumns) throw lines_.fail("more than the 10000 columns allowed");
    titles_ = std::move(*titles);
    if (has_row_names(header, row)) titles_.insert(titles_.begin(), std::string_view());
}

/// Recognises a column of row names without a title, as R and pandas write it: the row has one cell
/// more than the header line, and both begin with a quote, or the header line begins with a blank
/// and the row does not.
bool TableReader::has_row_names(std::string_view header, std::string_view row) const {
    if (header.empty() || row.empty()) return false;
    const bool quotes = header.front() == '"' && row.front() == '"';
    const bool indent =
        separator_ == ' ' && is_separator(header.front(), ' ') && !is_separator(row.front(), ' ');
    if (!quotes && !indent) return false;
    const auto cells = split(row, separator_, kMaxColumns);
    return cells && cells->size() == titles_.size() + 1;
}

bool TableReader::next() {
    if (!next_row(lines_)) {
        check_commas();
        return false;
    }
    if (!split_into(cells_, lines_.line(), separator_, titles_.size())) {
        throw lines_.fail("a quote is not closed");
    }
    if (cells_.size() != titles_.size()) throw width_error();
    return true;
}

Error TableReader::width_error() const {
    const bool more = cells_.size() > titles_.size();
    if (!more && lines_.cut_off()) return lines_.fail("the file ends within this line");
    std::string message = (more ? "more" : "fewer") + std::string(" cells than the ") +
                          std::to_string(titles_.size()) + " columns of the header line";
    if (more && separator_ == ',') {
        message += "; numbers with a decimal comma need semicolons or tabs between them";
    }
    return lines_.fail(message);
}

std::optional<double> TableReader::number(std::size_t column) {
    const std::string_view word = cells_[column];
    const std::size_t comma = word.find(',');
    if (comma != std::string_view::npos) return comma_number(word, comma);
    const std::optional<double> value = text::parse_number(word);
    if ((point_line_ == 0 || comma_line_ != 0) && value &&
        word.find('.') != std::string_view::npos) {
        point_line_ = lines_.number();
        check_marks(word);
    }
    return value;
}

std::optional<double> TableReader::comma_number(std::string_view word, std::size_t comma) {
    if (word.size() > kMaxNumberBytes) return std::nullopt;
    if (word.find_first_not_of("0123456789.,+-eE") == std::string_view::npos &&
        word.find('.') != std::string_view::npos) {
        throw lines_.fail("'" + std::string(word) +
                          "' has a point and a comma: which of them is the decimal mark is "
                          "ambiguous; write the number without separators of thousands");
    }
    std::string spelled(word);
    spelled[comma] = '.';
    const std::optional<double> value = text::parse_number(spelled);
    if (!value) return std::nullopt;
    if (comma_line_ == 0) first_comma_ = word;
    if (comma_line_ == 0) comma_line_ = lines_.number();
    only_thousands_ = only_thousands_ && may_separate_thousands(word);
    check_marks(word);
    return value;
}

void TableReader::check_marks(std::string_view word) const {
    if (point_line_ == 0 || comma_line_ == 0) return;
    const bool comma = word.find(',') != std::string_view::npos;
    throw lines_.fail("the decimal mark is ambiguous: '" + std::string(word) + "' has a " +
                      (comma ? "comma" : "point") + ", the number in line " +
                      std::to_string(comma ? point_line_ : comma_line_) + " a " +
                      (comma ? "point" : "comma"));
}

/// Checks the commas. A table with numbers between semicolons comes from a program that writes
/// decimal commas.
void TableReader::check_commas() const {
    if (separator_ == ';' || comma_line_ == 0 || !only_thousands_) return;
    throw text::error_at(ErrorKind::bad_file, name_, comma_line_,
                         "the comma of '" + first_comma_ +
                             "' is ambiguous: it may separate decimals or thousands; write the "
                             "numbers with points, or semicolons between them");
}

std::vector<std::string> titles_of(std::string_view content) {
    const std::string storage = converted(content).value_or("");
    LineReader lines(storage.empty() ? content : std::string_view(storage), "");
    if (!next_row(lines)) return {};
    const std::optional<char> told = told_separator(lines.line());
    if (told && !next_row(lines)) return {};
    LineReader ahead = lines;
    const std::string_view row = next_row(ahead) ? ahead.line() : std::string_view();
    const auto titles =
        split_header(lines.line(), told ? *told : separators_of(lines.line(), row).chosen);
    if (!titles) return {};
    return {titles->begin(), titles->end()};
}

}  // namespace ocean::csv
