// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The panels that plots of land share: a density over logarithmic wavenumbers, and a shaded relief.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>

#include "figure.hpp"
#include "spectrum_panels.hpp"

namespace ocean::app {

inline constexpr Color kTerrain{0.85, 0.42, 0.10};
inline constexpr Color kTerrainFill{0.95, 0.60, 0.25, 0.35};

/// Axes of a panel whose numbers are logarithms to the base of 10.
struct LogAxes {
    Box box;
    double left, right;  // log10 of the wavenumber [rad/m]
    double low, high;    // of the panel's own value

    Point place(double x, double y) const {
        const double part = (y - low) / (high - low);
        return {box.left + (x - left) / (right - left) * (box.right - box.left),
                box.bottom - std::clamp(part, 0.0, 1.0) * (box.bottom - box.top)};
    }
    /// Draws the frame of the panel.
    void frame(Figure& figure) const;
};

/// Draws lines of round wavelengths, 1, 2 and 5 times each power of ten, with their lengths below.
void draw_wavelengths(Figure& figure, const LogAxes& axes, bool labels);
/// Draws a line for each power of ten of a density [m^4].
void draw_decades(Figure& figure, const LogAxes& axes);

/// Heights on a grid, with their cell.
struct Heights {
    std::span<const float> values;
    int columns, rows, stride;
    double cell_x, cell_y;

    double at(int i, int j) const {
        return double{values[static_cast<std::size_t>(j) * static_cast<std::size_t>(stride) +
                             static_cast<std::size_t>(i)]};
    }
};

/// Draws a shaded relief of `scale` points per metre with its left bottom corner at `corner`.
void draw_relief(Figure& figure, const Heights& land, Point corner, double scale,
                 const std::string& title);
/// Draws a bar of a round length below a relief that is `width` metres wide.
void draw_scale_bar(Figure& figure, Point left, double scale, double width);

}  // namespace ocean::app
