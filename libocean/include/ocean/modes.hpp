// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Modes: the sea as a sum of waves, before any time. From the directional spectrum and the seed to
// h0, the phase rate and the excursion of each mode.
#pragma once

#include <complex>
#include <cstdint>
#include <vector>

#include "ocean/directional_spectrum.hpp"
#include "ocean/grid.hpp"

namespace ocean {

class ThreadPool;

/// All modes of one wavenumber band. Arrays are row-major [index of ky][index of kx], FFT order,
/// lattice.size() long. The Nyquist row and column and k = 0 are zero.
struct CascadeModes {
    int divisor = 1;  // period of this cascade = patch_size / divisor
    Lattice lattice;
    std::vector<std::complex<float>> h0;  // m
    std::vector<float> rate_high;         // omega / 2 pi, Hz; with a loop: whole turns per loop
    std::vector<float> rate_low;          // what float leaves of it
    std::vector<float> excursion;  // coth(k d) / k, m: horizontal excursion is -i kvec * this * h
};

struct Modes {
    Lattice lattice;
    double loop_period = 0.0;  // s, 0 = never
    std::vector<CascadeModes> cascades;

    /// Turns of a mode at time t are rate * tau: t itself, or the fraction of the loop.
    double tau(double time) const;
    /// omega = 2 pi rate * rate_unit: 1, or 1/loop_period.
    double rate_unit() const { return loop_period > 0.0 ? 1.0 / loop_period : 1.0; }
};

/// The variance of one mode, S D c_g / k dkx dky [m^2], without any random draw; n, m signed.
/// S D c_g / k is its mean over the mode's cell of the lattice, so that no energy falls between the
/// modes, however narrow the swell.
/// Zero outside the band limits (a wave of exactly that length is kept) of `parameters.surface` and
/// at k = 0.
double modal_variance(const DirectionalSpectrum& spectrum, const Parameters& parameters, int n,
                      int m);

/// h0(k) = 1/2 (xi_r + i xi_i) sqrt(S D c_g/k dkx dky). [Horvath 2015] eq. 62, [Tessendorf 2001]
/// eq. 42. Needs validated parameters.
Modes make_modes(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                 ThreadPool& pool);

/// Whole turns that a mode makes per loop: omega T / 2 pi to the nearest, at least 1.
double turns_per_loop(double omega, double loop_period);

}  // namespace ocean
