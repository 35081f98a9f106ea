// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pieces of a map that hang together.
#pragma once

#include "testing.hpp"

namespace ocean::test {

/// Returns the cells that are joined to `first` by sides of cells for which is_open(cell), none if
/// it is not; marks them as seen, and passes over those that are.
template <typename IsOpen>
std::vector<std::size_t> piece_of(std::size_t first, int columns, int rows, std::vector<char>& seen,
                                  const IsOpen& is_open) {
    std::vector<std::size_t> piece;
    const auto take = [&](std::size_t at) {
        if (seen[at] != 0 || !is_open(at)) return;
        seen[at] = 1;
        piece.push_back(at);
    };
    take(first);
    const auto width = static_cast<std::size_t>(columns), height = static_cast<std::size_t>(rows);
    for (std::size_t next = 0; next < piece.size(); ++next) {
        const std::size_t at = piece[next], i = at % width, j = at / width;
        if (i > 0) take(at - 1);
        if (i + 1 < width) take(at + 1);
        if (j > 0) take(at - width);
        if (j + 1 < height) take(at + width);
    }
    return piece;
}

}  // namespace ocean::test
