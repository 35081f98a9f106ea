// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The phases k.X of a hull's past as products of factors along x and y: the waves are a lattice, so
// that a sine and a cosine are two products.
#pragma once

#include <cstdint>
#include <vector>

#include "hulls/wake_nodes.hpp"
#include "hulls/wake_task.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

class WakeTurns {
  public:
    /// Segments of one filling at most; a multiple of kWakeBlock.
    static constexpr int kSegments = 128;

    /// half_length: of the hull [m].
    WakeTurns(int resolution, double side, double half_length);

    /// Fills the tables for up to kSegments segments of a past, from the node `first` on, and
    /// returns them with nodes numbered from there. Valid until the next filling.
    WakeRuns fill(const WakePast& past, int first);

    static std::uint64_t bytes(int resolution);

  private:
    /// Writes e^(2 pi i (n x + m y)) of a node as factors.
    void write(int node, int part, double x, double y);
    float* column(int block, int node, int part);

    int resolution_;
    double side_;
    double half_length_;
    int nodes_ = 0;
    PageVector<float> columns_, rows_;
    std::vector<WakeRun> runs_;
};

}  // namespace ocean
