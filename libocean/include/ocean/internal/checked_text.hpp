// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Untrusted text from files: bounded reading, UTF-8, numbers without regard to the locale, and
// messages that are safe to print. Every reader here begins and ends with these functions.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "ocean/error.hpp"

namespace ocean::text {

/// Returns true if the path is a pipe, a socket or a device.
bool is_pipe_or_device(const std::string& path);
/// Returns the whole file. Throws Error bad_file if it is missing, a directory, a pipe or device,
/// unreadable, or larger than `limit` bytes.
std::string read_file(const std::string& path, std::size_t limit);
/// Returns the whole file or pipe. For paths of a command line, where a shell may pass a pipe.
/// Throws as read_file.
std::string read_file_or_pipe(const std::string& path, std::size_t limit);
/// Returns the first `count` bytes of a file; fewer if it is shorter or unreadable. Reads no pipe,
/// because its bytes would then be lost.
std::string first_bytes(const std::string& path, std::size_t count);
/// Returns the path as UTF-8; the inverse of utf8_path.
std::string to_utf8(const std::filesystem::path& path);

/// UTF-16 as UTF-8 [RFC 2781] 2.2.
struct Utf16Text {
    std::string text;                 // with U+FFFD for each half of a character
    std::optional<std::size_t> half;  // place of the first half
};
/// Returns the text of bytes behind their byte order mark.
Utf16Text utf8_of_utf16(std::string_view bytes, bool big_endian);

/// Returns the bytes as one line without control characters or broken UTF-8, cut at about `limit`
/// bytes.
std::string printable(std::string_view bytes, std::size_t limit = 60);
/// Returns an error "NAME:LINE: message", or "NAME: message" for line 0.
Error error_at(ErrorKind kind, std::string_view name, std::size_t line, std::string_view message);
/// Returns the error with "NAME:LINE: " and `prefix` in front of its sentence. It keeps its kind
/// and its fields, which programs read.
Error error_at(const Error& error, std::string_view name, std::size_t line,
               std::string_view prefix = "");
/// Returns a reader's error as an error of the parameter whose text `given`, such as a file's name,
/// caused the read. The reader's sentence becomes the fault of the text.
Error error_of_text(const Error& error, const std::string& parameter, std::string_view given);

/// Returns the number that all of `digits` spells, finite or not; nothing if it spells none.
std::optional<double> parse_number(std::string_view digits);

}  // namespace ocean::text
