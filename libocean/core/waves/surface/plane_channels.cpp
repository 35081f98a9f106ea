// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From planes of linear fields to channels by the formulas of the table, a sample at a time. For
// the backends that are written to be read, and for channels without code in any backend.
#include "waves/surface/plane_channels.hpp"

#include <limits>

#include "ocean/thread_pool.hpp"

namespace ocean {

namespace {

/// One component of one output.
template <typename Real>
class ComponentWriter {
  public:
    ComponentWriter(const LinearPlanes<Real>& planes, const MapRequest& request,
                    const MapOutput& output, std::size_t component, ThreadPool& pool)
        : planes_(planes),
          request_(request),
          data_(output.data + component),
          stride_(static_cast<std::size_t>(output.components)),
          row_pitch_(output.pitch(request.modes.resolution)),
          factor_(output.component[component].factor),
          pool_(pool) {}

    void multiple(Linear field, Real times) const {
        const PageVector<Real>& plane = planes_[field];
        write([&](std::size_t i) { return times * plane[i]; });
    }

    void formula(const ChannelInfo& info) const {
        const LinearSet fields = request_.settings.choppiness == 0.0 ? info.flat : info.choppy;
        const SurfacePoint<Real> still = still_point(info);
        const FoamLayer& foam = request_.foam;
        const bool has_past = ocean::has_past(info.foam) && foam.map != nullptr;
        write([&](std::size_t i) {
            SurfacePoint<Real> point = still;
            for (const Linear field : kLinears) {
                if (!fields.contains(field)) continue;
                point.field[static_cast<std::size_t>(field)] = planes_[field][i];
            }
            if (has_past) point.previous_foam = foam.fade * foam.map[i];
            return info.formula(point);
        });
    }

  private:
    /// Returns the members that all samples share.
    SurfacePoint<Real> still_point(const ChannelInfo& info) const {
        const SurfaceSettings& settings = request_.settings;
        constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
        SurfacePoint<Real> point;
        for (const Linear field : kLinears) {
            point.field[static_cast<std::size_t>(field)] =
                info.choppy.contains(field) ? Real(0) : Real(kNone);
        }
        const bool has_threshold = info.foam != FoamUse::none;
        const bool has_past = ocean::has_past(info.foam);
        point.choppiness = static_cast<Real>(settings.choppiness);
        point.foam_threshold = has_threshold ? static_cast<Real>(settings.foam_threshold) : kNone;
        point.foam_width = has_threshold ? static_cast<Real>(settings.foam_width) : kNone;
        point.previous_foam = has_past ? 0.0f : kNone;
        point.foam_alone = has_past ? request_.foam.alone : kNone;
        point.foam_cutoff = has_past ? request_.foam.cutoff : kNone;
        point.cover_power = info.foam == FoamUse::cover ? request_.foam.cover_power : kNone;
        return point;
    }

    template <typename Value>
    void write(const Value& value) const {
        const auto width = static_cast<std::size_t>(request_.modes.resolution);
        const auto row = [&](int j) {
            const std::size_t first = static_cast<std::size_t>(j) * width;
            float* const line = data_ + static_cast<std::size_t>(j) * row_pitch_;
            for (std::size_t i = 0; i < width; ++i) {
                line[i * stride_] = factor_ * static_cast<float>(value(first + i));
            }
        };
        pool_.for_each_item(request_.modes.resolution, [&row](int j, int) { row(j); });
    }

    const LinearPlanes<Real>& planes_;
    const MapRequest& request_;
    float* data_;
    std::size_t stride_;
    std::size_t row_pitch_;
    float factor_;
    ThreadPool& pool_;
};

}  // namespace

template <typename Real>
void write_channels(const LinearPlanes<Real>& planes, const MapRequest& request,
                    std::span<const ChannelInfo> host_channels, ThreadPool& pool) {
    const Real choppiness = static_cast<Real>(request.settings.choppiness);
    for (const MapOutput& output : request.outputs) {
        for (std::size_t c = 0; c < output.used().size(); ++c) {
            const Quantity quantity = output.component[c].quantity;
            const ComponentWriter<Real> write(planes, request, output, c, pool);
            if (quantity.is_linear()) {
                write.multiple(quantity.linear(), Real(1));
            } else if (quantity.is_channel()) {
                const ChannelInfo& info = channel_info(quantity.channel(), host_channels);
                if (info.is_multiple()) {
                    write.multiple(info.field, info.times(choppiness));
                } else {
                    write.formula(info);
                }
            }
        }
    }
}

template void write_channels(const LinearPlanes<float>&, const MapRequest&,
                             std::span<const ChannelInfo>, ThreadPool&);
template void write_channels(const LinearPlanes<double>&, const MapRequest&,
                             std::span<const ChannelInfo>, ThreadPool&);

}  // namespace ocean
