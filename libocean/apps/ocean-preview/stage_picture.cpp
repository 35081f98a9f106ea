// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "stage_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "command.hpp"
#include "ocean/backend.hpp"
#include "ocean/internal/map_request.hpp"

namespace ocean::app {
namespace {

constexpr int kGap = 8;  // [pixels], between the whole and its middle
constexpr std::array<std::uint8_t, 3> kBehind = {24, 24, 24};
constexpr std::array<std::uint8_t, 3> kFrame = {255, 255, 255};

/// A rectangle of pixels; y counts from the bottom.
struct Place {
    int x, y, width, height;
};

class Page {
  public:
    Page(int width, int height)
        : picture_{width, height, std::vector<std::uint8_t>(pixels(width, height) * 3)} {
        for (std::size_t i = 0; i < picture_.rgb.size(); ++i) picture_.rgb[i] = kBehind[i % 3];
    }

    /// Copies a part of the stage, each pixel as a rectangle of `across` times `up` pixels.
    void magnify(const StagePicture& stage, const Place& part, int x, int y, int across, int up) {
        for (int j = 0; j < part.height * up; ++j) {
            for (int i = 0; i < part.width * across; ++i) {
                set(x + i, y + j, pixel_of(stage, part.x + i / across, part.y + j / up));
            }
        }
    }

    /// Copies the whole stage with the brightest pixel of each square of `step` pixels.
    void reduce(const StagePicture& stage, int x, int y, int step) {
        for (int j = 0; j < stage.height / step; ++j) {
            for (int i = 0; i < stage.width / step; ++i) {
                set(x + i, y + j, brightest(stage, {step * i, step * j, step, step}));
            }
        }
    }

    /// Copies the whole stage with the mean of each square of `step` pixels.
    void average(const StagePicture& stage, int x, int y, int step) {
        for (int j = 0; j < stage.height / step; ++j) {
            for (int i = 0; i < stage.width / step; ++i) {
                set(x + i, y + j, mean(stage, {step * i, step * j, step, step}));
            }
        }
    }

    void frame(const Place& place) {
        for (int i = -1; i <= place.width; ++i) {
            set(place.x + i, place.y - 1, kFrame);
            set(place.x + i, place.y + place.height, kFrame);
        }
        for (int j = -1; j <= place.height; ++j) {
            set(place.x - 1, place.y + j, kFrame);
            set(place.x + place.width, place.y + j, kFrame);
        }
    }

    StagePicture take() { return std::move(picture_); }

  private:
    using Colour = std::array<std::uint8_t, 3>;

    static std::size_t pixels(int width, int height) {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    static std::size_t at(const StagePicture& picture, int x, int y) {
        return 3 * (pixels(picture.width, y) + static_cast<std::size_t>(x));
    }
    static Colour pixel_of(const StagePicture& stage, int x, int y) {
        const std::size_t i = at(stage, x, y);
        return {stage.rgb[i], stage.rgb[i + 1], stage.rgb[i + 2]};
    }
    static Colour brightest(const StagePicture& stage, const Place& part) {
        Colour best{};
        for (int y = part.y; y < part.y + part.height; ++y) {
            for (int x = part.x; x < part.x + part.width; ++x) {
                const Colour colour = pixel_of(stage, x, y);
                if (std::ranges::max(colour) > std::ranges::max(best)) best = colour;
            }
        }
        return best;
    }
    static Colour mean(const StagePicture& stage, const Place& part) {
        std::array<int, 3> sum{};
        for (int y = part.y; y < part.y + part.height; ++y) {
            for (int x = part.x; x < part.x + part.width; ++x) {
                const Colour colour = pixel_of(stage, x, y);
                for (std::size_t c = 0; c < 3; ++c) sum[c] += colour[c];
            }
        }
        Colour result{};
        for (std::size_t c = 0; c < 3; ++c) {
            result[c] = static_cast<std::uint8_t>(sum[c] / (part.width * part.height));
        }
        return result;
    }
    void set(int x, int y, const Colour& colour) {
        if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height) return;
        std::ranges::copy(colour, &picture_.rgb[at(picture_, x, y)]);
    }

    StagePicture picture_;
};

/// Returns the middle of a plane.
Place middle_of(const StagePicture& stage) {
    const int half = std::min(stage.middle, stage.width / 2 - 1);
    return {stage.width / 2 - half, stage.height / 2 - half, 2 * half + 1, 2 * half + 1};
}

void lay_out_plane(const StagePicture& stage, int width, int height, Page& page) {
    const int side = std::max(1, std::min((width - kGap) / 2, height));
    const int times = std::max(1, side / stage.width);
    const int step = (stage.width + side - 1) / side;
    const int whole = step > 1 ? stage.width / step : stage.width * times;
    const int left = (width - kGap) / 2 - whole;
    const int low = (height - whole) / 2;
    if (step > 1) {
        page.reduce(stage, left, low, step);
    } else {
        page.magnify(stage, {0, 0, stage.width, stage.height}, left, low, times, times);
    }
    const Place middle = middle_of(stage);
    page.frame({left + middle.x * times / step, low + middle.y * times / step,
                middle.width * times / step, middle.height * times / step});
    const int more = std::max(1, side / middle.width);
    page.magnify(stage, middle, (width + kGap) / 2, (height - middle.height * more) / 2, more,
                 more);
}

void lay_out_whole(const StagePicture& stage, int width, int height, Page& page) {
    const int side = std::min(width, height);
    const int step = (stage.width + side - 1) / side;
    const int times = std::max(1, side / stage.width);
    const int whole = step > 1 ? stage.width / step : stage.width * times;
    const int left = (width - whole) / 2, low = (height - whole) / 2;
    if (step > 1) return page.average(stage, left, low, step);
    page.magnify(stage, {0, 0, stage.width, stage.height}, left, low, times, times);
}

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

StagePicture laid_out(const StagePicture& stage, int width, int height) {
    Page page(width, height);
    if (stage.middle > 0) {
        lay_out_plane(stage, width, height, page);
    } else if (stage.is_plane) {
        lay_out_whole(stage, width, height, page);
    } else {
        const int across = std::max(1, width / stage.width);
        const int up = std::max(1, height / stage.height);
        page.magnify(stage, {0, 0, stage.width, stage.height}, (width - across * stage.width) / 2,
                     (height - up * stage.height) / 2, across, up);
    }
    return page.take();
}

StagePicture make_stage_picture(gl::StageMaker& maker, Ocean& sea, double time, std::size_t cascade,
                                std::string_view name) {
    const Modes& modes = sea.modes(time);
    if (cascade >= modes.cascades.size()) {
        refuse("there is no cascade " + std::to_string(cascade) + "; allowed: 0 .. " +
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
