// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The blur: see grid_blur.hpp. Along each axis four boxes follow each other, whose convolution is a
// Gaussian but for 4 % of its peak. Boxes of whole samples have only certain deviations; these
// boxes give their two outermost samples a smaller weight, so that the variance is exact [Gwosdek
// 2011]. The blur uses no exponential, so that all machines get the same bits.
#include "grid_blur.hpp"

#include <algorithm>
#include <cmath>

namespace ocean {
namespace {

constexpr int kBoxes = 4;

/// Weights of a box: `inner` for the samples within `radius`, `outer` for the next sample at each
/// end.
struct Box {
    int radius;
    double inner;
    double outer;

    /// Returns the box of a variance v [samples^2]. With 2 r + 1 samples of weight 1 and two of
    /// weight a the variance is (r (r + 1) (2 r + 1) / 3 + 2 a (r + 1)^2) / (2 r + 1 + 2 a).
    static Box of_variance(double v) {
        const int radius = static_cast<int>(0.5 * (std::sqrt(12.0 * v + 1.0) - 1.0));
        const double r = radius, samples = 2.0 * r + 1.0;
        const double a = samples * (v - r * (r + 1.0) / 3.0) / (2.0 * ((r + 1.0) * (r + 1.0) - v));
        return {radius, 1.0 / (samples + 2.0 * a), a / (samples + 2.0 * a)};
    }

    int reach() const { return radius + 1; }
};

/// Applies a box to interleaved lines in place. Sample k of the result, k < length, is centred on
/// sample k + reach() of the input, which has length + 2 reach() samples.
void apply(const Box& box, int length, float* lines) {
    double sum[kGridLanes] = {};
    for (int k = 1; k <= 2 * box.radius + 1; ++k) {
        for (int l = 0; l < kGridLanes; ++l) sum[l] += double{lines[k * kGridLanes + l]};
    }
    const int last = 2 * box.reach();
    for (int k = 0; k < length; ++k) {
        float* const first = lines + k * kGridLanes;
        const float* const next = first + last * kGridLanes;
        for (int l = 0; l < kGridLanes; ++l) {
            const double ends = double{first[l]} + double{next[l]};
            first[l] = static_cast<float>(sum[l] * box.inner + ends * box.outer);
            sum[l] += double{next[l]} - double{first[kGridLanes + l]};
        }
    }
}

void blur_lines(std::span<float> map, const GridLines& lines, const Box& box,
                LineBuffers<float>& buffers, GridPasses& passes) {
    const int pad = kBoxes * box.reach();
    const auto samples = static_cast<std::size_t>(lines.length + 2 * pad);
    passes.run(lines.count, [&](int first, int lanes, int thread) {
        float* const buffer = buffers.of(thread, samples * kGridLanes);
        for (int k = 0; k < lines.length + 2 * pad; ++k) {
            const int from = std::clamp(k - pad, 0, lines.length - 1);
            for (int l = 0; l < kGridLanes; ++l) {
                buffer[k * kGridLanes + l] = map[lines.index(first + std::min(l, lanes - 1), from)];
            }
        }
        for (int b = 1; b <= kBoxes; ++b) {
            apply(box, lines.length + 2 * (pad - b * box.reach()), buffer);
        }
        for (int k = 0; k < lines.length; ++k) {
            for (int l = 0; l < lanes; ++l) {
                map[lines.index(first + l, k)] = buffer[k * kGridLanes + l];
            }
        }
    });
}

}  // namespace

void blur(std::span<float> map, const SampleGrid& grid, double deviation, GridPasses& passes) {
    const double widest = 2.0 * std::max(grid.columns, grid.rows);
    const double d = std::min(deviation, widest);
    const Box box = Box::of_variance(d * d / kBoxes);
    LineBuffers<float> buffers(passes.pool());
    blur_lines(map, GridLines::rows(grid), box, buffers, passes);
    blur_lines(map, GridLines::columns(grid), box, buffers, passes);
}

}  // namespace ocean
