// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade of seas: picks the open sea, its coast over a bed, or the sea with the wakes of its
// hulls. Each keeps what it computes, and computes again only what a changed parameter, or the take
// at another time, dirties. One thread at a time per object; several objects run in parallel.
//
//     Ocean ocean(read_sea("storm.toml"));
//     const Surface surface = ocean.evaluate(12.0, {Channel::height, Channel::foam}, 1024);
//     const WorldPoint buoy{10.0, 20.0};
//     QuerySample sample;
//     ocean.query(12.0, {&buoy, 1}, {&sample, 1});
//     ocean.set("waves.0.wind_speed", "14");            // another sea
//     ocean.perform(12.5, "wind_speed", "18");          // a live parameter glides
//     const SeaState state = ocean.state();
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "ocean/detail.hpp"
#include "ocean/domain.hpp"
#include "ocean/ocean_options.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/query.hpp"
#include "ocean/sea.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/spray.hpp"
#include "ocean/surface.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

class DirectionalSpectrum;
struct Modes;
class Coast;
class HullSea;
class OpenSea;
class PlacedSea;
class RegionSurf;
class SprayFollower;

/// Computes everything of one sea.
class Ocean {
  public:
    /// Validates the sea. Computes nothing yet. Throws Error.
    explicit Ocean(Sea sea, OceanOptions options = {});
    explicit Ocean(Parameters parameters, OceanOptions options = {});
    /// Makes the same sea for another thread. Shares what `built` has computed.
    Ocean(const Ocean& built, OceanOptions options);
    ~Ocean();

    const Sea& sea() const;
    const Parameters& parameters() const;
    /// Returns true for an open sea without hulls: its maps of one period show all of it.
    bool repeats() const;
    /// Returns a number that changes whenever the sea changes.
    std::uint64_t revision() const;
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
    const DirectionalSpectrum& spectrum() { return spectrum(parameters().time.start); }
    /// Returns the modes at a time [s]. Valid until the next call that computes.
    const Modes& modes(double time);
    /// Returns the modes at the start.
    const Modes& modes() { return modes(parameters().time.start); }
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
    /// Returns a map over a domain that does not wrap, of a sea over a bed or with hulls: sample
    /// (i, j) is that of the label domain.place(i, j). Over a bed it may have the masks depth,
    /// breaking and wetness (land_mask.hpp) beside the channels of the table. Foam is followed as
    /// for evaluate(); that of hulls is the open sea's and where waves break now. The first call
    /// computes where the waves go over the bed, which takes seconds: see
    /// OceanOptions::build_progress. Throws Error unsupported for a sea without a bed and hulls,
    /// invalid_value for a domain that wraps or has other than 2 .. kMaxRegionSide samples along a
    /// side, and out_of_memory.
    Surface region(double time, const Domain& domain, ChannelSet channels);
    /// Writes a region into a host's buffers of domain.samples[0] samples in a row. The outputs may
    /// hold channels alone. Throws as region().
    void region_into(double time, const Domain& domain, std::span<const MapOutput> outputs);
    /// Returns the samples of the wake of hull `hull` at a time: a square that moves with the hull
    /// by whole samples. Throws Error invalid_value if the sea has no such hull.
    Domain wake_domain(std::size_t hull, double time) const;
    /// Writes that wake without the open sea, by label: a region of the sea is the sum of both in
    /// each channel that adds up. It is 0 beyond its square. Throws as wake_domain() and region(),
    /// and unsupported for foam and masks.
    void wake_into(std::size_t hull, double time, const Domain& domain,
                   std::span<const MapOutput> outputs);
    /// Adds that wake to the fields of the open sea in a host's buffers, which are sums then; that
    /// of its jacobian, and normals, to first order. Each normal must be whole in one output.
    /// Throws as wake_into(), and unsupported for a part of a normal.
    void add_wake(std::size_t hull, double time, const Domain& domain,
                  std::span<const MapOutput> outputs);
    /// Computes now what the first region or query of a sea that does not repeat would compute.
    /// Throws as region().
    void prepare_coast();
    /// Returns the exponent p of cover = foam^p on a map of `resolution` samples (see
    /// foam_layer.hpp), for hosts that compute cover from foam themselves. Takes some tenths of a
    /// second after a change of waves or wind.
    double cover_power(double time, int resolution = 0);
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
    /// within the lifetime, a later one only for new ticks: the bits are the same. region: a part
    /// of a sea with hulls, whose wakes throw spray too; without it the spray is that of one period
    /// of the open sea. Over a bed it is always that of the whole bed. Throws Error invalid_value
    /// for settings out of range, unsupported for a region of a sea that repeats, and
    /// out_of_memory.
    std::vector<SprayParticle> spray(double time, const SpraySettings& settings = {},
                                     const std::optional<Domain>& region = {});
    /// Returns the mist of that spray: a puff for each particle born within the lifetime, including
    /// those that have ended since. Costs as much as spray().
    std::vector<MistPuff> mist(double time, const SpraySettings& settings = {},
                               const std::optional<Domain>& region = {});
    /// Returns the ticks of the foam's clock until foam that began empty equals settled foam, for
    /// the map that needs the longest.
    std::int64_t foam_settling_ticks() const;

    /// Measures on a map of at most 1024 samples along a side and scales to the default map. Blocks
    /// for a moment.
    FrameCost measure_frame_cost();

    const StageRuns& stage_runs() const;
    /// Returns the pool, for other work of the caller; not during a call of this object.
    ThreadPool& pool();

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

    /// Returns the sea as if it had no bed and no hulls: the water around a coast, for hosts that
    /// show both.
    OpenSea& open_sea() { return *open_; }

  private:
    friend class RegionSurf;

    bool has_bed() const;
    /// Returns the open sea. Throws Error unsupported for a sea over a bed, which `what` does not
    /// know.
    OpenSea& without_bed(std::string_view what);
    /// Returns the sea that does not repeat; nullptr: the open sea is all.
    PlacedSea* placed() const;
    /// Throws Error invalid_value unless the sea has that hull.
    void require_hull(std::size_t hull) const;
    /// Returns the sea that has regions. Throws Error unsupported for a sea that repeats.
    PlacedSea& region_sea() const;
    const SprayFollower& spray_at(double time, const SpraySettings& settings,
                                  const std::optional<Domain>& region);

    std::unique_ptr<OpenSea> open_;
    std::unique_ptr<Coast> coast_;    // of the open sea; used while it has a bed
    std::unique_ptr<HullSea> hulls_;  // the same; used while it has hulls
};

}  // namespace ocean
