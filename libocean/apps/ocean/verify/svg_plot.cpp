// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "svg_plot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "plot/figure.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

/// An axis: from numbers to units of the picture.
struct Axis {
    bool logarithmic;
    double from, to;  // of the picture
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    double scaled(double value) const {
        return logarithmic ? std::log10(std::max(value, 1e-300)) : value;
    }
    void hold(double value) {
        if (logarithmic && !(value > 0.0)) return;
        low = std::min(low, scaled(value));
        high = std::max(high, scaled(value));
    }
    /// Leaves a margin, and makes room where all numbers are one.
    void widen() {
        const double margin =
            high > low ? 0.05 * (high - low) : std::max(0.1 * std::abs(high), 1e-9);
        low -= margin;
        high += margin;
    }
    double at(double value) const {
        return from + (scaled(value) - low) / (high - low) * (to - from);
    }
    struct Tick {
        double value;
        std::string label;
    };
    std::vector<Tick> ticks() const {
        std::vector<Tick> all;
        if (logarithmic) {
            const double decades = high - low;
            const std::vector<int> factors = decades > 1.5   ? std::vector{1}
                                             : decades > 0.7 ? std::vector{1, 2, 5}
                                                             : std::vector{1, 2, 3, 4, 5, 6, 8};
            const int every = decades > 5.0 ? 2 : 1;
            for (int power = static_cast<int>(std::floor(low)); power <= high; power += every) {
                const double unit = std::pow(10.0, power);
                for (const int factor : factors) {
                    const double at = std::log10(factor * unit);
                    if (at < low || at > high) continue;
                    all.push_back({factor * unit, tick_label(factor * unit, unit)});
                }
            }
            return all;
        }
        const double step = tick_step(high - low, 5);
        for (double n = std::ceil(low / step); n * step <= high; n += 1.0) {
            all.push_back({n * step, tick_label(n == 0.0 ? 0.0 : n * step, step)});
        }
        return all;
    }
};

constexpr double kWidth = 480.0, kHeight = 300.0;
constexpr double kLeft = 64.0, kRight = 14.0, kTop = 26.0, kBottom = 46.0;

std::string line(double x1, double y1, double x2, double y2, const char* look) {
    return format_text("<line class=\"%s\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>", look,
                       x1, y1, x2, y2);
}

std::string label(double x, double y, const char* look, const std::string& text,
                  const char* more = "") {
    return format_text("<text class=\"%s\" x=\"%.1f\" y=\"%.1f\"%s>", look, x, y, more) +
           html_text(text) + "</text>";
}

std::string legend(bool has_curve) {
    std::string svg =
        format_text("<circle class=\"measured\" cx=\"%.1f\" cy=\"12\" r=\"3.2\"/>", kLeft + 6.0) +
        label(kLeft + 16.0, 16.0, "tick", "libocean");
    if (has_curve) {
        svg += line(kLeft + 88.0, 12.0, kLeft + 108.0, 12.0, "curve") +
               label(kLeft + 114.0, 16.0, "tick", "reference");
    }
    return svg;
}

}  // namespace

std::string html_text(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        escaped += c == '<'   ? "&lt;"
                   : c == '>' ? "&gt;"
                   : c == '&' ? "&amp;"
                   : c == '"' ? "&quot;"
                              : std::string(1, c);
    }
    return escaped;
}

std::string svg_plot(const verify::Plot& plot) {
    Axis x{plot.logarithmic, kLeft, kWidth - kRight};
    Axis y{plot.logarithmic, kHeight - kBottom, kTop};
    for (const auto* points : {&plot.curve, &plot.measured}) {
        for (const verify::Point& point : *points) {
            x.hold(point.x);
            y.hold(point.y - point.error);
            y.hold(point.y + point.error);
        }
    }
    x.widen();
    y.widen();
    std::string svg =
        format_text("<svg viewBox=\"0 0 %g %g\" role=\"img\"><title>", kWidth, kHeight) +
        html_text(plot.title + ": " + plot.y_label + " over " + plot.x_label) + "</title>";
    for (const auto& [value, text] : x.ticks()) {
        svg += line(x.at(value), kTop, x.at(value), kHeight - kBottom, "grid") +
               label(x.at(value), kHeight - kBottom + 16.0, "tick middle", text);
    }
    for (const auto& [value, text] : y.ticks()) {
        svg += line(kLeft, y.at(value), kWidth - kRight, y.at(value), "grid") +
               label(kLeft - 6.0, y.at(value) + 4.0, "tick end", text);
    }
    svg += label(0.5 * (kLeft + kWidth - kRight), kHeight - 8.0, "tick middle", plot.x_label);
    const double middle = 0.5 * (kTop + kHeight - kBottom);
    svg += label(14.0, middle, "tick middle", plot.y_label,
                 format_text(" transform=\"rotate(-90 14 %.1f)\"", middle).c_str());
    if (!plot.curve.empty()) {
        svg += "<polyline class=\"curve\" points=\"";
        for (const verify::Point& point : plot.curve) {
            svg += format_text("%.1f,%.1f ", x.at(point.x), y.at(point.y));
        }
        svg += "\"/>";
    }
    for (const verify::Point& point : plot.measured) {
        const double at = x.at(point.x);
        if (point.error > 0.0) {
            svg += line(at, y.at(point.y - point.error), at, y.at(point.y + point.error), "bar");
        }
        svg += format_text("<circle class=\"measured\" cx=\"%.1f\" cy=\"%.1f\" r=\"3.2\"/>", at,
                           y.at(point.y));
    }
    return svg + legend(!plot.curve.empty()) + "</svg>";
}

}  // namespace ocean::app
