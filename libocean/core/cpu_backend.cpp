// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The `cpu` backend, the default. Fields are real, so half of the kx axis is enough: transforms
// along y of the columns kx >= 0, then along x with two rows of the map in one complex line.
// Sixteen lines at a time, threads over blocks of lines; no sum depends on the number of threads.
#include <algorithm>
#include <cmath>

#include "lane_fft.hpp"
#include "ocean/thread_pool.hpp"
#include "synthesis.hpp"

namespace ocean {

namespace {

// 1.5 * 2^52: adding and subtracting it rounds a double to an integer, without a library call.
constexpr double kRound = 6755399441055744.0;

/// h, dh/dt and the excursion of kLanes columns kx at one ky.
struct LaneState {
    float re[kLanes], im[kLanes], rate_re[kLanes], rate_im[kLanes], excursion[kLanes];
};

/// Sine and cosine of turns, reduced in double: shaders/wave/turns.glsl, shortened to what float
/// holds and without branches.
void sin_cos_lanes(const double* turns, float* sine, float* cosine) {
    for (int l = 0; l < kLanes; ++l) {
        const double quarter = (4.0 * turns[l] + kRound) - kRound;
        const auto x = static_cast<float>((turns[l] - 0.25 * quarter) * 6.283185307179586);
        const double which = quarter - 4.0 * ((0.25 * quarter - 0.375 + kRound) - kRound);
        const int q = static_cast<int>(which);  // 0 .. 3
        const float x2 = x * x;
        float s = -1.0f / 5040.0f;
        s = s * x2 + 1.0f / 120.0f;
        s = s * x2 - 1.0f / 6.0f;
        s = x + x * x2 * s + x * x2 * x2 * x2 * x2 * (1.0f / 362880.0f);
        float c = -1.0f / 3628800.0f;
        c = c * x2 + 1.0f / 40320.0f;
        c = c * x2 - 1.0f / 720.0f;
        c = c * x2 + 1.0f / 24.0f;
        c = c * x2 - 0.5f;
        c = c * x2 + 1.0f;
        const float first = (q & 1) != 0 ? c : s;
        const float second = (q & 1) != 0 ? s : c;
        sine[l] = (q & 2) != 0 ? -first : first;
        cosine[l] = q == 1 || q == 2 ? -second : second;
    }
}

class Synthesis {
  public:
    Synthesis(const SynthesisRequest& request, ThreadPool& pool)
        : request_(request),
          pool_(pool),
          size_(request.resolution),
          half_((request.half_band() + kLanes - 1) / kLanes * kLanes),
          fft_(request.resolution) {
        const std::size_t columns = at(half_, size_);
        for (std::size_t f = 0; f < request.fields.size(); ++f) {
            column_re_.emplace_back(columns);
            column_im_.emplace_back(columns);
        }
    }

    LinearPlanes<float> run() {
        LinearPlanes<float> planes;
        for (const Linear field : request_.fields) planes[field].resize(at(size_, size_));
        pool_.for_each_range(half_ / kLanes, [this](int first, int last) {
            std::vector<LaneState> states(static_cast<std::size_t>(2 * half_ - 1));
            LaneBlock block(size_);
            LaneBlock work(size_);
            for (int b = first; b < last; ++b) transform_columns(b * kLanes, states, block, work);
        });
        pool_.for_each_range(size_ / 2 / kLanes, [this, &planes](int first, int last) {
            LaneBlock block(size_);
            LaneBlock work(size_);
            for (int b = first; b < last; ++b) transform_rows(b * kLanes, planes, block, work);
        });
        return planes;
    }

  private:
    static std::size_t at(int row, int row_length) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(row_length);
    }

