// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Modes: the sea as a sum of waves, before any time. From the directional spectrum and the seed to
// h0, the phase rate and the displacement of each mode.
#pragma once

#include <complex>
#include <cstdint>
#include <vector>

#include "ocean/cascades.hpp"
#include "ocean/directional_spectrum.hpp"
#include "ocean/grid.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/revision.hpp"

namespace ocean {

class ThreadPool;

/// Covariance of the gradients a = dDx/dx, b = dDy/dy, c = dDx/dy of the horizontal displacement,
/// which are jointly Gaussian: sums over modes of V f_i f_j with f = (kx^2, ky^2, kx ky) coth(kd) /
/// k and V the variance of the mode.
struct GradientCovariance {
    double aa = 0.0;
    double bb = 0.0;
    double cc = 0.0;
    double ab = 0.0;
    double ac = 0.0;
    double bc = 0.0;

    GradientCovariance& operator+=(const GradientCovariance& other);
    GradientCovariance& operator*=(double factor);
    bool operator==(const GradientCovariance&) const = default;
};

/// All modes of one wavenumber band. Arrays are row-major [index of ky][index of kx], FFT order,
/// lattice.size() long. The Nyquist row and column and k = 0 are zero.
struct CascadeModes {
    int divisor = 1;  // period of this cascade = patch_size / divisor
    Lattice lattice;
    PageVector<std::complex<float>> h0;  // m
    PageVector<float> rate_high;         // omega / 2 pi, Hz; with a loop: whole turns per loop
    PageVector<float> rate_low;          // the rest of it, which rate_high cannot hold
    PageVector<float> displacement;      // coth(k d) / k, m: that of h is -i kvec * this * h
    /// [s]: of the modes with max(|n|, |m|) = s.
    std::vector<GradientCovariance> shell_covariance;
};

struct Modes {
    Lattice lattice;
    double loop_period = 0.0;  // s, 0 = never
    double wind_speed = 0.0;   // m/s, U10: how much whitecap there is
    std::vector<CascadeModes> cascades;
    /// Another one for every change that their owner makes, so that what was made of them can be
    /// kept; of nothing where nobody counts.
    Revision revision;
    /// Another one when more than h0 has changed: what was made of rates and displacements alone
    /// can be kept. Of nothing where nobody counts.
    Revision lattice_revision;

    /// Of the modes that a map of `resolution` samples holds.
    GradientCovariance gradient_covariance(int resolution) const;

    /// Turns of a mode at time t are rate * tau: t itself, or the fraction of the loop.
    double tau(double time) const;
    /// omega = 2 pi rate * rate_unit: 1, or 1/loop_period.
    double rate_unit() const { return loop_period > 0.0 ? 1.0 / loop_period : 1.0; }
};

/// The variance of the mode (n, m), signed, on the lattice of the band: S D c_g / k dkx dky [m^2],
/// no random draw. S D c_g / k is a mean over the mode's cell of the lattice, so that no energy
/// falls between the modes, however narrow the swell. Zero outside the band, outside the limits of
/// `parameters.surface` (a wave of exactly that length is kept) and at k = 0.
double modal_variance(const DirectionalSpectrum& spectrum, const Parameters& parameters, int n,
                      int m, const CascadeBand& band = {});

/// The time as a fraction of the loop, 0 <= f < 1, rounded to 2^-44 of it: so much that t and
/// t + T give the same bits although each is rounded to a double.
double loop_fraction(double time, double loop_period);

/// The modes of a band cover its ring of wavenumbers unevenly. This factor makes `variance`, the
/// sum over the modes that measures_band picks, the integral over the ring. 1 for a sea of one
/// cascade, whose band is all its lattice.
double band_gain(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                 const CascadeBand& band, double variance);
/// Whether a mode of the band lies inside the circle of the lattice's Nyquist line: the last band
/// has corners beyond it.
bool measures_band(const CascadeBand& band, int resolution, int n, int m);

/// h0(k) = 1/2 (xi_r + i xi_i) sqrt(S D c_g/k dkx dky). [Horvath 2015] eq. 62, [Tessendorf 2001]
/// eq. 42. Needs validated parameters.
Modes make_modes(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                 ThreadPool& pool);

/// Of the heights of two seas, each at its own time: their covariance over all places by the root
/// of the product of their variances, -1 .. 1. Of two seeds about 0, of two winds over the same
/// noise about 1. Waves are the same where they stand on cascades of the same period; an opposite
/// wave's share, which comes and goes twice a period, is left out.
double height_correlation(const Modes& a, double time_a, const Modes& b, double time_b);

/// Whole turns that a mode makes per loop: omega T / 2 pi to the nearest, at least 1.
double turns_per_loop(double omega, double loop_period);

}  // namespace ocean
