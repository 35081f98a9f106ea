// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Untrusted text from files: see checked_text.hpp.
#include "ocean/internal/checked_text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::text {

bool is_pipe_or_device(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_other(std::filesystem::status(utf8_path(path), ignored));
}

std::string read_file(const std::string& path, std::size_t limit) {
    if (is_pipe_or_device(path)) {
        // Reading a pipe without a writer, or a device without an end, would hang the host.
        throw error_at(ErrorKind::bad_file, path, 0, "is a pipe or a device, not a file");
    }
    return read_file_or_pipe(path, limit);
}

std::string read_file_or_pipe(const std::string& path, std::size_t limit) {
    const auto fail = [&](const std::string& why) {
        return error_at(ErrorKind::bad_file, path, 0, why);
    };
    if (path.find('\0') != std::string::npos) throw fail("has a NUL in its name");
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

std::string first_bytes(const std::string& path, std::size_t count) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(utf8_path(path), ignored)) return "";
    std::ifstream stream(utf8_path(path), std::ios::binary);
    std::string bytes(count, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
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
    return error_at(Error(kind, std::string(message)), name, line);
}

Error error_at(const Error& error, std::string_view name, std::size_t line,
               std::string_view prefix) {
    std::string where(name);
    if (line > 0) where += ":" + std::to_string(line);
    const std::string sentence = std::string(prefix) + error.what();
    return Error(error.kind(), where + ": " + printable(sentence, 1000), error.fields());
}

Error error_of_text(const Error& error, const std::string& parameter, std::string_view given) {
    return Error(
        error.kind(), error.what(),
        {.what = error.what(), .parameter = parameter, .value = "\"" + printable(given) + "\""});
}

std::optional<double> parse_number(std::string_view digits) {
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0.0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

static void append_utf8(std::string& text, std::uint32_t code) {
    const auto byte = [&](std::uint32_t bits) { text += static_cast<char>(bits); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) {
        byte(0xC0 | code >> 6);
    } else {
        if (code < 0x10000) {
            byte(0xE0 | code >> 12);
        } else {
            byte(0xF0 | code >> 18);
            byte(0x80 | (code >> 12 & 0x3F));
        }
        byte(0x80 | (code >> 6 & 0x3F));
    }
    byte(0x80 | (code & 0x3F));
}

Utf16Text utf8_of_utf16(std::string_view bytes, bool big_endian) {
    const auto unit = [&](std::size_t i) -> std::uint32_t {
        const auto first = static_cast<std::uint8_t>(bytes[2 * i]);
        const auto second = static_cast<std::uint8_t>(bytes[2 * i + 1]);
        return big_endian ? first * 256u + second : second * 256u + first;
    };
    constexpr std::uint32_t kReplacement = 0xFFFD;
    std::string text;
    std::optional<std::size_t> half;
    text.reserve(bytes.size() / 2 + bytes.size() / 16);
    const std::size_t count = bytes.size() / 2;
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t code = unit(i);
        const bool high = code >= 0xD800 && code < 0xDC00;
        const std::uint32_t low = high && i + 1 < count ? unit(i + 1) : 0;
        if (low >= 0xDC00 && low < 0xE000) {
            code = 0x10000 + ((code - 0xD800) << 10 | (low - 0xDC00));
            ++i;
        } else if (code >= 0xD800 && code < 0xE000) {
            code = kReplacement;
            if (!half) half = text.size();
        }
        append_utf8(text, code);
    }
    if (bytes.size() % 2 != 0) {
        if (!half) half = text.size();
        append_utf8(text, kReplacement);
    }
    return {std::move(text), half};
}

}  // namespace ocean::text
