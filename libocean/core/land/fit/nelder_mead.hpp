// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Minimises a function of a few numbers without its derivatives.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace ocean {

struct Bounds {
    double lowest;
    double highest;
};

struct Minimum {
    std::vector<double> place;
    double value;
};

/// Returns a local minimum within the bounds near `start` by the simplex of Nelder and Mead [Nelder
/// and Mead 1965]; a point outside counts as the nearest one inside. `steps` are the first sides of
/// the simplex. Ends when the simplex has shrunk to 1e-6 of the bounds, or after 2000 calls.
Minimum minimize(const std::function<double(std::span<const double>)>& function,
                 std::span<const double> start, std::span<const double> steps,
                 std::span<const Bounds> bounds);

}  // namespace ocean
