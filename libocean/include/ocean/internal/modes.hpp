// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Modes: the sea as a sum of waves, without time. They hold the amplitude h0, the phase rate and
// the displacement of each mode, made from the directional spectrum and the seed.
#pragma once

#include <complex>
#include <vector>

#include "ocean/internal/cascades.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/revision.hpp"
#include "ocean/page_vector.hpp"

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

/// All modes of one band of wavenumbers. Arrays are row-major [index of ky][index of kx], FFT
/// order, lattice.size() long. The Nyquist row and column and k = 0 are zero.
struct CascadeModes {
    int divisor = 1;  // period of this cascade = patch_size / divisor
    Lattice lattice;
    PageVector<std::complex<float>> h0;  // [m]
    PageVector<float> rate_high;         // omega / 2 pi [Hz]; with a loop: whole turns per loop
    PageVector<float> rate_low;          // the part of it that rate_high cannot hold
    PageVector<float> displacement;      // coth(k d) / k [m]: D = -i kvec * this * h
    /// [s]: the covariance of the modes with max(|n|, |m|) = s.
    std::vector<GradientCovariance> shell_covariance;
};

struct Modes {
    Lattice lattice;
    double loop_period = 0.0;  // [s], 0 = never
    double wind_speed = 0.0;   // U10 [m/s]: determines how many whitecaps there are
    std::vector<CascadeModes> cascades;
    /// Changes whenever the owner modifies the modes; caches compare it. Default-constructed, and
    /// then unequal to every other, if the owner does not track revisions.
    Revision revision;
    /// Changes only when more than h0 is modified: caches of phase rates and displacements compare
    /// it. Default-constructed like `revision`.
    Revision lattice_revision;
    /// Wavenumber of the shortest waves whose products bind waves of second order [rad/m]; 0 = the
    /// surface is linear.
    double binding_limit = 0.0;

    /// Returns the covariance of the modes that a map of `resolution` samples holds.
    GradientCovariance gradient_covariance(int resolution) const;

    /// Returns tau, so that a mode has made rate * tau turns at a time [s]: the time itself, or the
    /// fraction of the loop.
    double tau(double time) const;
    /// Returns the factor f in omega = 2 pi rate f: 1, or 1 / loop_period.
    double rate_unit() const { return loop_period > 0.0 ? 1.0 / loop_period : 1.0; }
};

/// Returns the variance S D c_g / k dkx dky [m^2] of the mode (n, m), signed, on the lattice of the
/// band, without a random draw. S D c_g / k is the mean over the mode's cell of the lattice, so
/// that no energy is lost between the modes, however narrow the swell. 0 outside the band, outside
/// the wavelength limits of `parameters.surface` (a wave of exactly that length is kept) and at k =
/// 0.
double modal_variance(const DirectionalSpectrum& spectrum, const Parameters& parameters, int n,
                      int m, const CascadeBand& band = {});

/// Returns the time as a fraction f of the loop, 0 <= f < 1, rounded to 2^-44 of it, so that t and
/// t + T give the same bits although each is rounded to a double.
double loop_fraction(double time, double loop_period);

/// Returns the factor that corrects the energy of a band. Its modes cover its ring of wavenumbers
/// unevenly: the factor scales `variance`, the sum over the modes that measures_band picks, to the
/// integral over the ring. 1 for a sea of one cascade, whose band is its whole lattice.
double band_gain(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                 const CascadeBand& band, double variance);
/// Returns true for a mode of the band inside the circle of the lattice's Nyquist line. The last
/// band also has modes beyond that circle, in its corners.
bool measures_band(const CascadeBand& band, int resolution, int n, int m);

/// Returns the modes of a sea: h0(k) = 1/2 (xi_r + i xi_i) sqrt(S D c_g/k dkx dky), [Horvath 2015]
/// eq. 62, [Tessendorf 2001] eq. 42. Needs validated parameters. The bits are the same for any
/// number of threads.
Modes make_modes(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                 ThreadPool& pool);

/// Returns the correlation of the heights of two seas, each at its own time [s]: their covariance
/// over all places, divided by the root of the product of their variances; -1 .. 1. About 0 for two
/// seeds, about 1 for two winds over the same noise. Waves of both seas are identified where their
/// cascades have the same period; the part of opposite waves, which oscillates twice per period, is
/// neglected.
double height_correlation(const Modes& a, double time_a, const Modes& b, double time_b);

/// Returns the whole turns that a mode makes per loop: omega T / 2 pi, rounded, at least 1.
double turns_per_loop(double omega, double loop_period);

}  // namespace ocean