    /// Adds one cascade to the columns n0 .. n0 + kLanes - 1 of the map, all ky.
    void add_cascade(const CascadeModes& cascade, int n0, std::vector<LaneState>& states) const {
        const int stride = request_.stride(cascade);
        const int half = request_.half(cascade);
        int columns[kLanes];  // of the cascade; -1 where it has none: mode (0, 0) is zero
        bool any = false;
        for (int l = 0; l < kLanes; ++l) {
            const bool there = (n0 + l) % stride == 0 && (n0 + l) / stride < half;
            columns[l] = there ? (n0 + l) / stride : -1;
            any = any || there;
        }
        if (!any) return;
        for (int m = -half + 1; m < half; ++m) {
            add_modes(cascade, columns, m,
                      states[static_cast<std::size_t>(m * stride + half_ - 1)]);
        }
    }

    /// Modes (columns[l], m) of a cascade: shaders/wave/phase.glsl across lanes.
    void add_modes(const CascadeModes& cascade, const int* columns, int m, LaneState& state) const {
        const int width = cascade.lattice.resolution;
        const std::size_t row = at(fft_index(m, width), width);
        const std::size_t mirror_row = at(fft_index(-m, width), width);
        const double unit = kTwoPi * request_.rate_unit;
        std::size_t index[kLanes], mirror_index[kLanes];
        double turns[kLanes], rate[kLanes];
        float sine[kLanes], cosine[kLanes];
        for (int l = 0; l < kLanes; ++l) {
            const bool there = columns[l] >= 0;
            index[l] = there ? row + static_cast<std::size_t>(columns[l]) : 0;
            mirror_index[l] =
                there ? mirror_row + static_cast<std::size_t>(fft_index(-columns[l], width)) : 0;
        }
        for (int l = 0; l < kLanes; ++l) {
            rate[l] = static_cast<double>(cascade.rate_high[index[l]]) + cascade.rate_low[index[l]];
            const double whole = rate[l] * request_.tau;
            turns[l] = whole - ((whole + kRound) - kRound);
        }
        sin_cos_lanes(turns, sine, cosine);
        for (int l = 0; l < kLanes; ++l) {
            const std::complex<float> h = cascade.h0[index[l]];
            const std::complex<float> mirror = cascade.h0[mirror_index[l]];
            const float forward_re = h.real() * cosine[l] + h.imag() * sine[l];
            const float forward_im = h.imag() * cosine[l] - h.real() * sine[l];
            const float mirror_re = mirror.real() * cosine[l] + mirror.imag() * sine[l];
            const float mirror_im = mirror.real() * sine[l] - mirror.imag() * cosine[l];
            const auto omega = static_cast<float>(rate[l] * unit);
            state.re[l] += forward_re + mirror_re;
            state.im[l] += forward_im + mirror_im;
            state.rate_re[l] += omega * (forward_im - mirror_im);
            state.rate_im[l] += omega * (mirror_re - forward_re);
            if (columns[l] >= 0) state.excursion[l] = cascade.excursion[index[l]];
        }
    }

    /// Coefficients of one field for kLanes columns, in FFT order along ky.
    void fill_block(Linear field, int n0, const std::vector<LaneState>& states,
                    LaneBlock& block) const {
        const LinearShape shape = linear_shape(field);
        const auto step = static_cast<float>(request_.wavenumber_step());
        std::fill(block.re.begin(), block.re.end(), 0.0f);
        std::fill(block.im.begin(), block.im.end(), 0.0f);
        for (int m = -half_ + 1; m < half_; ++m) {
            const LaneState& state = states[static_cast<std::size_t>(m + half_ - 1)];
            const float* in_re = shape.rate ? state.rate_re : state.re;
            const float* in_im = shape.rate ? state.rate_im : state.im;
            float* out_re = block.re.data() + at(fft_index(m, size_), kLanes);
            float* out_im = block.im.data() + at(fft_index(m, size_), kLanes);
            float fixed = static_cast<float>(shape.sign);
            for (int i = 0; i < shape.y_power; ++i) fixed *= step * static_cast<float>(m);
            for (int l = 0; l < kLanes; ++l) {
                const float kx = step * static_cast<float>(n0 + l);
                float factor = fixed;
                if (shape.x_power > 0) factor *= kx;
                if (shape.x_power > 1) factor *= kx;
                if (shape.excursion) factor *= state.excursion[l];
                out_re[l] = shape.odd ? -factor * in_im[l] : factor * in_re[l];
                out_im[l] = shape.odd ? factor * in_re[l] : factor * in_im[l];
            }
        }
    }

