// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A backend at work; see map_writer.hpp. Channels without code in the backend are computed from the
// linear fields that it writes.
#include "waves/surface/map_writer.hpp"

#include <algorithm>

#include "ocean/thread_pool.hpp"
#include "waves/kernel/map_kernel.hpp"
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

namespace {

/// Returns the fields of bound waves that the outputs read.
LinearSet bound_fields(const MapRequest& request, std::span<const ChannelInfo> host_channels) {
    if (request.modes.binding_limit == 0.0) return {};
    const LinearSet read =
        fields_of(request.outputs) |
        fields_of(channels_of(request.outputs), request.settings.choppiness == 0.0, host_channels);
    LinearSet bound;
    for (const Linear field : kLinears) {
        if (read.contains(field) && kBoundFields.contains(field)) bound = bound | field;
    }
    return bound;
}

/// Returns those of the channels whose formulas read one of the fields.
ChannelSet formulas_of(LinearSet fields, ChannelSet channels,
                       std::span<const ChannelInfo> host_channels) {
    ChannelSet formulas;
    for (int c = 0; c < kMaxChannels; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (!channels.contains(channel)) continue;
        const ChannelInfo& info = channel_info(channel, host_channels);
        if (!info.is_multiple() && info.choppy.intersects(fields)) formulas = formulas | channel;
    }
    return formulas;
}

/// Returns the factor of a quantity that is a multiple of the field; 0 for any other quantity.
float factor_of(Linear field, Quantity quantity, const SurfaceSettings& settings,
                std::span<const ChannelInfo> host_channels) {
    if (quantity.is_linear()) return quantity.linear() == field ? 1.0f : 0.0f;
    if (!quantity.is_channel()) return 0.0f;
    const ChannelInfo& info = channel_info(quantity.channel(), host_channels);
    if (!info.is_multiple() || info.field != field) return 0.0f;
    return info.times(static_cast<float>(settings.choppiness));
}

/// Adds a plane to one component of an output.
void add_plane(const PageVector<float>& plane, float factor, std::size_t component,
               const MapOutput& output, int resolution, ThreadPool& pool) {
    const auto width = static_cast<std::size_t>(resolution);
    const auto stride = static_cast<std::size_t>(output.components);
    const std::size_t pitch = output.pitch(resolution);
    pool.for_each_item(resolution, [&](int j, int) {
        const float* const from = plane.data() + static_cast<std::size_t>(j) * width;
        float* const to = output.data + static_cast<std::size_t>(j) * pitch + component;
        for (std::size_t i = 0; i < width; ++i) to[i * stride] += factor * from[i];
    });
}

}  // namespace

void MapWriter::add_bound_waves(const MapRequest& request, LinearSet fields, LinearSet planes,
                                ThreadPool& pool) {
    if (!bound_) bound_.emplace(backend_);
    bound_->make(request, fields, pool);
    const int resolution = request.modes.resolution;
    for (const Linear field : kLinears) {
        if (!fields.contains(field)) continue;
        const PageVector<float>& bound = bound_->planes()[field];
        if (planes.contains(field)) {
            const MapOutput plane{planes_[field].data(), 1, {}};
            add_plane(bound, 1.0f, 0, plane, resolution, pool);
        }
        for (const MapOutput& output : request.outputs) {
            for (std::size_t c = 0; c < output.used().size(); ++c) {
                const float factor = factor_of(field, output.component[c].quantity,
                                               request.settings, host_channels_) *
                                     output.component[c].factor;
                if (factor != 0.0f) add_plane(bound, factor, c, output, resolution, pool);
            }
        }
    }
}

void MapWriter::write_by_kernel(ChannelSet channels, const MapRequest& request, ThreadPool& pool) {
    outputs_.clear();
    append_with(channels, false, request.outputs, outputs_);
    const int resolution = request.modes.resolution;
    PlanarFields fields;
    fields.row_stride = static_cast<std::size_t>(resolution);
    for (const Linear field : kLinears) {
        fields.plane[static_cast<std::size_t>(field)] = planes_[field].data();
    }
    for (std::size_t i = 0; i < outputs_.size(); i += kMaxOutputs) {
        const auto some =
            std::span(outputs_).subspan(i, std::min(outputs_.size() - i, std::size_t{kMaxOutputs}));
        const KernelFrame frame{request.modes.tau, request.settings, some, request.foam};
        pool.for_each_range(resolution, [&](int first, int last) {
            write_rows(fields, resolution, first, last, frame);
        });
    }
}

bool MapWriter::write(const MapRequest& request, ThreadPool& pool) {
    const bool packed = write_samples(request, pool);
    for (const MapOutput& output : request.outputs) {
        if (output.seam) close_seam(output, request.modes.resolution);
    }
    return packed;
}

bool MapWriter::keeps_in_one_run(const MapRequest& request) const {
    // Formulas of the table and of a host write their own channel alone.
    const ChannelSet by_formula = channels_of(request.outputs).without(backend_.makes);
    return backend_.keeps_foam && !has_past(foam_use(by_formula, host_channels_));
}

bool MapWriter::write_after_tick(const MapRequest& request, ThreadPool& pool) {
    const MapOutput foam{request.foam.kept, 1, {{{Channel::foam, 1.0f}}}};
    MapRequest tick = request;
    tick.outputs = {&foam, 1};
    tick.foam.kept = nullptr;
    const bool packed = write_samples(tick, pool);
    MapRequest map = request;
    map.foam.map = request.foam.kept;
    map.foam.fade = 1.0f;
    map.foam.cutoff = 0.0f;
    map.foam.kept = nullptr;
    return write_samples(map, pool) || packed;
}

bool MapWriter::write_samples(const MapRequest& request, ThreadPool& pool) {
    const ChannelSet asked = channels_of(request.outputs);
    require_channels(asked, host_channels_);
    if (request.foam.kept != nullptr && !keeps_in_one_run(request)) {
        return write_after_tick(request, pool);
    }
    const LinearSet bound = bound_fields(request, host_channels_);
    const ChannelSet moved = formulas_of(bound, asked, host_channels_);
    const ChannelSet others = asked.without(backend_.makes) | moved;
    if (others.empty() && bound.empty()) return maps_(request, pool);

    outputs_.clear();
    append_with(asked.without(others), true, request.outputs, outputs_);
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
    if (!bound.empty()) add_bound_waves(request, bound, fields, pool);

    const ChannelSet quick = moved.without(moved.without(kKernelFormulas));
    write_by_kernel(quick, request, pool);
    outputs_.clear();
    append_with(others.without(quick), false, request.outputs, outputs_);
    part.outputs = outputs_;
    write_channels(planes_, part, host_channels_, pool);
    return packed;
}

}  // namespace ocean
