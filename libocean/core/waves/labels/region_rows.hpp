// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rows of a region: the channels that follow from height and offsets at its labels. A surface
// writes its own channels, such as foam.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "ocean/query.hpp"
#include "ocean/surface.hpp"
#include "waves/labels/label_point.hpp"

namespace ocean {

/// Throws Error invalid_value for a domain that wraps or has other than 2 .. kMaxRegionSide samples
/// along a side.
void require_region(const Domain& domain);

/// Returns a channel of one period at a label, linear between its samples.
float read_period(const Surface& map, Channel channel, WorldPoint label);

/// Returns true if a channel of a region needs derivatives in time.
bool needs_rates(ChannelSet channels);
/// Returns true if a channel of a region needs derivatives along x and y.
bool needs_gradients(ChannelSet channels);

inline constexpr std::array<Channel, 3> kNormal = {Channel::nx, Channel::ny, Channel::nz};
inline constexpr ChannelSet kNormals = {Channel::nx, Channel::ny, Channel::nz};

/// The samples of a row that are written, and whether their values are added to those there.
struct RegionSpan {
    int first, end;     // samples
    bool adds = false;  // to the fields of other waves; see Ocean::add_wake()
};

/// Some samples of a row, with the values that several channels share. Point is a LabelPoint or
/// derived from it.
template <typename Point>
struct RegionPiece {
    static constexpr std::size_t kSize = 256;

    std::size_t first;  // index of the first sample in the region
    std::size_t count;
    std::array<WorldPoint, kSize> labels;
    std::array<Point, kSize> points;
    std::array<std::array<float, 3>, kSize> normals;  // if a channel needs them
    std::array<float, kSize> jacobians;               // the same

    void finish(ChannelSet channels) {
        if (channels.intersects(kNormals)) {
            for (std::size_t i = 0; i < count; ++i) normals[i] = label_normal(points[i]);
        }
        if (channels.intersects({Channel::jacobian, Channel::whitecap})) {
            for (std::size_t i = 0; i < count; ++i) jacobians[i] = label_jacobian(points[i]);
        }
    }
};

/// A component of the samples of a piece, `step` floats apart.
struct RegionTarget {
    Channel channel;
    float factor;
    float* to;
    std::size_t step;
    bool adds;

