// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The right panel of the spectrum's plot: the directions towards which the waves of each frequency
// travel.
#include <algorithm>
#include <array>
#include <cmath>

#include "ocean/internal/grid.hpp"
#include "spectrum_panels.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

constexpr Color kMean{0.75, 0.10, 0.25};
constexpr Color kWind{0.25, 0.25, 0.28};

/// Returns a colour from white for 0 to the blue of deep water for 1.
Color water_color(double share) {
    constexpr std::array<Color, 6> kStops = {{{1.00, 1.00, 1.00},
                                              {0.80, 0.91, 0.93},
                                              {0.47, 0.76, 0.82},
                                              {0.16, 0.53, 0.68},
                                              {0.07, 0.30, 0.50},
                                              {0.04, 0.09, 0.28}}};
    const double position = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(position), kStops.size() - 2);
    const double part = position - static_cast<double>(below);
    const auto blend = [&](double a, double b) { return a + part * (b - a); };
    const Color& a = kStops[below];
    const Color& b = kStops[below + 1];
    return {blend(a.red, b.red), blend(a.green, b.green), blend(a.blue, b.blue)};
}

Point on_dial(const Dial& dial, double share, double theta) {
    return {dial.center.x + share * dial.radius * std::cos(theta),
            dial.center.y - share * dial.radius * std::sin(theta)};
}

/// Returns the maximal density of the panel [m^2/(Hz deg)].
double draw_density(Figure& figure, const Dial& dial, const Picture& picture) {
    const DirectionalSpectrum& spectrum = picture.spectrum;
    double top = 0.0;
    for (const double value : spectrum.table()) top = std::max(top, value);
    const auto share = [&](Point point) {
        const double x = (point.x - dial.center.x) / dial.radius;
        const double y = (dial.center.y - point.y) / dial.radius;
        const double r = std::hypot(x, y);
        if (r > 1.0 || !(top > 0.0)) return -1.0;
        return spectrum.density(kTwoPi * r * picture.rim, std::atan2(y, x)) / top;
    };
    figure.raster({dial.center.x - dial.radius, dial.center.y - dial.radius}, 2 * dial.radius,
                  2 * dial.radius, [&](Point point) {
                      const double value = share(point);
                      // The square root makes a weak system visible beside a strong one.
                      return value < 0.0 ? Color{1, 1, 1, 0} : water_color(std::sqrt(value));
                  });
    return top * kTwoPi / kDegrees;
}

void draw_dial(Figure& figure, const Dial& dial, double highest) {
    const double step = tick_step(highest, 4);
    for (double f = step; f < highest * 0.97; f += step) {
        figure.circle(dial.center, dial.radius * f / highest, kFaint, 0.8);
        figure.text(on_dial(dial, f / highest, -1.18), tick_label(f, step) + " Hz", kSmall, kInk,
                    Anchor::center, false, false, true);
    }
    for (int degrees = 0; degrees < 360; degrees += 30) {
        figure.line({dial.center, on_dial(dial, 1.0, degrees / kDegrees)}, kFaint, 0.8);
        if (degrees % 90 == 0) continue;
        figure.text(on_dial(dial, 1.09, degrees / kDegrees), format_text("%d\u00b0", degrees), 10.5,
                    kInk);
    }
    figure.circle(dial.center, dial.radius, kInk, 1.0);
    const double gap = dial.radius + 8;
    const Point c = dial.center;
    figure.text({c.x + gap, c.y}, "0\u00b0 east, +x", kText, kInk, Anchor::left);
    figure.text({c.x - gap, c.y}, "180\u00b0 west", kText, kInk, Anchor::right);
    figure.text({c.x, c.y - gap - 8}, "90\u00b0 north, +y", kText, kInk);
    figure.text({c.x, c.y + gap + 8}, "270\u00b0 south", kText, kInk);
}

/// Draws the labels along the rim only, so that they do not cover the spectrum.
void draw_directions(Figure& figure, const Dial& dial, const Picture& picture) {
    constexpr double kFrom = 0.7;
    for (const WaveSystem& waves : picture.parameters.waves) {
        if (waves.spectrum == SpectrumKind::measured || waves.wind_above().value_or(0.0) <= 0.0)
            continue;
        const double theta = waves.direction_degrees() / kDegrees;
        figure.dashed_line({on_dial(dial, kFrom, theta), on_dial(dial, 1.0, theta)}, kWind, 1.6);
        figure.text(on_dial(dial, 0.86, theta + 0.1), "wind", kSmall, kWind, Anchor::center, false,
                    false, true);
    }
    if (!(picture.state.significant_wave_height.asked > 0.0)) return;
    const double theta = picture.state.mean_direction.asked / kDegrees;
    figure.arrow(on_dial(dial, kFrom, theta), on_dial(dial, 1.0, theta), kMean, 2.2);
    figure.text(on_dial(dial, 0.83, theta - 0.13), "mean", kSmall, kMean, Anchor::center, false,
                false, true);
}

void draw_color_scale(Figure& figure, const Box& box, double top) {
    figure.raster({box.left, box.top}, box.right - box.left, box.bottom - box.top, [&](Point p) {
        return water_color((box.bottom - p.y) / (box.bottom - box.top));
    });
    figure.line({{box.left, box.top},
                 {box.right, box.top},
                 {box.right, box.bottom},
                 {box.left, box.bottom},
                 {box.left, box.top}},
                kInk, 0.8);
    // Marks are evenly spaced in colour: a quarter of the scale is a sixteenth of the density.
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double y = box.bottom - share * (box.bottom - box.top);
        figure.line({{box.right, y}, {box.right + 4, y}}, kInk, 0.8);
        figure.text({box.right + 8, y}, format_text("%.2g", share * share * top), kSmall, kInk,
                    Anchor::left);
    }
    figure.text({box.left - 8, box.top - 18}, "E [m\u00b2/(Hz\u00b7deg)]", kSmall, kInk,
                Anchor::center);
}

}  // namespace

void draw_direction_panel(Figure& figure, const Dial& dial, const Box& scale,
                          const Picture& picture) {
    const double top = draw_density(figure, dial, picture);
    draw_dial(figure, dial, picture.rim);
    draw_directions(figure, dial, picture);
    if (top > 0.0) draw_color_scale(figure, scale, top);
    figure.text({dial.center.x, dial.center.y + dial.radius + 52},
                "direction the waves travel to; distance from the centre: frequency", kSmall, kInk);
}

}  // namespace ocean::app
