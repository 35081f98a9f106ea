// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Breaking waves: how high a wave can be over a bed, how much energy breaking takes, which crests
// break, and the shape that a crest has in shallow water. The formulas are templates over the
// scalar: a dual number in place of a double returns their derivatives. Such a type converts from
// double, has the arithmetic operators, and its namespace has sqrt, exp, log, pow, tanh, sin, cos
// and value_of.
//
// The waves of a place are the real part of an analytic signal Z [m]: |Z| is the amplitude of the
// group, arg Z the phase, and Z turns as exp(i (k x - omega t)). Throughout, k is the wavenumber of
// the peak at this depth [rad/m], d the depth [m].
#pragma once

#include <cmath>
#include <vector>

#include "field/ease.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean {

/// Returns the value of a scalar, which decides branches; for a dual number, without its
/// derivatives.
constexpr double value_of(double x) {
    return x;
}
constexpr double value_of(float x) {
    return double{x};
}

/// Hrms / d in saturated surf, and the strength of a breaker [Thornton and Guza 1983].
inline constexpr double kSurfGamma = 0.42;
inline constexpr double kBreakerStrength = 1.0;
/// Up to this ratio of a wave to the highest wave, the limiter leaves the wave unchanged.
inline constexpr double kLimiterKnee = 0.7;
/// Skewness and asymmetry of crest_shape as a share of the measured nonlinearity: a sum of shaped
/// waves of different heights has slightly more of both than each wave.
inline constexpr double kShapeShare = 0.8;
/// Smooths amplitudes about zero, far below any visible wave [m].
inline constexpr double kLeastAmplitude = 1e-6;

/// Returns 0 for x <= 0, 1 for x >= 1, and ease_quintic between them.
template <typename Real>
Real breaking_step(const Real& x) {
    if (value_of(x) <= 0.0) return Real(0.0);
    if (value_of(x) >= 1.0) return Real(1.0);
    return ease_quintic(x);
}

/// Returns |Z| [m], smooth where it vanishes.
template <typename Real>
Real amplitude_of(const Real& re, const Real& im) {
    using std::sqrt;
    return sqrt(re * re + im * im + Real(kLeastAmplitude * kLeastAmplitude));
}

// ---- heights

/// Returns the ratio of the highest single wave to the depth over a bed of this slope (rise over
/// run, in any direction): 0.75 min(1 + 15 slope^(4/3), 1.4). The slope's factor is from [Goda
/// 1970]; the level and the limit are ours.
template <typename Real>
Real breaker_index(const Real& slope) {
    using std::pow;
    if (value_of(slope) <= 0.0) return Real(0.75);
    const Real factor = Real(1.0) + Real(15.0) * pow(slope, Real(4.0 / 3.0));
    return value_of(factor) < 1.4 ? Real(0.75) * factor : Real(0.75 * 1.4);
}

/// Returns the height of the highest wave [m], (0.88 / k) tanh(index k d / 0.88) [Battjes and
/// Janssen 1978]: 0.14 wavelengths in deep water, index d in shallow.
template <typename Real>
Real highest_wave(const Real& k, const Real& d, const Real& index) {
    using std::tanh;
    return Real(0.88) / k * tanh(index * k * d / Real(0.88));
}

/// Returns the limiter f(u) of a wave u times as high as the highest: u up to the knee u0, then
/// u0 + (1 - u0) tanh((u - u0) / (1 - u0)), below 1. Its slope is continuous.
template <typename Real>
Real limited(const Real& u) {
    using std::tanh;
    if (value_of(u) <= kLimiterKnee) return u;
    const Real room = Real(1.0 - kLimiterKnee);
    return Real(kLimiterKnee) + room * tanh((u - Real(kLimiterKnee)) / room);
}

// ---- loss of energy

/// Returns the energy that breaking takes per area and time, over rho g [m^2/s], from waves of this
/// rms height [m] and peak frequency f [Hz]: (3 sqrt(pi) / 16) B^3 f H^5 / (gamma^2 d^3) (1 - (1 +
/// (H / (gamma d))^2)^(-5/2)) [Thornton and Guza 1983], with the weight of their eq. 21. The energy
/// of such waves, over rho g, is H^2 / 8.
template <typename Real>
Real breaking_dissipation(const Real& rms_height, const Real& d, const Real& f) {
    using std::sqrt;
    constexpr double factor = 3.0 * 1.7724538509055159 / 16.0 * kBreakerStrength *
                              kBreakerStrength * kBreakerStrength;  // sqrt(pi) = 1.77..
    const Real ratio = rms_height / (Real(kSurfGamma) * d);
    const Real s = Real(1.0) + ratio * ratio;
    return Real(factor) * f * rms_height * rms_height * rms_height * ratio * ratio / d *
           (Real(1.0) - Real(1.0) / (s * s * sqrt(s)));
}

