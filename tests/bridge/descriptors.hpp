// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The open files of this process.
#pragma once

#include <cstddef>
#include <filesystem>
#include <iterator>

namespace ocean::bridge::test {

inline std::size_t open_descriptors() {
    const std::filesystem::directory_iterator all("/proc/self/fd");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

}  // namespace ocean::bridge::test
