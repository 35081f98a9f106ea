// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Linux's control groups; see control_groups.hpp.
#include "base/control_groups.hpp"

#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

namespace ocean {

namespace {

/// Returns the first number of a one-line file such as /sys/fs/cgroup/memory.max, which may contain
/// "max".
std::uint64_t number_in(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::uint64_t value = 0;
    return file >> value ? value : kUnknown;
}

/// Returns the number after `key` in a file of "key 123" lines.
std::uint64_t value_in(const std::filesystem::path& path, std::string_view key) {
    std::ifstream file(path);
    std::string word;
    std::uint64_t value = 0;
    while (file >> word >> value) {
        if (word == key) return value;
    }
    return kUnknown;
}

}  // namespace

std::vector<std::filesystem::path> control_groups(const std::filesystem::path& list,
                                                  const std::filesystem::path& root) {
    std::ifstream file(list);
    std::vector<std::filesystem::path> groups = {root};
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("0::/")) continue;  // version 2 only
        // In a container the list may name a path outside of it. Missing files set no limit.
        for (const auto& part : std::filesystem::path(line.substr(4))) {
            groups.push_back(groups.back() / part);
        }
    }
    return groups;
}

int cores_of_cgroups(const std::vector<std::filesystem::path>& groups) {
    double cores = std::numeric_limits<int>::max();
    for (const std::filesystem::path& group : groups) {
        std::ifstream file(group / "cpu.max");  // "200000 100000", or "max 100000"
        double quota = 0.0;
        double period = 0.0;
        if (file >> quota >> period && quota > 0.0 && period > 0.0) {
            cores = std::min(cores, std::max(std::ceil(quota / period), 1.0));
        }
    }
    return static_cast<int>(cores);
}

std::uint64_t memory_of_cgroups(const std::vector<std::filesystem::path>& groups) {
    std::uint64_t least = kUnknown;
    for (const std::filesystem::path& group : groups) {
        const std::filesystem::path stat = group / "memory.stat";
        // The kernel gives up the cache of files on demand. Memory without a file (shmem) is
        // counted in this cache but stays.
        const std::uint64_t files = value_in(stat, "file");
        const std::uint64_t cache = files == kUnknown ? 0 : left_of(files, value_in(stat, "shmem"));
        const std::uint64_t current = number_in(group / "memory.current");
        const std::uint64_t used = current == kUnknown ? kUnknown : left_of(current, cache);
        least = std::min(least, left_of(number_in(group / "memory.max"), used));
    }
    return least;
}

}  // namespace ocean
