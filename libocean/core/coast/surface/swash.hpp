// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The swash: how high waves run up a beach, the sheet of water that follows them, and the sand and
// foam that they leave. Run-up has three parts, as measured on beaches: a steady set-up, a part
// that follows the waves, and a part that follows their groups; the last two follow the same waves
// that break before the beach. The formulas are templates over the scalar, as in breaking.hpp.
#pragma once

#include <cmath>
#include <cstddef>

#include "coast/statics/breaking.hpp"
#include "coast/statics/shore_delays.hpp"
#include "field/quad_grid.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean {

/// The waves of the open sea, in the quantities of run-up.
struct RunUpSea {
    double height = 0.0;  // significant wave height [m]
    double length = 0.0;  // deep-water wavelength of the peak period [m]
    bool runs_up = true;  // false: the surface ends at the line of still water
};

/// Facts of a place.
template <typename Real>
struct SwashPlace {
    Real bed;          // height over still water [m]
    Real slope;        // of the bed, rise over run
    Real arrival;      // share of the open sea's energy that arrives if none breaks
    Real rms_height;   // Hrms [m]
    Real group_width;  // square root of the sum of the squares of all waves' shares of the energy
};

/// Returns the facts of a label, number i of a block of ShoreDelays::ground and number n of a block
/// of ShoreEnergy::breaking, with their derivatives if Real is Jet.
template <typename Real>
SwashPlace<Real> swash_place(const QuadBlock& ground, std::size_t i, const QuadBlock& energy,
                             std::size_t n) {
    return {field_at<Real>(ground, 0, i), field_at<Real>(ground, 2, i),
            field_at<Real>(energy, 2, n), field_at<Real>(energy, 0, n),
            field_at<Real>(energy, 3, n)};
}

/// The waves of a place at a time.
template <typename Real>
struct SwashWaves {
    Real re, im;   // Z before the limiter [m]
    Real squares;  // sum over bands and sectors of |Z|^2 [m^2]
};

/// The surface in the swash.
template <typename Real>
struct SwashSurface {
    Real height;     // over still water [m]; below the bed on dry ground
    Real displaced;  // the share of the displacement that is left
};

/// The range of beaches for which run-up was measured; other beaches use the nearest limit.
inline constexpr double kFlattestBeach = 0.02;
inline constexpr double kSteepestBeach = 0.14;
/// The surface turns from waves into run-up below this depth, in units of the min depth that waves
/// feel. The set-up begins below this depth in units of the open sea's height.
inline constexpr double kSwashDepths = 2.2;
/// The thickness scale of the sheet's tip [m].
inline constexpr double kSheet = 0.05;
/// The shares of the measured swash that the waves and their groups have. With them the 2 % run-up
/// of directional seas on plane beaches equals the measured run-up to 10 %; with the whole of both
/// it would be higher, since the highest of many waves exceeds 2 standard deviations.
inline constexpr double kIncidentShare = 0.75;
inline constexpr double kGroupShare = 0.90;
/// The highest wave in the swash, in standard deviations of the surface.
inline constexpr double kHighestSwash = 3.0;

/// Returns x clamped to least .. greatest.
template <typename Real>
Real swash_clamped(const Real& x, double least, double greatest) {
    if (value_of(x) <= least) return Real(least);
    return value_of(x) >= greatest ? Real(greatest) : x;
}

// ---- run-up

/// Returns sqrt(H0 L0) [m] of the waves that arrive: H0 is the open sea's height times the square
/// root of the share of its energy that arrives.
template <typename Real>
Real run_up_scale(const RunUpSea& sea, const Real& arrival) {
    using std::sqrt;
    const Real share = sqrt(swash_clamped(arrival, 1e-8, 4.0));
    return sqrt(Real(sea.height * sea.length) * share);
}

/// Returns the slope of a beach within the measured range.
template <typename Real>
Real beach_slope(const Real& slope) {
    return swash_clamped(slope, kFlattestBeach, kSteepestBeach);
}

/// Returns the set-up of the mean water line [m], 0.35 slope sqrt(H0 L0) [Stockdon 2006] eq. 10.
template <typename Real>
Real set_up(const Real& scale, const Real& slope) {
    return Real(0.35) * slope * scale;
}

/// Returns the height that 2 % of the run-ups exceed [m], 1.1 (set-up + S / 2), with the swash
/// S = sqrt(H0 L0 (0.563 slope^2 + 0.004)) [Stockdon 2006] eq. 19.
template <typename Real>
Real run_up_2_percent(const Real& scale, const Real& slope) {
    using std::sqrt;
    const Real swash = scale * sqrt(Real(0.563) * slope * slope + Real(0.004));
    return Real(1.1) * (set_up(scale, slope) + Real(0.5) * swash);
}

/// Returns the excess of the groups' energy over its mean, in units of its standard deviation, at
/// most 2: (sum |Z|^2 / 2 m0 - 1) / w. m0 is the variance, w the group width. Each square belongs
/// to one band and sector: the square of the sum would make the waves run up twice.
template <typename Real>
Real group_excess(const SwashPlace<Real>& place, const Real& squares, const Real& rms_height) {
    const Real mean = Real(0.25) * rms_height * rms_height;
    const Real width = swash_clamped(place.group_width, 0.05, 1.0);
    const Real excess = (squares / mean - Real(1.0)) / width;
    return Real(2.0) * limited(Real(0.5) * excess);
}

