// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A backend at work; see map_writer.hpp. Channels without code in the backend are computed from the
// linear fields that it writes.
#include "waves/surface/map_writer.hpp"

#include "ocean/internal/map_request.hpp"
#include "waves/surface/plane_channels.hpp"

namespace ocean {

MapWriter::MapWriter(const Backend& backend, std::span<const ChannelInfo> host_channels)
    : backend_(backend), host_channels_(host_channels), maps_(backend.start()) {}

MapWriter::MapWriter(const MapWriter& other, std::span<const ChannelInfo> host_channels)
    : backend_(other.backend_), host_channels_(host_channels), maps_(other.maps_) {}

namespace {

/// Appends the outputs, with only those components that hold `channels`.
void append_with(ChannelSet channels, bool fields, std::span<const MapOutput> outputs,
                 std::vector<MapOutput>& to) {
    for (MapOutput output : outputs) {
        bool any = false;
        for (auto& [quantity, factor] : output.used()) {
            const bool wanted = quantity.is_channel() ? channels.contains(quantity.channel())
                                                      : quantity.is_linear() && fields;
            if (!wanted) quantity = {};
            any = any || wanted;
        }
        if (any) to.push_back(output);
    }
}

/// Copies the first samples to the seam, one period further.
void close_seam(const MapOutput& output, int resolution) {
    const auto rows = static_cast<std::size_t>(resolution);
    const auto components = static_cast<std::size_t>(output.components);
    const std::size_t pitch = output.pitch(resolution);
    const std::size_t width = output.width(resolution);
    for (std::size_t c = 0; c < components; ++c) {
        if (output.component[c].quantity == Quantity{}) continue;
        float* const first = output.data + c;
        for (std::size_t j = 0; j < rows; ++j) {
            first[j * pitch + width - components] = first[j * pitch];
        }
        for (std::size_t i = 0; i < width; i += components) first[rows * pitch + i] = first[i];
    }
}

}  // namespace

bool MapWriter::write(const MapRequest& request, ThreadPool& pool) {
    const bool packed = write_samples(request, pool);
    for (const MapOutput& output : request.outputs) {
        if (output.seam) close_seam(output, request.modes.resolution);
    }
    return packed;
}

bool MapWriter::write_samples(const MapRequest& request, ThreadPool& pool) {
    const ChannelSet asked = channels_of(request.outputs);
    require_channels(asked, host_channels_);
    const ChannelSet others = asked.without(backend_.makes);
    if (others.empty()) return maps_(request, pool);

    outputs_.clear();
    append_with(backend_.makes, true, request.outputs, outputs_);
    const LinearSet fields = fields_of(others, request.settings.choppiness == 0.0, host_channels_);
    const std::size_t samples = Lattice{request.modes.resolution, 1.0}.size();
    for (const Linear field : kLinears) {
        if (!fields.contains(field)) continue;
        planes_[field].resize(samples);
        outputs_.push_back({planes_[field].data(), 1, {{{field, 1.0f}}}});
    }
    MapRequest part = request;
    part.outputs = outputs_;
    const bool packed = maps_(part, pool);

    outputs_.clear();
    append_with(others, false, request.outputs, outputs_);
    part.outputs = outputs_;
    write_channels(planes_, part, host_channels_, pool);
    return packed;
}

}  // namespace ocean
