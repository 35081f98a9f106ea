// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See land_panels.hpp.
#include "land_panels.hpp"

#include <cmath>

#include "ocean/internal/grid.hpp"
#include "text.hpp"

namespace ocean::app {

void LogAxes::frame(Figure& figure) const {
    figure.line({{box.left, box.top},
                 {box.right, box.top},
                 {box.right, box.bottom},
                 {box.left, box.bottom},
                 {box.left, box.top}},
                kInk, 1.0);
}

void draw_wavelengths(Figure& figure, const LogAxes& axes, bool labels) {
    const int last = static_cast<int>(std::ceil(std::log10(kTwoPi) - axes.left));
    for (int power = last; power >= -3; --power) {
        for (const double digit : {5.0, 2.0, 1.0}) {
            const double wavelength = digit * std::pow(10.0, power);
            const double x = std::log10(kTwoPi / wavelength);
            if (x < axes.left || x > axes.right) continue;
            const double at = axes.place(x, axes.low).x;
            figure.line({{at, axes.box.top}, {at, axes.box.bottom}}, kFaint, 0.8);
            if (!labels) continue;
            const std::string text = wavelength >= 1000.0
                                         ? significant<3>(wavelength / 1000.0) + " km"
                                         : significant<3>(wavelength) + " m";
            figure.text({at, axes.box.bottom + 14}, text, kSmall, kInk);
        }
    }
}

void draw_decades(Figure& figure, const LogAxes& axes) {
    const int count = static_cast<int>(std::lround(axes.high - axes.low));
    const int step = count > 10 ? 2 : 1;
    for (int i = 0; i <= count; i += step) {
        const double y = axes.place(axes.left, axes.low + i).y;
        figure.line({{axes.box.left, y}, {axes.box.right, y}}, kFaint, 0.8);
        figure.text({axes.box.left - 8, y},
                    "1e" + std::to_string(static_cast<int>(std::lround(axes.low)) + i), kText, kInk,
                    Anchor::right);
    }
    figure.text({axes.box.left - 52, 0.5 * (axes.box.top + axes.box.bottom)},
                "density S(k) [m\u2074]", kText, kInk, Anchor::center, true);
}

namespace {

/// Returns the brightness of a slope in a light from the north-west, 45 degrees high.
double brightness(const Heights& land, int i, int j) {
    const int i0 = std::max(i - 1, 0), i1 = std::min(i + 1, land.columns - 1);
    const int j0 = std::max(j - 1, 0), j1 = std::min(j + 1, land.rows - 1);
    const double sx = (land.at(i1, j) - land.at(i0, j)) / ((i1 - i0) * land.cell_x);
    const double sy = (land.at(i, j1) - land.at(i, j0)) / ((j1 - j0) * land.cell_y);
    const double lit = (0.5 * sx - 0.5 * sy + std::sqrt(0.5)) / std::sqrt(1.0 + sx * sx + sy * sy);
    return std::clamp(lit, 0.0, 1.0);
}

}  // namespace

void draw_relief(Figure& figure, const Heights& land, Point corner, double scale,
                 const std::string& title) {
    const double width = land.columns * land.cell_x * scale;
    const double height = land.rows * land.cell_y * scale;
    const auto color = [&](Point point) {
        const auto sample = [](double metres, double cell, int count) {
            return std::clamp(static_cast<int>(metres / cell), 0, count - 1);
        };
        const int i = sample((point.x - corner.x) / scale, land.cell_x, land.columns);
        const int j = sample((corner.y - point.y) / scale, land.cell_y, land.rows);
        const double light = std::pow(0.08 + 0.92 * brightness(land, i, j), 0.8);
        return Color{0.96 * light, 0.94 * light, 0.88 * light};
    };
    figure.raster({corner.x, corner.y - height}, width, height, color);
    figure.text({corner.x, corner.y - height - 12}, title, kText, kInk, Anchor::left);
}

void draw_scale_bar(Figure& figure, Point left, double scale, double width) {
    const double length = tick_step(width, 4);
    const Point right{left.x + length * scale, left.y};
    figure.line({left, right}, kInk, 2.0);
    figure.text(
        {right.x + 8, left.y},
        length >= 1000.0 ? significant<3>(length / 1000.0) + " km" : significant<3>(length) + " m",
        kSmall, kInk, Anchor::left);
}

}  // namespace ocean::app
