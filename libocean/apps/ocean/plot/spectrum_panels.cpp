// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The panels of the spectrum's plot: on the left variance density over frequency, asked and
// resolved; on the right the directions towards which the waves of each frequency travel.
#include "spectrum_panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "text.hpp"

namespace ocean::app {
namespace {

constexpr Color kTarget{0.05, 0.27, 0.44};
constexpr Color kResolved{0.85, 0.42, 0.10};
constexpr Color kResolvedFill{0.95, 0.60, 0.25, 0.35};

void draw_axes(Figure& figure, const Box& box, double highest, double top_value) {
    const auto x_of = [&](double f) { return box.left + f / highest * (box.right - box.left); };
    const auto y_of = [&](double s) { return box.bottom - s / top_value * (box.bottom - box.top); };
    const double x_step = tick_step(highest, 8);
    for (double f = 0.0; f <= highest * 1.0001; f += x_step) {
        figure.line({{x_of(f), box.top}, {x_of(f), box.bottom}}, kFaint, 0.8);
        figure.text({x_of(f), box.bottom + 14}, tick_label(f, x_step), kText, kInk);
    }
    const double y_step = tick_step(top_value, 6);
    for (double s = 0.0; s <= top_value * 1.0001; s += y_step) {
        figure.line({{box.left, y_of(s)}, {box.right, y_of(s)}}, kFaint, 0.8);
        figure.text({box.left - 8, y_of(s)}, tick_label(s, y_step), kText, kInk, Anchor::right);
    }
    figure.line({{box.left, box.top}, {box.left, box.bottom}, {box.right, box.bottom}}, kInk, 1.0);
    const double middle = 0.5 * (box.left + box.right);
    figure.text({middle, box.bottom + 36}, "frequency f [Hz]", kText, kInk);
    figure.text({box.left - 58, 0.5 * (box.top + box.bottom)}, "variance density S(f) [m\u00b2/Hz]",
                kText, kInk, Anchor::center, true);
}

/// Draws a second scale of periods on top; the roundest numbers come first, others fill the gaps.
void draw_periods(Figure& figure, const Box& box, double highest) {
    std::vector<double> taken;
    for (const int period : {10, 5, 20, 2, 3, 4, 1, 15, 8, 6, 7, 12, 30}) {
        const double x = box.left + (1.0 / period) / highest * (box.right - box.left);
        const auto close = [x](double other) { return std::abs(x - other) < 26.0; };
        if (x > box.right || std::any_of(taken.begin(), taken.end(), close)) continue;
        figure.line({{x, box.top}, {x, box.top - 4}}, kInk, 0.8);
        figure.text({x, box.top - 12}, std::to_string(period), kSmall, kInk);
        taken.push_back(x);
    }
    figure.line({{box.left, box.top}, {box.right, box.top}}, kInk, 0.5);
    figure.text({box.left - 8, box.top - 12}, "period [s]", kSmall, kInk, Anchor::right);
}

void draw_legend(Figure& figure, const Box& box, const SeaState& state) {
    const double x = box.right - 236;
    double y = box.top + 20;
    figure.line({{x, y}, {x + 26, y}}, kTarget, 2.2);
    figure.text({x + 34, y}, "asked: the spectrum", kText, kInk, Anchor::left, false, false, true);
    y += 20;
    figure.area({{x, y - 6}, {x + 26, y - 6}, {x + 26, y + 6}, {x, y + 6}}, kResolvedFill);
    figure.line({{x, y - 6}, {x + 26, y - 6}}, kResolved, 1.2);
    figure.text({x + 34, y},
                format_text("resolved by the grid: %.1f %%", 100.0 * state.energy_resolved), kText,
                kInk, Anchor::left, false, false, true);
}

}  // namespace

void draw_frequency_panel(Figure& figure, const Box& box, const Picture& picture) {
    constexpr int kCurvePoints = 1500;
    std::vector<double> curve;
    for (int i = 0; i <= kCurvePoints; ++i) {
        curve.push_back(kTwoPi * picture.spectrum.frequency_density(kTwoPi * picture.highest * i /
                                                                    kCurvePoints));
    }
    double top = *std::max_element(curve.begin(), curve.end());
    top = std::max(top, *std::max_element(picture.steps.begin(), picture.steps.end()));
    top = top > 0.0 ? 1.08 * top : 1.0;
    const auto place = [&](double share, double value) {
        return Point{box.left + share * (box.right - box.left),
                     box.bottom - value / top * (box.bottom - box.top)};
    };
    draw_axes(figure, box, picture.highest, top);
    draw_periods(figure, box, picture.highest);

    std::vector<Point> outline = {place(0.0, 0.0)};
    const double count = static_cast<double>(picture.steps.size());
    for (std::size_t i = 0; i < picture.steps.size(); ++i) {
        outline.push_back(place(static_cast<double>(i) / count, picture.steps[i]));
        outline.push_back(place(static_cast<double>(i + 1) / count, picture.steps[i]));
    }
    outline.push_back(place(1.0, 0.0));
    figure.area(outline, kResolvedFill);
    figure.line(outline, kResolved, 1.0);

    std::vector<Point> points;
    for (int i = 0; i <= kCurvePoints; ++i) {
        points.push_back(
            place(static_cast<double>(i) / kCurvePoints, curve[static_cast<std::size_t>(i)]));
    }
    figure.line(points, kTarget, 2.2);
    draw_legend(figure, box, picture.state);
}

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
