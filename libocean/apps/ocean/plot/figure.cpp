// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See figure.hpp.
#include "figure.hpp"

#include <cairo.h>

#include <cmath>
#include <cstdint>

#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "text.hpp"

namespace ocean::app {

Figure::Figure(double width, double height, double scale)
    : scale_(scale),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width * scale),
                                          static_cast<int>(height * scale)),
               cairo_surface_destroy),
      context_(cairo_create(surface_.get()), cairo_destroy) {
    cairo_scale(context_.get(), scale, scale);
    cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
    source({1.0, 1.0, 1.0});
    cairo_paint(context_.get());
}

void Figure::source(Color color) {
    cairo_set_source_rgba(context_.get(), color.red, color.green, color.blue, color.alpha);
}

void Figure::path(const std::vector<Point>& points) {
    cairo_new_path(context_.get());
    for (const Point& point : points) cairo_line_to(context_.get(), point.x, point.y);
}

void Figure::line(const std::vector<Point>& points, Color color, double width) {
    path(points);
    source(color);
    cairo_set_line_width(context_.get(), width);
    cairo_stroke(context_.get());
}

void Figure::dashed_line(const std::vector<Point>& points, Color color, double width) {
    const double dashes[] = {3.0 * width, 3.0 * width};
    cairo_set_dash(context_.get(), dashes, 2, 0.0);
    line(points, color, width);
    cairo_set_dash(context_.get(), nullptr, 0, 0.0);
}

void Figure::area(const std::vector<Point>& points, Color fill) {
    path(points);
    cairo_close_path(context_.get());
    source(fill);
    cairo_fill(context_.get());
}

void Figure::circle(Point center, double radius, Color color, double width) {
    cairo_new_path(context_.get());
    cairo_arc(context_.get(), center.x, center.y, radius, 0.0, kTwoPi);
    source(color);
    cairo_set_line_width(context_.get(), width);
    cairo_stroke(context_.get());
}

void Figure::arrow(Point tail, Point tip, Color color, double width) {
    const double angle = std::atan2(tip.y - tail.y, tip.x - tail.x);
    const double head = 5.0 * width;
    const auto barb = [&](double turn) {
        return Point{tip.x - head * std::cos(angle + turn), tip.y - head * std::sin(angle + turn)};
    };
    const double shaft = 0.8 * head;  // the line ends inside the head, so that the tip stays sharp
    line({tail, {tip.x - shaft * std::cos(angle), tip.y - shaft * std::sin(angle)}}, color, width);
    area({tip, barb(0.45), barb(-0.45)}, color);
}

void Figure::text(Point point, const std::string& text, double size, Color color, Anchor anchor,
                  bool turned, bool bold, bool halo) {
    cairo_t* const context = context_.get();
    cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, size);
    cairo_text_extents_t extents;
    cairo_text_extents(context, text.c_str(), &extents);
    const double share = anchor == Anchor::left ? 0.0 : anchor == Anchor::center ? 0.5 : 1.0;
    cairo_save(context);
    cairo_translate(context, point.x, point.y);
    if (turned) cairo_rotate(context, -kPi / 2.0);
    // Digits and capitals are about 0.72 of the size high; centring that height looks right.
    cairo_move_to(context, -share * extents.x_advance, 0.36 * size);
    cairo_text_path(context, text.c_str());
    if (halo) {
        source({1.0, 1.0, 1.0, 0.8});
        cairo_set_line_width(context, 0.3 * size);
        cairo_stroke_preserve(context);
    }
    source(color);
    cairo_fill(context);
    cairo_restore(context);
}

void Figure::paint_pixels(Point corner, int columns, int rows, const std::vector<Color>& pixels) {
    const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> image(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, columns, rows), cairo_surface_destroy);
    unsigned char* const data = cairo_image_surface_get_data(image.get());
    if (data == nullptr) throw Error(ErrorKind::out_of_memory, "no memory for a picture");
    const int stride = cairo_image_surface_get_stride(image.get());
    cairo_surface_flush(image.get());
    std::size_t index = 0;
    for (int j = 0; j < rows; ++j) {
        auto* const scanline = reinterpret_cast<std::uint32_t*>(data + j * stride);
        for (int i = 0; i < columns; ++i, ++index) {
            const Color& color = pixels[index];
            const auto byte = [&](double value) {
                return static_cast<std::uint32_t>(std::lround(255.0 * value * color.alpha));
            };
            scanline[i] = (static_cast<std::uint32_t>(std::lround(255.0 * color.alpha)) << 24) |
                          (byte(color.red) << 16) | (byte(color.green) << 8) | byte(color.blue);
        }
    }
    cairo_surface_mark_dirty(image.get());
    cairo_save(context_.get());
    cairo_translate(context_.get(), corner.x, corner.y);
    cairo_scale(context_.get(), 1.0 / scale_, 1.0 / scale_);
    cairo_set_source_surface(context_.get(), image.get(), 0.0, 0.0);
    cairo_paint(context_.get());
    cairo_restore(context_.get());
}

std::string Figure::png() const {
    const auto append = [](void* closure, const unsigned char* data, unsigned int length) {
        static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
        return CAIRO_STATUS_SUCCESS;
    };
    std::string bytes;
    const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), append, &bytes);
    if (status != CAIRO_STATUS_SUCCESS) {
        throw Error(ErrorKind::output, std::string("the picture cannot be encoded: ") +
                                           cairo_status_to_string(status));
    }
    return bytes;
}

}  // namespace ocean::app
