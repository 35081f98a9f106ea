// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade: keeps the chain parameters -> spectrum -> modes -> surface -> foam and recomputes
// only what a changed parameter, or the take at another time, dirties. One thread at a time per
// object; several objects run in parallel.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ocean/backend.hpp"
#include "ocean/detail.hpp"
#include "ocean/domain.hpp"
#include "ocean/float_pose.hpp"
#include "ocean/foam.hpp"
#include "ocean/map_output.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/query.hpp"
#include "ocean/sea.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/spray.hpp"
#include "ocean/stage_runs.hpp"
#include "ocean/surface.hpp"
#include "ocean/surface_query.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

class Chain;
class Coast;
class DetailMaps;
class MapWriter;
class Performer;
class ShoreMotion;
class ShoreSurface;
class SprayFollower;
class SurfReader;
struct RegionTraces;
enum class SurfTrace;

struct OceanOptions {
    int threads = 0;                    // 0 = the cores this process may use
    ThreadPool::RunJobs run_jobs = {};  // runs jobs on a host's own threads
    Backend backend = Backend::cpu;
    /// settled: foam at a time does not depend on earlier calls. empty: for live tools, which must
    /// not wait; foam begins with the first frame and is correct after foam_settling_ticks().
    FoamStart foam_start = FoamStart::settled;
    /// Called while foam is followed from its beginning; may throw to stop the call.
    std::function<void(std::int64_t done, std::int64_t total)> foam_progress = {};
    /// Called by the calling thread about 100 times a second during a computation; may throw to
    /// stop it. The outputs of a stopped call are incomplete; the Ocean can still be used.
    std::function<void()> interrupt = {};
    /// Channels beside those of the table, computed by their formulas with any backend:
    /// Channel(kChannelCount + i) is row i. Rows and names must outlive the Ocean.
    std::span<const ChannelInfo> channels = {};
    /// Called while the coast of a sea over a bed is computed, with what is being computed and the
    /// share of it that is done, 0 .. 1; may throw to stop the call.
    std::function<void(std::string_view work, double share)> build_progress = {};
};

/// Approximate seconds that a frame of displacement, normal and foam takes on this machine.
struct FrameCost {
    double alone = 0.0;        // with the whole past of its foam
    double in_sequence = 0.0;  // after the previous frame
};

/// Computes everything of one sea.
class Ocean {
  public:
    /// Validates the sea. Computes nothing yet. Throws Error.
    explicit Ocean(Sea sea, OceanOptions options = {});
    explicit Ocean(Parameters parameters, OceanOptions options = {});
    /// Makes the same sea for another thread. Shares what `built` has computed.
    Ocean(const Ocean& built, OceanOptions options);
    ~Ocean();

    const Sea& sea() const { return sea_; }
    const Parameters& parameters() const { return sea_.parameters; }
    /// Returns a number that changes whenever the sea changes.
    std::uint64_t revision() const { return revision_; }
    /// Sets a parameter by name. Throws Error and changes nothing if the value is refused. Rules
    /// between parameters are checked by the next call that computes. This does not read files:
    /// after a change of `file`, `record`, `place` or `take`, pass the sea to seafile's
    /// resolve_files and the result to change().
    void set(std::string_view name, std::string_view value);
    /// Lets a live parameter glide to the value from `time` [s] on. The change becomes an event of
    /// the sea's own take, so its text reproduces every frame. Maps and foam before `time` stay
    /// valid and are not computed again. Events of one parameter are at least kMinEventSpacing
    /// apart: a value that comes sooner is delayed until then, and the last one replaces the
    /// others. Throws Error, and changes nothing, for parameters that are not live, a loop, a time
    /// before the last performed event, and a full take.
    void perform(double time, std::string_view name, std::string_view value);
    /// Replaces the whole sea. Recomputes only what its differences from the previous one dirty.
    void change(Sea sea);

