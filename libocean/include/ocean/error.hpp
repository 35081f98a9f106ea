// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The one exception type. It is thrown where values enter (validation, files) and where the machine
// refuses (memory, disk), never from the middle of a computation.
//
//     try {
//         Sea sea = read_sea(path);
//     } catch (const Error& error) {
//         std::fprintf(stderr, "%s\n", error.what());  // one sentence, for people
//         if (error.kind() == ErrorKind::bad_file) return 2;
//         mark(error.fields().parameter);  // "waves.0.fetch", for programs
//     }
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
    out_of_memory,  // too little memory, reported before anything is allocated
    interrupted,    // stopped by the user
    no_gpu,         // no GPU, an unsuitable one, or one that was lost
};

/// The parts of a message, for programs. A part that the error does not have is empty.
struct ErrorFields {
    std::string what = "";       // the fault: "is out of range"
    std::string parameter = "";  // its path, "waves.0.fetch"; or an argument or member
    std::string value = "";      // as the caller wrote it
    std::string allowed = "";    // "1000 .. 1e+07 m"
};

/// States the fault, the value and the allowed values in one sentence that a user can act on.
class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, const std::string& message)
        : std::runtime_error(message), kind_(kind), fields_{.what = message} {}
    /// Makes the message "PARAMETER = VALUE: WHAT; allowed: ALLOWED" from the parts that are not
    /// empty.
    Error(ErrorKind kind, ErrorFields fields);
    /// Takes another sentence for the same parts, such as one that begins with a file and a line.
    Error(ErrorKind kind, const std::string& message, ErrorFields fields)
        : std::runtime_error(message), kind_(kind), fields_(std::move(fields)) {}

    ErrorKind kind() const noexcept { return kind_; }
    const ErrorFields& fields() const noexcept { return fields_; }

  private:
    ErrorKind kind_;
    ErrorFields fields_;
};

}  // namespace ocean
