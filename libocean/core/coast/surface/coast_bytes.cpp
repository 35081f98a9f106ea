// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The memory of a coast, known before it is allocated.
#include "coast/statics/shore_statics.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/query.hpp"
#include "ocean/sea_bed.hpp"

namespace ocean {

std::uint64_t coast_bytes(const Parameters& parameters) {
    const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
    const ShoreBands bands = choose_bands(spectrum, parameters);
    // The splines of the open sea and of its waves in no band.
    const std::uint64_t splines =
        2 * SurfaceQuery::map_bytes(default_map_resolution(parameters.grid), {.refine = 1});
    return shore_statics_bytes(parameters.water.bed->domain, bands.waves.size()) + splines +
           modes_bytes(parameters.grid);
}

std::uint64_t region_work_bytes(const Parameters& parameters, const Domain& domain,
                                ChannelSet channels) {
    const std::uint64_t followed =
        domain.count() * (kFoamMaps * sizeof(float) + sizeof(WorldPoint));
    const std::uint64_t wet = channels.contains(channel_of(LandMask::wetness)) ? followed : 0;
    if (!channels.intersects({Channel::foam, Channel::cover})) return wet;
    const int shown = default_map_resolution(parameters.grid);
    return wet + followed + maps_bytes(shown, kFoamMaps + 2);
}

}  // namespace ocean
