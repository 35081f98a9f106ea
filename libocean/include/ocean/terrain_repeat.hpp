// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How far a tile's repeats can be seen: its autocorrelation by the theorem of Wiener and Khinchin,
// C(r) = sum |h(k)|^2 e^(i k r) / sum |h|^2 for heights, and with k^2 |h|^2 for slopes, over all
// lags of its period. A layer of a shorter period makes a peak at each of its multiples.
//
//     const TerrainRepeat repeat = *terrain.state().repeat;  // of a tile
//     std::printf("%.2f at %.0f m\n", repeat.height.correlation, repeat.height.distance);
#pragma once

namespace ocean {

struct Modes;

/// The highest peak of an autocorrelation away from lag 0.
struct RepeatPeak {
    double correlation = 0.0;  // 0 .. 1; 0 without any peak
    double distance = 0.0;     // its lag [m]
};

/// Peaks of a terrain within its period, where it repeats as a whole.
struct TerrainRepeat {
    RepeatPeak height;
    RepeatPeak slope;  // of the sum of the correlations of both slopes
};

/// Returns the highest local maxima of the autocorrelations beyond the distance at which their mean
/// over all directions first falls to 1/10. `modes` belong to a terrain. At most 4096 samples a
/// side are examined: on larger grids the longer waves alone. Throws Error out_of_memory.
TerrainRepeat find_repeat(const Modes& modes);

}  // namespace ocean
