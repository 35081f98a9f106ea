// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "waves/query/query_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace ocean {
namespace {

/// Sums over a row of modes; rows are added in order.
struct BoundSums {
    double displacement = 0.0;          // sum of |h0| k coth(kd)/k
    double displacement_squares = 0.0;  // sum of the squares
    double lacking = 0.0;               // |h0|^2 of the modes, or aliases, that are not shown

    void add(const BoundSums& other) {
        displacement += other.displacement;
        displacement_squares += other.displacement_squares;
        lacking += other.lacking;
    }
};

/// Returns (n / (R - n))^8, the energy of a mode's alias relative to the mode, along one axis of a
/// spline of R samples.
double alias_energy(int n, int spline) {
    const double ratio = static_cast<double>(n) / (spline - n);
    return std::pow(ratio * ratio, 4);
}

}  // namespace

QueryBounds query_bounds(const Modes& modes, int band, int spline, bool exact, ThreadPool& pool) {
    BoundSums total;
    for (const CascadeModes& cascade : modes.cascades) {
        const int size = cascade.lattice.resolution;
        const double step = cascade.lattice.wavenumber_step();
        const int half = size / 2;
        std::vector<double> alias(static_cast<std::size_t>(half), 1.0);
        std::vector<char> held(static_cast<std::size_t>(half), 0);
        for (int n = 0; n < half && n * cascade.divisor < band / 2; ++n) {
            alias[static_cast<std::size_t>(n)] = alias_energy(n * cascade.divisor, spline);
            held[static_cast<std::size_t>(n)] = 1;
        }
        std::vector<BoundSums> rows(static_cast<std::size_t>(2 * half - 1));
        pool.for_each_range(2 * half - 1, [&](int first, int last) {
            for (int row = first; row < last; ++row) {
                BoundSums& sums = rows[static_cast<std::size_t>(row)];
                const int m = row - half + 1;
                const auto y = static_cast<std::size_t>(std::abs(m));
                for (int n = -half + 1; n < half; ++n) {
                    const auto x = static_cast<std::size_t>(std::abs(n));
                    const std::size_t at = mode_index(n, m, size);
                    const auto energy = static_cast<double>(std::norm(cascade.h0[at]));
                    if (held[x] == 0 || held[y] == 0) {
                        sums.lacking += energy;
                        continue;
                    }
                    if (!exact) sums.lacking += energy * (alias[x] + alias[y]);
                    const double k = step * std::sqrt(static_cast<double>(n * n + m * m));
                    const double part = k * static_cast<double>(cascade.displacement[at]);
                    const double square = energy * part * part;
                    sums.displacement_squares += square;
                    sums.displacement += std::sqrt(square);
                }
            }
        });
        for (const BoundSums& row : rows) total.add(row);
    }
    // h(k, t) has both h0(k) and conj(h0(-k)).
    return {1.0001 * std::min(8.0 * std::sqrt(2.0 * total.displacement_squares),
                              2.0 * total.displacement),
            std::sqrt(2.0 * total.lacking)};
}

}  // namespace ocean
