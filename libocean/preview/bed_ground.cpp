// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "bed_ground.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace ocean::preview {
namespace {

constexpr std::size_t kGroundComponents = 4;

// Heights over still water up to which ground is sand, and slopes up to which it holds sand and
// from which it is a cliff; each with the width of its edge.
constexpr double kSandTop = 3.0, kSandEdge = 2.5;        // [m]
constexpr double kSandSlope = 0.25, kCliffSlope = 0.55;  // 14 and 29 degrees
constexpr double kSlopeEdge = 0.2;
constexpr double kCliffTop = 25.0, kCliffEdge = 10.0;  // [m]

double step_down(double end, double edge, double x) {
    const double t = std::clamp((end + edge - x) / edge, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace

LandImage bed_image(const SeaBed& bed, int max_resolution) {
    const Domain& domain = bed.domain;
    const int own = std::max(domain.samples[0], domain.samples[1]);
    LandImage image;
    image.resolution = std::min(own, max_resolution);
    const double texel = bed.cell() * (own - 1) / (image.resolution - 1);
    image.period = texel * image.resolution;
    image.origin = domain.origin;
    image.wraps = false;
    const auto side = static_cast<std::size_t>(image.resolution);
    image.texels.resize(kGroundComponents * side * side);
    for (std::size_t j = 0, n = 0; j < side; ++j) {
        for (std::size_t i = 0; i < side; ++i, ++n) {
            const double x = domain.origin[0] + texel * static_cast<double>(i);
            const double y = domain.origin[1] + texel * static_cast<double>(j);
            const double slope_x =
                (bed_height(bed, x + texel, y) - bed_height(bed, x - texel, y)) / (2.0 * texel);
            const double slope_y =
                (bed_height(bed, x, y + texel) - bed_height(bed, x, y - texel)) / (2.0 * texel);
            float* const t = &image.texels[kGroundComponents * n];
            t[0] = static_cast<float>(bed_height(bed, x, y));
            t[1] = static_cast<float>(slope_x);
            t[2] = static_cast<float>(slope_y);
            t[3] = t[1] * t[1] + t[2] * t[2];
        }
    }
    return image;
}

std::vector<std::uint8_t> bed_masks(const LandImage& image) {
    std::vector<std::uint8_t> masks(image.texels.size());
    for (std::size_t n = 0; n < masks.size(); n += kGroundComponents) {
        const auto height = static_cast<double>(image.texels[n]);
        const double slope = std::sqrt(static_cast<double>(image.texels[n + 3]));
        const double level = step_down(kSandSlope, kSlopeEdge, slope);
        const double sand = step_down(kSandTop, kSandEdge, height) * level;
        const double cliff = step_down(kCliffTop, kCliffEdge, height) *
                             (1.0 - step_down(kCliffSlope - kSlopeEdge, kSlopeEdge, slope));
        masks[n] = static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * (sand - cliff)));
        masks[n + 3] = 128;
    }
    return masks;
}

DrawnLand bed_land(const SeaBed& bed, LandImage image) {
    DrawnLand land;
    double slopes = 0.0, sum = 0.0, squares = 0.0, count = 0.0;
    for (std::size_t n = 0; n < image.texels.size(); n += kGroundComponents) {
        const auto height = static_cast<double>(image.texels[n]);
        slopes += static_cast<double>(image.texels[n + 3]);
        if (height <= 0.0) continue;
        sum += height;
        squares += height * height;
        count += 1.0;
    }
    const auto [lowest, highest] = std::ranges::minmax(bed.heights);
    land.mean = sum / std::max(count, 1.0);
    land.rms = std::sqrt(std::max(squares / std::max(count, 1.0) - land.mean * land.mean, 0.0));
    land.rms_slope =
        std::sqrt(slopes / static_cast<double>(image.texels.size() / kGroundComponents));
    land.cell = bed.cell();
    land.heights = {static_cast<double>(lowest), static_cast<double>(highest)};
    land.water_level = 0.0;
    land.has_masks = true;
    land.image = std::make_shared<const LandImage>(std::move(image));
    return land;
}

}  // namespace ocean::preview
