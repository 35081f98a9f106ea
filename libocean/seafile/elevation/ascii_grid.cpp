// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// ESRI ASCII grids (.asc): a header of keys and values, then the heights from the north-west corner
// on, row by row, separated by blanks and line ends of any kind. Lines that begin with '#' or "//"
// are comments. The text is read in blocks, so that reading needs one block of memory beside the
// heights.
#include <algorithm>
#include <limits>
#include <vector>

#include "grid_header.hpp"
#include "ocean/internal/elevation_rules.hpp"

namespace ocean {
namespace {

using elevation::grid_number;
using elevation::GridHeader;
using elevation::GridHeaderReader;

constexpr std::size_t kBlockBytes = std::size_t{1} << 16;
constexpr std::size_t kMaxWordBytes = 64;

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\0';
}

/// Splits a stream into words, with their lines.
class WordStream {
  public:
    WordStream(std::istream& stream, const std::string& name)
        : stream_(stream), name_(name), block_(kBlockBytes) {
        if (peek() == '\xEF') take_byte_order_mark();
    }

    /// Steps to the next word; false at the end.
    bool next() {
        word_.clear();
        for (char c = peek(); !ended_; c = peek()) {
            if (is_blank(c)) {
                if (!word_.empty()) return true;
                skip();
            } else if (word_.empty() && begins_comment(c)) {
                while (!ended_ && peek() != '\n') skip();
            } else {
                if (word_.empty()) line_ = next_line_;
                if (word_.size() == kMaxWordBytes) {
                    throw fail("'" + text::printable(word_, 30) + "' is no number of a grid");
                }
                word_ += c;
                skip();
            }
        }
        return !word_.empty();
    }
    const std::string& word() const { return word_; }
    /// Returns the line of the word, from 1.
    std::size_t line() const { return line_; }
    /// Returns the bytes that were read up to the end of the word.
    std::size_t bytes() const { return bytes_; }
    Error fail(const std::string& message) const {
        return text::error_at(ErrorKind::bad_file, name_, line_, message);
    }

  private:
    char peek() {
        if (at_ == filled_ && !ended_) {
            stream_.read(block_.data(), static_cast<std::streamsize>(block_.size()));
            filled_ = static_cast<std::size_t>(stream_.gcount());
            at_ = 0;
            ended_ = filled_ == 0;
        }
        return ended_ ? '\n' : block_[at_];
    }
    void skip() {
        at_line_start_ = block_[at_] == '\n';
        next_line_ += at_line_start_ ? 1 : 0;
        ++at_;
        ++bytes_;
    }
    bool begins_comment(char c) const {
        return at_line_start_ && (c == '#' || c == '/' || c == ';' || c == '!');
    }
    void take_byte_order_mark() {
        for (int i = 0; i < 3 && !ended_; ++i) {
            peek();
            skip();
        }
        at_line_start_ = true;
    }

    std::istream& stream_;
    const std::string& name_;
    std::vector<char> block_;
    std::size_t at_ = 0;
    std::size_t filled_ = 0;
    std::size_t bytes_ = 0;
    bool ended_ = false;
    bool at_line_start_ = true;
    std::size_t next_line_ = 1;
    std::size_t line_ = 1;
    std::string word_;
};

/// Reads the header and the first height, or stops at the end of the text.
GridHeader read_header(WordStream& words, const std::string& name) {
    GridHeaderReader header(name);
    bool more = words.next();
    while (more && !grid_number(words.word())) {
        const std::string key = words.word();
        if (!GridHeaderReader::knows(key)) {
            throw words.fail("'" + text::printable(key, 30) +
                             "' is neither a key of a grid's header nor a number");
        }
        const std::size_t line = words.line();
        if (!words.next()) throw words.fail("the file ends after the key " + key);
        header.add(key, words.word(), line);
        more = words.next();
    }
    if (!more) throw words.fail("the file ends within the header, before any height");
    return header.finish(words.line());
}

class HeightReader {
  public:
    HeightReader(WordStream& words, const GridHeader& header) : words_(words), header_(header) {}

    /// Returns the height of the present word, NaN for a missing one.
    float read() const {
        const std::optional<double> value = grid_number(words_.word());
        if (!value) {
            throw words_.fail("'" + text::printable(words_.word(), 30) + "' is not a height");
        }
        const bool is_missing =
            header_.missing.matches(*value, words_.word()) || elevation::is_fill_value(*value);
        return is_missing ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(*value);
    }

  private:
    WordStream& words_;
    const GridHeader& header_;
};

/// Throws if `bytes` of text cannot hold the grid. Called before the grid's memory is allocated.
void require_text(const WordStream& words, const GridHeader& header, std::size_t bytes) {
    const std::size_t count = static_cast<std::size_t>(header.columns * header.rows);
    const std::size_t needed = 2 * count - 1;  // a digit and a blank per height
    const std::size_t left = bytes + words.word().size() - std::min(words.bytes(), bytes);
    if (left >= needed) return;
    throw words.fail("the file is cut off: " + std::to_string(header.columns) + " x " +
                     std::to_string(header.rows) + " heights need at least " +
                     std::to_string(needed) + " bytes, " + std::to_string(left) + " follow");
}

}  // namespace

ElevationModel parse_ascii_grid(std::istream& text, std::size_t bytes, const std::string& name,
                                const std::string& crs, const ElevationOptions& options) {
    constexpr int kRowsPerReport = 64;
    WordStream words(text, name);
    const GridHeader header = read_header(words, name);
    elevation::require_sides(name, header.columns, header.rows);
    require_text(words, header, bytes);
    elevation::RawModel raw = elevation::make_raw_model(header, name, crs);
    const HeightReader reader(words, header);
    const std::size_t columns = static_cast<std::size_t>(header.columns);
    const int rows = static_cast<int>(header.rows);
    bool more = true;
    for (int row = 0; row < rows; ++row) {
        float* const heights =
            raw.model.heights.data() + static_cast<std::size_t>(rows - 1 - row) * columns;
        for (std::size_t i = 0; i < columns; ++i) {
            if (!more) {
                throw words.fail("the file ends after " +
                                 std::to_string(static_cast<std::size_t>(row) * columns + i) +
                                 " of " + std::to_string(raw.model.heights.size()) + " heights");
            }
            heights[i] = reader.read();
            more = words.next();
        }
        if (options.progress && row % kRowsPerReport == 0) options.progress(row, rows);
    }
    if (more) {
        throw words.fail("more than the " + std::to_string(raw.model.heights.size()) +
                         " heights of the header");
    }
    return elevation::finish(std::move(raw), name, options);
}

}  // namespace ocean
