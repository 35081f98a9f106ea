// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A land as a function of the place; see land_function.hpp. Maps are written row by row, each row
// from the places of its samples alone.
#include "ocean/land_function.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "land/function/land_function_parts.hpp"
#include "land/function/land_row.hpp"
#include "ocean/error.hpp"

namespace ocean {
namespace {

/// Returns a step without its last 12 bits. Steps are sizes divided by counts; regions of the same
/// cell have steps that differ in these bits.
double rounded_step(double step) {
    constexpr std::uint64_t kLastBits = (std::uint64_t{1} << 12) - 1;
    const auto bits = std::bit_cast<std::uint64_t>(step) + (kLastBits + 1) / 2;
    return std::bit_cast<double>(bits & ~kLastBits);
}

/// Returns coordinate i of an axis: a whole number of steps from 0 or from the region's origin, so
/// that a place has the same bits in every region.
class Steps {
  public:
    Steps(const Domain& region, std::size_t axis)
        : origin_(region.origin[axis]), step_(rounded_step(region.step(axis))) {
        const double first = origin_ / step_;
        constexpr double kRounding = 1e-7;
        if (std::abs(first - std::round(first)) > kRounding || std::abs(first) > 1e15) return;
        first_ = std::round(first);
        origin_ = 0.0;
    }
    double at(int i) const { return origin_ + (first_ + i) * step_; }
    double step() const { return step_; }

  private:
    double origin_, step_;
    double first_ = 0.0;
};

}  // namespace

struct LandFunction::Impl {
    explicit Impl(LandFunctionParts its) : parts(std::move(its)) {
        for (const auto& [mask, grid] : parts.masks) channels = channels | channel_of(mask);
        if (!parts.gullies) return;
        for (const LandMask mask : kGullyMasks) channels = channels | channel_of(mask);
    }

    LandFunctionParts parts;
    ChannelSet channels = kTerrainChannels;
};

namespace {

/// Returns the channel of a quantity; masks and linear fields included.
Channel channel_of_quantity(Quantity quantity) {
    if (quantity.is_channel()) return quantity.channel();
    switch (quantity.linear()) {
        case Linear::height:
            return Channel::height;
        case Linear::slope_x:
            return Channel::slope_x;
        case Linear::slope_y:
            return Channel::slope_y;
        default:
            return static_cast<Channel>(kChannelNumbers);
    }
}

}  // namespace

LandFunction::LandFunction(LandFunctionParts parts)
    : impl_(std::make_unique<Impl>(std::move(parts))) {}
LandFunction::~LandFunction() = default;
LandFunction::LandFunction(LandFunction&&) noexcept = default;

const Domain& LandFunction::domain() const {
    return impl_->parts.domain;
}

double LandFunction::cell() const {
    return std::max(domain().step(0), domain().step(1));
}

ChannelSet LandFunction::channels() const {
    return impl_->channels;
}

namespace {

/// The three rows that a row's slopes need, and the writer of its outputs.
class RowWriter {
  public:
    RowWriter(const Domain& region, std::span<const MapOutput> outputs,
              const LandFunctionParts& parts, ChannelSet wanted)
        : region_(region),
          outputs_(outputs),
          parts_(parts),
          by_difference_(parts.gullies.has_value() && wanted.intersects(kSlopes)),
          margin_(by_difference_ ? 1 : 0),
          x_(region, 0),
          y_(region, 1) {}

    bool by_difference() const { return by_difference_; }
    const Domain& region() const { return region_; }

    /// Sets the places of row j, with one more at both ends for differences.
    void place(LandRow& row, int j) const {
        const int columns = region_.samples[0];
        row.resize(static_cast<std::size_t>(columns + 2 * margin_));
        const double y = y_at(j);
        for (int i = -margin_; i < columns + margin_; ++i) {
            row.x[static_cast<std::size_t>(i + margin_)] = x_at(i);
        }
        std::ranges::fill(row.y, y);
    }

