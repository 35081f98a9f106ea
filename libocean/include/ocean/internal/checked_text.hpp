// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Text that comes from files nobody has checked: bounded reading, UTF-8, numbers without regard to
// the locale, and messages that are safe to print. First and last stop of every reader here.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "ocean/error.hpp"

namespace ocean::text {

bool is_pipe_or_device(const std::string& path);
/// The whole file. Throws Error bad_file: missing, a directory, a pipe or device, unreadable,
/// larger than `limit`.
std::string read_file(const std::string& path, std::size_t limit);
/// The same for what a command line names, where a shell may put a pipe.
std::string read_file_or_pipe(const std::string& path, std::size_t limit);
/// The first `count` bytes of a file; fewer where it has not so many or cannot be read. None of a
/// pipe, where they would then be missing.
std::string first_bytes(const std::string& path, std::size_t count);
/// The inverse of utf8_path.
std::string to_utf8(const std::filesystem::path& path);

/// One line without control characters or broken UTF-8, at most about `limit` bytes.
std::string printable(std::string_view bytes, std::size_t limit = 60);
/// "NAME:LINE: message", or "NAME: message" for line 0.
Error error_at(ErrorKind kind, std::string_view name, std::size_t line, std::string_view message);
/// Returns the error with "NAME:LINE: " and `prefix` in front of its sentence. It keeps its kind
/// and its fields, which programs read.
Error error_at(const Error& error, std::string_view name, std::size_t line,
               std::string_view prefix = "");
/// Returns the error of a reader as one of the parameter whose text, such as a file's name, made it
/// read. The sentence stays; it is what is wrong with the text.
Error error_of_text(const Error& error, const std::string& parameter, std::string_view given);

/// The number that all of `digits` spells, finite or not; nothing if it spells none.
std::optional<double> parse_number(std::string_view digits);

}  // namespace ocean::text
