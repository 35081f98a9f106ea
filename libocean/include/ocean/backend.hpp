// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Backends: they make the maps of one time out of the modes. A backend is a value: its name and one
// function. core has three; a library above core adds its own, and core does not know it.
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
struct CoastRequest;

/// Returns h so that a map of `map_resolution` samples holds the modes -h + 1 .. h - 1 along each
/// axis, out of a lattice of `modes` of them. `stride` is the distance of neighbouring modes of the
/// lattice, in modes of the map.
inline int half_of(int modes, int stride, int map_resolution) {
    const int below_nyquist = (map_resolution / 2 - 1) / stride + 1;
    return std::min(modes / 2, below_nyquist);
}

/// The modes of a map at one time: those of a whole sea, or those of one of its cascades over the
/// cascade's own period.
struct MapModes {
    std::span<const CascadeModes> cascades;
    double period = 0.0;     // of the map [m]
    int divisor = 1;         // patch_size / period
    double tau = 0.0;        // Modes::tau of the time
    double rate_unit = 1.0;  // Modes::rate_unit
    int resolution = 0;      // of the map; may be above or below that of the modes
    Revision revision;       // Modes::revision
    Revision lattice_revision;
    int held_by = 0;  // only modes that a map of this resolution holds; 0: of `resolution`

    double wavenumber_step() const { return kTwoPi / period; }
    /// Returns the factor by which mode (n, m) of a cascade is mode (n, m) * stride of the map.
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
/// Returns the modes of one cascade at a time [s], for a map over the cascade's own period.
MapModes cascade_modes(const Modes& modes, std::size_t cascade, double time, int resolution);

/// The input of a backend: which maps of one time to write.
struct MapRequest {
    MapModes modes;
    SurfaceSettings settings;  // the choppiness; for whitecaps as from with_threshold
    std::span<const MapOutput> outputs;
    FoamLayer foam;
};

/// Writes the outputs, without their seams. A MapFunction may keep its arrays, and what it derives
/// from the modes for later requests with the same revision. Returns true if it had to derive
/// anything from the modes. One call at a time; copies of a MapFunction run in parallel and share
/// what they keep until one of them changes it.
using MapFunction = std::function<bool(const MapRequest&, ThreadPool&)>;

/// Writes the sums over the waves of a coast at labels; see ocean/coast_waves.hpp. It may keep what
/// does not change with time. One call at a time.
using CoastFunction = std::function<void(const CoastRequest&)>;

/// How well a backend suits this machine.
struct BackendFitness {
    bool runs = true;
    bool fast = false;   // faster than cpu: `auto` chooses it
    std::string reason;  // the device it runs on; or why it does not run or is not fast
};

struct Backend {
    std::string_view name;
    /// The channels that the backend computes itself. The others are computed, by their formulas,
    /// from the linear fields, which every backend writes.
    ChannelSet makes;
    /// Returns an independent function with nothing kept yet.
    MapFunction (*start)() = nullptr;
    /// Returns the bytes it needs for maps of such fields, beside modes and outputs; null: few.
    std::uint64_t (*work_bytes)(const Grid& grid, LinearSet fields, int resolution) = nullptr;
    /// Returns how well it suits this machine for maps of that resolution; null: it runs on all.
    BackendFitness (*fitness)(int resolution) = nullptr;
    /// True if it is faster than cpu on some machines: `auto` then calls `fitness`.
    bool may_be_fast = false;
    /// Returns an independent function for coasts; null: the processor sums their waves.
    CoastFunction (*start_coast)() = nullptr;

    bool operator==(const Backend& other) const { return name == other.name; }

    static const Backend cpu;     // the default: half spectrum, vectorised, on all threads
    static const Backend radix2;  // full complex transforms in float, one field at a time: to read
    static const Backend dft;     // direct sums along each axis in double, N^3 work: the reference
};

/// Returns cpu, radix2 and dft.
std::span<const Backend> core_backends();
/// Returns the core backend of that name. Throws Error invalid_value for another name; "gl" belongs
/// to programs that link ocean::gl.
const Backend& find_backend(std::string_view name);

}  // namespace ocean