/// Returns the height of the water line [m] that the waves of this moment reach: set-up, plus the
/// swash of the waves with 4 standard deviations of 0.75 slope sqrt(H0 L0) [Stockdon 2006] eq. 11,
/// plus the swash of their groups with 0.06 sqrt(H0 L0), eq. 12. The squares of 0.75 and 0.06 are
/// 0.563 and 0.004.
template <typename Real>
Real run_up(const RunUpSea& sea, const SwashPlace<Real>& place, const SwashWaves<Real>& waves) {
    using std::sqrt;
    constexpr double incident = kIncidentShare * 0.25 * 0.7503332592921628;  // sqrt(0.563)
    constexpr double groups = kGroupShare * 0.25 * 0.06324555320336759;      // sqrt(0.004)
    constexpr double rms_over_deviation = 2.8284271247461903;                // sqrt(8)
    const Real slope = beach_slope(place.slope);
    const Real scale = run_up_scale(sea, place.arrival);
    // Where almost no energy arrives, the ratios are limited.
    const Real rms_height = swash_clamped(place.rms_height, 0.01 * sea.height + 1e-6, 1e3);
    // The highest waves have the same limit on any beach, in units of the standard deviation.
    const Real to_deviations = Real(rms_over_deviation) / rms_height;
    const Real u = amplitude_of(waves.re, waves.im) * to_deviations / Real(kHighestSwash);
    const Real along = waves.re * to_deviations * limited(u) / u;
    return set_up(scale, slope) + Real(incident) * scale * slope * along +
           Real(groups) * scale * group_excess(place, waves.squares, rms_height);
}

// ---- the sheet of water

/// Returns the share of run-up, against waves, in the surface: 1 from the line of still water
/// upward, 0 in water deeper than 1.3 m.
template <typename Real>
Real swash_weight(const Real& bed) {
    if (value_of(bed) >= 0.0) return Real(1.0);
    return breaking_step(Real(1.0) + bed / Real(kSwashDepths * kLeastFeltDepth));
}

/// Returns the share of the waves' displacement that is left: 0 from the line of still water
/// upward, 1 beyond the swash's depths and beyond kCalmLength before the line. On steep beaches the
/// water would fold over if the displacement ended faster.
template <typename Real>
Real displacement_left(const SwashPlace<Real>& place) {
    constexpr double kCalmLength = 40.0;  // [m]
    if (value_of(place.bed) >= 0.0) return Real(0.0);
    const Real by_slope = Real(kCalmLength) * place.slope;
    const bool is_steep = value_of(by_slope) > kSwashDepths * kLeastFeltDepth;
    const Real depths = is_steep ? by_slope : Real(kSwashDepths * kLeastFeltDepth);
    return Real(1.0) - breaking_step(Real(1.0) + place.bed / depths);
}

/// Returns the set-up before the swash as a share of the set-up at the water line: (1 - d / 2.2
/// H0)^2.
template <typename Real>
Real set_up_share(const RunUpSea& sea, const Real& bed) {
    if (value_of(bed) >= 0.0) return Real(1.0);
    const Real left = Real(1.0) + bed / Real(kSwashDepths * sea.height + 1e-6);
    return value_of(left) > 0.0 ? left * left : Real(0.0);
}

/// Returns the depth of the sheet [m] where the run-up is `excess` above the bed: e (1 + exp(-|e| /
/// s)). Its tip is a film that rises from the bed twice as steeply as a level surface would, so
/// that surface and bed meet in a clear line; dry sand lies above the film's continuation by as
/// much. A few s from the tip the surface is level.
template <typename Real>
Real sheet_depth(const Real& excess) {
    using std::exp;
    const Real height = value_of(excess) < 0.0 ? -excess : excess;
    return excess * (Real(1.0) + exp(-height / Real(kSheet)));
}

/// Returns the surface of a place whose waves alone, without run-up, have this height [m].
template <typename Real>
SwashSurface<Real> swash_surface(const RunUpSea& sea, const SwashPlace<Real>& place,
                                 const SwashWaves<Real>& waves, const Real& height) {
    const Real weight = swash_weight(place.bed);
    const Real rest = Real(1.0) - weight;
    const Real displaced = displacement_left(place);
    if (!sea.runs_up) return {rest * height, displaced};
    const Real rise = set_up(run_up_scale(sea, place.arrival), beach_slope(place.slope)) *
                      set_up_share(sea, place.bed);
    if (value_of(weight) <= 0.0) return {height + rise, displaced};
    const Real level = rest * (height + rise) + weight * run_up(sea, place, waves);
    const Real excess = level - place.bed;
    return {level + weight * (sheet_depth(excess) - excess), displaced};
}

// ---- sand and foam

/// Returns the share of a breaking wave's foam that is left over a bed of this height [m]: 0 on
/// land, where tip_foam makes the foam.
float surf_left(float bed);

/// Returns the dampness, 0 .. 1, of sand that only the highest waves reach, by its height over
/// still water and the 2 % run-up [m], above which sand is dry.
float damp_of(float bed, float run_up);

/// Returns the source of foam at the tip of the sheet, 0 .. 1, about 2 m wide on any beach.
float tip_foam(float depth, float slope, float weight);

}  // namespace ocean
