// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The weights that combine the parts of a coast's surface: where the bed ends, where waves feel it,
// where they break. Scalar is Jet, or Plain without derivatives.
#pragma once

#include <algorithm>

#include "coast/statics/shore_delays.hpp"
#include "field/ease.hpp"
#include "field/jet.hpp"
#include "field/quad_grid.hpp"
#include "ocean/domain.hpp"

namespace ocean {

/// Returns ease_quintic of t clamped to 0 .. 1, with its derivative in closed form.
template <typename Scalar>
Scalar shore_step(const Scalar& t) {
    const float x = std::clamp(t.value(), 0.0f, 1.0f);
    const float rest = x * (1.0f - x);
    return chain(t, ease_quintic(x), 30.0f * rest * rest);
}

/// Returns a number clamped to 0 .. 1, with derivative 0 where it is clamped. Sums of weights are 1
/// to rounding.
template <typename Scalar>
Scalar held_in_unit(const Scalar& t) {
    constexpr float kRounding = 1e-6f;
    if (t.value() <= 0.0f) return {0.0f};
    return t.value() >= 1.0f - kRounding ? Scalar(1.0f) : t;
}

/// Returns the influence of the bed on the waves at a label, from ShoreDelays::ground and
/// ShoreEnergy::remainder: exactly 0 in the open sea, exactly 1 where the influence is full.
template <typename Scalar>
Scalar bed_influence_at(const QuadBlock& ground, const QuadBlock& remainder, std::size_t label) {
    const Scalar uninfluenced =
        (Scalar(1.0f) - held_in_unit(field_at<Scalar>(ground, 3, label))) *
        (Scalar(1.0f) - held_in_unit(field_at<Scalar>(remainder, 2, label)));
    return Scalar(1.0f) - uninfluenced;
}

/// Returns the influence of the bed where walls lower the waves at a label by a factor.
template <typename Scalar>
Scalar bed_influence_in_lee(const Scalar& bed_influence, const Scalar& lower) {
    constexpr float kFully = 0.05f;
    if (lower.value() >= 1.0f) return bed_influence;
    const Scalar calmed = shore_step((1.0f / kFully) * (Scalar(1.0f) - lower));
    return Scalar(1.0f) - (Scalar(1.0f) - bed_influence) * (Scalar(1.0f) - calmed);
}

/// Returns the width of the strip along the border of the bed where the open sea fades in [m].
inline double border_margin(const Domain& domain) {
    constexpr double kMargin = 64.0;  // [m]
    return std::min({kMargin, domain.size[0] / 8.0, domain.size[1] / 8.0});
}

/// Returns the share of the coast: 0 from the border of the bed outwards, 1 from `margin` inwards.
inline Jet share_inside(const Domain& domain, double margin, double x, double y) {
    const double west = x - domain.origin[0];
    const double south = y - domain.origin[1];
    const double east = domain.size[0] - west;
    const double north = domain.size[1] - south;
    const double nearest = std::min({west, east, south, north});
    if (nearest <= 0.0) return {0.0f};
    if (nearest >= margin) return {1.0f};
    const auto distance = static_cast<float>(nearest / margin);
    const auto slope = static_cast<float>(1.0 / margin);
    if (nearest == west) return shore_step(Jet(distance, slope, 0.0f));
    if (nearest == east) return shore_step(Jet(distance, -slope, 0.0f));
    if (nearest == south) return shore_step(Jet(distance, 0.0f, slope));
    return shore_step(Jet(distance, 0.0f, -slope));
}

/// The weights that add the surface of the coast and the open sea's surface where the bed ends.
/// Both are random: their variances add, except for the part that they share.
template <typename Scalar>
struct BorderWeights {
    Scalar coast{1.0f};
    Scalar open{0.0f};
};
template <typename Scalar>
BorderWeights<Scalar> border_weights(const Scalar& share, const Scalar& correlation) {
    if (share.value() >= 1.0f) return {};
    if (share.value() <= 0.0f) return {{0.0f}, {1.0f}};
    const Scalar rest = Scalar(1.0f) - share;
    const Scalar variance = share * share + rest * rest + 2.0f * share * rest * correlation;
    const Scalar scale = Scalar(1.0f) / sqrt(variance);
    return {share * scale, rest * scale};
}

/// Returns the share of the waves in no band, which are short, that is left over a depth: 0 in the
/// shallowest water.
template <typename Scalar>
Scalar short_waves_left(const Scalar& depth) {
    constexpr float kFade = 1.4f;  // [m]
    return shore_step((1.0f / kFade) * (depth - Scalar(kLeastFeltDepth)));
}

/// Returns how much waves break by the depth, 0 .. 1, by the ratio of their rms height to it.
inline float surf_weight(float rms_height, float depth) {
    constexpr float kFirst = 0.12f;
    constexpr float kRange = 0.10f;
    return shore_step(Plain((rms_height / depth - kFirst) / kRange)).value();
}

}  // namespace ocean