    /// Columns kx = n0 .. n0 + kLanes - 1 of every field, along y; result as [kx][y].
    void transform_columns(int n0, std::vector<LaneState>& states, LaneBlock& block,
                           LaneBlock& work) {
        std::fill(states.begin(), states.end(), LaneState{});
        for (const CascadeModes& cascade : request_.cascades) add_cascade(cascade, n0, states);
        for (std::size_t f = 0; f < request_.fields.size(); ++f) {
            fill_block(request_.fields[f], n0, states, block);
            fft_.inverse(block, work);
            transpose(block.re, column_re_[f].data() + at(n0, size_));
            transpose(block.im, column_im_[f].data() + at(n0, size_));
        }
    }

    /// [element][lane] of a block to rows of `size_`, one per lane, in tiles that stay in L1.
    void transpose(const std::vector<float>& block, float* rows) const {
        for (int tile = 0; tile < size_; tile += kLanes) {
            for (int l = 0; l < kLanes; ++l) {
                float* row = rows + at(l, size_) + tile;
                const float* column = block.data() + at(tile, kLanes) + l;
                for (int i = 0; i < kLanes; ++i) row[i] = column[i * kLanes];
            }
        }
    }

    /// Rows j0 .. j0 + kLanes - 1 as real parts and the rows half a map further as imaginary parts:
    /// Z(kx) = A + i B, and Z(-kx) = conj(A) + i conj(B) because both rows are real.
    void transform_rows(int j0, LinearPlanes<float>& planes, LaneBlock& block,
                        LaneBlock& work) const {
        for (std::size_t f = 0; f < request_.fields.size(); ++f) {
            std::fill(block.re.begin(), block.re.end(), 0.0f);
            std::fill(block.im.begin(), block.im.end(), 0.0f);
            for (int n = 0; n < half_; ++n) {
                const std::size_t offset = at(n, size_) + static_cast<std::size_t>(j0);
                const float* a_re = column_re_[f].data() + offset;
                const float* a_im = column_im_[f].data() + offset;
                const float* b_re = a_re + size_ / 2;
                const float* b_im = a_im + size_ / 2;
                float* plus_re = block.re.data() + at(n, kLanes);
                float* plus_im = block.im.data() + at(n, kLanes);
                if (n == 0) {  // the mean along x of a real row is real
                    std::copy(a_re, a_re + kLanes, plus_re);
                    std::copy(b_re, b_re + kLanes, plus_im);
                    continue;
                }
                float* minus_re = block.re.data() + at(size_ - n, kLanes);
                float* minus_im = block.im.data() + at(size_ - n, kLanes);
                for (int l = 0; l < kLanes; ++l) {
                    plus_re[l] = a_re[l] - b_im[l];
                    plus_im[l] = a_im[l] + b_re[l];
                    minus_re[l] = a_re[l] + b_im[l];
                    minus_im[l] = b_re[l] - a_im[l];
                }
            }
            fft_.inverse(block, work);
            float* plane = planes[request_.fields[f]].data();
            transpose(block.re, plane + at(j0, size_));
            transpose(block.im, plane + at(j0 + size_ / 2, size_));
        }
    }

    const SynthesisRequest& request_;
    ThreadPool& pool_;
    int size_;  // of the map
    int half_;  // columns that may hold modes, in whole blocks
    LaneFft fft_;
    std::vector<std::vector<float>> column_re_;  // per field: [kx][y]
    std::vector<std::vector<float>> column_im_;
};

}  // namespace

LinearPlanes<float> synthesize_cpu(const SynthesisRequest& request, ThreadPool& pool) {
    return Synthesis(request, pool).run();
}

}  // namespace ocean
