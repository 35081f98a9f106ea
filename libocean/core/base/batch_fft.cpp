// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The transform of sixteen columns; see batch_fft.hpp.
#include "base/batch_fft.hpp"

#include <cmath>

#include "ocean/internal/grid.hpp"

namespace ocean {

namespace {

constexpr int kParts = kFftBatch / 4;

}  // namespace

BatchFft::BatchFft(int size, int reach) : size_(size), reach_(reach), group_(1) {
    while (size / (2 * group_) >= 2 * reach + 1) group_ *= 2;
    const int groups = size / group_;
    wave_of_group_.assign(static_cast<std::size_t>(groups), reach + 1);
    int bits = 0;
    while ((1 << bits) < groups) ++bits;
    for (int wave = -reach; wave <= reach; ++wave) {
        const int residue = wave < 0 ? wave + groups : wave;
        int reversed = 0;
        for (int b = 0; b < bits; ++b) reversed |= ((residue >> b) & 1) << (bits - 1 - b);
        wave_of_group_[static_cast<std::size_t>(reversed)] = wave;
    }
    for (int k = 0; k < size / 2; ++k) {
        const double angle = kTwoPi * k / size;
        cosine_.push_back(static_cast<float>(std::cos(angle)));
        sine_.push_back(static_cast<float>(std::sin(angle)));
    }
}

std::size_t BatchFft::bytes() const {
    return wave_of_group_.size() * sizeof(int) + 2 * cosine_.size() * sizeof(float);
}

void BatchFft::transform(const BatchRow* spectrum, std::size_t stride, BatchRow* work) const {
    spread(spectrum, stride, work);
    int half = group_;
    for (; 4 * half <= size_; half *= 4) double_step(half, work);
    if (2 * half <= size_) step(half, work);
}

// The inputs of a group are every groups-th wave. Within -reach .. reach that is one wave: k
// itself, the first input, or k < 0, the last input. The group therefore has one wave, of frequency
// 0 or -1.
void BatchFft::spread(const BatchRow* spectrum, std::size_t stride, BatchRow* work) const {
    for (const int wave : wave_of_group_) {
        if (wave > reach_) {
            for (int j = 0; j < group_; ++j) *work++ = BatchRow{};
            continue;
        }
        const BatchRow& input = spectrum[static_cast<std::size_t>(wave + reach_) * stride];
        for (int j = 0; j < group_; ++j, ++work) {
            if (wave >= 0 || j == 0) {
                *work = input;
                continue;
            }
            // e^(-2 pi i j / group); beyond half a turn, minus the root half a turn before.
            const bool far = 2 * j >= group_;
            const auto at = static_cast<std::size_t>((far ? j - group_ / 2 : j) * (size_ / group_));
            const float c = far ? -cosine_[at] : cosine_[at];
            const float s = far ? sine_[at] : -sine_[at];
            for (int p = 0; p < kParts; ++p) {
                work->re[p] = input.re[p] * c - input.im[p] * s;
                work->im[p] = input.re[p] * s + input.im[p] * c;
            }
        }
    }
}

void BatchFft::step(int half, BatchRow* work) const {
    const auto turn = static_cast<std::size_t>(size_ / (2 * half));
    for (BatchRow* start = work; start < work + size_; start += 2 * half) {
        for (int k = 0; k < half; ++k) {
            const float c = cosine_[static_cast<std::size_t>(k) * turn];
            const float s = sine_[static_cast<std::size_t>(k) * turn];
            BatchRow& a = start[k];
            BatchRow& b = start[k + half];
            for (int p = 0; p < kParts; ++p) {
                const FourFloats re = b.re[p] * c - b.im[p] * s;
                const FourFloats im = b.re[p] * s + b.im[p] * c;
                b.re[p] = a.re[p] - re;
                b.im[p] = a.im[p] - im;
                a.re[p] += re;
                a.im[p] += im;
            }
        }
    }
}

// step(half) and step(2 half) in one pass over the memory.
void BatchFft::double_step(int half, BatchRow* work) const {
    const auto turn = static_cast<std::size_t>(size_ / (4 * half));
    for (BatchRow* start = work; start < work + size_; start += 4 * half) {
        for (int k = 0; k < half; ++k) {
            const auto at = static_cast<std::size_t>(k) * turn;
            const float c1 = cosine_[2 * at];
            const float s1 = sine_[2 * at];
            const float c2 = cosine_[at];
            const float s2 = sine_[at];
            BatchRow& a = start[k];
            BatchRow& b = start[k + half];
            BatchRow& c = start[k + 2 * half];
            BatchRow& d = start[k + 3 * half];
            for (int p = 0; p < kParts; ++p) {
                const FourFloats b_re = b.re[p] * c1 - b.im[p] * s1;
                const FourFloats b_im = b.re[p] * s1 + b.im[p] * c1;
                const FourFloats d_re = d.re[p] * c1 - d.im[p] * s1;
                const FourFloats d_im = d.re[p] * s1 + d.im[p] * c1;
                const FourFloats e_re = c.re[p] + d_re;
                const FourFloats e_im = c.im[p] + d_im;
                const FourFloats f_re = c.re[p] - d_re;
                const FourFloats f_im = c.im[p] - d_im;
                const FourFloats g_re = e_re * c2 - e_im * s2;
                const FourFloats g_im = e_re * s2 + e_im * c2;
                const FourFloats h_re = f_re * c2 - f_im * s2;
                const FourFloats h_im = f_re * s2 + f_im * c2;
                const FourFloats p_re = a.re[p] + b_re;
                const FourFloats p_im = a.im[p] + b_im;
                const FourFloats q_re = a.re[p] - b_re;
                const FourFloats q_im = a.im[p] - b_im;
                a.re[p] = p_re + g_re;
                a.im[p] = p_im + g_im;
                c.re[p] = p_re - g_re;
                c.im[p] = p_im - g_im;
                // In the second half, the root has turned by a further quarter: times i.
                b.re[p] = q_re - h_im;
                b.im[p] = q_im + h_re;
                d.re[p] = q_re + h_im;
                d.im[p] = q_im - h_re;
            }
        }
    }
}

}  // namespace ocean
