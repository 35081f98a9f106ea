// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The loop over labels that adds the waves of one band and sector, for one instruction set; the
// build compiles it once for each (core/CMakeLists.txt).
#pragma once

#include "base/simd/simd.hpp"
#include "coast/loops/band_sector_task.hpp"

namespace ocean::OCEAN_KERNEL {

/// A vector of labels' values with their derivatives, kParts of JetParts. Values that do not change
/// with time have at most three parts.
template <int kParts>
struct LaneJet {
    Vec part[kParts];
};

template <int kParts>
OCEAN_INLINE LaneJet<kParts> load_jet(const float* const* from, std::size_t label) {
    LaneJet<kParts> jet;
    for (int p = 0; p < kParts; ++p) jet.part[p] = load(from[p] + label);
    return jet;
}
template <int kParts>
OCEAN_INLINE void add_jet(float* const* to, std::size_t label, const LaneJet<kParts>& jet) {
    for (int p = 0; p < kParts; ++p) {
        store(to[p] + label, load(to[p] + label) + jet.part[p]);
    }
}

template <int kParts, int kOther>
OCEAN_INLINE LaneJet<kParts> operator*(const LaneJet<kParts>& a, const LaneJet<kOther>& b) {
    LaneJet<kParts> product;
    product.part[0] = a.part[0] * b.part[0];
    for (int p = 1; p < kParts; ++p) {
        product.part[p] =
            p < kOther ? fma(a.part[0], b.part[p], b.part[0] * a.part[p]) : b.part[0] * a.part[p];
    }
    return product;
}
template <int kParts>
OCEAN_INLINE LaneJet<kParts> operator+(const LaneJet<kParts>& a, const LaneJet<kParts>& b) {
    LaneJet<kParts> sum;
    for (int p = 0; p < kParts; ++p) sum.part[p] = a.part[p] + b.part[p];
    return sum;
}
template <int kParts>
OCEAN_INLINE LaneJet<kParts> operator-(const LaneJet<kParts>& a, const LaneJet<kParts>& b) {
    LaneJet<kParts> difference;
    for (int p = 0; p < kParts; ++p) difference.part[p] = a.part[p] - b.part[p];
    return difference;
}

template <int kParts>
struct LaneTurn {
    LaneJet<kParts> cosine;
    LaneJet<kParts> sine;
};

/// Returns cosine and sine of an angle [rad] of at most some thousand turns.
template <int kParts>
OCEAN_INLINE LaneTurn<kParts> turn_by(const LaneJet<kParts>& angle) {
    constexpr float kPerRadian = 0.159154943f;
    constexpr float kHigh = 6.28125f;  // 2 pi in two parts; products with the first are exact
    constexpr float kLow = 1.93530718e-3f;
    const Vec whole = nearest(angle.part[0] * Vec(kPerRadian));
    const Vec rest = fnma(whole, kLow, fnma(whole, kHigh, angle.part[0]));
    const SinCosLanes lanes = sin_cos(rest * Vec(kPerRadian));
    LaneTurn<kParts> turn;
    turn.cosine.part[0] = lanes.cosine;
    turn.sine.part[0] = lanes.sine;
    for (int p = 1; p < kParts; ++p) {
        turn.cosine.part[p] = -(lanes.sine * angle.part[p]);
        turn.sine.part[p] = lanes.cosine * angle.part[p];
    }
    return turn;
}

/// Converts a jet by the shifted place into a jet by the label, which moves the place through its
/// shift.
template <int kParts, int kStatic>
OCEAN_INLINE LaneJet<kParts> by_label(const LaneJet<kParts>& at_place,
                                      const LaneJet<kStatic>& shift_x,
                                      const LaneJet<kStatic>& shift_y) {
    LaneJet<kParts> jet = at_place;
    if constexpr (kParts > 1) {
        const Vec x = at_place.part[1];
        const Vec y = at_place.part[2];
        jet.part[1] = fma(y, shift_y.part[1], fma(x, shift_x.part[1], x));
        jet.part[2] = fma(x, shift_x.part[2], fma(y, shift_y.part[2], y));
    }
    return jet;
}

template <int kParts, bool kDisplaces>
OCEAN_INLINE void add_band_sector(const BandSectorTask& task) {
    constexpr int kStatic = kParts < 3 ? kParts : 3;
    for (std::size_t label = 0; label < task.count; label += kLanes) {
        const auto delay = [&](int field) OCEAN_INLINE_LAMBDA {
            LaneJet<kStatic> jet;
            for (int p = 0; p < kStatic; ++p) jet.part[p] = load(task.delay[p][field] + label);
            return jet;
        };
        const LaneJet<kStatic> shift_x = delay(0);
        const LaneJet<kStatic> shift_y = delay(1);
        const auto re = by_label(load_jet<kParts>(task.re, label), shift_x, shift_y);
        const auto im = by_label(load_jet<kParts>(task.im, label), shift_x, shift_y);

        // The signal times A e^(i P).
        const LaneTurn<kStatic> phase = turn_by(delay(2));
        const auto amplitude = load_jet<kStatic>(task.amplitude, label);
        const LaneJet<kStatic> cosine = amplitude * phase.cosine;
        const LaneJet<kStatic> sine = amplitude * phase.sine;
        const LaneJet<kParts> real = re * cosine - im * sine;
        const LaneJet<kParts> imaginary = re * sine + im * cosine;
        add_jet(task.real, label, real);
        add_jet(task.imaginary, label, imaginary);
        add_jet(task.squares, label, real * real + imaginary * imaginary);
        if constexpr (!kDisplaces) continue;

        LaneJet<kStatic> angle = delay(3);
        angle.part[0] = Vec(task.centre) + angle.part[0];
        const LaneTurn<kStatic> direction = turn_by(angle);
        const auto displacement = imaginary * load_jet<kStatic>(task.displacement, label);
        add_jet(task.along_x, label, displacement * direction.cosine);
        add_jet(task.along_y, label, displacement * direction.sine);
    }
}

static void run_band_sector_loop(const BandSectorTask& task) {
    switch (task.parts) {
        case JetParts::value:
            return task.displaces ? add_band_sector<1, true>(task)
                                  : add_band_sector<1, false>(task);
        case JetParts::gradient:
            return add_band_sector<3, true>(task);
        case JetParts::all:
            return add_band_sector<4, true>(task);
    }
}

extern const BandSectorLoop kBandSectorLoop;
constexpr BandSectorLoop kBandSectorLoop = run_band_sector_loop;

}  // namespace ocean::OCEAN_KERNEL
