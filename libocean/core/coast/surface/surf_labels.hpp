// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The labels of a region over which waves can break by the depth or run up. They do not depend on
// time, so that foam and wet ground of many ticks are followed at these labels alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ocean/query.hpp"

namespace ocean {

class ShoreSurface;
class ThreadPool;

/// Arrays of one value for each label in the surf or the swash, in the order of the labels.
struct SurfLabels {
    bool in_swash = false;             // all of them; otherwise none
    std::vector<std::uint32_t> index;  // index among the labels
    std::vector<double> x, y;          // [m]
    std::vector<float> rms_height;     // [m]
    std::vector<float> depth;          // [m]
    std::vector<float> share;          // share of the waves that break
    std::vector<float> on_bed;         // weight of the coast's surface
    // See SwashPlace.
    std::vector<float> bed, slope, arrival, group_width;
    std::vector<float> lee;  // factor on waves behind narrow walls
    // Arguments of broken_wave, for labels in the swash alone.
    std::vector<float> wavenumber, highest, gain;

    std::size_t size() const { return index.size(); }
};

/// Returns the labels in the surf and in the swash in pieces, each of at most 1024 labels that lie
/// within 1024 consecutive ones. The indices count all labels.
std::vector<SurfLabels> find_surf(const ShoreSurface& surface, std::span<const WorldPoint> labels,
                                  ThreadPool& pool);

}  // namespace ocean