    /// Returns the spectrum at a time [s], which matters for a sea with a take. Valid until the
    /// next call that computes.
    const DirectionalSpectrum& spectrum(double time);
    /// Returns the spectrum at the start.
    const DirectionalSpectrum& spectrum() { return spectrum(sea_.parameters.time.start); }
    /// Returns the modes at a time [s]. Valid until the next call that computes.
    const Modes& modes(double time);
    /// Returns the modes at the start.
    const Modes& modes() { return modes(sea_.parameters.time.start); }
    /// Returns the statistics of the sea at the start.
    SeaState state();

    /// Returns a map of `resolution` samples; 0 = default_map_resolution of the grid. Foam is
    /// followed from where it begins or, faster, from the last requested time: the bits are the
    /// same. Throws Error for an unknown channel, and out_of_memory before anything is allocated.
    Surface evaluate(double time, ChannelSet channels, int resolution = 0);
    /// Writes a map of `resolution` samples (0 = default_map_resolution of the grid) into a host's
    /// buffers, which must hold resolution^2 samples and need no alignment; 64 bytes are fastest.
    /// The backend cpu writes each value once, from the last stage of the transform. Throws as
    /// evaluate().
    void evaluate_into(double time, std::span<const MapOutput> outputs, int resolution = 0);
    /// Returns a map over a domain that does not wrap, of a sea over a bed: sample (i, j) is that
    /// of the label domain.place(i, j). Beside the channels of the table it may have the masks
    /// depth, breaking and wetness (land_mask.hpp). Foam is followed as for evaluate(). The first
    /// call computes where the waves go over the bed, which takes seconds: see
    /// OceanOptions::build_progress. Throws Error unsupported for a sea without a bed,
    /// invalid_value for a domain that wraps or has other than 2 .. kMaxRegionSide samples along a
    /// side, and out_of_memory.
    Surface region(double time, const Domain& domain, ChannelSet channels);
    /// Writes a region into a host's buffers of domain.samples[0] samples in a row. The outputs may
    /// hold channels alone. Throws as region().
    void region_into(double time, const Domain& domain, std::span<const MapOutput> outputs);
    /// Computes now what the first region or query of a sea over a bed would compute. Throws as
    /// region().
    void prepare_coast();
    /// Returns the exponent p of cover = foam^p on a map of `resolution` samples (see
    /// foam_layer.hpp), for hosts that compute cover from foam themselves. Takes some tenths of a
    /// second after a change of waves or wind.
    double cover_power(double time, int resolution = 0);
    double cover_power(double time, const ShownFoam& foam);
    /// Writes the foam of a lattice, resolution^2 samples, without a finer map's whitecaps over it.
    /// Throws as evaluate().
    void lattice_foam_into(double time, const FoamLattice& lattice, std::span<float> foam);
    /// Writes the small map of one cascade over its own period,
    /// modes(time).cascades[cascade].lattice: at any point the sum over all cascades, each wrapped
    /// at its own period, is the sea's. The outputs may hold linear fields and channels that add
    /// up, the multiples of the table. resolution: 0 = that of the lattice. Throws as evaluate().
    void evaluate_cascade_into(std::size_t cascade, double time, std::span<const MapOutput> outputs,
                               int resolution = 0);
    /// Returns the slopes that a map of settings.resolution samples lacks, by band. The first call
    /// for such settings builds the tiles' lattices. Throws Error invalid_value and out_of_memory.
    DetailBudget detail_budget(double time, const DetailSettings& settings = {});
    /// Returns the waves too short for that map, as slope maps of one time. Like maps, a pure
    /// function of sea, time and settings, also for a sea with a take or a loop; the bits are the
    /// same for any number of threads. Throws as detail_budget().
    Detail detail(double time, const DetailSettings& settings = {});
    /// Writes these slope maps into a host's buffers: outputs[i] receives slope_x and slope_y of
    /// detail_bands()[i], settings.samples^2 samples. `outputs` may be shorter than the bands.
    /// Throws as detail_budget().
    void detail_into(double time, std::span<const MapOutput> outputs,
                     const DetailSettings& settings = {});
    /// Returns all particles of spray alive at a time [s], in an unspecified but reproducible
    /// order. The first call computes a map of spray_lattice for every tick of the foam's clock
    /// within the lifetime, a later one only for new ticks: the bits are the same. Throws Error
    /// invalid_value for settings out of range, and out_of_memory.
    std::vector<SprayParticle> spray(double time, const SpraySettings& settings = {});
    /// Returns the mist of that spray: a puff for each particle born within the lifetime, including
    /// those that have ended since. Costs as much as spray().
    std::vector<MistPuff> mist(double time, const SpraySettings& settings = {});
    /// Returns the ticks of the foam's clock until foam that began empty equals settled foam, for
    /// the map that needs the longest.
    std::int64_t foam_settling_ticks() const;

