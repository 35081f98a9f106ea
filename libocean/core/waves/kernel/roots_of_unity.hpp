// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// exp(2 pi i k / R) when the program is compiled, for the codelets.
#pragma once

namespace ocean {

/// cosine[k], sine[k] of 2 pi k / R for k < R, R a power of two >= 8. Rounded from double: reduced
/// exactly to an eighth of a turn, then the Taylor series to x^17.
template <int R>
struct RootsOfUnity {
    float cosine[R];
    float sine[R];

    constexpr RootsOfUnity() : cosine{}, sine{} {
        for (int k = 0; k < R; ++k) {
            const int quarter = (4 * k + R / 2) / R;  // the nearest
            const double x = 6.283185307179586 * (4 * k - quarter * R) / (4.0 * R);
            const double s = series(x, x, 1);
            const double c = series(x, 1.0, 0);
            const double quarters[4][2] = {{c, s}, {-s, c}, {-c, -s}, {s, -c}};
            cosine[k] = static_cast<float>(quarters[quarter % 4][0]);
            sine[k] = static_cast<float>(quarters[quarter % 4][1]);
        }
    }

  private:
    /// term - term x^2 / ((n + 1)(n + 2)) + ...
    static constexpr double series(double x, double term, int n) {
        double sum = 0.0;
        for (; n < 18; n += 2) {
            sum += term;
            term *= -x * x / ((n + 1) * (n + 2));
        }
        return sum;
    }
};

}  // namespace ocean
