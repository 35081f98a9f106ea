// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
#include "stage_layout.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

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

}  // namespace ocean::app
