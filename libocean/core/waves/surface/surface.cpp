// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The maps of one time that users see. Last stage of the pipeline.
#include "ocean/surface.hpp"

#include "ocean/error.hpp"
#include "ocean/foam.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/kernel/cpu_backend.hpp"
#include "waves/surface/map_writer.hpp"
#include "waves/surface/plane_channels.hpp"

namespace ocean {

Surface::Surface(const Domain& domain, double time, ChannelSet channels)
    : domain_(domain), time_(time), channels_(channels) {
    for (std::size_t c = 0; c < maps_.size(); ++c) {
        if (has(static_cast<Channel>(c))) maps_[c].resize(domain.count());
    }
}

std::span<const float> Surface::channel(Channel channel) const {
    if (!has(channel)) return {};
    return maps_[static_cast<std::size_t>(channel)];
}

std::span<float> Surface::channel(Channel channel) {
    if (!has(channel)) return {};
    return maps_[static_cast<std::size_t>(channel)];
}

void copy_channels(const Surface& map, std::span<const MapOutput> outputs, ThreadPool& pool) {
    const int columns = map.domain().samples[0];
    const auto width = static_cast<std::size_t>(columns);
    pool.for_each_range(map.domain().samples[1], [&](int first, int last) {
        for (const MapOutput& output : outputs) {
            const auto used = output.used();
            for (std::size_t c = 0; c < used.size(); ++c) {
                if (!used[c].quantity.is_channel()) continue;
                const std::span<const float> from = map.channel(used[c].quantity.channel());
                for (int j = first; j < last; ++j) {
                    const auto row = static_cast<std::size_t>(j);
                    float* to = output.data + row * output.pitch(columns) + c;
                    for (std::size_t i = 0; i < width; ++i, to += used.size()) {
                        *to = used[c].factor * from[row * width + i];
                    }
                }
            }
        }
    });
}

std::vector<MapOutput> outputs_of(Surface& surface) {
    std::vector<MapOutput> outputs;
    for (int c = 0; c < kChannelNumbers; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (!surface.has(channel)) continue;
        outputs.push_back({surface.channel(channel).data(), 1, {{{channel, 1.0f}}}});
    }
    return outputs;
}

SurfaceSettings with_threshold(const SurfaceSettings& settings, const Modes& modes,
                               int resolution) {
    SurfaceSettings result = settings;
    result.foam_threshold =
        whitecap_threshold(modes.gradient_covariance(resolution), settings, modes.wind_speed);
    result.foam_coverage = FoamCoverage::threshold;
    return result;
}

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
