// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The open sea of an Ocean: keeps the chain parameters -> spectrum -> modes -> surface -> foam and
// recomputes only what a changed parameter, or the take at another time, dirties. A bed of the sea
// does not count here: the water around a coast is an open sea too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ocean/detail.hpp"
#include "ocean/domain.hpp"
#include "ocean/internal/float_pose.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/revision.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/ocean_options.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/query.hpp"
#include "ocean/sea.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/spray.hpp"
#include "ocean/surface.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

class Chain;
class DetailMaps;
class MapWriter;
struct MapModes;
class Performer;
class SprayFollower;

/// Functions without a comment do as those of Ocean.
class OpenSea {
  public:
    OpenSea(Sea sea, OceanOptions options);
    OpenSea(const OpenSea& built, OceanOptions options);
    ~OpenSea();

    const Sea& sea() const { return sea_; }
    const Parameters& parameters() const { return sea_.parameters; }
    const OceanOptions& options() const { return options_; }
    std::uint64_t revision() const { return revision_; }
    ThreadPool& pool() { return pool_; }
    StageRuns& stage_runs() { return runs_; }

    /// The kept results that a change of the sea makes invalid.
    struct Ended {
        bool past = false;  // what was followed over time
        bool grid = false;
    };
    Ended change(Sea sea);
    void perform(double time, std::string_view name, std::string_view value);
    /// Takes the foam that another object has followed, if it has the same waves.
    void take_foam(OpenSea& before);

    // The chain at a time [s]. Each result is valid until the next call that computes.
    const Parameters& parameters_at(double time);
    const DirectionalSpectrum& spectrum(double time);
    /// Returns the revision of what spectrum() returned last.
    const Revision& spectrum_revision() const;
    const Modes& modes(double time);
    /// Returns the surface settings with the whitecaps' threshold of maps of that resolution.
    const SurfaceSettings& shown_settings(double time, int resolution);
    SeaState state();

    Surface evaluate(double time, ChannelSet channels, int resolution);
    void evaluate_into(double time, std::span<const MapOutput> outputs, int resolution);
    void evaluate_cascade_into(std::size_t cascade, double time, std::span<const MapOutput> outputs,
                               int resolution);
    double cover_power(double time, int resolution);
    double cover_power(double time, const ShownFoam& foam);
    /// Writes the foam of a lattice, resolution^2 samples, without a finer map's whitecaps over it.
    /// Throws as evaluate().
    void lattice_foam_into(double time, const FoamLattice& lattice, std::span<float> foam);
    std::int64_t foam_settling_ticks() const;
    DetailBudget detail_budget(double time, const DetailSettings& settings);
    Detail detail(double time, const DetailSettings& settings);
    void detail_into(double time, std::span<const MapOutput> outputs,
                     const DetailSettings& settings);
    FrameCost measure_frame_cost();

    /// Fills a map of kSprayChannels at a time [s].
    using SprayMap = std::function<void(double time, Surface& map)>;
    /// Returns the spray of this sea's own surface.
    const SprayFollower& spray(double time, const SpraySettings& settings);
    /// Returns the spray of another surface over a domain. `require_room` throws if the maps do not
    /// fit into memory.
    const SprayFollower& spray(double time, const SpraySettings& settings, const Domain& domain,
                               const std::function<void()>& require_room, const SprayMap& fill);

    void query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions& options);
    double query_height_error(double time, const QueryOptions& options);
    void water_motion(double time, std::span<const WaterPoint> points,
                      std::span<WaterMotion> motions, const QueryOptions& options);
    void float_poses(double time, std::span<const FloatBody> bodies, std::span<FloatPose> poses);

  private:
    /// Sets the chain to the parameters at that time. Throws Error if the sea is not valid.
    void go_to(double time);
    const Parameters& now() const;
    const Modes& current_modes();
    /// Returns the modes of the chain's time for a map: those of both ends of a passage, if the
    /// backend interpolates between them.
    MapModes modes_of_map(double time, int resolution);
    /// Writes maps of the sea at the chain's time, with whitecaps laid over `foam`.
    void write_maps(double time, std::span<const MapOutput> outputs, int resolution,
                    const FoamLayer& foam);
    /// Returns the foam of a lattice before the map that is made next, see FoamState::layer_of_map.
    FoamLayer foam_layer(double time, const FoamLattice& lattice);
    /// Keeps the tick that a map has written, if the layer has one.
    void keep_foam(const FoamLayer& layer, const FoamLattice& lattice);
    /// Writes the foam of a lattice at the chain's time: its own whitecaps over `before`.
    void write_lattice_foam(double time, const FoamLattice& lattice, const FoamLayer& before,
                            std::span<float> foam);
    /// Returns the foam of a lattice at the chain's time as a layer of a finer map. Valid until the
    /// next call.
    FoamLayer spread_layer(double time, const FoamLayer& layer, const FoamLattice& lattice,
                           int resolution);
    bool has_foam(ChannelSet channels) const;
    int map_resolution(int requested) const;
    /// Throws Error out_of_memory if `maps` more maps, beside what the channels need, do not fit.
    void require_map_memory(int resolution, int maps, ChannelSet channels) const;
    DetailMaps& detail_at(double time, const DetailSettings& settings);
    /// Returns the options with the resolution of the displayed map filled in.
    QueryOptions shown(QueryOptions options) const;
    const SurfaceQuery& surface_query(double time, const QueryOptions& options);
    const OrbitalMotion& orbital_motion(double time, double z, const QueryOptions& options);

    Sea sea_;
    std::uint64_t revision_ = 1;  // changes with the sea
    std::uint64_t checked_ = 0;   // the last revision found valid
    OceanOptions options_;
    ThreadPool pool_;
    StageRuns runs_;
    std::unique_ptr<Chain> chain_;
    std::unique_ptr<MapWriter> maps_;
    std::vector<std::unique_ptr<MapWriter>> cascade_maps_;
    std::unique_ptr<MapWriter> foam_maps_;   // for lattices of fewer waves than their samples hold
    std::map<int, ChannelSet> allocated_;    // by resolution: what the backend has arrays for
    std::map<FoamLattice, FoamState> foam_;  // each lattice that a map has needed
    PageVector<float> lattice_foam_;         // at the time of the last map that is finer
    PageVector<float> spread_foam_;          // the same on that map
    std::map<DetailSettings, std::unique_ptr<DetailMaps>> detail_;
    std::unique_ptr<SprayFollower> spray_;  // for the last call
    std::unique_ptr<Performer> performer_;

    /// Identifies the maps of a query.
    struct QueryKey {
        std::uint64_t revision = 0;  // of the sea; 0 = the maps are incomplete
        double time = 0.0;
        double z = 0.0;
        QueryOptions options = {};

        bool operator==(const QueryKey&) const = default;
    };
    /// The query of the last call, with its maps.
    template <typename Query>
    struct CachedQuery {
        QueryKey key;
        Query query;
    };
    std::optional<CachedQuery<SurfaceQuery>> surface_query_;
    std::optional<CachedQuery<OrbitalMotion>> orbital_motion_;
};

}  // namespace ocean
