// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The one exception type. It is thrown where values enter (validation, files) and where the
// machine refuses (memory, disk), never from the middle of the mathematics.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace ocean {

enum class ErrorKind {
    invalid_value,  // a parameter or argument out of its range, of a wrong type, unknown
    bad_file,       // an input file that cannot be read or is not what it claims
    not_found,      // a record or preset that does not exist
    unsupported,    // a key or product whose feature this version does not have
    output,         // the run's own writing failed: path, permission, full disk
    out_of_memory,  // more memory than there is, said before it is allocated
    interrupted,    // stopped by the user
    no_gpu,         // none there, one that cannot do it, or one that was lost
};

/// The parts of a message that a program reads, as texts; empty where an error has no such part.
struct ErrorFields {
    std::string what = "";       // "is out of range"
    std::string parameter = "";  // the path, "waves.0.fetch", or what else has the value
    std::string value = "";      // as it was given
    std::string allowed = "";    // "1000 .. 1e+07 m"
};

/// Says what was wrong, the value, and what is allowed, in one sentence a user can act on.
class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, const std::string& message)
        : std::runtime_error(message), kind_(kind), fields_{.what = message} {}
    /// The message is "PARAMETER = VALUE: WHAT; allowed: ALLOWED", without the parts that are
    /// empty.
    Error(ErrorKind kind, ErrorFields fields);
    /// The same parts in another sentence, such as one that begins with a file and a line.
    Error(ErrorKind kind, const std::string& message, ErrorFields fields)
        : std::runtime_error(message), kind_(kind), fields_(std::move(fields)) {}

    ErrorKind kind() const noexcept { return kind_; }
    const ErrorFields& fields() const noexcept { return fields_; }

  private:
    ErrorKind kind_;
    ErrorFields fields_;
};

}  // namespace ocean
