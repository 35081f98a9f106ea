// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Text that comes from files nobody has checked: see text.hpp.
#include "text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <vector>

#include "ocean/platform.hpp"

namespace ocean::text {

std::string read_file(const std::string& path, std::size_t limit) {
    const auto fail = [&](const std::string& why) {
        return error_at(ErrorKind::bad_file, path, 0, why);
    };
    const std::filesystem::path file = utf8_path(path);
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) throw fail("is a directory, not a file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        const bool there = std::filesystem::exists(file, ignored);
        throw fail(there ? "cannot be read: no permission" : "no such file");
    }
    std::string content;
    std::vector<char> block(std::size_t{1} << 16);
    while (stream) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        content.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        if (content.size() > limit) {
            throw fail("is larger than the " + std::to_string(limit >> 20) + " MiB allowed");
        }
    }
    if (stream.bad()) throw fail("cannot be read to its end");
    return content;
}

std::string to_utf8(const std::filesystem::path& path) {
    const std::u8string bytes = path.u8string();
    return std::string(bytes.begin(), bytes.end());
}

std::size_t utf8_character(std::string_view bytes) {
    if (bytes.empty()) return 0;
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || bytes.size() < length) return 0;
    std::uint32_t code = lead & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0u) != 0x80u) return 0;
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    return overlong || surrogate || code > 0x10FFFF ? 0 : length;
}

std::string printable(std::string_view bytes, std::size_t limit) {
    std::string out;
    while (!bytes.empty()) {
        if (out.size() >= limit) return out + "...";
        const std::size_t length = utf8_character(bytes);
        const auto first = static_cast<std::uint8_t>(bytes[0]);
        const bool shown = length > 1 || (length == 1 && first >= 0x20 && first != 0x7F);
        out += shown ? bytes.substr(0, length) : std::string_view("?");
        bytes.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return out;
}

Error error_at(ErrorKind kind, std::string_view name, std::size_t line, std::string_view message) {
    std::string where(name);
    if (line > 0) where += ":" + std::to_string(line);
    return Error(kind, where + ": " + printable(message, 1000));
}

std::optional<double> parse_number(std::string_view digits) {
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0.0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

namespace {

/// Levenshtein's distance: insertions, deletions and replacements.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names) {
    word = word.substr(0, 64);
    std::string_view best;
    std::size_t fewest = std::max<std::size_t>(2, word.size() / 2) + 1;
    for (std::string_view name : names) {
        const std::size_t edits = edit_distance(word, name);
        if (edits < fewest) {
            fewest = edits;
            best = name;
        }
    }
    return best;
}

}  // namespace ocean::text