    void write(int j, LandRow& row, const LandRow* below, const LandRow* above) const {
        if (by_difference_) difference(row, *below, *above);
        const int columns = region_.samples[0];
        for (const MapOutput& output : outputs_) {
            const auto step = static_cast<std::size_t>(output.components);
            float* const to = output.data + static_cast<std::size_t>(j) * output.pitch(columns);
            for (std::size_t c = 0; c < output.used().size(); ++c) {
                const auto& [quantity, factor] = output.component[c];
                if (quantity == Quantity()) continue;
                const Channel channel = channel_of_quantity(quantity);
                for (int i = 0; i < columns; ++i) {
                    const auto at = static_cast<std::size_t>(i + margin_);
                    to[static_cast<std::size_t>(i) * step + c] = factor * value(row, at, channel);
                }
                if (output.seam) to[static_cast<std::size_t>(columns) * step + c] = to[c];
            }
        }
    }

    /// Copies the first row behind the last one if an output has a seam.
    void close() const {
        for (const MapOutput& output : outputs_) {
            if (!output.seam) continue;
            const std::size_t pitch = output.pitch(region_.samples[0]);
            float* const last = output.data + static_cast<std::size_t>(region_.samples[1]) * pitch;
            for (std::size_t i = 0; i < output.width(region_.samples[0]); ++i) {
                const std::size_t component = i % static_cast<std::size_t>(output.components);
                if (output.component[component].quantity == Quantity()) continue;
                last[i] = output.data[i];
            }
        }
    }

  private:
    /// Returns a coordinate. A sample beyond a tile has the coordinate of its twin on the other
    /// side.
    double x_at(int i) const { return x_.at(wrapped(i, 0)); }
    double y_at(int j) const { return y_.at(wrapped(j, 1)); }
    int wrapped(int i, std::size_t axis) const {
        const int n = region_.samples[axis];
        return region_.wraps ? ((i % n) + n) % n : i;
    }

    void difference(LandRow& row, const LandRow& below, const LandRow& above) const {
        const double across = 0.5 / x_.step(), along = 0.5 / y_.step();
        for (std::size_t i = 1; i + 1 < row.size(); ++i) {
            row.slope_x[i] = across * (row.height[i + 1] - row.height[i - 1]);
            row.slope_y[i] = along * (above.height[i] - below.height[i]);
        }
    }

    float value(const LandRow& row, std::size_t at, Channel channel) const {
        switch (channel) {
            case Channel::height:
                return static_cast<float>(row.height[at]);
            case Channel::slope_x:
                return static_cast<float>(row.slope_x[at]);
            case Channel::slope_y:
                return static_cast<float>(row.slope_y[at]);
            case Channel::nx:
            case Channel::ny:
            case Channel::nz: {
                const double x = row.slope_x[at], y = row.slope_y[at];
                const double scale = 1.0 / std::sqrt(1.0 + x * x + y * y);
                if (channel == Channel::nz) return static_cast<float>(scale);
                return static_cast<float>(-scale * (channel == Channel::nx ? x : y));
            }
            default:
                break;
        }
        for (std::size_t m = 0; m < kGullyMasks.size(); ++m) {
            if (parts_.gullies && channel == channel_of(kGullyMasks[m])) return row.masks[m][at];
        }
        for (const auto& [mask, grid] : parts_.masks) {
            if (channel == channel_of(mask)) return grid->at(row.x[at], row.y[at]);
        }
        return 0.0f;
    }

