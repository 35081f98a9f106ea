// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The transform across lanes; see lane_fft.hpp.
#include "lane_fft.hpp"

#include <cmath>

#include "ocean/grid.hpp"

namespace ocean {

LaneFft::LaneFft(int n) : n_(n) {
    for (int k = 0; k < n; ++k) {
        const double angle = kTwoPi * k / n;
        twiddle_.push_back(
            {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))});
    }
}

namespace {

struct Planes {
    float* re;
    float* im;
};

/// One radix-4 butterfly for `count` neighbouring elements, `quarter` apart in x and `count` in y.
template <typename Twiddle>
void butterfly_4(Planes x, Planes y, int count, int quarter, Twiddle w1, Twiddle w2, Twiddle w3) {
    const float* __restrict xr = x.re;
    const float* __restrict xi = x.im;
    float* __restrict yr = y.re;
    float* __restrict yi = y.im;
    for (int i = 0; i < count; ++i) {
        const float ar = xr[i], ai = xi[i];
        const float br = xr[i + quarter], bi = xi[i + quarter];
        const float cr = xr[i + 2 * quarter], ci = xi[i + 2 * quarter];
        const float dr = xr[i + 3 * quarter], di = xi[i + 3 * quarter];
        const float apc_r = ar + cr, apc_i = ai + ci;
        const float amc_r = ar - cr, amc_i = ai - ci;
        const float bpd_r = br + dr, bpd_i = bi + di;
        const float turned_r = di - bi, turned_i = br - dr;  // i (b - d)
        const float one_r = amc_r + turned_r, one_i = amc_i + turned_i;
        const float two_r = apc_r - bpd_r, two_i = apc_i - bpd_i;
        const float three_r = amc_r - turned_r, three_i = amc_i - turned_i;
        yr[i] = apc_r + bpd_r;
        yi[i] = apc_i + bpd_i;
        yr[i + count] = w1.re * one_r - w1.im * one_i;
        yi[i + count] = w1.re * one_i + w1.im * one_r;
        yr[i + 2 * count] = w2.re * two_r - w2.im * two_i;
        yi[i + 2 * count] = w2.re * two_i + w2.im * two_r;
        yr[i + 3 * count] = w3.re * three_r - w3.im * three_i;
        yi[i + 3 * count] = w3.re * three_i + w3.im * three_r;
    }
}

void butterfly_2(Planes x, Planes y, int count) {
    const float* __restrict xr = x.re;
    const float* __restrict xi = x.im;
    float* __restrict yr = y.re;
    float* __restrict yi = y.im;
    for (int i = 0; i < count; ++i) {
        yr[i] = xr[i] + xr[i + count];
        yi[i] = xi[i] + xi[i + count];
        yr[i + count] = xr[i] - xr[i + count];
        yi[i + count] = xi[i] - xi[i + count];
    }
}

}  // namespace

void LaneFft::inverse(LaneBlock& data, LaneBlock& work) const {
    LaneBlock* from = &data;
    LaneBlock* to = &work;
    int length = n_;  // of the transforms still to be done
    int stride = 1;   // how many of them are interleaved
    for (; length >= 4; length /= 4, stride *= 4) {
        const int count = stride * kLanes;
        const int quarter = length / 4 * count;
        for (int p = 0; p < length / 4; ++p) {
            const auto w = [&](int power) {
                return twiddle_[static_cast<std::size_t>(p * power * stride)];
            };
            butterfly_4(Planes{from->re.data() + p * count, from->im.data() + p * count},
                        Planes{to->re.data() + 4 * p * count, to->im.data() + 4 * p * count}, count,
                        quarter, w(1), w(2), w(3));
        }
        std::swap(from, to);
    }
    if (length == 2) {
        butterfly_2(Planes{from->re.data(), from->im.data()}, Planes{to->re.data(), to->im.data()},
                    stride * kLanes);
        std::swap(from, to);
    }
    if (from != &data) std::swap(data, work);
}

}  // namespace ocean
