// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From modes to the maps of one time that users see. This is the last stage of the pipeline.
#include "ocean/internal/make_surface.hpp"

#include "ocean/error.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/surface/map_writer.hpp"

namespace ocean {

Surface make_surface(const Modes& modes, const SurfaceSettings& settings, double time,
                     ChannelSet channels, const Backend& backend, ThreadPool& pool,
                     int resolution) {
    require_time(time);
    if (resolution == 0) resolution = modes.lattice.resolution;
    require_resolution(resolution);
    require_channels(channels);
    const FoamUse foam = foam_use(channels);
    if (has_past(foam)) {
        throw Error(ErrorKind::invalid_value,
                    "foam depends on earlier times: make it by Ocean or FoamState");
    }
    Surface surface(Lattice{resolution, modes.lattice.period}, time, channels);
    const std::vector<MapOutput> outputs = outputs_of(surface);
    MapWriter(backend).write(
        {map_modes(modes, time, resolution),
         foam == FoamUse::threshold ? with_threshold(settings, modes, resolution) : settings,
         outputs,
         {}},
        pool);
    return surface;
}

}  // namespace ocean
