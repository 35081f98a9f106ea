// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The input of the loop that adds the waves of one band and sector to the labels of a block: plain
// data, so that the files compiled for one instruction set need nothing of the standard library.
#pragma once

#include <cstddef>

#include "base/simd/simd_level.hpp"

namespace ocean {

/// The parts of each number that are computed: `value`; `gradient`, also the gradient [1/m]; `all`,
/// also the rate [1/s].
enum class JetParts { value = 1, gradient = 3, all = 4 };

/// Arrays of one float for each label, whole vectors of 64 bytes long. Their first index is the
/// part: value, by x, by y, by t.
struct BandSectorTask {
    std::size_t count;
    JetParts parts;
    bool displaces;             // along_x and along_y are written; false: values alone
    float centre;               // direction of the middle of the sector [rad]
    const float* delay[3][4];   // shift x and y [m], phase, turn [rad] of ShoreDelays::waves
    const float* amplitude[3];  // relative to the open sea
    const float* re[4];         // the signal at the shifted place, derivatives by it [m]
    const float* im[4];
    const float* displacement[3];  // coth(k d)
    // Sums over bands and sectors, by the label: the waves [m], their squares, and their
    // displacement at choppiness 1 [m].
    float* real[4];
    float* imaginary[4];
    float* squares[4];  // of |Z| of each band and sector [m^2]
    float* along_x[4];
    float* along_y[4];
};

using BandSectorLoop = void (*)(const BandSectorTask&);

/// Returns the loop of an instruction set that is compiled in.
BandSectorLoop band_sector_loop(SimdLevel level);

}  // namespace ocean
