// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The coast of an Ocean: an open sea over its bed. Regions and answers at points come from the one
// surface over the bed; foam of breaking waves is followed at labels, as the open sea's is on its
// lattices. A sea over a bed has no take, so that its waves are those of one sea state.
#pragma once

#include <memory>
#include <span>

#include "coast/surface/coast_chain.hpp"
#include "coast/surface/shore_motion.hpp"
#include "coast/surface/surf_reader.hpp"
#include "ocean/domain.hpp"
#include "ocean/internal/open_sea.hpp"

namespace ocean {

/// Functions without a comment do as those of Ocean. The sea must have a bed while they are called.
class Coast {
  public:
    /// Keeps a reference to the sea around it.
    explicit Coast(OpenSea& open) : open_(open) {}
    /// Makes the same coast for another thread, of the same sea. Shares its statics.
    Coast(const Coast& built, OpenSea& open) : open_(open), chain_(built.chain_) {}

    /// Drops what a change of the sea has ended.
    void drop(const OpenSea::Ended& ended);
    void prepare();

    Surface region(double time, const Domain& domain, ChannelSet channels);
    void region_into(double time, const Domain& domain, std::span<const MapOutput> outputs);
    /// Returns the spray of the bed's domain.
    const SprayFollower& spray(double time, const SpraySettings& settings);

    void query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions& options);
    double query_height_error(double time, const QueryOptions& options);
    void water_motion(double time, std::span<const WaterPoint> points,
                      std::span<WaterMotion> motions, const QueryOptions& options);
    void float_poses(double time, std::span<const FloatBody> bodies, std::span<FloatPose> poses);

  private:
    const SeaBed& bed() const { return *open_.parameters().water.bed; }
    int shown() const { return default_map_resolution(open_.parameters().grid); }
    CoastSea sea_at(double time);
    /// Returns the surface over the bed at a time. Valid until the next call.
    ShoreSurface& surface(double time, ShoreSurface::Rates rates);
    CoastChain::Exact exact(double time);
    /// Throws as region() before a region is computed, and out_of_memory if `new_maps` maps of its
    /// samples do not fit beside its foam.
    void begin_region(double time, const Domain& domain, ChannelSet channels, std::size_t new_maps);
    void write_region(double time, const Domain& domain, std::span<const MapOutput> outputs);
    /// Returns the foam of breaking waves, or the wetness of the ground, at the reader's labels.
    FoamLayer surf_layer(SurfTrace trace, double time, SurfReader& reader, FoamState& state);
    /// Returns the open sea's part of foam and cover over one period.
    Surface open_foam(double time, ChannelSet channels);
    /// Writes the foam of samples of a query. `found`: the surface at their labels.
    void add_foam(double time, std::span<QuerySample> samples, std::span<const ShorePoint> found);

    OpenSea& open_;
    CoastChain chain_;
    ShoreMotion motion_;
    std::unique_ptr<RegionTraces> traces_;  // of the last region
};

}  // namespace ocean
