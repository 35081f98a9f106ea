// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Text that comes from files nobody has checked: see text.hpp.
#include "text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <vector>

#include "ocean/platform.hpp"
#include "ocean/text.hpp"

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

std::optional<double> take_fortran_number(std::string_view& text) {
    const auto is_any = [&](std::size_t at, std::string_view of) {
        return at < text.size() && of.find(text[at]) != std::string_view::npos;
    };
    const auto after_digits = [&](std::size_t at) {
        while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
        return at;
    };
    const std::size_t first = is_any(0, "+-") ? 1 : 0;
    const std::size_t point = after_digits(first);
    const bool has_point = is_any(point, ".");
    const std::size_t mantissa = has_point ? after_digits(point + 1) : point;
    if (mantissa == first + (has_point ? 1 : 0)) return std::nullopt;

    const bool letter = is_any(mantissa, "eEdD");
    const std::size_t exponent = mantissa + (letter ? 1 : 0);
    const std::size_t signless = exponent + (is_any(exponent, "+-") ? 1 : 0);
    std::size_t end = after_digits(signless);
    const bool bare = has_point && signless > exponent && end == signless + 3 && !is_any(end, ".");
    if (letter && end == signless) return std::nullopt;
    if (!letter && !bare) end = mantissa;
    if (end < text.size() && !is_any(end, " \t+-")) return std::nullopt;

    std::string spelled(text.substr(0, mantissa));
    if (end > mantissa) spelled.append("e").append(text.substr(exponent, end - exponent));
    const std::optional<double> value = parse_number(spelled);
    if (value) text.remove_prefix(end);
    return value;
}

}  // namespace ocean::text