/// Returns the share of waves that break, 0 .. 1: v - v / (1 + v), v = (Hrms / (gamma d))^2, the
/// integral of [Thornton and Guza 1983] eq. 21 over all heights.
template <typename Real>
Real share_that_breaks(const Real& rms_height, const Real& d) {
    const Real ratio = rms_height / (Real(kSurfGamma) * d);
    const Real v = ratio * ratio;
    const Real share = v * v / (Real(1.0) + v);
    return value_of(share) < 1.0 ? share : Real(1.0);
}

/// Returns how strongly a crest breaks, 0 .. 1, the source of foam. The highest `share` of the
/// waves breaks: with a Rayleigh distribution of heights, the waves of an amplitude above (Hrms /
/// 2) sqrt(-ln share). Foam comes from their front faces alone, a phase of 0.55 before the crest;
/// where Hrms / d is below 0.12 there is none. Z is the signal before the limiter.
template <typename Real>
Real breaking_source(const Real& re, const Real& im, const Real& rms_height, const Real& d,
                     const Real& share) {
    using std::log;
    using std::sqrt;
    constexpr double cos_lead = 0.8525245220595057, sin_lead = 0.5226872289306592;
    const double s = value_of(share);
    const Real q = s < 1e-6 ? Real(1e-6) : s > 0.98 ? Real(0.98) : share;
    const Real amplitude = amplitude_of(re, im);
    const Real wanted = Real(0.5) * rms_height * sqrt(-log(q));
    const Real threshold = value_of(wanted) > 1e-3 ? wanted : Real(1e-3);
    const Real face = (re * Real(cos_lead) + im * Real(sin_lead)) / amplitude;
    return breaking_step((amplitude / threshold - Real(0.97)) / Real(0.25)) *
           breaking_step((face - Real(0.80)) / Real(0.16)) *
           breaking_step((rms_height / d - Real(0.12)) / Real(0.10));
}

// ---- shape of crests

/// Returns the Ursell number (3/4) a k / (k d)^3 of waves of amplitude a [m]
/// [Ruessink 2012] eq. 6.
template <typename Real>
Real ursell_number(const Real& amplitude, const Real& k, const Real& d) {
    const Real kd = k * d;
    return Real(0.75) * amplitude * k / (kd * kd * kd);
}

/// Returns the nonlinearity B, so that B cos(psi) is the skewness of the surface and B sin(psi) its
/// asymmetry: 0.857 / (1 + exp((-0.471 - log10 Ur) / 0.297)) [Ruessink 2012] eq. 9. It is written
/// as 0.857 x / (x + c) with a power x of Ur, which needs no logarithm of 0.
template <typename Real>
Real nonlinearity(const Real& ursell) {
    using std::pow;
    if (value_of(ursell) <= 0.0) return Real(0.0);
    constexpr double power = 1.4622709828392317;  // 1 / (0.297 ln 10)
    constexpr double c = 0.2047719033589133;      // exp(-0.471 / 0.297)
    const Real x = pow(ursell, Real(power));
    return Real(0.857) * x / (x + Real(c));
}

/// Returns the biphase psi [rad], 0 for skewed waves, -pi/2 for saw teeth: (pi/2) (tanh(0.815 /
/// Ur^0.672) - 1) [Ruessink 2012] eq. 10. Below Ur = 0.009 the tanh is 1 to rounding.
template <typename Real>
Real biphase(const Real& ursell) {
    using std::pow;
    using std::tanh;
    if (value_of(ursell) < 0.009) return Real(0.0);
    return Real(0.5 * kPi) * (tanh(Real(0.815) / pow(ursell, Real(0.672))) - Real(1.0));
}

/// Returns the r of Abreu's wave whose nonlinearity is B: 2 b / (1 + b^2) with b = sqrt(2) B /
/// sqrt(9 + 2 B^2), the inverse of B = 3 b / sqrt(2 (1 - b^2)) [Ruessink 2012] eq. 11,
/// [Malarkey and Davies 2012].
template <typename Real>
Real shape_of_nonlinearity(const Real& nonlinearity) {
    using std::sqrt;
    const Real s = Real(2.0) * nonlinearity * nonlinearity;
    return Real(2.0 * 1.4142135623730951) * nonlinearity * sqrt(Real(9.0) + s) /
           (Real(9.0) + Real(2.0) * s);
}

