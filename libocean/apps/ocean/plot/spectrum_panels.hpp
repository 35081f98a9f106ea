// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The two panels of the spectrum's plot, and their common data.
#pragma once

#include <vector>

#include "figure.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/sea_state.hpp"

namespace ocean::app {

inline constexpr Color kInk{0.13, 0.15, 0.18};
inline constexpr Color kFaint{0.13, 0.15, 0.18, 0.14};
inline constexpr double kText = 12.5;  // [points]
inline constexpr double kSmall = 10.5;
inline constexpr double kDegrees = 180.0 / kPi;

struct Picture {
    const DirectionalSpectrum& spectrum;
    const Parameters& parameters;
    const SeaState& state;
    double highest;                    // frequency of the left panel's end [Hz]
    const std::vector<double>& steps;  // [m^2/Hz], resolved by the grid, evenly over [0, highest]
    double rim;                        // frequency of the right panel's rim [Hz]
};

struct Box {
    double left, top, right, bottom;
};

struct Dial {
    Point center;
    double radius;
};

/// Draws S(f) as asked and as resolved.
void draw_frequency_panel(Figure& figure, const Box& box, const Picture& picture);
/// Draws E(f, theta) around the compass, with its colour scale.
void draw_direction_panel(Figure& figure, const Dial& dial, const Box& scale,
                          const Picture& picture);

}  // namespace ocean::app
