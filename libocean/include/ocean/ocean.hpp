// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade: keeps the chain parameters -> spectrum -> modes -> surface -> foam and redoes only
// what a changed parameter, or the take at another time, dirties. One thread at a time per object;
// several objects run in parallel.
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
#include "ocean/thread_pool.hpp"

namespace ocean {

class Chain;
class DetailMaps;
class MapWriter;
class Performer;
class SprayFollower;

struct OceanOptions {
    int threads = 0;                    // 0 = the cores this process may use
    ThreadPool::RunJobs run_jobs = {};  // on a host's own threads
    Backend backend = Backend::cpu;
    /// settled: foam is what it always is at that time, whatever was asked before. empty: for live
    /// tools, which do not wait: foam begins with the first frame and is right after a while.
    FoamStart foam_start = FoamStart::settled;
    /// Called while foam is followed from its beginning; may throw to stop that.
    std::function<void(std::int64_t done, std::int64_t total)> foam_progress = {};
    /// Called by the caller's thread about a hundred times a second while anything is computed; may
    /// throw to stop it. What a stopped call was to write is then unfinished, and the sea goes on.
    std::function<void()> interrupt = {};
    /// Channels beside those of the table, made by their formulas with any backend:
    /// Channel(kChannelCount + i) is row i. Rows and names must outlive the Ocean.
    std::span<const ChannelInfo> channels = {};
};

/// Seconds that one frame of displacement, normal and foam takes on this machine, about.
struct FrameCost {
    double alone = 0.0;        // with all the past that its foam has
    double in_sequence = 0.0;  // after the frame before it
};

class Ocean {
  public:
    /// Validates. Nothing is computed yet.
    explicit Ocean(Sea sea, OceanOptions options = {});
    explicit Ocean(Parameters parameters, OceanOptions options = {});
    /// The same sea for another thread: what `built` has is shared, not built again.
    Ocean(const Ocean& built, OceanOptions options);
    ~Ocean();

    const Sea& sea() const { return sea_; }
    const Parameters& parameters() const { return sea_.parameters; }
    /// Another number whenever the sea is changed.
    std::uint64_t revision() const { return revision_; }
    /// Throws and changes nothing if the value is refused. Rules between parameters are checked
    /// when the sea is next asked for anything. Files that are named are for seafile's
    /// resolve_files to read: give it the changed sea, and this the result.
    void set(std::string_view name, std::string_view value);
    /// A live parameter glides to the value from that time on, as in a take: in the sea's own,
    /// which grows, so that its text makes every frame again. What was before that time stays, foam
    /// included, and costs nothing again. Values of one parameter that come within
    /// kLeastEventDistance wait for the rest of it, and the last of them counts. Throws Error, and
    /// changes nothing, for parameters that are not live, a loop, a time before the last that was
    /// performed, and a take that is full.
    void perform(double time, std::string_view name, std::string_view value);
    /// All of the sea at once: what differs from the one before says what is done again.
    void change(Sea sea);

    /// At a time, which matters for a sea with a take; the start where none is given.
    const DirectionalSpectrum& spectrum(double time);
    const DirectionalSpectrum& spectrum() { return spectrum(sea_.parameters.time.start); }
    const Modes& modes(double time);
    const Modes& modes() { return modes(sea_.parameters.time.start); }
    SeaState state();

    /// A map of `resolution` samples; 0 = default_map_resolution of the grid. Foam is followed from
    /// where it begins or, faster, from the last time that it was asked for: the same bits.
    /// Throws Error for a channel that is not known, and out_of_memory before it allocates more
    /// than there is.
    Surface evaluate(double time, ChannelSet channels, int resolution = 0);
    /// The same into the buffers of a host, which need no alignment (64 bytes are fastest) and must
    /// hold resolution^2 samples. With the cpu backend each value is written once, from the last
    /// stage of the transform.
    void evaluate_into(double time, std::span<const MapOutput> outputs, int resolution = 0);
    /// Of such a map: its cover is foam to this power, see foam_layer.hpp. For hosts that make the
    /// one of the other. Some tenths of a second after a change of waves or wind.
    double cover_power(double time, int resolution = 0);
    /// The small map of one cascade over its own period, modes(time).cascades[cascade].lattice: at
    /// any point the sum over the cascades, each wrapped round its own period, is the sea's. Of
    /// channels that add up, the multiples of the table, and of linear fields. resolution: 0 = that
    /// of the lattice.
    void evaluate_cascade_into(std::size_t cascade, double time, std::span<const MapOutput> outputs,
                               int resolution = 0);
    /// The slopes that a map of settings.resolution samples lacks, by band: with the first call for
    /// those settings the tiles' lattices are made. Throws Error invalid_value and out_of_memory.
    DetailBudget detail_budget(double time, const DetailSettings& settings = {});
    /// The waves too short for that map, as slope maps of one time. A pure function of sea, time
    /// and settings, as maps are: performed, looping, the same bits for any number of threads.
    Detail detail(double time, const DetailSettings& settings = {});
    /// The same into the buffers of a host: outputs[i] of detail_bands()[i], as many or fewer, of
    /// settings.samples^2 samples, with the channels slope_x and slope_y.
    void detail_into(double time, std::span<const MapOutput> outputs,
                     const DetailSettings& settings = {});
    /// All spray that is alive at a time, in no place's order but always the same one. The first
    /// call makes a map of spray_lattice for every tick of the foam's clock within the lifetime,
    /// later ones for new ticks alone: the same bits. Throws Error invalid_value for settings out
    /// of range, and out_of_memory.
    std::vector<SprayParticle> spray(double time, const SpraySettings& settings = {});
    /// The mist of that spray: a puff for each particle that was born within the lifetime, those
    /// that have ended since among them. At the cost of the spray.
    std::vector<MistPuff> mist(double time, const SpraySettings& settings = {});
    /// Ticks of the foam's clock until maps' foam that began empty is what it always is, of the
    /// map that has longest to go.
    std::int64_t foam_settling_ticks() const;

