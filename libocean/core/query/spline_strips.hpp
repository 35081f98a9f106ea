// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spline maps of one time, made strip by strip where they are looked at: of a map, a few points
// need a few columns, and pass two of the kernel, which is most of its work, makes columns.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "kernel/map_kernel.hpp"
#include "kernel/packed_modes.hpp"
#include "ocean/page_vector.hpp"
#include "query/parts.hpp"

namespace ocean {

class ThreadPool;

class SplineStrips {
  public:
    /// Packs the modes for maps of `resolution` samples.
    SplineStrips(const Modes& modes, int resolution, const ModeFactor& factor, ThreadPool& pool);
    /// Other modes. False, with nothing changed, if their lattice is another.
    bool repack(const Modes& modes, const ModeFactor& factor, ThreadPool& pool);

    /// From now on of that time: no strip is there. The outputs' buffers must stay.
    void begin(const Modes& modes, double time, std::span<const MapOutput> outputs,
               ThreadPool& pool);

    int count() const { return there_.count(); }
    int width() const { return width_; }
    int strip_of(int column) const { return column / width_; }
    bool has(int strip) const { return there_.has(strip); }
    /// Makes those that are not there, on the threads of the pool if there is one.
    void make(std::span<const int> strips, ThreadPool* pool) const;
    void need(int strip) const {
        if (!has(strip)) make({&strip, 1}, nullptr);
    }

  private:
    std::shared_ptr<PackedModes> packed_;
    MapKernel kernel_;
    int width_;
    mutable Parts there_;
    mutable std::mutex making_;
    mutable std::vector<PageVector<float>> scratch_;  // of each thread
};

}  // namespace ocean
