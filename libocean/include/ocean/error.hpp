// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The one exception type. It is thrown where values enter (validation, files) and where the
// machine refuses (memory, disk), never from the middle of the mathematics.
#pragma once

#include <stdexcept>
#include <string>

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

/// Says what was wrong, the value, and what is allowed, in one sentence a user can act on.
class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    ErrorKind kind() const noexcept { return kind_; }

  private:
    ErrorKind kind_;
};

}  // namespace ocean
