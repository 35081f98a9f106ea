// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The input of a backend: the modes of a map at one time, and the outputs to write.
#pragma once

#include <algorithm>
#include <span>

#include "ocean/backend.hpp"
#include "ocean/internal/foam_layer.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/surface.hpp"

namespace ocean {

/// Returns h so that a map of `map_resolution` samples holds the modes -h + 1 .. h - 1 along each
/// axis, of a lattice of `modes` modes. `stride` is the distance of neighbouring modes of the
/// lattice, in modes of the map.
inline int half_of(int modes, int stride, int map_resolution) {
    const int below_nyquist = (map_resolution / 2 - 1) / stride + 1;
    return std::min(modes / 2, below_nyquist);
}

/// The modes of a map at one time: of a whole sea, or of one of its cascades over the cascade's own
/// period.
struct MapModes {
    std::span<const CascadeModes> cascades;
    double period = 0.0;     // of the map [m]
    int divisor = 1;         // patch_size / period
    double tau = 0.0;        // Modes::tau of the time
    double rate_unit = 1.0;  // Modes::rate_unit
    int resolution = 0;      // of the map; may differ from the modes' resolution
    Revision revision;       // Modes::revision
    Revision lattice_revision;
    int held_by = 0;             // resolution of a map that holds the modes; 0: `resolution`
    double binding_limit = 0.0;  // Modes::binding_limit; 0 for a cascade that binds no waves
    /// Modes of the same lattice, and how far the map's amplitudes are on the way to them. Empty:
    /// the map's are those of `cascades`.
    std::span<const CascadeModes> toward = {};
    Revision toward_revision = {};
    float share = 0.0f;

    double wavenumber_step() const { return kTwoPi / period; }
    /// Returns the stride by which mode (n, m) of a cascade is mode (n, m) * stride of the map.
    int stride(const CascadeModes& cascade) const { return cascade.divisor / divisor; }
    /// Returns h so that the map holds the modes -h + 1 .. h - 1 of a cascade along each axis.
    int half(const CascadeModes& cascade) const {
        return half_of(cascade.lattice.resolution, stride(cascade),
                       held_by > 0 ? std::min(held_by, resolution) : resolution);
    }
    /// Returns h so that all modes of the map beyond -h + 1 .. h - 1 are zero.
    int half_band() const {
        int half_band = 0;
        for (const CascadeModes& cascade : cascades) {
            half_band = std::max(half_band, (half(cascade) - 1) * stride(cascade) + 1);
        }
        return half_band;
    }
};

/// Returns all modes of a sea at a time [s], for a map of `resolution` samples.
MapModes map_modes(const Modes& modes, double time, int resolution);
/// Returns the modes that are `share` of the way between those of two states, for a backend that
/// interpolates.
MapModes map_modes(const Modes& from, const Modes& to, float share, double time, int resolution);
/// Returns the modes of one cascade at a time [s], for a map over the cascade's own period.
MapModes cascade_modes(const Modes& modes, std::size_t cascade, double time, int resolution);

/// The input of a backend: which maps of one time to write.
struct MapRequest {
    MapModes modes;
    SurfaceSettings settings;  // the choppiness; for whitecaps as from with_threshold
    std::span<const MapOutput> outputs;
    FoamLayer foam;
};

}  // namespace ocean
