// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Looks into a selection of patches: which one a point lies in, and how high the shown surface is.
#pragma once

#include <bit>
#include <cstdint>
#include <unordered_map>

#include "ocean/internal/land_quadtree.hpp"
#include "testing.hpp"

namespace ocean {

using Position = std::array<double, 3>;
/// Returns the height at a point for a spacing.
using PointHeight = std::function<float(WorldPoint, double spacing)>;

/// Returns a number from low to high.
inline double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

/// Returns a height that shares nothing with those beside it and with other spacings: rougher than
/// any land, so that no gap hides.
inline float rough_height(WorldPoint point, double spacing) {
    std::uint64_t h = 0;
    for (const double value : {point.x + 0.0, point.y + 0.0, spacing}) {
        h = (h ^ std::bit_cast<std::uint64_t>(value)) * 0xbf58476d1ce4e5b9ull;
        h ^= h >> 29;
    }
    return 100.0f * static_cast<float>(h >> 40) / 16777216.0f;
}

inline Position place_vertex(const QuadtreeSettings& settings, const LandView& view, int level,
                             LandIndex index, const PointHeight& height) {
    const LandVertex v = land_vertex(settings, view, level, index);
    const double spacing = settings.spacing_of(level);
    const float own = v.share < 1.0 ? height(v.label, spacing) : 0.0f;
    std::array<float, 2> coarse{};
    for (std::size_t end = 0; end < 2 && v.share > 0.0; ++end) {
        coarse[end] = height(land_label(settings, level, v.parents[end]), 2.0 * spacing);
    }
    return {v.shown.x, v.shown.y, v.height(own, coarse[0], coarse[1])};
}

/// The patches of a selection by place.
class PatchMap {
  public:
    PatchMap(const QuadtreeSettings& settings, std::span<const LandPatch> patches)
        : settings_(settings) {
        for (const LandPatch& patch : patches) {
            const bool is_new =
                patches_
                    .emplace(key(patch.level - (patch.quarter ? 1 : 0), patch.i, patch.j), patch)
                    .second;
            repeated_ |= !is_new;
        }
    }

    bool has_repeats() const { return repeated_; }

    /// Returns the patch in which a point lies, or null.
    const LandPatch* find(double x, double y) const {
        double side = settings_.patch * settings_.spacing;
        for (int size = 0; size < settings_.levels; ++size, side *= 2.0) {
            const auto i = static_cast<std::int64_t>(std::floor(x / side));
            const auto j = static_cast<std::int64_t>(std::floor(y / side));
            if (const LandPatch* patch = at(size, i, j)) return patch;
        }
        return nullptr;
    }

  private:
    static std::uint64_t key(int size, std::int64_t i, std::int64_t j) {
        constexpr std::uint64_t kHalf = (1ull << 29) - 1;
        return static_cast<std::uint64_t>(size) << 58 |
               (static_cast<std::uint64_t>(i) & kHalf) << 29 |
               (static_cast<std::uint64_t>(j) & kHalf);
    }
    const LandPatch* at(int size, std::int64_t i, std::int64_t j) const {
        const auto found = patches_.find(key(size, i, j));
        return found == patches_.end() ? nullptr : &found->second;
    }

    QuadtreeSettings settings_;
    std::unordered_map<std::uint64_t, LandPatch> patches_;
    bool repeated_ = false;
};

/// Returns the height of the triangle that is shown at a point, or none outside all patches.
inline std::optional<double> shown_height(const QuadtreeSettings& settings, const LandView& view,
                                          const PatchMap& map, const PointHeight& height,
                                          WorldPoint point) {
    const LandPatch* const patch = map.find(point.x, point.y);
    if (patch == nullptr) return std::nullopt;
    const double parent = 2.0 * settings.spacing_of(patch->level);
    const LandIndex low{2 * static_cast<std::int64_t>(std::floor(point.x / parent)),
                        2 * static_cast<std::int64_t>(std::floor(point.y / parent))};
    std::array<Position, 9> p;
    for (std::size_t n = 0; n < 9; ++n) {
        const LandIndex v{low.i + static_cast<std::int64_t>(n % 3),
                          low.j + static_cast<std::int64_t>(n / 3)};
        p[n] = place_vertex(settings, view, patch->level, v, height);
    }
    for (const std::size_t q : {0u, 1u, 3u, 4u}) {
        for (const auto& [b, c] :
             {std::pair<std::size_t, std::size_t>{q + 1, q + 4}, {q + 4, q + 3}}) {
            const double bx = p[b][0] - p[q][0], by = p[b][1] - p[q][1];
            const double cx = p[c][0] - p[q][0], cy = p[c][1] - p[q][1];
            const double area = bx * cy - by * cx;
            if (!(area > 0.0)) continue;
            const double x = point.x - p[q][0], y = point.y - p[q][1];
            const double wb = (x * cy - y * cx) / area, wc = (bx * y - by * x) / area;
            if (wb < -1e-9 || wc < -1e-9 || wb + wc > 1.0 + 1e-9) continue;
            return p[q][2] + wb * (p[b][2] - p[q][2]) + wc * (p[c][2] - p[q][2]);
        }
    }
    return std::nullopt;
}

}  // namespace ocean
