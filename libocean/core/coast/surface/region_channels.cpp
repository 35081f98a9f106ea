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
#include "ocean/internal/coast_waves.hpp"
#include "ocean/internal/surf_traces.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/page_vector.hpp"
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
constexpr ChannelSet kNormals = {Channel::nx, Channel::ny, Channel::nz};
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

void RegionChannels::write(const CoastFunction& sum_waves, const Domain& domain,
                           std::span<const MapOutput> outputs, ThreadPool& pool) const {
    const int rows = domain.samples[1];
    if (!sum_waves) {
        pool.for_each_item(rows, [&](int j, int) { write_row(domain, j, {}, outputs); });
        return;
    }
    // Enough labels for every core of a GPU; the sums of as many labels take some 10 MB.
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
            const std::size_t from = static_cast<std::size_t>(row) * width;
            write_row(domain, first + row, {sums, labels.size(), from}, outputs);
        });
    }
}

struct RegionChannels::Piece {
    static constexpr std::size_t kSize = 256;

    std::size_t first;  // index of the first sample in the region
    std::size_t count;
    std::array<WorldPoint, kSize> labels;
    std::array<ShorePoint, kSize> points;
    std::array<std::array<float, 3>, kSize> normals;  // if a channel needs them
    std::array<float, kSize> jacobians;               // the same
};

void RegionChannels::write_row(const Domain& domain, int j, ReadySums ready,
                               std::span<const MapOutput> outputs) const {
    const auto width = static_cast<std::size_t>(domain.samples[0]);
    const auto row = static_cast<std::size_t>(j);
    Piece piece;
    for (std::size_t first = 0; first < width; first += Piece::kSize) {
        const std::size_t count = std::min(Piece::kSize, width - first);
        piece.first = row * width + first;
        piece.count = count;
        for (std::size_t i = 0; i < count; ++i) {
            const auto [x, y] = domain.place(static_cast<int>(first + i), j);
            piece.labels[i] = {x, y};
        }
        surface_.read(std::span(piece.labels).first(count), parts_,
                      std::span(piece.points).first(count), nullptr,
                      {ready.sums, ready.labels, ready.first + first});
        if (channels_.intersects(kNormals)) {
            for (std::size_t i = 0; i < count; ++i) {
                piece.normals[i] = shore_normal(piece.points[i]);
            }
        }
        if (channels_.intersects({Channel::jacobian, Channel::whitecap})) {
            for (std::size_t i = 0; i < count; ++i) {
                piece.jacobians[i] = shore_jacobian(piece.points[i]);
            }
        }
        for (const MapOutput& output : outputs) {
            const auto used = output.used();
            float* const to =
                output.data + row * output.pitch(domain.samples[0]) + first * used.size();
            for (std::size_t c = 0; c < used.size(); ++c) {
                if (used[c].quantity.is_channel()) write_piece(piece, used[c], to + c, used.size());
            }
        }
    }
}

void RegionChannels::write_piece(const Piece& piece, const MapOutput::Component& component,
                                 float* to, std::size_t step) const {
    const Channel channel = component.quantity.channel();
    const auto each = [&](const auto& value) {
        for (std::size_t i = 0; i < piece.count; ++i) to[i * step] = component.factor * value(i);
    };
    const auto each_point = [&](const auto& value) {
        each([&](std::size_t i) { return value(piece.points[i]); });
    };
    switch (channel) {
        case Channel::dx:
            return each_point([](const ShorePoint& point) { return point.dx.value(); });
        case Channel::dy:
            return each_point([](const ShorePoint& point) { return point.dy.value(); });
        case Channel::height:
            return each_point([](const ShorePoint& point) { return point.height.value(); });
        case Channel::nx:
            return each([&](std::size_t i) { return piece.normals[i][0]; });
        case Channel::ny:
            return each([&](std::size_t i) { return piece.normals[i][1]; });
        case Channel::nz:
            return each([&](std::size_t i) { return piece.normals[i][2]; });
        case Channel::slope_x:
            return each_point([](const ShorePoint& point) { return point.height.by_x(); });
        case Channel::slope_y:
            return each_point([](const ShorePoint& point) { return point.height.by_y(); });
        case Channel::jacobian:
            return each([&](std::size_t i) { return piece.jacobians[i]; });
        case Channel::whitecap:
            return each([&](std::size_t i) {
                const ShorePoint& point = piece.points[i];
                const float offshore = wave::single_precision::surface_whitecap(
                    piece.jacobians[i], static_cast<float>(settings_.foam_threshold),
                    static_cast<float>(settings_.foam_width));
                return std::max((1.0f - point.surf) * offshore, point.breaking);
            });
        case Channel::foam:
            return each([&](std::size_t i) {
                const ShorePoint& point = piece.points[i];
                return foam_.foam(piece.labels[i], piece.first + i, point.breaking, point.surf);
            });
        case Channel::vx:
            return each_point([](const ShorePoint& point) { return point.dx.by_t(); });
        case Channel::vy:
            return each_point([](const ShorePoint& point) { return point.dy.by_t(); });
        case Channel::vz:
            return each_point([](const ShorePoint& point) { return point.height.by_t(); });
        case Channel::dx_x:
            return each_point([](const ShorePoint& point) { return point.dx.by_x(); });
        case Channel::dy_y:
            return each_point([](const ShorePoint& point) { return point.dy.by_y(); });
        // Over a bed the two mixed derivatives differ a little.
        case Channel::dx_y:
            return each_point(
                [](const ShorePoint& point) { return 0.5f * (point.dx.by_y() + point.dy.by_x()); });
        case Channel::cover:
            return each([&](std::size_t i) {
                const ShorePoint& point = piece.points[i];
                return foam_.cover(piece.labels[i], piece.first + i, point.breaking, point.surf);
            });
    }
    if (channel == channel_of(LandMask::breaking)) {
        return each_point([](const ShorePoint& point) { return point.breaking; });
    }
    if (channel == channel_of(LandMask::wetness)) {
        return each([&](std::size_t i) {
            const float past = wet_.map == nullptr ? 0.0f : wet_.fade * wet_.map[piece.first + i];
            return std::max(piece.points[i].wetness, past);
        });
    }
    if (channel == channel_of(LandMask::depth)) {
        return each([&](std::size_t i) {
            const ShorePoint& point = piece.points[i];
            const double x = piece.labels[i].x + static_cast<double>(point.dx.value());
            const double y = piece.labels[i].y + static_cast<double>(point.dy.value());
            return point.height.value() - bed_height(bed_, x, y);
        });
    }
    each([](std::size_t) { return 0.0f; });
}

}  // namespace ocean
