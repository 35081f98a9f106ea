// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The left panel of the spectrum's plot: variance density over frequency, asked and resolved.
#include <algorithm>
#include <cmath>

#include "ocean/internal/grid.hpp"
#include "spectrum_panels.hpp"
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

}  // namespace ocean::app