    /// Writes, or adds, the factor times value(i) for each sample i.
    template <typename Value>
    void write(std::size_t count, const Value& value) const {
        const float scale = factor;  // which no write can change
        if (adds) {
            for (std::size_t i = 0; i < count; ++i) to[i * step] += scale * value(i);
        } else {
            for (std::size_t i = 0; i < count; ++i) to[i * step] = scale * value(i);
        }
    }
};

/// Writes a channel of height and offsets; returns false for any other.
template <typename Point>
bool write_position(const RegionPiece<Point>& piece, const RegionTarget& target) {
    const auto each = [&](const auto& value) {
        target.write(piece.count, value);
        return true;
    };
    const auto each_point = [&](const auto& value) {
        return each([&](std::size_t i) { return value(piece.points[i]); });
    };
    switch (target.channel) {
        case Channel::dx:
            return each_point([](const LabelPoint& point) { return point.dx.value(); });
        case Channel::dy:
            return each_point([](const LabelPoint& point) { return point.dy.value(); });
        case Channel::height:
            return each_point([](const LabelPoint& point) { return point.height.value(); });
        case Channel::nx:
            return each([&](std::size_t i) { return piece.normals[i][0]; });
        case Channel::ny:
            return each([&](std::size_t i) { return piece.normals[i][1]; });
        case Channel::nz:
            return each([&](std::size_t i) { return piece.normals[i][2]; });
        case Channel::slope_x:
            return each_point([](const LabelPoint& point) { return point.height.by_x(); });
        case Channel::slope_y:
            return each_point([](const LabelPoint& point) { return point.height.by_y(); });
        case Channel::jacobian:
            return each([&, still = target.adds ? 1.0f : 0.0f](std::size_t i) {
                return piece.jacobians[i] - still;
            });
        case Channel::vx:
            return each_point([](const LabelPoint& point) { return point.dx.by_t(); });
        case Channel::vy:
            return each_point([](const LabelPoint& point) { return point.dy.by_t(); });
        case Channel::vz:
            return each_point([](const LabelPoint& point) { return point.height.by_t(); });
        case Channel::dx_x:
            return each_point([](const LabelPoint& point) { return point.dx.by_x(); });
        case Channel::dy_y:
            return each_point([](const LabelPoint& point) { return point.dy.by_y(); });
        // Over a bed the two mixed derivatives differ a little.
        case Channel::dx_y:
            return each_point(
                [](const LabelPoint& point) { return 0.5f * (point.dx.by_y() + point.dy.by_x()); });
        case Channel::whitecap:
        case Channel::foam:
        case Channel::cover:
            return false;
    }
    return false;
}

/// Lays the slopes of the displayed points on the normals of an output, to first order in both.
/// Each normal must be whole there.
template <typename Point>
void tilt_normals(const RegionPiece<Point>& piece, std::span<const MapOutput::Component> used,
                  float* to) {
    std::array<std::size_t, 3> at{};
    std::array<float, 3> sign{};
    for (std::size_t c = 0; c < used.size(); ++c) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (used[c].quantity != Quantity(kNormal[axis])) continue;
            at[axis] = c;
            sign[axis] = used[c].factor;
        }
    }
    for (std::size_t i = 0; i < piece.count; ++i, to += used.size()) {
        const std::array<float, 3> wake = label_cross(piece.points[i]);
        const float steep = sign[2] * to[at[2]] / wake[2];
        const float x = sign[0] * to[at[0]] + steep * wake[0];
        const float y = sign[1] * to[at[1]] + steep * wake[1];
        const float z = sign[2] * to[at[2]];
        const float scale = 1.0f / std::sqrt(x * x + y * y + z * z);
        to[at[0]] = sign[0] * scale * x;
        to[at[1]] = sign[1] * scale * y;
        to[at[2]] = sign[2] * scale * z;
    }
}

/// Writes samples of row j of a region, which holds channels alone. read(labels, points, first)
/// writes the surface at labels, the first of which has the index `first` in the region;
/// write_own(piece, target) writes a channel that write_position does not know.
template <typename Point, typename Read, typename WriteOwn>
void write_region_row(const Domain& domain, int j, RegionSpan span, ChannelSet channels,
                      std::span<const MapOutput> outputs, const Read& read,
                      const WriteOwn& write_own) {
    using Piece = RegionPiece<Point>;
    const auto width = static_cast<std::size_t>(domain.samples[0]);
    const auto row = static_cast<std::size_t>(j);
    const auto end = static_cast<std::size_t>(span.end);
    const double y = domain.place(0, j)[1];
    const double step = domain.step(0);
    Piece piece;
    for (auto first = static_cast<std::size_t>(span.first); first < end; first += Piece::kSize) {
        const std::size_t count = std::min(end - first, Piece::kSize);
        piece.first = row * width + first;
        piece.count = count;
        for (std::size_t i = 0; i < count; ++i) {
            piece.labels[i] = {domain.origin[0] + static_cast<double>(first + i) * step, y};
        }
        read(std::span<const WorldPoint>(piece.labels).first(count),
             std::span(piece.points).first(count), first);
        piece.finish(span.adds ? channels.without(kNormals) : channels);
        for (const MapOutput& output : outputs) {
            const auto used = output.used();
            float* const to =
                output.data + row * output.pitch(domain.samples[0]) + first * used.size();
            if (span.adds && channels_of({&output, 1}).intersects(kNormals)) {
                tilt_normals(piece, used, to);
            }
            for (std::size_t c = 0; c < used.size(); ++c) {
                if (!used[c].quantity.is_channel()) continue;
                const RegionTarget target{used[c].quantity.channel(), used[c].factor, to + c,
                                          used.size(), span.adds};
                if (span.adds && kNormals.contains(target.channel)) continue;
                if (!write_position(piece, target)) write_own(piece, target);
            }
        }
    }
}

}  // namespace ocean
