// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Vectors of a world with z up in one with y up.
#pragma once

#include <utility>
#include <vector>

namespace ocean::io {

/// (x, y, z) to (x, z, -y), of as many as there are.
inline void turn_vectors_y_up(std::vector<float>& vectors) {
    for (std::size_t at = 0; at < vectors.size(); at += 3) {
        std::swap(vectors[at + 1], vectors[at + 2]);
        vectors[at + 2] = -vectors[at + 2];
    }
}

}  // namespace ocean::io
