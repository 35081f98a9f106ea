// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The law of a coast across the shore line: depths, heights and masks as functions of the distance.
// It uses only polynomials, quotients and square roots, so that all machines get the same bits.
#pragma once

#include <algorithm>
#include <cmath>

#include "field/ease.hpp"
#include "ocean/internal/shoreline_profile.hpp"

namespace ocean {

/// A bed that falls by `slope` down to 4/5 of the depth `closure`, and by `outer` from 6/5 of this
/// depth on.
struct BedLaw {
    double slope;
    double closure;  // [m]
    double outer;

    /// Returns the depth at a distance from the shore [m].
    double depth(double x) const {
        const double begin = 0.8 * closure / slope, length = 0.4 * closure / slope;
        return slope * x - (slope - outer) * length * ease_integral((x - begin) / length);
    }
};

inline constexpr BedLaw kExposedBed{.slope = 0.16, .closure = 7.0, .outer = 1.0 / 40.0};

class ShorelineLaw {
  public:
    ShorelineLaw(const ShorelineSettings& settings, double cell)
        : settings_(settings),
          cell_(cell),
          sheltered_{.slope = settings.beach_slope,
                     .closure = settings.closure,
                     .outer = std::min(1.0 / 90.0, 0.5 * settings.beach_slope)} {}

    /// Returns the height above the level [m], where z is the land's own height, d the signed
    /// distance from the shore [m] and b the shelter.
    double height(double z, double d, double b) const {
        return d > 0.0 ? land(z, d, b) : -depth(z, -d, b);
    }

    /// Returns the share of sand: the beach's share of the profile.
    double beach(double d, double b) const {
        const double end = settings_.closure / settings_.beach_slope;
        return d > 0.0 ? b * on_beach(d) : b * (1.0 - ease(0.5 * end, end, -d));
    }

    /// Returns the share of a cliff: 1 at a shore, 0 inland and out at sea.
    double cliff(double d) const {
        return d > 0.0 ? 1.0 - ease(25.0, 75.0, d) : 1.0 - ease(0.0, 20.0, -d);
    }

  private:
    double on_beach(double y) const {
        return 1.0 - ease(0.35 * settings_.width, settings_.width, y);
    }

    double depth(double z, double x, double b) const {
        const double bed =
            b * on_shelf(sheltered_.depth(x)) + (1.0 - b) * on_shelf(kExposedBed.depth(x));
        const double far = ease(900.0, 2600.0, x);
        return (1.0 - far) * bed + far * std::max(-z, 0.8 * settings_.shelf);
    }
    /// Returns a depth softly limited by the shelf: depth / (1 + (depth / shelf)^4)^(1/4).
    double on_shelf(double depth) const {
        const double u = depth / settings_.shelf;
        return depth / std::sqrt(std::sqrt(1.0 + u * u * u * u));
    }

    double land(double z, double y, double b) const {
        // The face rises as 1 - exp(-t), by the reciprocal of the first terms of exp(t).
        const double t = settings_.face * y / settings_.berm;
        const double grown = t * (1.0 + t * (1.0 / 2 + t * (1.0 / 6 + t / 24)));
        const double beach = settings_.berm * (grown / (1.0 + grown)) + 0.012 * y;
        // All land is above the water. A beach removes higher land and fills little.
        const double own = std::max(z, 0.25 * std::min(y, 12.0));
        const double hold = b * on_beach(y);
        const double inland =
            hold * std::min(beach, std::max(own, 0.3 * beach)) + (1.0 - hold) * own;
        // The water line between two samples is located as if the ground were straight between
        // them.
        const double line = y * (b * sheltered_.slope + (1.0 - b) * kExposedBed.slope);
        const double away = ease(0.75 * cell_, 2.25 * cell_, y);
        return (1.0 - away) * line + away * inland;
    }

    ShorelineSettings settings_;
    double cell_;  // [m]
    BedLaw sheltered_;
};

}  // namespace ocean
