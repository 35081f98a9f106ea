// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See standard_input.hpp.
#include "standard_input.hpp"

#include <array>
#include <cstdio>
#include <utility>

#include "ocean/error.hpp"

namespace ocean::app {

std::string read_standard_input(std::size_t limit) {
    const auto fail = [](const std::string& why) {
        return Error(ErrorKind::bad_file, "standard input: " + why);
    };
    static bool read = false;
    if (std::exchange(read, true)) throw fail("is read once; give one of the two a file");
    std::string content;
    std::array<char, 1 << 16> block;
    while (const std::size_t got = std::fread(block.data(), 1, block.size(), stdin)) {
        content.append(block.data(), got);
        if (content.size() > limit) {
            throw fail("more than the " + std::to_string(limit >> 20) + " MiB allowed");
        }
    }
    if (std::ferror(stdin) != 0) throw fail("cannot be read to its end");
    return content;
}

}  // namespace ocean::app
