// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The differences between operating systems, in one place: core/base/platform.cpp.
#pragma once

#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace ocean {

/// Returns the cores that this process may run on, at least 1: its affinity and the quotas of its
/// control groups (cpu.max, rounded up).
int available_cores();
/// Returns a number of this process. It is different in a child after fork(), which has only one
/// thread.
std::uint64_t process_number();
/// The resources that the calling thread has used so far; 0 if the system does not report them.
struct ThreadUsage {
    std::int64_t preemptions = 0;  // times that its core was given to another thread
    double seconds = 0.0;          // of CPU time
};
ThreadUsage usage_of_this_thread();
/// Sets the calling thread's floating-point modes to the standard's while the object lives: a
/// host's rounding and flush-to-zero modes are saved and restored.
class PlainFloats {
  public:
    PlainFloats();
    ~PlainFloats();
    PlainFloats(const PlainFloats&) = delete;
    PlainFloats& operator=(const PlainFloats&) = delete;

  private:
    std::fenv_t host_;
    [[maybe_unused]] unsigned host_sse_ = 0;  // MXCSR, where the CPU has it
};
/// While the object lives, numbers that the calling thread prints have a decimal point. Hosts, such
/// as Qt's, set a locale for the whole process, which may have a decimal comma.
class PointNumbers {
  public:
    PointNumbers();
    ~PointNumbers();
    PointNumbers(const PointNumbers&) = delete;
    PointNumbers& operator=(const PointNumbers&) = delete;

  private:
    void* host_;  // the thread's locale, as the system names it
    [[maybe_unused]] int host_mode_ = 0;
};
/// Returns the bytes that can still be allocated (free memory, container and process limits), or
/// the largest value if the system does not report them.
std::uint64_t available_memory();
/// Bytes of the caches: the second level, private to a core, and the last level, which cores share.
/// Both are guesses if the system does not report them.
struct CacheSizes {
    std::size_t core = std::size_t{512} << 10;
    std::size_t shared = std::size_t{8} << 20;
};
CacheSizes cache_sizes();
/// Returns the path of UTF-8 text, the encoding of all interfaces.
std::filesystem::path utf8_path(std::string_view text);

}  // namespace ocean
