// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The small map of one cascade over its own period (modes.cascades[cascade].lattice), for real-time
// hosts that add up cascades while they draw: at any point the sum over all cascades, each wrapped
// at its own period, is the sea's.
#pragma once

#include <cstddef>

#include "ocean/backend.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/surface.hpp"

namespace ocean {

/// Makes the maps of one cascade, to be kept from frame to frame: it packs the modes again only
/// when their revision changes, and allocates nothing once all its fields have been requested. One
/// thread at a time; several objects run in parallel.
class CascadeMap {
  public:
    /// Makes the maps of `cascade`. resolution: a power of two, 32 .. 8192; 0 = the resolution of
    /// the cascade's lattice.
    explicit CascadeMap(std::size_t cascade, int resolution = 0,
                        const Backend& backend = Backend::cpu);

    /// Returns the fields at a time [s], valid until the next call. All calls need `modes` of the
    /// same sea, as Ocean::modes returns them.
    const LinearPlanes<float>& planes(const Modes& modes, double time, LinearSet fields,
                                      ThreadPool& pool);

  private:
    std::size_t cascade_;
    int resolution_;
    MapFunction maps_;
    LinearPlanes<float> planes_;
};

}  // namespace ocean
