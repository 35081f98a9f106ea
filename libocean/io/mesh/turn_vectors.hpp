// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Vectors from a world with z up to one with y up.
#pragma once

#include <utility>
#include <vector>

namespace ocean::io {

/// Replaces each (x, y, z) by (x, z, -y).
inline void turn_vectors_y_up(std::vector<float>& vectors) {
    for (std::size_t at = 0; at < vectors.size(); at += 3) {
        std::swap(vectors[at + 1], vectors[at + 2]);
        vectors[at + 2] = -vectors[at + 2];
    }
}

}  // namespace ocean::io
