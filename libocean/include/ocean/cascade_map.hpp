// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The small map of one cascade over its own period (modes.cascades[cascade].lattice), for real-time
// hosts that add up cascades while they draw: at any point the sum over the cascades, each wrapped
// round its own period, is the sea's.
#pragma once

#include <cstddef>

#include "ocean/backend.hpp"
#include "ocean/surface.hpp"

namespace ocean {

/// Kept from frame to frame: it packs modes again where their revision is another, and allocates
/// nothing once its fields have been asked for. One thread at a time; several run in parallel.
class CascadeMap {
  public:
    /// resolution: 0 = that of the cascade's lattice; else a power of two, 32 .. 8192.
    explicit CascadeMap(std::size_t cascade, int resolution = 0,
                        const Backend& backend = Backend::cpu);

    /// Those fields at a time, valid until the next call. `modes`: of one sea, as from
    /// Ocean::modes.
    const LinearPlanes<float>& planes(const Modes& modes, double time, LinearSet fields,
                                      ThreadPool& pool);

  private:
    std::size_t cascade_;
    int resolution_;
    MapFunction maps_;
    LinearPlanes<float> planes_;
};

}  // namespace ocean
