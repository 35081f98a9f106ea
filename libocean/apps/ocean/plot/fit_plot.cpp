// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See plots.hpp.
#include "plots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "land_panels.hpp"
#include "ocean/terrain.hpp"
#include "spectrum_panels.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

constexpr Color kLand{0.05, 0.27, 0.44};

LogAxes density_axes(const TerrainFit& fit, const Box& box) {
    double low = 1e300, high = -1e300;
    for (const FittedRing& ring : fit.rings) {
        low = std::min({low, std::log10(ring.density), std::log10(ring.model) - ring.scatter});
        high = std::max({high, std::log10(ring.density), std::log10(ring.model) + ring.scatter});
    }
    const double first = std::log10(fit.rings.front().wavenumber);
    const double last = std::log10(fit.rings.back().wavenumber);
    const double margin = 0.03 * (last - first);
    return {box, first - margin, last + margin, std::floor(low - 0.1), std::ceil(high + 0.1)};
}

void draw_density(Figure& figure, const TerrainFit& fit, const LogAxes& axes) {
    draw_decades(figure, axes);
    draw_wavelengths(figure, axes, false);
    std::vector<Point> model, upper, band;
    for (const FittedRing& ring : fit.rings) {
        const double x = std::log10(ring.wavenumber), y = std::log10(ring.model);
        model.push_back(axes.place(x, y));
        band.push_back(axes.place(x, y - ring.scatter));
        upper.push_back(axes.place(x, y + ring.scatter));
    }
    band.insert(band.end(), upper.rbegin(), upper.rend());
    figure.area(band, kTerrainFill);
    figure.line(model, kTerrain, 2.2);
    for (const FittedRing& ring : fit.rings) {
        figure.circle(axes.place(std::log10(ring.wavenumber), std::log10(ring.density)), 3.0, kLand,
                      1.6);
    }
    axes.frame(figure);
    const double x = axes.box.left + 18;
    double y = axes.box.bottom - 42;
    figure.circle({x + 13, y}, 3.0, kLand, 1.6);
    figure.text({x + 34, y}, "elevation model", kText, kInk, Anchor::left);
    y += 20;
    figure.area({{x, y - 6}, {x + 26, y - 6}, {x + 26, y + 6}, {x, y + 6}}, kTerrainFill);
    figure.line({{x, y}, {x + 26, y}}, kTerrain, 2.2);
    figure.text({x + 34, y}, "terrain: mean of its seeds, and the scatter of one", kText, kInk,
                Anchor::left);
}

void draw_residuals(Figure& figure, const TerrainFit& fit, const LogAxes& density, const Box& box) {
    constexpr double kRange = 0.3;
    const LogAxes axes{box, density.left, density.right, -kRange, kRange};
    const double good = 0.05;
    figure.area({axes.place(axes.left, -good), axes.place(axes.right, -good),
                 axes.place(axes.right, good), axes.place(axes.left, good)},
                {0.2, 0.55, 0.3, 0.15});
    draw_wavelengths(figure, axes, true);
    for (const double value : {-0.2, 0.0, 0.2}) {
        const double y = axes.place(axes.left, value).y;
        figure.line({{box.left, y}, {box.right, y}}, kFaint, 0.8);
        figure.text({box.left - 8, y}, tick_label(value, 0.2), kText, kInk, Anchor::right);
    }
    std::vector<Point> line;
    for (const FittedRing& ring : fit.rings) {
        line.push_back(axes.place(std::log10(ring.wavenumber), ring.residual()));
    }
    figure.line(line, kTerrain, 1.6);
    axes.frame(figure);
    figure.text({0.5 * (box.left + box.right), box.bottom + 34}, "wavelength", kText, kInk);
    figure.text({box.left - 52, 0.5 * (box.top + box.bottom)}, "log10 error", kText, kInk,
                Anchor::center, true);
}

/// The place of the two reliefs, one above the other.
struct ReliefLayout {
    Point corner;  // left top
    double width, height;
    double scale;  // [points per metre]
};

constexpr double kBetween = 36.0;  // space for a title

ReliefLayout relief_layout(const ElevationModel& bed, const Box& box) {
    const double width = bed.domain.samples[0] * bed.domain.step(0);
    const double height = bed.domain.samples[1] * bed.domain.step(1);
    const double each = 0.5 * (box.bottom - box.top) - kBetween;
    const double scale = std::min((box.right - box.left) / width, each / height);
    return {{box.left, box.top}, width * scale, height * scale, scale};
}

void draw_reliefs(Figure& figure, const ElevationModel& bed, const TerrainFit& fit,
                  const ReliefLayout& layout, int threads) {
    const Domain& domain = bed.domain;
    const Heights land{bed.heights,       domain.samples[0], domain.samples[1],
                       domain.samples[0], domain.step(0),    domain.step(1)};
    Terrain made(fit.terrain, {.threads = threads});
    const Surface surface = made.surface({Channel::height});
    const int n = fit.terrain.resolution;
    const auto cells = [&](double points) {
        return std::min(n, static_cast<int>(std::lround(points / layout.scale / fit.cell)));
    };
    const Heights terrain{surface.channel(Channel::height),
                          cells(layout.width),
                          cells(layout.height),
                          n,
                          fit.cell,
                          fit.cell};
    const double left = layout.corner.x;
    const double first = layout.corner.y + 18.0 + layout.height;
    const double second = first + kBetween + layout.height;
    draw_relief(figure, land, {left, first}, layout.scale, "elevation model");
    draw_relief(figure, terrain, {left, second}, layout.scale,
                "terrain, seed " + std::to_string(fit.terrain.seed));
    draw_scale_bar(figure, {left, second + 16.0}, layout.scale, layout.width / layout.scale);
}

}  // namespace

std::string plot_fit(const ElevationModel& bed, const TerrainFit& fit, const std::string& name,
                     int threads) {
    const ReliefLayout reliefs = relief_layout(bed, {750, 84, 1200, 640});
    const double width = std::max(1000.0, reliefs.corner.x + reliefs.width + 40.0);
    Figure figure(width, 660.0, 1.5);
    figure.text({82, 30}, name, 17.0, kInk, Anchor::left, false, true);
    figure.text(
        {82, 54},
        format_text("cell %.4g m     rms %.4g m, terrain %.4g m     slopes of 50, 90, 99 %%: "
                    "%.1f, %.1f, %.1f\u00b0, terrain %.1f, %.1f, %.1f\u00b0",
                    fit.cell, fit.bed.rms, fit.model.rms, fit.bed.slopes[0], fit.bed.slopes[1],
                    fit.bed.slopes[2], fit.model.slopes[0], fit.model.slopes[1],
                    fit.model.slopes[2]),
        13.5, kInk, Anchor::left);
    const LogAxes axes = density_axes(fit, {82, 84, 700, 460});
    draw_density(figure, fit, axes);
    draw_residuals(figure, fit, axes, {82, 480, 700, 600});
    draw_reliefs(figure, bed, fit, reliefs, threads);
    return figure.png();
}

}  // namespace ocean::app
