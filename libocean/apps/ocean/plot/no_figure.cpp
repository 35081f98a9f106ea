// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// In the place of figure.cpp in programs without cairo: no figure can be made.
#include "figure.hpp"
#include "ocean/error.hpp"

namespace ocean::app {

Figure::Figure(double, double, double)
    : scale_(0.0), surface_(nullptr, nullptr), context_(nullptr, nullptr) {
    throw Error(ErrorKind::output, "no plot: this program was built without cairo");
}

void Figure::line(const std::vector<Point>&, Color, double) {}
void Figure::dashed_line(const std::vector<Point>&, Color, double) {}
void Figure::area(const std::vector<Point>&, Color) {}
void Figure::circle(Point, double, Color, double) {}
void Figure::arrow(Point, Point, Color, double) {}
void Figure::text(Point, const std::string&, double, Color, Anchor, bool, bool, bool) {}
void Figure::paint_pixels(Point, int, int, const std::vector<Color>&) {}
std::string Figure::png() const {
    return {};
}

}  // namespace ocean::app
