// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What differs between operating systems, in one place: core/base/platform.cpp.
#pragma once

#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace ocean {

/// Cores that this process may run on, at least 1: affinity and the quotas of its control groups
/// (cpu.max, rounded up) respected.
int available_cores();
/// Of this process: another in a child after fork(), which has but the one thread.
std::uint64_t process_number();
/// What the calling thread has had so far; zeros where the system does not tell.
struct ThreadUsage {
    std::int64_t preemptions = 0;  // how often its core was taken for another thread
    double seconds = 0.0;          // of a core
};
ThreadUsage usage_of_this_thread();
/// The calling thread's floating-point modes, set to the standard's while the object lives: what a
/// host rounds by, or flushes to zero, is its own.
class PlainFloats {
  public:
    PlainFloats();
    ~PlainFloats();
    PlainFloats(const PlainFloats&) = delete;
    PlainFloats& operator=(const PlainFloats&) = delete;

  private:
    std::fenv_t host_;
    [[maybe_unused]] unsigned host_sse_ = 0;  // MXCSR, where there is one
};
/// Bytes that can still be allocated (free memory, container and process limits), or the largest
/// value where the system does not tell.
std::uint64_t available_memory();
/// Path from the UTF-8 text that all interfaces use.
std::filesystem::path utf8_path(std::string_view text);

}  // namespace ocean
