// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/picking.hpp"

#include <algorithm>
#include <cmath>

#include "ocean/internal/text.hpp"

namespace ocean::app {

std::optional<PickedWater> pick_water(LiveSea& sea, const preview::Camera& camera,
                                      const std::array<double, 2>& place, double aspect) {
    constexpr int kSteps = 3;
    PickedWater picked{};
    double level = 0.0;
    for (int step = 0;; ++step) {
        const auto met = camera.meet_level(place[0], place[1], aspect, level);
        if (!met) return std::nullopt;
        picked.point = {(*met)[0], (*met)[1]};
        if (step == kSteps) return picked;
        sea.ocean().query(sea.time(), {&picked.point, 1}, {&picked.sample, 1}, {.foam = false});
        level = picked.sample.height;
    }
}

std::string describe(const PickedWater& picked, preview::Renderer& renderer,
                     const preview::DrawnSea& shown, const preview::Camera& camera, int cascade) {
    const auto& [point, sample] = picked;
    const auto drawn = preview::probe(renderer, shown, camera, {point.x, point.y}, cascade);
    return format_text("x %.2f  y %.2f  height %.2f m\nnormal %.2f %.2f %.2f\nfoam %.2f", point.x,
                       point.y, sample.height, sample.normal[0], sample.normal[1], sample.normal[2],
                       drawn ? drawn->cover : 0.0);
}

std::optional<WorldPoint> pick_ground(const preview::DrawnLand& land, const preview::Camera& camera,
                                      const std::array<double, 2>& place, double aspect) {
    constexpr double kFarthest = 200e3;  // [m]
    constexpr int kHalvings = 30;
    const std::array<double, 3> sight = camera.line_of_sight(place[0], place[1], aspect);
    const auto clearance = [&](double distance) {
        const double x = camera.eye[0] + distance * sight[0];
        const double y = camera.eye[1] + distance * sight[1];
        return camera.eye[2] + distance * sight[2] - land.surface_at(x, y);
    };
    const double texel = preview::texel_of(land);
    double before = 0.0;
    for (double distance = 0.1 * texel; distance < kFarthest;) {
        const double free = clearance(distance);
        if (free <= 0.0) {
            double behind = distance;
            for (int i = 0; i < kHalvings; ++i) {
                const double middle = 0.5 * (before + behind);
                (clearance(middle) > 0.0 ? before : behind) = middle;
            }
            return WorldPoint{camera.eye[0] + behind * sight[0], camera.eye[1] + behind * sight[1]};
        }
        if (sight[2] >= 0.0 && camera.eye[2] + distance * sight[2] > land.heights[1]) break;
        before = distance;
        distance += std::max({0.25 * texel, 0.3 * free, 1e-3 * distance});
    }
    return std::nullopt;
}

std::string describe(const WorldPoint& point, LiveLand& land) {
    QuerySample sample{};
    // The sum of all waves of a larger grid takes longer than a frame.
    constexpr int kMaxExact = 1024;
    land.terrain().query({&point, 1}, {&sample, 1},
                         {.exact = land.model().resolution <= kMaxExact});
    const double slope = std::acos(std::clamp(sample.normal[2], -1.0, 1.0)) * 360.0 / kTwoPi;
    return format_text("x %.2f  y %.2f  height %.2f m\nslope %.1f deg  normal %.2f %.2f %.2f",
                       point.x, point.y, sample.height, slope, sample.normal[0], sample.normal[1],
                       sample.normal[2]);
}

}  // namespace ocean::app
