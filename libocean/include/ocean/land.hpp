// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Land: the facade of a terrain, as Ocean is of a sea. It keeps noise, modes and what backends
// derive from them, and redoes only the stages that a changed parameter dirties.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "ocean/backend.hpp"
#include "ocean/query.hpp"
#include "ocean/surface.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrain_modes.hpp"
#include "ocean/terrain_state.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

struct LandOptions {
    int threads = 0;                    // 0 = the cores this process may use
    ThreadPool::RunJobs run_jobs = {};  // runs jobs on a host's own threads
    Backend backend = Backend::cpu;
    /// Called by the calling thread about 100 times a second during a computation; may throw to
    /// stop it. The Land can still be used.
    std::function<void()> interrupt = {};
};

/// The channels of a terrain, which has no displacement.
inline constexpr ChannelSet kTerrainChannels = {
    Channel::height, Channel::nx, Channel::ny, Channel::nz, Channel::slope_x, Channel::slope_y};

/// How often each stage of a terrain ran, for tests and tools.
struct TerrainRuns {
    int noise = 0;
    int filter = 0;
    int maps = 0;

    bool operator==(const TerrainRuns&) const = default;
};

/// One thread at a time per object; several objects run in parallel.
class Land {
  public:
    /// Validates the terrain; nothing is computed before it is requested. Throws Error
    /// invalid_value.
    explicit Land(Terrain terrain, const LandOptions& options = {});
    /// Makes the land of another thread, which shares what this one has computed.
    Land(const Land& shared, const LandOptions& options);
    ~Land();

    const Terrain& terrain() const;
    /// Replaces the terrain. Throws Error invalid_value and changes nothing if it is not valid.
    void set_terrain(Terrain terrain);
    /// Sets one parameter from text. Throws as set_parameter and validate, and changes nothing
    /// then.
    void set(std::string_view name, std::string_view value);

    /// Returns the modes, without the mean height.
    const Modes& modes();
    /// Returns the height that is added to every sample [m]: the mean, or that of `range`.
    double offset();
    TerrainScale scale();
    TerrainState state();

    /// Returns one map of `resolution` samples (0 = the terrain's own): all waves below its Nyquist
    /// line. Throws Error invalid_value for other channels than kTerrainChannels.
    Surface surface(ChannelSet channels, int resolution = 0);
    /// Writes such a map into buffers of the caller.
    void surface_into(std::span<const MapOutput> outputs, int resolution = 0);

    /// Writes height and normal at each point; velocity and foam are 0. Throws Error invalid_value
    /// for a point that is not finite.
    void query(std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions& options = {});

    /// Returns the rms error of such heights against the exact sum over all waves [m].
    double query_height_error(const QueryOptions& options = {});

    const TerrainRuns& runs() const;
    ThreadPool& pool();

    /// Returns the bytes of noise and modes.
    static std::uint64_t bytes(const Terrain& terrain);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean
