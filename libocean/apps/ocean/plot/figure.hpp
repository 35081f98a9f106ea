// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A page drawn by cairo: lines, texts and axes in points, and the PNG file as bytes. It is
// independent of the sea.
#pragma once

#include <memory>
#include <string>
#include <vector>

// As <cairo.h> has them: figure.cpp alone needs cairo.
typedef struct _cairo cairo_t;
typedef struct _cairo_surface cairo_surface_t;

namespace ocean::app {

struct Point {
    double x;
    double y;
};

struct Color {
    double red;
    double green;
    double blue;
    double alpha = 1.0;
};

/// The position of a text relative to its point.
enum class Anchor { left, center, right };

class Figure {
  public:
    /// Makes a white page with `scale` pixels per point.
    Figure(double width, double height, double scale);

    void line(const std::vector<Point>& points, Color color, double width);
    void dashed_line(const std::vector<Point>& points, Color color, double width);
    void area(const std::vector<Point>& points, Color fill);
    void circle(Point center, double radius, Color color, double width);
    /// Draws an arrow from tail to tip.
    void arrow(Point tail, Point tip, Color color, double width);
    /// Draws a text of `size` [points], centred vertically; a `turned` text reads upwards. A halo
    /// keeps it legible on colours.
    void text(Point point, const std::string& text, double size, Color color,
              Anchor anchor = Anchor::center, bool turned = false, bool bold = false,
              bool halo = false);
    /// Paints `color(point)` on a rectangle at the page's own resolution.
    template <typename ColorOf>
    void raster(Point corner, double width, double height, const ColorOf& color_of);

    /// Returns the bytes of a PNG file. Throws Error output.
    std::string png() const;

  private:
    void path(const std::vector<Point>& points);
    void source(Color color);
    void paint_pixels(Point corner, int columns, int rows, const std::vector<Color>& pixels);

    double scale_;
    std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
    std::unique_ptr<cairo_t, void (*)(cairo_t*)> context_;
};

/// Returns 1, 2 or 5 times a power of ten, so that `range` has about `count` steps.
double tick_step(double range, int count);
/// Returns the number without trailing zeros.
std::string tick_label(double value, double step);

template <typename ColorOf>
void Figure::raster(Point corner, double width, double height, const ColorOf& color_of) {
    const int columns = static_cast<int>(width * scale_);
    const int rows = static_cast<int>(height * scale_);
    std::vector<Color> pixels;
    pixels.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            pixels.push_back(
                color_of({corner.x + (i + 0.5) / scale_, corner.y + (j + 0.5) / scale_}));
        }
    }
    paint_pixels(corner, columns, rows, pixels);
}

}  // namespace ocean::app
