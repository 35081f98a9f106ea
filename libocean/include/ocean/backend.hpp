// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Backends: what makes the maps of one time out of the modes. A backend is a value, its name and
// one function; core has three, and a library above core adds its own without core knowing it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "ocean/foam_layer.hpp"
#include "ocean/map_output.hpp"
#include "ocean/modes.hpp"

namespace ocean {

class ThreadPool;

/// The modes -half + 1 .. half - 1 along each axis of `modes` of them fit a map on which they stand
/// `stride` apart.
inline int half_of(int modes, int stride, int map_resolution) {
    const int below_nyquist = (map_resolution / 2 - 1) / stride + 1;
    return std::min(modes / 2, below_nyquist);
}

/// The modes of a map at one time: those of a whole sea, or of one of its cascades over its own
/// period.
struct MapModes {
    std::span<const CascadeModes> cascades;
    double period = 0.0;     // of the map, m
    int divisor = 1;         // patch_size / period
    double tau = 0.0;        // of Modes
    double rate_unit = 1.0;  // of Modes
    int resolution = 0;      // of the map; may be more or less than that of the modes
    Revision revision;       // of Modes
    Revision lattice_revision;
    int held_by = 0;  // only modes that a map of this resolution holds; 0: of `resolution`

    double wavenumber_step() const { return kTwoPi / period; }
    /// Mode (n, m) of a cascade is mode (n, m) * stride(cascade) of the map.
    int stride(const CascadeModes& cascade) const { return cascade.divisor / divisor; }
    /// The map holds the modes -half + 1 .. half - 1 of a cascade along each axis.
    int half(const CascadeModes& cascade) const {
        return half_of(cascade.lattice.resolution, stride(cascade),
                       held_by > 0 ? std::min(held_by, resolution) : resolution);
    }
    /// Of the map itself: its modes beyond -half_band + 1 .. half_band - 1 are zero.
    int half_band() const {
        int half_band = 0;
        for (const CascadeModes& cascade : cascades) {
            half_band = std::max(half_band, (half(cascade) - 1) * stride(cascade) + 1);
        }
        return half_band;
    }
};

/// All modes of a sea.
MapModes map_modes(const Modes& modes, double time, int resolution);
/// Those of one of its cascades.
MapModes cascade_modes(const Modes& modes, std::size_t cascade, double time, int resolution);

/// What a backend is asked for: maps of one time.
struct MapRequest {
    MapModes modes;
    SurfaceSettings settings;  // the choppiness; for whitecaps as from with_threshold
    std::span<const MapOutput> outputs;
    FoamLayer foam;
};

/// Writes the outputs, without their seams. It may keep what it makes of the modes for requests
/// with the same revision of them, and its arrays. Returns whether it had to
/// make anything of the modes. One call at a time; copies of it run in parallel, share what they
/// keep and change it for themselves alone.
using MapFunction = std::function<bool(const MapRequest&, ThreadPool&)>;

/// What a backend has to say of this machine.
struct BackendFitness {
    bool runs = true;
    bool fast = false;   // more than cpu: what `auto` takes
    std::string reason;  // what it runs on; or why it does not run, or is not fast
};

struct Backend {
    std::string_view name;
    /// The channels that it makes itself. Others are made, by their formulas, of the linear fields,
    /// which every backend writes.
    ChannelSet makes;
    MapFunction (*start)() = nullptr;
    /// Memory of its own for maps of such fields of a sea, beside modes and outputs; null: little.
    std::uint64_t (*work_bytes)(const Grid& grid, LinearSet fields, int resolution) = nullptr;
    /// For maps of that resolution; null: it runs everywhere.
    BackendFitness (*fitness)(int resolution) = nullptr;
    /// Somewhere it is faster than cpu: `auto` asks for its fitness.
    bool may_be_fast = false;

    bool operator==(const Backend& other) const { return name == other.name; }

    static const Backend cpu;     // the default: half spectrum, vectorised, on all threads
    static const Backend radix2;  // full complex transforms in float, one field at a time: to read
    static const Backend dft;     // direct sums along each axis in double: the judge. N^3 work
};

/// cpu, radix2, dft.
std::span<const Backend> core_backends();
/// One of those by name. Throws Error; "gl" is for those who link ocean::gl.
const Backend& find_backend(std::string_view name);

}  // namespace ocean
