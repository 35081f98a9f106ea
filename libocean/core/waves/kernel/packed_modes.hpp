// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The modes of a map as packets, which pass one reads from beginning to end; frame_task.hpp
// describes a packet.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "frame_task.hpp"
#include "ocean/backend.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

/// Factors of a mode's amplitude and of its displacement, applied while it is packed.
struct ModeScale {
    float amplitude = 1.0f;
    float displacement = 1.0f;
};
/// Returns the scale of mode (n, m), signed, of a cascade; it must be the same for (-n, -m).
/// Several threads call it at once.
using ModeFactor = std::function<ModeScale(std::size_t cascade, int n, int m)>;

class PackedModes {
  public:
    PackedModes(const MapModes& modes, ThreadPool& pool, SimdLevel level,
                const ModeFactor& factor = {});

    /// Packs other modes into the same memory. Returns false and changes nothing if their lattices
    /// or the map differ. If the lattice revision equals the previous modes', the packed rates and
    /// displacements stay, which are more than half of the data.
    bool refill(const MapModes& modes, ThreadPool& pool, const ModeFactor& factor = {});

    /// Returns the position in amplitudes() of P and Q, re and im each, of the modes kx, an FFT
    /// index of the map, in a block of neighbouring ky; `lanes` floats each. The lattice must have
    /// them.
    std::size_t place(int kx, int block) const;
    /// Returns the packets, for a caller that writes the amplitudes of frame_task.hpp itself.
    float* amplitudes() { return packets_.data(); }

    SimdLevel level() const { return level_; }
    int size() const { return size_; }
    /// Returns a multiple of B and of sixteen; only ky below it have modes.
    int columns() const { return columns_; }
    double rate_unit() const { return rate_unit_; }
    double wavenumber_step() const { return wavenumber_step_; }
    const float* packets() const { return packets_.data(); }
    const ModeGroup* groups() const { return groups_.data(); }

  private:
    class Packing;
    /// The numbers of a mode that are packed: all, or its amplitudes alone.
    enum class Numbers { all, amplitudes };
    void pack_all(const Packing& packing, Numbers numbers, ThreadPool& pool);

    SimdLevel level_;
    int size_;
    int columns_;
    double rate_unit_;
    double wavenumber_step_;
    Revision lattice_revision_;  // of rates and displacements; none if scaled
    std::vector<ModeGroup> groups_;
    PageVector<float> packets_;
};

}  // namespace ocean
