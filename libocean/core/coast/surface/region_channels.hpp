// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The channels of a region of a sea over its bed, from its surface and its foam.
#pragma once

#include <cstddef>
#include <span>

#include "coast/surface/shore_surface.hpp"
#include "ocean/backend.hpp"
#include "ocean/internal/foam_layer.hpp"
#include "ocean/query.hpp"
#include "ocean/sea_bed.hpp"
#include "ocean/surface.hpp"
#include "waves/labels/region_rows.hpp"

namespace ocean {

/// The foam over a region: the open sea's foam, by label over one period, and the faded earlier
/// foam of breaking waves at the labels of the region.
struct RegionFoamMaps {
    FoamLayer surf;
    Surface open;

    /// Returns the foam at the label with that index. `breaking` and `in_surf` come from the
    /// label's ShorePoint.
    float foam(WorldPoint label, std::size_t index, float breaking, float in_surf) const;
    /// Returns the share of the water that the foam hides.
    float cover(WorldPoint label, std::size_t index, float breaking, float in_surf) const;

  private:
    float surf_alone(std::size_t index, float breaking) const;
};

/// Returns the parts of the surface that the channels of a region need.
JetParts region_parts(ChannelSet channels);

/// Ends the whitecaps of a region where the swash begins: its tips are foam that no wind tears off.
void leave_out_swash(const SeaBed& bed, Surface& map);

class RegionChannels {
  public:
    /// Prepares maps of these channels. `wet`: the faded earlier wetness of the ground. Keeps
    /// references to the other arguments.
    RegionChannels(const ShoreSurface& surface, ChannelSet channels,
                   const SurfaceSettings& settings, const RegionFoamMaps& foam,
                   const FoamLayer& wet, const SeaBed& bed)
        : surface_(surface),
          channels_(channels),
          parts_(region_parts(channels)),
          settings_(settings),
          foam_(foam),
          wet_(wet),
          bed_(bed) {}

    /// Writes the outputs of a region, which hold channels alone, on all threads. `sum_waves` sums
    /// the waves; if it is empty, the processor sums them.
    void write(const CoastFunction& sum_waves, const Domain& domain,
               std::span<const MapOutput> outputs, ThreadPool& pool) const;

  private:
    using Piece = RegionPiece<ShorePoint>;

    /// Writes row j. `ready`: the sums at its labels.
    void write_row(const Domain& domain, int j, ReadySums ready,
                   std::span<const MapOutput> outputs) const;
    /// Writes a channel that does not follow from height and offsets alone.
    void write_own(const Piece& piece, const RegionTarget& target) const;

    const ShoreSurface& surface_;
    ChannelSet channels_;
    JetParts parts_;
    const SurfaceSettings& settings_;
    const RegionFoamMaps& foam_;
    const FoamLayer& wet_;
    const SeaBed& bed_;
};

}  // namespace ocean
