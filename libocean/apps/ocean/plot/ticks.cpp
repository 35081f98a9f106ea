// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers along the axes of a figure. See figure.hpp.
#include <algorithm>
#include <cmath>

#include "figure.hpp"
#include "text.hpp"

namespace ocean::app {

double tick_step(double range, int count) {
    if (!(range > 0.0)) return 1.0;
    const double raw = range / count;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (raw <= factor * power * 1.0001) return factor * power;
    }
    return 10.0 * power;
}

std::string tick_label(double value, double step) {
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    return format_text("%.*f", std::min(decimals, 9), value);
}

}  // namespace ocean::app
