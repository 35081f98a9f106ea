// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Inverse transforms of sixteen columns at once, of spectra that hold few waves: the transform of
// maps that oversample their waves many times. The reference is Radix2Fft (ocean/internal/fft.hpp),
// with the same sign and scale.
#pragma once

#include <cstddef>
#include <vector>

namespace ocean {

inline constexpr int kFftBatch = 16;

/// Four floats, with the arithmetic of one. Every x86-64 and ARMv8 has such registers.
using FourFloats = float __attribute__((vector_size(16)));

/// One complex number of each of kFftBatch columns.
struct BatchRow {
    FourFloats re[kFftBatch / 4];
    FourFloats im[kFftBatch / 4];

    float* real() { return reinterpret_cast<float*>(re); }
    float* imaginary() { return reinterpret_cast<float*>(im); }
};

/// Cooley and Tukey's decimation in time, two steps of radix 2 in one. The first steps, at which
/// each group has only one input that is not zero, are written out without arithmetic on zeros.
/// Immutable: any thread may use it.
class BatchFft {
  public:
    /// Prepares transforms of `size` samples, a power of two, for the waves -reach .. reach; 2
    /// reach <= size. With 2 reach = size the transform is a whole one: wave -reach, which is wave
    /// reach, is not read.
    BatchFft(int size, int reach);
    int size() const { return size_; }
    int reach() const { return reach_; }
    /// Writes work[j] = sum over k = -reach .. reach of X_k exp(2 pi i j k / size), j < size, where
    /// X_k = spectrum[(k + reach) * stride].
    void transform(const BatchRow* spectrum, std::size_t stride, BatchRow* work) const;
    std::size_t bytes() const;

  private:
    void spread(const BatchRow* spectrum, std::size_t stride, BatchRow* work) const;
    void step(int half, BatchRow* work) const;
    void double_step(int half, BatchRow* work) const;

    int size_;
    int reach_;
    int group_;                       // samples of a group that has one input
    std::vector<int> wave_of_group_;  // index of the group's residue; -1: none
    std::vector<float> cosine_;       // cosine of 2 pi k / size, k < size / 2
    std::vector<float> sine_;
};

}  // namespace ocean