    /// Measures on a map of at most 1024 samples along a side and scales to the default map. Blocks
    /// for a moment.
    FrameCost measure_frame_cost();

    const StageRuns& stage_runs() const { return runs_; }
    /// Returns the pool, for other work of the caller; not during a call of this object.
    ThreadPool& pool() { return pool_; }

    /// Writes one sample of the displayed surface for each point. Queries of the same time and
    /// options share their maps; the next time reuses most of their memory. Writes nothing if a
    /// point is refused. Throws as SurfaceQuery, and out_of_memory.
    void query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions& options = {});
    /// Returns SurfaceQuery::height_error [m] for such a query.
    double query_height_error(double time, const QueryOptions& options = {});
    /// Writes the motion of the water at points of any depths, one for each point. Each different
    /// depth costs two transforms. Throws as OrbitalMotion, and out_of_memory.
    void water_motion(double time, std::span<const WaterPoint> points,
                      std::span<WaterMotion> motions, const QueryOptions& options = {});
    /// Writes the pose of each body, see float_pose().
    void float_poses(double time, std::span<const FloatBody> bodies, std::span<FloatPose> poses);

  private:
    /// Sets the chain to the parameters at that time. Throws Error if the sea is not valid.
    void go_to(double time);
    const Parameters& now() const;
    const Modes& current_modes();
    /// Throws Error unsupported for a sea over a bed, which `what` does not know.
    void require_open_sea(std::string_view what) const;
    /// Calls body(sea) with the sea at a time, as the coast takes it.
    template <typename Body>
    decltype(auto) with_coast_sea(double time, const Body& body);
    void require_bed() const;
    /// Writes maps of the open sea.
    void write_open(double time, std::span<const MapOutput> outputs, int resolution);
    /// Returns the surface over the bed at a time. Valid until the next call.
    ShoreSurface& shore_surface(double time, bool with_rates);
    void query_shore(double time, std::span<const WorldPoint> points,
                     std::span<QuerySample> samples, const QueryOptions& options);
    /// Throws as region() before a region is computed, and out_of_memory if `new_maps` maps of its
    /// samples do not fit beside its foam.
    void begin_region(double time, const Domain& domain, ChannelSet channels, std::size_t new_maps);
    /// Writes a region of the sea at the chain's time.
    void write_region(double time, const Domain& domain, std::span<const MapOutput> outputs);
    /// Returns the foam of breaking waves, or the wetness of the ground, at the reader's labels.
    FoamLayer surf_layer(SurfTrace trace, double time, SurfReader& reader, FoamState& state);
    /// Writes maps of the sea at the chain's time, with whitecaps laid over `foam`.
    void write_maps(double time, std::span<const MapOutput> outputs, int resolution,
                    const FoamLayer& foam);
    FoamLayer foam_layer(double time, const FoamLattice& lattice);
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
    SprayFollower& spray_at(double time, const SpraySettings& settings);
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
    std::unique_ptr<MapWriter> foam_maps_;  // for lattices of fewer waves than their samples hold
    std::map<int, ChannelSet> made_;  // by resolution: channels that the backend has arrays for
    std::map<FoamLattice, FoamState> foam_;  // each lattice that a map has needed
    PageVector<float> lattice_foam_;         // at the time of the last map that is finer
    PageVector<float> spread_foam_;          // the same on that map
    std::map<DetailSettings, std::unique_ptr<DetailMaps>> detail_;
    std::unique_ptr<SprayFollower> spray_;  // for the settings of the last call
    std::unique_ptr<Performer> performer_;
    std::unique_ptr<Coast> coast_;
    std::unique_ptr<ShoreMotion> shore_motion_;
    std::unique_ptr<RegionTraces> region_traces_;

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
