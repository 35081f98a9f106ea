// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs work that may crash, hang or use much memory in a child with limits: a part of this program,
// or another one. Its result comes back through a pipe; a crash ends the child alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace ocean::sandbox {

/// Writes all bytes.
using Sink = std::function<void(const void* bytes, std::size_t count)>;
/// Reads `count` bytes. Returns false if fewer are left.
using Source = std::function<bool(void* bytes, std::size_t count)>;
/// Thrown if a child sends bytes that the program would not have sent.
struct WireError : std::runtime_error {
    WireError() : std::runtime_error("no content") {}
};

struct ChildLimits {
    /// In a child by fork: the memory beyond the program's at the fork. For another program: all
    /// its memory.
    std::uint64_t memory_bytes = std::uint64_t{2} << 30;
    unsigned cpu_seconds = 20;
};

/// The end of a child without a usable result: "it crashed (signal 11)".
struct ChildFailure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Calls `produce` in a child, and `consume` in this process on the bytes that the child writes.
/// The child has no standard streams, cannot write files, and ends when `produce` returns or
/// throws. `consume` throws WireError for invalid bytes; its other exceptions are passed on. Throws
/// ChildFailure; Error interrupted if a signal of the user reached the child, output if the system
/// has no process left.
void run_in_child(const ChildLimits& limits, const std::function<void(const Sink&)>& produce,
                  const std::function<void(const Source&)>& consume);

/// Executes the program whose path is the first argument, with an empty environment, in the folder
/// "/", with a pipe as its only stream, and calls `consume` on what it writes to its standard
/// output. Limits and exceptions are the same as run_in_child's; a program that cannot be executed
/// counts as one that stopped early.
void run_program(const ChildLimits& limits, const std::vector<std::string>& arguments,
                 const std::function<void(const Source&)>& consume);

}  // namespace ocean::sandbox
