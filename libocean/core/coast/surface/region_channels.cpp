// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast/surface/region_channels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "coast/surface/shore_query.hpp"
#include "coast/surface/swash.hpp"
#include "ocean/coast_waves.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/surf_traces.hpp"
#include "ocean/thread_pool.hpp"
#include "wave/wave.hpp"
#include "waves/query/query_points.hpp"

namespace ocean {
namespace {

/// Returns a channel of one period at a label, linear between its samples.
float read_period(const Surface& map, Channel channel, WorldPoint label) {
    const std::span<const float> values = map.channel(channel);
    const int samples = map.resolution();
    const double u = wrapped(label.x, map.period()) / map.period() * samples;
    const double v = wrapped(label.y, map.period()) / map.period() * samples;
    const int i = static_cast<int>(u);
    const int j = static_cast<int>(v);
    const auto at = [&](int column, int row) {
        return values[static_cast<std::size_t>(row & (samples - 1)) *
                          static_cast<std::size_t>(samples) +
                      static_cast<std::size_t>(column & (samples - 1))];
    };
    const auto s = static_cast<float>(u - i);
    const auto t = static_cast<float>(v - j);
    const auto row = [&](int of) { return at(i, of) + s * (at(i + 1, of) - at(i, of)); };
    return row(j) + t * (row(j + 1) - row(j));
}

constexpr ChannelSet kRates = {Channel::vx, Channel::vy, Channel::vz};
constexpr ChannelSet kGradients = {
    Channel::nx,   Channel::ny,   Channel::nz,   Channel::slope_x,  Channel::slope_y,
    Channel::dx_x, Channel::dy_y, Channel::dx_y, Channel::jacobian, Channel::whitecap};

}  // namespace

JetParts region_parts(ChannelSet channels) {
    if (channels.intersects(kRates)) return JetParts::all;
    return channels.intersects(kGradients) ? JetParts::gradient : JetParts::value;
}

float RegionFoamMaps::surf_alone(std::size_t index, float breaking) const {
    const float past = surf.map == nullptr ? 0.0f : surf.fade * surf.map[index];
    const float foam = std::max(breaking, past);
    return foam < surf.cutoff ? 0.0f : foam;
}

float RegionFoamMaps::foam(WorldPoint label, std::size_t index, float breaking,
                           float in_surf) const {
    const float offshore = (1.0f - in_surf) * read_period(open, Channel::foam, label);
    return std::max(offshore, surf_alone(index, breaking));
}

float RegionFoamMaps::cover(WorldPoint label, std::size_t index, float breaking,
                            float in_surf) const {
    const float offshore = (1.0f - in_surf) * read_period(open, Channel::cover, label);
    const float surf_cover = std::pow(surf_alone(index, breaking), kSurfCoverPower);
    return 1.0f - (1.0f - offshore) * (1.0f - surf_cover);
}

float RegionChannels::value(Channel channel, WorldPoint label, std::size_t index,
                            const ShorePoint& point) const {
    switch (channel) {
        case Channel::dx:
            return point.dx.value();
        case Channel::dy:
            return point.dy.value();
        case Channel::height:
            return point.height.value();
        case Channel::nx:
            return shore_normal(point)[0];
        case Channel::ny:
            return shore_normal(point)[1];
        case Channel::nz:
            return shore_normal(point)[2];
        case Channel::slope_x:
            return point.height.by_x();
        case Channel::slope_y:
            return point.height.by_y();
        case Channel::jacobian:
            return shore_jacobian(point);
        case Channel::whitecap: {
            const float offshore = wave::single_precision::surface_whitecap(
                shore_jacobian(point), static_cast<float>(settings_.foam_threshold),
                static_cast<float>(settings_.foam_width));
            return std::max((1.0f - point.surf) * offshore, point.breaking);
        }
        case Channel::foam:
            return foam_.foam(label, index, point.breaking, point.surf);
        case Channel::vx:
            return point.dx.by_t();
        case Channel::vy:
            return point.dy.by_t();
        case Channel::vz:
            return point.height.by_t();
        case Channel::dx_x:
            return point.dx.by_x();
        case Channel::dy_y:
            return point.dy.by_y();
        // Over a bed the two mixed derivatives differ a little.
        case Channel::dx_y:
            return 0.5f * (point.dx.by_y() + point.dy.by_x());
        case Channel::cover:
            return foam_.cover(label, index, point.breaking, point.surf);
    }
    return 0.0f;
}

void leave_out_swash(const SeaBed& bed, Surface& map) {
    const Domain& domain = map.domain();
    const std::span<float> whitecaps = map.channel(Channel::whitecap);
    std::size_t next = 0;
    for (int j = 0; j < domain.samples[1]; ++j) {
        for (int i = 0; i < domain.samples[0]; ++i, ++next) {
            const auto [x, y] = domain.place(i, j);
            whitecaps[next] = std::min(whitecaps[next], surf_left(bed_height(bed, x, y)));
        }
    }
}

void RegionChannels::write(const CoastFunction& sum_waves, Surface& map, ThreadPool& pool) const {
    const Domain& domain = map.domain();
    const int rows = domain.samples[1];
    if (!sum_waves) {
        pool.for_each_item(rows, [&](int j, int) { write_row(j, {}, map); });
        return;
    }
    // Enough labels for every core of a GPU, whose sums take some 10 MB.
    constexpr int kLabels = 1 << 17;
    const CoastWaves waves = surface_.waves();
    const auto width = static_cast<std::size_t>(domain.samples[0]);
    const int at_once = std::max(1, kLabels / domain.samples[0]);
    std::vector<WorldPoint> labels;
    PageVector<float> sums;
    for (int first = 0; first < rows; first += at_once) {
        const int count = std::min(at_once, rows - first);
        labels.clear();
        for (int j = first; j < first + count; ++j) {
            for (int i = 0; i < domain.samples[0]; ++i) {
                const auto [x, y] = domain.place(i, j);
                labels.push_back({x, y});
            }
        }
        const auto parts = static_cast<std::size_t>(parts_);
        sums.resize(kCoastSums * parts * labels.size());
        sum_waves({waves, first == 0, labels, parts, sums});
        pool.for_each_item(count, [&](int row, int) {
            write_row(first + row, {sums, labels.size(), static_cast<std::size_t>(row) * width},
                      map);
        });
    }
}

void RegionChannels::write_row(int j, ReadySums ready, Surface& map) const {
    constexpr std::size_t kPiece = 256;
    const Domain& domain = map.domain();
    const auto width = static_cast<std::size_t>(domain.samples[0]);
    const std::size_t row = static_cast<std::size_t>(j) * width;
    std::array<WorldPoint, kPiece> labels;
    std::array<ShorePoint, kPiece> points;
    for (std::size_t first = 0; first < width; first += kPiece) {
        const std::size_t count = std::min(kPiece, width - first);
        for (std::size_t i = 0; i < count; ++i) {
            const auto [x, y] = domain.place(static_cast<int>(first + i), j);
            labels[i] = {x, y};
        }
        surface_.read(std::span(labels).first(count), parts_, std::span(points).first(count),
                      nullptr, {ready.sums, ready.labels, ready.first + first});
        for (int c = 0; c < kChannelCount; ++c) {
            const auto channel = static_cast<Channel>(c);
            if (!map.has(channel)) continue;
            const std::span<float> out = map.channel(channel).subspan(row + first, count);
            for (std::size_t i = 0; i < count; ++i) {
                out[i] = value(channel, labels[i], row + first + i, points[i]);
            }
        }
        if (map.has(channel_of(LandMask::breaking))) {
            const auto out = map.channel(channel_of(LandMask::breaking)).subspan(row + first);
            for (std::size_t i = 0; i < count; ++i) out[i] = points[i].breaking;
        }
        if (map.has(channel_of(LandMask::wetness))) {
            const auto out = map.channel(channel_of(LandMask::wetness)).subspan(row + first);
            for (std::size_t i = 0; i < count; ++i) {
                const float past =
                    wet_.map == nullptr ? 0.0f : wet_.fade * wet_.map[row + first + i];
                out[i] = std::max(points[i].wetness, past);
            }
        }
        if (map.has(channel_of(LandMask::depth))) {
            const auto out = map.channel(channel_of(LandMask::depth)).subspan(row + first);
            for (std::size_t i = 0; i < count; ++i) {
                const ShorePoint& point = points[i];
                const double x = labels[i].x + static_cast<double>(point.dx.value());
                const double y = labels[i].y + static_cast<double>(point.dy.value());
                out[i] = point.height.value() - bed_height(bed_, x, y);
            }
        }
    }
}

}  // namespace ocean
