// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea that does not repeat: a coast, or a sea with hulls. Its maps are regions.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "ocean/domain.hpp"
#include "ocean/internal/open_sea.hpp"
#include "ocean/query.hpp"
#include "ocean/surface.hpp"

namespace ocean {

inline constexpr ChannelSet kFoamChannels = {Channel::foam, Channel::cover};

/// Functions without a comment do as those of Ocean.
class PlacedSea {
  public:
    /// Keeps a reference to the sea around it.
    explicit PlacedSea(OpenSea& open) : open_(open) {}
    virtual ~PlacedSea() = default;
    PlacedSea(const PlacedSea&) = delete;
    PlacedSea& operator=(const PlacedSea&) = delete;

    /// Drops what a change of the sea has ended.
    virtual void drop(const OpenSea::Ended& ended) = 0;
    /// Computes what the first region or query would compute.
    virtual void prepare() = 0;
    /// Adds what is its own to the state of the open sea.
    virtual void describe(SeaState&) {}

    Surface region(double time, const Domain& domain, ChannelSet channels);
    void region_into(double time, const Domain& domain, std::span<const MapOutput> outputs);
    virtual const SprayFollower& spray(double time, const SpraySettings& settings,
                                       const std::optional<Domain>& region) = 0;

    virtual void query(double time, std::span<const WorldPoint> points,
                       std::span<QuerySample> samples, const QueryOptions& options) = 0;
    double query_height_error(double time, const QueryOptions& options);
    virtual void water_motion(double time, std::span<const WaterPoint> points,
                              std::span<WaterMotion> motions, const QueryOptions& options) = 0;
    void float_poses(double time, std::span<const FloatBody> bodies, std::span<FloatPose> poses);

  protected:
    OpenSea& open() { return open_; }
    const Parameters& parameters() const { return open_.parameters(); }
    /// Returns the samples of the open sea's map whose waves count.
    int shown() const;
    /// Returns the rms error of heights [m] that are not exact.
    virtual double height_error(double time) = 0;
    /// Returns channels of the open sea over one period.
    Surface open_map(double time, ChannelSet channels);

    /// Returns the maps beside the region's own that its channels need, and whether they keep the
    /// region's labels too.
    struct RegionMaps {
        std::size_t maps = 0;
        bool labels = false;
    };
    virtual RegionMaps region_maps(ChannelSet channels) const = 0;
    virtual std::string_view why_no_linear_fields() const = 0;
    /// Returns the masks that a region has.
    virtual ChannelSet masks() const = 0;
    /// Returns "a sea with hulls".
    virtual std::string_view name() const = 0;
    /// Writes a region that has been checked.
    virtual void write_region(double time, const Domain& domain,
                              std::span<const MapOutput> outputs) = 0;

  private:
    /// Throws as region() before a region is computed, unsupported for a mask that this sea has
    /// not, and out_of_memory if `new_maps` maps of its samples do not fit beside what it needs.
    void begin_region(double time, const Domain& domain, ChannelSet channels, std::size_t new_maps);

    void require_masks(ChannelSet channels) const;

    OpenSea& open_;
};

}  // namespace ocean
