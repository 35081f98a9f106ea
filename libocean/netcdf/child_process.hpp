// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Work that may crash, hang or grow, done in a forked child under limits; its bytes come back
// through a pipe. What a crash costs is the child.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>

#include "netcdf_wire.hpp"

namespace ocean::netcdf {

struct ChildLimits {
    std::uint64_t memory_bytes = std::uint64_t{2} << 30;  // beyond what the program has already
    unsigned cpu_seconds = 20;
};

/// How a child ended that gave nothing usable: "it crashed (signal 11)".
struct ChildFailure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Calls `produce` in a child and `consume` here, on what it wrote. The child has no standard
/// streams, can write no file, and ends when `produce` returns or throws. `consume` throws
/// WireError for nonsense; its other exceptions are passed on. Throws ChildFailure, Error
/// interrupted (a signal of the user's reached the child), and output for want of processes.
void run_in_child(const ChildLimits& limits, const std::function<void(const Sink&)>& produce,
                  const std::function<void(const Source&)>& consume);

}  // namespace ocean::netcdf
