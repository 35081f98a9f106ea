// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The coast of an Ocean: an open sea over its bed. Regions and answers at points come from the one
// surface over the bed; foam of breaking waves is followed at labels, as the open sea's is on its
// lattices. A sea over a bed has no take, so that its waves are those of one sea state.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "coast/surface/coast_chain.hpp"
#include "coast/surface/shore_motion.hpp"
#include "coast/surface/surf_reader.hpp"
#include "ocean/land_mask.hpp"
#include "placed_sea.hpp"

namespace ocean {

/// The sea must have a bed while its functions are called.
class Coast final : public PlacedSea {
  public:
    using PlacedSea::PlacedSea;
    /// Makes the same coast for another thread, of the same sea. Shares its statics.
    Coast(const Coast& built, OpenSea& open) : PlacedSea(open), chain_(built.chain_) {}

    void drop(const OpenSea::Ended& ended) override;
    void prepare() override;

    /// Returns the spray of the bed's domain, for any region.
    const SprayFollower& spray(double time, const SpraySettings& settings,
                               const std::optional<Domain>& region) override;

    /// Returns the labels of a reader that waves reach, at a time. Valid until its next read.
    const std::vector<SurfReader::Piece>& surf(double time, SurfReader& reader) {
        return reader.read(surface(time, ShoreSurface::Rates::without), open().pool());
    }

    void query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions& options) override;
    void water_motion(double time, std::span<const WaterPoint> points,
                      std::span<WaterMotion> motions, const QueryOptions& options) override;

  private:
    const SeaBed& bed() const { return *parameters().water.bed; }
    CoastSea sea_at(double time);
    /// Returns the surface over the bed at a time. Valid until the next call. cells: see
    /// ShoreSurface::move_to.
    ShoreSurface& surface(double time, ShoreSurface::Rates rates,
                          const SignalCells* cells = nullptr);
    CoastChain::Exact exact(double time);
    std::string_view name() const override { return "a sea over a bed"; }
    ChannelSet masks() const override { return kMasksOverBed; }
    std::string_view why_no_linear_fields() const override {
        return "over a bed waves do not add up";
    }
    double height_error(double time) override;
    RegionMaps region_maps(ChannelSet channels) const override;
    void write_region(double time, const Domain& domain,
                      std::span<const MapOutput> outputs) override;
    /// Returns the foam of breaking waves, or the wetness of the ground, at the reader's labels.
    FoamLayer surf_layer(SurfTrace trace, double time, SurfReader& reader, FoamState& state);
    /// Writes the foam of samples of a query. `found`: the surface at their labels.
    void add_foam(double time, std::span<QuerySample> samples, std::span<const ShorePoint> found);

    CoastChain chain_;
    ShoreMotion motion_;
    std::unique_ptr<RegionTraces> traces_;  // of the last region
};

}  // namespace ocean