    const Domain& region_;
    std::span<const MapOutput> outputs_;
    const LandFunctionParts& parts_;
    bool by_difference_;
    int margin_;
    Steps x_, y_;
};

/// Returns all channels of the outputs, linear fields included.
ChannelSet wanted_of(std::span<const MapOutput> outputs) {
    ChannelSet wanted;
    for (const MapOutput& output : outputs) {
        for (const auto& [quantity, factor] : output.used()) {
            if (!(quantity == Quantity())) wanted = wanted | channel_of_quantity(quantity);
        }
    }
    return wanted;
}

void require_available(ChannelSet wanted, ChannelSet available) {
    if (available.contains(wanted)) return;
    for (int c = 0; c <= kChannelNumbers; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (!wanted.contains(channel) || available.contains(channel)) continue;
        throw Error(ErrorKind::unsupported,
                    "this terrain has no " + std::string(channel_info(channel).name) +
                        (is_mask(channel) ? ": its file has no section that makes this mask" : ""));
    }
}

}  // namespace

void LandFunction::write(const Domain& region, std::span<const MapOutput> outputs,
                         ThreadPool& pool) const {
    const ChannelSet wanted = wanted_of(outputs);
    require_available(wanted, channels());
    const double cell = rounded_step(std::max(region.step(0), region.step(1)));
    const RowWriter writer(region, outputs, impl_->parts, wanted);
    // Neighbouring rows share the rows that their differences need.
    constexpr int kRowsOfItem = 16;
    const int rows = region.samples[1];
    pool.for_each_item((rows + kRowsOfItem - 1) / kRowsOfItem, [&](int item, int) {
        std::array<LandRow, 3> ring;
        const auto made = [&](int j) -> LandRow& {
            return ring[static_cast<std::size_t>((j + 3) % 3)];
        };
        const auto make = [&](int j) {
            writer.place(made(j), j);
            compute(impl_->parts, cell, wanted, made(j));
        };
        const int first = item * kRowsOfItem, last = std::min(first + kRowsOfItem, rows);
        if (writer.by_difference()) {
            make(first - 1);
            make(first);
        }
        for (int j = first; j < last; ++j) {
            make(writer.by_difference() ? j + 1 : j);
            writer.write(j, made(j), &made(j - 1), &made(j + 1));
        }
    });
    writer.close();
}

Surface LandFunction::surface(const Domain& region, ChannelSet channels, ThreadPool& pool) const {
    Surface surface(region, 0.0, channels);
    write(region, outputs_of(surface), pool);
    return surface;
}

void LandFunction::query(std::span<const WorldPoint> points, std::span<QuerySample> samples,
                         double cell, ThreadPool& pool) const {
    for (const WorldPoint& point : points) {
        if (std::isfinite(point.x) && std::isfinite(point.y)) continue;
        throw Error(ErrorKind::invalid_value, "a point of the query is not finite");
    }
    constexpr int kPointsOfItem = 256;
    const auto count = static_cast<int>(points.size());
    pool.for_each_item((count + kPointsOfItem - 1) / kPointsOfItem, [&](int item, int) {
        const auto first = static_cast<std::size_t>(item) * kPointsOfItem;
        const auto part =
            points.subspan(first, std::min<std::size_t>(kPointsOfItem, points.size() - first));
        // With gullies four neighbours follow the points, for differences.
        const bool by_difference = impl_->parts.gullies.has_value();
        const std::size_t n = part.size();
        LandRow row;
        row.resize(by_difference ? 5 * n : n);
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::size_t neighbour = i / n;
            const WorldPoint& point = part[i % n];
            row.x[i] = point.x + (neighbour == 1 ? cell : neighbour == 2 ? -cell : 0.0);
            row.y[i] = point.y + (neighbour == 3 ? cell : neighbour == 4 ? -cell : 0.0);
        }
        compute(impl_->parts, cell, kSlopes, row);
        for (std::size_t i = 0; i < n; ++i) {
            if (by_difference) {
                row.slope_x[i] = (row.height[n + i] - row.height[2 * n + i]) / (2.0 * cell);
                row.slope_y[i] = (row.height[3 * n + i] - row.height[4 * n + i]) / (2.0 * cell);
            }
            const double x = row.slope_x[i], y = row.slope_y[i];
            const double scale = 1.0 / std::sqrt(1.0 + x * x + y * y);
            QuerySample& sample = samples[first + i];
            sample = {};
            sample.height = row.height[i];
            sample.normal[0] = -scale * x;
            sample.normal[1] = -scale * y;
            sample.normal[2] = scale;
            sample.label[0] = part[i].x;
            sample.label[1] = part[i].y;
        }
    });
}

std::uint64_t LandFunction::bytes() const {
    const LandFunctionParts& parts = impl_->parts;
    std::uint64_t sum = SplinePyramid::bytes(parts.base->finest().domain());
    if (parts.fine) sum += SplinePyramid::bytes(parts.fine->finest().domain());
    if (parts.shore) sum += parts.shore->bytes();
    if (parts.detail_share) sum += parts.detail_share->bytes();
    for (const auto& [mask, grid] : parts.masks) sum += grid->bytes();
    return sum;
}

}  // namespace ocean