/// Returns the height of the surface [m], Abreu's wave of the amplitude and phase of Z: q (Re Z + c
/// |Z|) / (1 - r (Im Z cos(phi) - Re Z sin(phi)) / |Z|), q = sqrt(1 - r^2), c = r sin(phi) / (1 +
/// q): [Abreu 2010] eq. 7, with Re Z / |Z| for sin and Im Z / |Z| for cos. From crest to trough it
/// measures 2 |Z| and its mean is 0, for every r and phi; r = 0 returns Re Z. phi = -psi - pi/2
/// [Ruessink 2012] eq. 12.
template <typename Real>
Real crest_shape(const Real& re, const Real& im, const Real& r, const Real& phi) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const Real cos_phi = cos(phi), sin_phi = sin(phi);
    const Real q = sqrt(Real(1.0) - r * r);
    const Real c = r * sin_phi / (Real(1.0) + q);
    const Real amplitude = amplitude_of(re, im);
    return q * (re + c * amplitude) / (Real(1.0) - r * (im * cos_phi - re * sin_phi) / amplitude);
}

/// Returns r for waves of this amplitude [m].
template <typename Real>
Real shape_of_amplitude(const Real& amplitude, const Real& k, const Real& d) {
    return shape_of_nonlinearity(Real(kShapeShare) * nonlinearity(ursell_number(amplitude, k, d)));
}

/// The waves of one place after breaking.
template <typename Real>
struct BrokenWave {
    Real share;   // the limiter's factor on Z and on all quantities proportional to it
    Real height;  // of the surface [m]
};

/// Returns the limited and shaped wave of Z: Z' = Z gain f(u) / u, u = 2 gain |Z| / highest, then
/// crest_shape(Z'). gain is LimiterGain's. From crest to trough no wave exceeds `highest` [m].
template <typename Real>
BrokenWave<Real> broken_wave(const Real& re, const Real& im, const Real& highest, const Real& gain,
                             const Real& k, const Real& d) {
    const Real amplitude = amplitude_of(re, im);
    const Real u = Real(2.0) * gain * amplitude / highest;
    const Real share = value_of(u) <= kLimiterKnee ? gain : gain * limited(u) / u;
    const Real ursell = ursell_number(amplitude * share, k, d);
    const Real r = shape_of_nonlinearity(Real(kShapeShare) * nonlinearity(ursell));
    const Real phi = -biphase(ursell) - Real(0.5 * kPi);
    return {share, crest_shape(re * share, im * share, r, phi)};
}

/// The gain before the limiter that restores the variance which limiter and shape take from waves
/// with a Rayleigh distribution of heights. Immutable; any thread may use it.
class LimiterGain {
  public:
    LimiterGain();

    /// Returns the gain of waves of this rms height in units of the highest wave. q = sqrt(1 - r^2)
    /// of typical waves: the shape leaves 2 q / (1 + q) of their variance. Exact for rms_ratio
    /// sqrt((1 + q) / (2 q)) up to 0.9; higher waves lose variance.
    template <typename Real>
    Real operator()(const Real& rms_ratio, const Real& q) const {
        using std::sqrt;
        const Real shape = sqrt((Real(1.0) + q) / (Real(2.0) * q));
        return limiter_gain(rms_ratio * shape) * shape;
    }

  private:
    static constexpr double kHighestRatio = 0.9;
    static constexpr int kIntervals = 144;

    template <typename Real>
    Real limiter_gain(const Real& rms_ratio) const {
        constexpr double per_ratio = kIntervals / kHighestRatio;
        const double at = value_of(rms_ratio) * per_ratio;
        if (at >= kIntervals) return Real(table_.back());
        const auto i = static_cast<std::size_t>(at > 0.0 ? at : 0.0);
        return Real(table_[i]) + (rms_ratio * Real(per_ratio) - Real(static_cast<double>(i))) *
                                     Real(table_[i + 1] - table_[i]);
    }

    std::vector<double> table_;
};

/// Returns the q that LimiterGain takes: the q of a wave as high as the significant height, sqrt(2)
/// Hrms.
template <typename Real>
Real typical_shape_root(const Real& rms_height, const Real& k, const Real& d) {
    using std::sqrt;
    const Real r = shape_of_amplitude(rms_height * Real(0.70710678118654752), k, d);
    return sqrt(Real(1.0) - r * r);
}

}  // namespace ocean
