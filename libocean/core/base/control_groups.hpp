// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The share that Linux's control groups (version 2) leave to a process: containers and batch
// systems set their quotas there.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <vector>

namespace ocean {

/// A number of bytes that stands for "no limit" or "unknown".
inline constexpr std::uint64_t kUnknown = std::numeric_limits<std::uint64_t>::max();
inline std::uint64_t left_of(std::uint64_t limit, std::uint64_t used) {
    if (limit == kUnknown) return kUnknown;
    return used == kUnknown ? limit : limit - std::min(limit, used);
}

/// Returns the groups that a list such as /proc/self/cgroup names, below `root`, from the root
/// down. A group without a folder sets no limit.
std::vector<std::filesystem::path> control_groups(const std::filesystem::path& list,
                                                  const std::filesystem::path& root);
/// Returns the cores that cpu.max allows, rounded up; the largest value if there is no limit.
int cores_of_cgroups(const std::vector<std::filesystem::path>& groups);
/// Returns the bytes that can still be allocated, with the page cache counted as free; the largest
/// value if there is no limit.
std::uint64_t memory_of_cgroups(const std::vector<std::filesystem::path>& groups);

}  // namespace ocean
