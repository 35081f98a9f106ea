// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Backends: they make the maps of one time out of the modes. A backend is a value: its name and one
// function. core has three; a library above core adds its own, and core does not know it.
//
//     Ocean reference(sea, {.backend = Backend::dft});
//     Ocean on_gpu(sea, {.backend = gl::kBackend});  // of ocean::gl
//     for (const Backend& each : core_backends()) std::puts(each.name.data());
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "ocean/channel.hpp"

namespace ocean {

class ThreadPool;
struct CoastRequest;
struct Grid;
struct MapRequest;

/// Writes the outputs, without their seams. A MapFunction may keep its arrays, and what it derives
/// from the modes for later requests with the same revision. Returns true if it had to derive
/// anything from the modes. One call at a time; copies of a MapFunction run in parallel and share
/// what they keep until one of them changes it.
using MapFunction = std::function<bool(const MapRequest&, ThreadPool&)>;

/// Writes the sums over the waves of a coast at labels; see ocean/internal/coast_waves.hpp. It may
/// keep what does not change with time. One call at a time.
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
    /// Returns the bytes that maps of such fields need beside modes and outputs; null: few.
    std::uint64_t (*work_bytes)(const Grid& grid, LinearSet fields, int resolution) = nullptr;
    /// Returns how well the backend suits this machine for maps of that resolution; null: it runs
    /// on all machines.
    BackendFitness (*fitness)(int resolution) = nullptr;
    /// True if the backend is faster than cpu on some machines: `auto` then calls `fitness`.
    bool may_be_fast = false;
    /// Returns an independent function for coasts; null: the processor sums their waves.
    CoastFunction (*start_coast)() = nullptr;
    /// True if the backend writes FoamLayer::kept. Otherwise a tick of foam and the map over it are
    /// two requests.
    bool keeps_foam = false;
    /// True if the backend reads MapModes::toward. Otherwise it is given interpolated modes.
    bool interpolates = false;

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
