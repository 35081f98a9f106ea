// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See plots.hpp.
#include "plots.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "land_panels.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

constexpr Color kTile{0.05, 0.27, 0.44};
constexpr double kGood = 0.05;  // of log10 of the density

LogAxes density_axes(std::span<const TerrainRing> rings, const Box& box) {
    double low = 1e300, high = -1e300;
    for (const TerrainRing& ring : rings) {
        const double asked = std::log10(ring.asked);
        low = std::min(low, asked - ring.scatter);
        high = std::max(high, asked + ring.scatter);
    }
    const double first = std::log10(rings.front().wavenumber);
    const double last = std::log10(rings.back().wavenumber);
    const double margin = 0.03 * (last - first);
    return {box, first - margin, last + margin, std::floor(low - 0.1), std::ceil(high + 0.1)};
}

/// Draws a band between mean - scatter and mean + scatter of the seeds, relative to `base`.
template <typename Base>
void draw_band(Figure& figure, const LogAxes& axes, std::span<const TerrainRing> rings,
               const Base& base) {
    std::vector<Point> band, upper;
    for (const TerrainRing& ring : rings) {
        const double x = std::log10(ring.wavenumber);
        const double y = std::log10(ring.mean) - base(ring);
        band.push_back(axes.place(x, y - ring.scatter));
        upper.push_back(axes.place(x, y + ring.scatter));
    }
    band.insert(band.end(), upper.rbegin(), upper.rend());
    figure.area(band, kTerrainFill);
}

void draw_legend(Figure& figure, const LogAxes& axes, int seeds) {
    const double x = axes.box.left + 18;
    double y = axes.box.bottom - 62;
    figure.line({{x, y}, {x + 26, y}}, kTerrain, 2.2);
    figure.text({x + 34, y}, "asked by the law", kText, kInk, Anchor::left);
    y += 20;
    figure.circle({x + 13, y}, 3.0, kTile, 1.6);
    figure.text({x + 34, y}, "this tile", kText, kInk, Anchor::left);
    y += 20;
    figure.area({{x, y - 6}, {x + 26, y - 6}, {x + 26, y + 6}, {x, y + 6}}, kTerrainFill);
    figure.text({x + 34, y}, format_text("mean of %d seeds, and the scatter of one", seeds), kText,
                kInk, Anchor::left);
}

void draw_density(Figure& figure, std::span<const TerrainRing> rings, const LogAxes& axes,
                  int seeds) {
    draw_decades(figure, axes);
    draw_wavelengths(figure, axes, false);
    draw_band(figure, axes, rings, [](const TerrainRing&) { return 0.0; });
    std::vector<Point> asked;
    for (const TerrainRing& ring : rings) {
        asked.push_back(axes.place(std::log10(ring.wavenumber), std::log10(ring.asked)));
    }
    figure.line(asked, kTerrain, 2.2);
    for (const TerrainRing& ring : rings) {
        if (ring.tile <= 0.0) continue;
        figure.circle(axes.place(std::log10(ring.wavenumber), std::log10(ring.tile)), 3.0, kTile,
                      1.6);
    }
    axes.frame(figure);
    draw_legend(figure, axes, seeds);
}

void draw_errors(Figure& figure, std::span<const TerrainRing> rings, const LogAxes& density,
                 const Box& box) {
    constexpr double kRange = 0.3;
    const LogAxes axes{box, density.left, density.right, -kRange, kRange};
    draw_wavelengths(figure, axes, true);
    for (const double value : {-0.2, 0.0, 0.2}) {
        const double y = axes.place(axes.left, value).y;
        figure.line({{box.left, y}, {box.right, y}}, kFaint, 0.8);
        figure.text({box.left - 8, y}, tick_label(value, 0.2), kText, kInk, Anchor::right);
    }
    for (const double value : {-kGood, kGood}) {
        const double y = axes.place(axes.left, value).y;
        figure.dashed_line({{box.left, y}, {box.right, y}}, kInk, 0.6);
    }
    const auto asked = [](const TerrainRing& ring) { return std::log10(ring.asked); };
    draw_band(figure, axes, rings, asked);
    std::vector<Point> line;
    for (const TerrainRing& ring : rings) {
        line.push_back(
            axes.place(std::log10(ring.wavenumber), std::log10(ring.mean) - asked(ring)));
        if (ring.tile <= 0.0) continue;
        figure.circle(axes.place(std::log10(ring.wavenumber), std::log10(ring.tile) - asked(ring)),
                      2.4, kTile, 1.2);
    }
    figure.line(line, kTerrain, 1.6);
    axes.frame(figure);
    figure.text({0.5 * (box.left + box.right), box.bottom + 34}, "wavelength", kText, kInk);
    figure.text({box.left - 52, 0.5 * (box.top + box.bottom)}, "log10 error", kText, kInk,
                Anchor::center, true);
}

void draw_tile(Figure& figure, Terrain& land, const Box& box) {
    const Surface surface = land.surface({Channel::height});
    const int side = surface.resolution();
    const double cell = surface.period() / side;
    const double scale = (box.right - box.left) / surface.period();
    const Heights heights{surface.channel(Channel::height), side, side, side, cell, cell};
    draw_relief(figure, heights, {box.left, box.bottom}, scale,
                "the tile, seed " + std::to_string(land.model().seed));
    draw_scale_bar(figure, {box.left, box.bottom + 16.0}, scale, surface.period());
}

}  // namespace

std::string plot_terrain(Terrain& land, std::span<const TerrainRing> rings, int seeds,
                         const std::string& name) {
    const TerrainState state = land.state();
    Figure figure(1150.0, 660.0, 1.5);
    figure.text({82, 30}, name, 17.0, kInk, Anchor::left, false, true);
    figure.text({82, 54},
                format_text("cell %.4g m     rms %.4g m     slopes of 50, 90, 99 %%: %.1f, %.1f, "
                            "%.1f\u00b0     seed %u",
                            state.cell, state.rms.resolved, state.slope_angles[0].resolved,
                            state.slope_angles[1].resolved, state.slope_angles[2].resolved,
                            land.model().seed),
                13.5, kInk, Anchor::left);
    if (rings.empty()) {
        figure.text({390, 280}, "flat: no waves", kText, kInk);
        return figure.png();
    }
    const LogAxes axes = density_axes(rings, {82, 84, 700, 460});
    draw_density(figure, rings, axes, seeds);
    draw_errors(figure, rings, axes, {82, 480, 700, 600});
    draw_tile(figure, land, {750, 102, 1110, 462});
    return figure.png();
}

}  // namespace ocean::app
