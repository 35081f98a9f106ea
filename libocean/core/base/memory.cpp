// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The check that memory is available; see memory.hpp.
#include "ocean/internal/memory.hpp"

#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean {

void require_memory(std::uint64_t bytes, const std::string& what, const std::string& advice) {
    if (bytes == 0) return;  // available_memory() is a system call
    const std::uint64_t there = available_memory();
    if (bytes <= there) return;
    const auto mebibytes = [](std::uint64_t value) { return std::to_string(value >> 20) + " MiB"; };
    throw Error(ErrorKind::out_of_memory, what + " needs " + mebibytes(bytes) + " of memory, " +
                                              mebibytes(there) + " are available; " + advice);
}

}  // namespace ocean
