// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From modes to the maps of one time that users see. Last stage of the pipeline.
#include "ocean/make_surface.hpp"

#include "ocean/error.hpp"
#include "ocean/foam.hpp"
#include "ocean/map_request.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/kernel/cpu_backend.hpp"
#include "waves/surface/map_writer.hpp"
#include "waves/surface/plane_channels.hpp"

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

Surface combine_planes(const LinearPlanes<float>& planes, const Lattice& lattice, double time,
                       const SurfaceSettings& settings, ChannelSet channels, ThreadPool& pool) {
    require_channels(channels);
    Surface surface(lattice, time, channels);
    std::vector<MapOutput> fast, others;
    for (const MapOutput& output : outputs_of(surface)) {
        const bool has_code = kCpuChannels.contains(output.component[0].quantity.channel());
        (has_code ? fast : others).push_back(output);
    }
    PlanarFields fields{{}, static_cast<std::size_t>(lattice.resolution)};
    for (const Linear field : kLinears) {
        fields.plane[static_cast<std::size_t>(field)] = planes[field].data();
    }
    pool.for_each_range(lattice.resolution, [&](int first, int last) {
        write_rows(fields, lattice.resolution, first, last, {0.0, settings, fast, {}});
    });
    MapRequest request{{}, settings, others, {}};
    request.modes.resolution = lattice.resolution;
    write_channels(planes, request, {}, pool);
    return surface;
}

}  // namespace ocean
