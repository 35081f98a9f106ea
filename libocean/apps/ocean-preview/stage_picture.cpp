// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "stage_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "ocean/backend.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/map_request.hpp"

namespace ocean::app {
namespace {

constexpr double kDecades = 4.0;

std::uint8_t byte(double value) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

/// The colour wheel of [Smith 1978] with full saturation.
std::array<std::uint8_t, 3> wheel(double turns, double value) {
    std::array<std::uint8_t, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double place = turns + static_cast<double>(i) / 3.0;
        const double away = std::abs(6.0 * (place - std::floor(place)) - 3.0);
        rgb[i] = byte(value * std::clamp(away - 1.0, 0.0, 1.0));
    }
    return rgb;
}

/// Returns the number of pixels to each side of the middle that hold 95 % of the energy.
template <typename Energy>
int middle_of(int width, const Energy& energy) {
    constexpr double kShare = 0.95;
    constexpr int kMinMiddle = 8;
    const int half = width / 2;
    std::vector<double> rings(static_cast<std::size_t>(half) + 1);
    for (int y = 0; y < width; ++y) {
        for (int x = 0; x < width; ++x) {
            const int ring = std::max(std::abs(x - half), std::abs(y - half));
            rings[static_cast<std::size_t>(ring)] +=
                energy(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x));
        }
    }
    const double whole = std::accumulate(rings.begin(), rings.end(), 0.0);
    double inside = 0.0;
    int middle = 0;
    while (middle < half && (inside += rings[static_cast<std::size_t>(middle)]) < kShare * whole) {
        ++middle;
    }
    return std::max(middle, kMinMiddle);
}

std::array<std::uint8_t, 3> complex_colour(double re, double im, double largest) {
    const double amplitude = std::hypot(re, im);
    if (amplitude <= 0.0 || largest <= 0.0) return {0, 0, 0};
    return wheel(std::atan2(im, re) / kTwoPi, 1.0 + std::log10(amplitude / largest) / kDecades);
}

/// Returns a grey picture of a plane; shade() gives 0 (black) .. 1 (white) for a value.
template <typename Shade>
StagePicture grey_picture(int side, const std::vector<float>& plane, Shade&& shade) {
    StagePicture picture{side, side, {}};
    picture.is_plane = true;
    picture.rgb.reserve(3 * plane.size());
    for (const float value : plane) {
        picture.rgb.insert(picture.rgb.end(), 3, byte(shade(static_cast<double>(value))));
    }
    return picture;
}

/// Returns the lowest and the highest value that is not 0.
std::array<double, 2> range_of(const std::vector<float>& plane) {
    float low = 0.0f, high = 0.0f;
    for (const float value : plane) {
        if (value > 0.0f && (low == 0.0f || value < low)) low = value;
        high = std::max(high, value);
    }
    return {static_cast<double>(low), static_cast<double>(high)};
}

/// Returns the place of a value in a range by logarithms, 0 .. 1; 0 for no value.
double log_place(double value, double low, double high) {
    if (value <= 0.0 || low <= 0.0) return 0.0;
    return std::log(value / low) / std::max(std::log(high / low), 1e-9);
}

}  // namespace

StagePicture make_stage_picture(gl::StageMaker& maker, Ocean& sea, double time, std::size_t cascade,
                                std::string_view name) {
    const Modes& modes = sea.modes(time);
    if (cascade >= modes.cascades.size()) {
        throw Error(ErrorKind::invalid_value, "there is no cascade " + std::to_string(cascade) +
                                                  "; allowed: 0 .. " +
                                                  std::to_string(modes.cascades.size() - 1));
    }
    const int resolution = modes.cascades[cascade].lattice.resolution;
    const gl::StageImage image =
        maker.make(cascade_modes(modes, cascade, time, resolution), name, sea.pool());
    const std::size_t channels = image.channels.size();
    const std::size_t pixels = image.texels.size() / channels;
    const auto texel = [&](std::size_t pixel, std::size_t channel) {
        return static_cast<double>(image.texels[pixel * channels + channel]);
    };
    double largest = 0.0;
    for (std::size_t p = 0; p < pixels; ++p) {
        largest = std::max(largest, std::hypot(texel(p, 0), texel(p, 1)));
    }
    StagePicture picture{image.width, image.height, std::vector<std::uint8_t>(3 * pixels), 0};
    for (std::size_t p = 0; p < pixels; ++p) {
        const std::array<std::uint8_t, 3> rgb =
            name == "butterfly"
                ? std::array{byte(0.5 + 0.5 * texel(p, 0)), byte(0.5 + 0.5 * texel(p, 1)),
                             byte(texel(p, 2) / image.height)}
                : complex_colour(texel(p, 0), texel(p, 1), largest);
        std::ranges::copy(rgb, &picture.rgb[3 * p]);
    }
    if (name != "butterfly") {
        picture.middle = middle_of(image.width, [&](std::size_t pixel) {
            return std::pow(texel(pixel, 0), 2.0) + std::pow(texel(pixel, 1), 2.0);
        });
    }
    return picture;
}

StagePicture make_stage_picture(const TerrainStages& stages, std::string_view name) {
    const int side = stages.resolution;
    if (name == "noise") {
        return grey_picture(side, stages.noise, [](double v) { return 0.5 + v / 6.0; });
    }
    if (name == "transform") {
        return grey_picture(side, stages.transform,
                            [](double v) { return log_place(v, 0.01, std::sqrt(10.0)); });
    }
    const auto [low, high] = range_of(stages.filter);
    return grey_picture(
        side, name == "filter" ? stages.filter : stages.filtered,
        [low = low, high = high](double v) { return 0.1 + 0.9 * log_place(v, low, high); });
}

}  // namespace ocean::app
