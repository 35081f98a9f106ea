// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Terrain: the facade of a terrain, as Ocean is the facade of a sea. It keeps noise and modes, the
// data that backends derive from them, and the function of a land that erosion and shore have
// shaped. It redoes only the stages that a changed parameter dirties.
//
//     Terrain terrain(read_terrain("hills.toml"));
//     const Surface map = terrain.surface({Channel::height, Channel::nz});
//     const Domain square = domain_of(Region{.size = {200.0, 200.0}, .cell = 0.5});
//     const Surface near = terrain.region(square, terrain.channels());
//     const WorldPoint camera{120.0, 80.0};
//     QuerySample ground;
//     terrain.query({&camera, 1}, {&ground, 1});
//     std::puts(terrain_state_json(terrain.state()).c_str());
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/backend.hpp"
#include "ocean/domain.hpp"
#include "ocean/query.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/surface.hpp"
#include "ocean/terrain_model.hpp"
#include "ocean/terrain_repeat.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

class LandFunction;
class Surface;
struct Modes;
struct TerrainScale;

/// The waves of one octave of wavelength.
struct TerrainOctave {
    double longest_wave = 0.0;  // [m]; the shortest is half of it
    AskedResolved rms;          // of the heights of these waves [m]
    /// Exponent beta: `asked` is the law's exponent in the middle of the octave, `resolved` the
    /// slope of a line through the densities of eight rings of this tile, NaN if the octave has
    /// fewer than 100 waves.
    AskedResolved exponent;
};

/// `asked` is the mean of all seeds, a sum over the modes of the lattice without their noise;
/// `resolved` is this very tile. A land with erosion, a shore or a place of its own is measured on
/// a map instead: `resolved` describes that map, `asked` its waves before they were shaped; NaN for
/// an elevation model.
struct TerrainState {
    AskedResolved rms;        // [m]
    AskedResolved rms_slope;  // root of the mean square slope
    /// Slope angles [degrees] that 50, 90 and 99 % of the land do not exceed, computed from the
    /// mean square slope as for a Gaussian surface without direction.
    std::vector<AskedResolved> slope_angles;
    double mean = 0.0;             // [m]
    double shortest_wave = 0.0;    // within the limits, along an axis of the grid [m]
    double longest_wave = 0.0;     // [m]
    double period = 0.0;           // [m]; 0 for a land that exists once
    std::array<double, 2> size{};  // of a land that exists once, or of the tile [m]
    double lowest = 0.0;           // lowest height of the measured map [m]; 0 if none
    double highest = 0.0;
    double cell = 0.0;                   // distance of samples [m]
    double measured_cell = 0.0;          // cell of the map whose slopes are stated; shaped land
    std::vector<TerrainOctave> octaves;  // from the longest wave
    /// The highest peaks within the period, without gullies, which add to both. Unset for a land
    /// that exists once.
    std::optional<TerrainRepeat> repeat;
    std::uint64_t memory_bytes = 0;     // for noise, modes and a map of height and slopes
    std::vector<std::string> warnings;  // full sentences, for people
};

/// Returns the statistics of a terrain with these modes; `offset` is the height added to the modes.
TerrainState terrain_state(const TerrainModel& terrain, const Modes& modes,
                           const TerrainScale& scale, double offset);
/// Replaces the statistics that shaping changes by the statistics of `map`, which has heights and
/// slopes.
void measure_shaped(const Surface& map, TerrainState& state);
/// Returns the JSON object of `ocean info --json`.
std::string terrain_state_json(const TerrainState& state);

struct TerrainOptions {
    int threads = 0;                    // 0 = the cores this process may use
    ThreadPool::RunJobs run_jobs = {};  // runs jobs on a host's own threads
    Backend backend = Backend::cpu;
    /// Called by the calling thread about 100 times a second during a computation; may throw to
    /// stop it. The Terrain can still be used.
    std::function<void()> interrupt = {};
    /// Is called by the calling thread while a shaped land is built, with what is being computed
    /// and the share of it that is done, 0 .. 1; may throw to stop, as interrupt.
    std::function<void(std::string_view work, double share)> progress = {};
};

/// How often each stage of a terrain ran, for tests and tools.
struct TerrainRuns {
    int noise = 0;
    int filter = 0;
    int maps = 0;
    int shape = 0;    // of the function of a shaped land
    int streams = 0;  // runs of `shape` that carved streams anew

    bool operator==(const TerrainRuns&) const = default;
};

/// One thread at a time per object; several objects run in parallel.
class Terrain {
  public:
    /// Validates the values; nothing is computed before it is requested. Throws Error
    /// invalid_value.
    explicit Terrain(TerrainModel model, const TerrainOptions& options = {});
    /// Makes the land for another thread. It shares what `shared` has computed.
    Terrain(const Terrain& shared, const TerrainOptions& options);
    ~Terrain();

    const TerrainModel& model() const;
    /// Replaces the terrain. Throws Error invalid_value and changes nothing if it is not valid.
    void set_model(TerrainModel model);
    /// Sets one parameter from text. Throws as set_parameter and validate, and changes nothing
    /// then.
    void set(std::string_view name, std::string_view value);

    /// Returns the modes, without the mean height.
    const Modes& modes();
    /// Returns the height that is added to every sample [m]: the mean, or the height that moves the
    /// map into `range`.
    double offset();
    TerrainScale scale();
    TerrainState state();

    /// Returns the land as a function of the place; also for a tile without gullies, whose own maps
    /// are made by transforms. The first call builds the function, which stays valid after changes.
    std::shared_ptr<const LandFunction> function();
    /// Returns the channels of the land's maps: kTerrainChannels, and the masks of a shaped land.
    ChannelSet channels() const;
    /// Returns the domain of a map of `resolution` samples (0 = the terrain's own): a tile has that
    /// many along each side, a placed land along its longer one.
    Domain domain(int resolution = 0) const;

    /// Returns one map of domain(resolution). A tile's map has all waves below its Nyquist line.
    /// Throws Error unsupported for channels that the land does not have.
    Surface surface(ChannelSet channels, int resolution = 0);
    /// Writes the map of domain(resolution) into buffers of the caller. Throws as surface(), and
    /// Error unsupported for a placed land that is not a square.
    void surface_into(std::span<const MapOutput> outputs, int resolution = 0);
    /// Returns the map of a region at any place, of samples that lie region.step() apart; a tile
    /// repeats, and a placed land is clamped to its rectangle. Throws as surface().
    Surface region(const Domain& region, ChannelSet channels);
    /// Writes the map of a region into buffers of the caller, rows of region.samples[0] samples.
    void region_into(const Domain& region, std::span<const MapOutput> outputs);

    /// Writes height and normal at each point; velocity and foam are 0. Throws Error invalid_value
    /// for a point that is not finite.
    void query(std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions& options = {});

    /// Returns the rms error of query()'s heights against the exact sum over all waves [m].
    double query_height_error(const QueryOptions& options = {});

    const TerrainRuns& runs() const;
    ThreadPool& pool();

    /// Returns the bytes of noise and modes.
    static std::uint64_t bytes(const TerrainModel& model);

  private:
    void shaped_into(std::span<const MapOutput> outputs, int resolution);

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Returns the channels that a terrain's sections give it: see Terrain::channels.
ChannelSet terrain_channels(const TerrainModel& model);
/// Returns the domain of a terrain's maps: see Terrain::domain. A base must have been read.
Domain terrain_domain(const TerrainModel& model, int resolution = 0);

}  // namespace ocean
