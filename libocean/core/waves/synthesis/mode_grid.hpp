// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The complex coefficients of one field at one time, for the backends that are written to be read.
#pragma once

#include <complex>
#include <vector>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/map_request.hpp"
#include "wave/wave.hpp"
#include "waves/synthesis/synthesis.hpp"

namespace ocean {

/// Returns h(k, t) and its rate for mode (n, m), in double from the stored floats: the definition
/// that the fast backend is tested against.
inline wave::double_precision::ModeState state_of_mode(const CascadeModes& cascade, double tau,
                                                       double rate_unit, int n, int m) {
    const int size = cascade.lattice.resolution;
    const std::size_t at = mode_index(n, m, size);
    const std::complex<double> h0 = cascade.h0[at];
    const std::complex<double> mirror = cascade.h0[mode_index(-n, -m, size)];
    const double rate = static_cast<double>(cascade.rate_high[at]) + cascade.rate_low[at];
    const double turns = wave::double_precision::phase_turns(rate, 0.0, tau, 0.0);
    return wave::double_precision::mode_state(h0.real(), h0.imag(), mirror.real(), mirror.imag(),
                                              turns, rate * kTwoPi * rate_unit);
}

/// Returns the coefficient of exp(i k x) of a field; kx, ky in [rad/m], displacement in [m].
inline std::complex<double> linear_coefficient(Linear field,
                                               const wave::double_precision::ModeState& state,
                                               double kx, double ky, double displacement) {
    const LinearShape shape = linear_shape(field);
    double factor = shape.sign;
    for (int i = 0; i < shape.x_power; ++i) factor *= kx;
    for (int i = 0; i < shape.y_power; ++i) factor *= ky;
    if (shape.displacement) factor *= displacement;
    const double re = shape.rate ? state.rate_re : state.re;
    const double im = shape.rate ? state.rate_im : state.im;
    return shape.odd ? std::complex<double>(-factor * im, factor * re)
                     : std::complex<double>(factor * re, factor * im);
}

/// Returns a grid, row-major [ky][kx] in FFT order, of a map of `resolution`; zero where there are
/// no modes.
template <typename Real>
std::vector<std::complex<Real>> coefficient_grid(const MapModes& modes, Linear field) {
    const int size = modes.resolution;
    std::vector<std::complex<Real>> grid(static_cast<std::size_t>(size) *
                                         static_cast<std::size_t>(size));
    for (const CascadeModes& cascade : modes.cascades) {
        const int half = modes.half(cascade);
        const int stride = modes.stride(cascade);
        const double step = cascade.lattice.wavenumber_step();
        for (int m = -half + 1; m < half; ++m) {
            for (int n = -half + 1; n < half; ++n) {
                const auto state = state_of_mode(cascade, modes.tau, modes.rate_unit, n, m);
                const std::complex<double> value = linear_coefficient(
                    field, state, step * n, step * m,
                    cascade.displacement[mode_index(n, m, cascade.lattice.resolution)]);
                // The bands are disjoint: all but one of the cascades add zero.
                grid[mode_index(n * stride, m * stride, size)] += std::complex<Real>(
                    static_cast<Real>(value.real()), static_cast<Real>(value.imag()));
            }
        }
    }
    return grid;
}

}  // namespace ocean