    /// Measured on a map of at most 512 samples a side and scaled to the default map: takes a
    /// moment.
    FrameCost measure_frame_cost();

    const StageRuns& stage_runs() const { return runs_; }
    /// For work beside the ocean's own; not during a call of it.
    ThreadPool& pool() { return pool_; }

    /// Queries of one time and options keep what they make for the next of the same, and most of
    /// it for the next time. Samples are as many as points; nothing is written if a point is
    /// refused. Errors as in query.hpp, and out_of_memory.
    void query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions& options = {});
    /// SurfaceQuery::height_error of such a query.
    double query_height_error(double time, const QueryOptions& options = {});
    /// OrbitalMotion at points of any depths, as many motions as points. Each other depth costs two
    /// transforms.
    void water_motion(double time, std::span<const WaterPoint> points,
                      std::span<WaterMotion> motions, const QueryOptions& options = {});
    void float_poses(double time, std::span<const FloatBody> bodies, std::span<FloatPose> poses);

  private:
    /// Makes the chain stand for that time. Throws if the sea is not valid.
    void go_to(double time);
    const Parameters& now() const;
    const Modes& current_modes();
    /// Writes the current sea's maps, foam over what the layer says.
    void write_maps(double time, std::span<const MapOutput> outputs, int resolution,
                    const FoamLayer& foam);
    FoamLayer foam_layer(double time, const FoamLattice& lattice);
    void make_foam_tick(double time, const FoamLattice& lattice, const FoamLayer& before,
                        std::span<float> foam);
    /// Returns the layer of a foam lattice on a finer map of the current sea. Valid until the next
    /// call.
    FoamLayer spread_layer(const FoamLayer& layer, int lattice, int resolution);
    bool has_foam(ChannelSet channels) const;
    int map_resolution(int asked) const;
    /// For so many maps beside what the channels need.
    void require_map_memory(int resolution, int maps, ChannelSet channels) const;
    DetailMaps& detail_at(double time, const DetailSettings& settings);
    SprayFollower& spray_at(double time, const SpraySettings& settings);
    /// On the map that is shown when nobody says.
    QueryOptions shown(QueryOptions options) const;
    const SurfaceQuery& surface_query(double time, const QueryOptions& options);
    const OrbitalMotion& orbital_motion(double time, double z, const QueryOptions& options);

    Sea sea_;
    std::uint64_t revision_ = 1;  // of the sea: another number when it is changed
    std::uint64_t checked_ = 0;   // the revision that was last found valid
    OceanOptions options_;
    ThreadPool pool_;
    StageRuns runs_;
    std::unique_ptr<Chain> chain_;
    std::unique_ptr<MapWriter> maps_;
    std::vector<std::unique_ptr<MapWriter>> cascade_maps_;
    std::unique_ptr<MapWriter> foam_maps_;  // of lattices that hold fewer waves than they could
    std::map<int, ChannelSet> made_;  // of each resolution so far: what the backend keeps is there
    std::map<FoamLattice, FoamState> foam_;  // of each foam lattice that maps have needed
    PageVector<float> spread_foam_;          // of the last map that is finer than its foam lattice
    std::map<DetailSettings, std::unique_ptr<DetailMaps>> detail_;
    std::unique_ptr<SprayFollower> spray_;  // of the settings that were asked for last
    std::unique_ptr<Performer> performer_;

    /// What a query was asked for.
    struct Asked {
        std::uint64_t revision = 0;  // of the sea; 0: what is kept is neither of one nor of another
        double time = 0.0;
        double z = 0.0;
        QueryOptions options = {};

        bool operator==(const Asked&) const = default;
    };
    /// What was asked last, and its answer's maps.
    template <typename Query>
    struct Kept {
        Asked asked;
        Query query;
    };
    std::optional<Kept<SurfaceQuery>> surface_query_;
    std::optional<Kept<OrbitalMotion>> orbital_motion_;
};

}  // namespace ocean
