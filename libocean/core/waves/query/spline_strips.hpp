// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spline maps of one time, made strip by strip where they are read: a few points need only a few
// columns of a map. Pass two, the larger part of the kernel's work, makes columns, and pass one
// stores only those that it will read.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "ocean/page_vector.hpp"
#include "waves/kernel/map_kernel.hpp"
#include "waves/kernel/packed_modes.hpp"
#include "waves/query/lazy_tiles.hpp"

namespace ocean {

class ThreadPool;

class SplineStrips {
  public:
    /// Packs the modes for maps of `resolution` samples.
    SplineStrips(const Modes& modes, int resolution, const ModeFactor& factor, ThreadPool& pool);
    /// Packs other modes. Returns false and changes nothing if their lattice differs.
    bool repack(const Modes& modes, const ModeFactor& factor, ThreadPool& pool);

    /// Begins another time, without any strip. The outputs' buffers must outlive the strips. The
    /// first make() runs pass one, for its strips and those that the time before needed; a make()
    /// of others runs it once more, for all the others.
    void begin(const Modes& modes, double time, std::span<const MapOutput> outputs,
               ThreadPool& pool);
    /// Runs pass one for all strips at once, after begin(), for a caller whose threads make strips
    /// one by one.
    void sweep_all(ThreadPool& pool);

    /// Returns the packed modes, whose amplitudes may change between sweep_all(), or the last
    /// make() of a time, and begin().
    PackedModes& packed() { return *packed_; }

    int count() const { return ready_.count(); }
    int width() const { return width_; }
    int strip_of(int column) const { return column / width_; }
    bool has(int strip) const { return ready_.has(strip); }
    /// Returns true if pass one of this time has run for a strip.
    bool is_swept(int strip) const { return swept_[static_cast<std::size_t>(strip)] != 0; }
    /// Makes the given strips that are missing, on the threads of the pool unless it is null.
    void make(std::span<const int> strips, ThreadPool* pool) const;
    void need(int strip) const {
        if (!has(strip)) make({&strip, 1}, nullptr);
    }

  private:
    void sweep_for(std::span<const int> strips, ThreadPool* pool) const;

    std::shared_ptr<PackedModes> packed_;
    mutable MapKernel kernel_;
    int width_;
    mutable std::vector<std::uint8_t> swept_;       // [strip]: 1 = pass one has run for it
    mutable std::vector<std::uint8_t> next_sweep_;  // [strip]: 1 = it joins the next run
    mutable LazyTiles ready_;
    mutable std::mutex making_;
    mutable std::vector<PageVector<float>> scratch_;  // one for each thread
};

}  // namespace ocean
