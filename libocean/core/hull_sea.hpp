// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sea of an Ocean with hulls: the open sea and the wakes, which add up at labels. Regions and
// answers at points come from that one surface.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "hulls/hull_surface.hpp"
#include "ocean/internal/revision.hpp"
#include "ocean/land_mask.hpp"
#include "placed_sea.hpp"

namespace ocean {

/// The sea must have hulls while its functions are called.
class HullSea final : public PlacedSea {
  public:
    using PlacedSea::PlacedSea;

    void drop(const OpenSea::Ended& ended) override;
    void prepare() override;
    void describe(SeaState& state) override;

    /// Returns the spray of a region's waves and wakes, or of the open sea, which knows no wake.
    const SprayFollower& spray(double time, const SpraySettings& settings,
                               const std::optional<Domain>& region) override;

    Domain wake_domain(std::size_t hull, double time) const;
    /// adds: does as Ocean::add_wake().
    void wake_into(std::size_t hull, double time, const Domain& domain,
                   std::span<const MapOutput> outputs, bool adds);

    void query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions& options) override;
    void water_motion(double time, std::span<const WaterPoint> points,
                      std::span<WaterMotion> motions, const QueryOptions& options) override;

    /// Returns the surface at a time, for tests.
    const HullSurface& surface(double time) { return surface(time, true); }

  private:
    std::string_view name() const override { return "a sea with hulls"; }
    ChannelSet masks() const override { return kHullMasks; }
    std::string_view why_no_linear_fields() const override {
        return "with hulls it shows the displaced surface";
    }
    double height_error(double time) override;
    RegionMaps region_maps(ChannelSet channels) const override;
    void write_region(double time, const Domain& domain,
                      std::span<const MapOutput> outputs) override;
    HullSurface& surface(double time, bool rates);
    /// Returns the surface of the sea at a time, which has not begun there.
    HullSurface& still_surface(double time);
    /// Writes the foam of samples of a query. `found`: the surface at their labels.
    void add_foam(double time, std::span<QuerySample> samples, std::span<const LabelPoint> found);

    std::optional<HullSurface> surface_;
    // The sea from which surface_ was made:
    Revision modes_;
    std::vector<Hull> hulls_;
    Water water_;
    double choppiness_ = 0.0;
    double loop_period_ = 0.0;
};

}  // namespace ocean
