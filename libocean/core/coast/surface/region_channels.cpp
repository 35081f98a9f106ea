// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast/surface/region_channels.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "coast/surface/swash.hpp"
#include "ocean/internal/coast_waves.hpp"
#include "ocean/internal/surf_traces.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/thread_pool.hpp"
#include "wave/wave.hpp"

namespace ocean {
JetParts region_parts(ChannelSet channels) {
    if (needs_rates(channels)) return JetParts::all;
    return needs_gradients(channels) ? JetParts::gradient : JetParts::value;
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

void RegionChannels::write_row(const Domain& domain, int j, ReadySums ready,
                               std::span<const MapOutput> outputs) const {
    const auto read = [&](std::span<const WorldPoint> labels, std::span<ShorePoint> points,
                          std::size_t first) {
        surface_.read(labels, parts_, points, nullptr,
                      {ready.sums, ready.labels, ready.first + first});
    };
    const auto own = [&](const Piece& piece, const RegionTarget& target) {
        write_own(piece, target);
    };
    write_region_row<ShorePoint>(domain, j, {0, domain.samples[0]}, channels_, outputs, read, own);
}

void RegionChannels::write_own(const Piece& piece, const RegionTarget& target) const {
    const auto each = [&](const auto& value) {
        target.write(piece.count,
                     [&](std::size_t i) { return value(piece.points[i], i, piece.first + i); });
    };
    if (target.channel == Channel::whitecap) {
        return each([&](const ShorePoint& point, std::size_t i, std::size_t) {
            const float offshore = wave::single_precision::surface_whitecap(
                piece.jacobians[i], static_cast<float>(settings_.foam_threshold),
                static_cast<float>(settings_.foam_width));
            return std::max((1.0f - point.surf) * offshore, point.breaking);
        });
    }
    if (target.channel == Channel::foam) {
        return each([&](const ShorePoint& point, std::size_t i, std::size_t at) {
            return foam_.foam(piece.labels[i], at, point.breaking, point.surf);
        });
    }
    if (target.channel == Channel::cover) {
        return each([&](const ShorePoint& point, std::size_t i, std::size_t at) {
            return foam_.cover(piece.labels[i], at, point.breaking, point.surf);
        });
    }
    if (target.channel == channel_of(LandMask::breaking)) {
        return each(
            [](const ShorePoint& point, std::size_t, std::size_t) { return point.breaking; });
    }
    if (target.channel == channel_of(LandMask::wetness)) {
        return each([&](const ShorePoint& point, std::size_t, std::size_t at) {
            const float past = wet_.map == nullptr ? 0.0f : wet_.fade * wet_.map[at];
            return std::max(point.wetness, past);
        });
    }
    if (target.channel == channel_of(LandMask::depth)) {
        return each([&](const ShorePoint& point, std::size_t i, std::size_t) {
            const double x = piece.labels[i].x + static_cast<double>(point.dx.value());
            const double y = piece.labels[i].y + static_cast<double>(point.dy.value());
            return point.height.value() - bed_height(bed_, x, y);
        });
    }
    each([](const ShorePoint&, std::size_t, std::size_t) { return 0.0f; });
}

}  // namespace ocean
