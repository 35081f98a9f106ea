// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Inverse transforms of sixteen columns at once, of spectra that hold few waves: the transform of
// maps that oversample their waves many times. The reference is Radix2Fft (ocean/internal/fft.hpp),
// with the same sign and scale.
#pragma once

#include <cstddef>
#include <vector>

#include "base/batch_fft_task.hpp"

namespace ocean {

/// Cooley and Tukey's decimation in time, two steps of radix 2 in one. The first steps, at which
/// each group has only one input that is not zero, are written out without arithmetic on zeros.
/// Immutable: any thread may use it.
class BatchFft {
  public:
    /// Prepares transforms of `size` samples, a power of two, for the waves -reach .. reach; 2
    /// reach <= size. With 2 reach = size the transform is a whole one: wave -reach, which is wave
    /// reach, is not read.
    BatchFft(int size, int reach, SimdLevel level = simd_level());
    int size() const { return size_; }
    int reach() const { return reach_; }
    /// Makes row j = sum over k = -reach .. reach of X_k exp(2 pi i j k / size), j < size, where
    /// X_k = spectrum[(k + reach) * stride]. Other rows of `out` are as good as unwritten.
    void transform(const BatchRow* spectrum, std::size_t stride, const BatchOutput& out) const;
    std::size_t bytes() const;

  private:
    int size_;
    int reach_;
    int group_;                       // samples of a group that has one input
    std::vector<int> wave_of_group_;  // index of the group's residue; reach + 1: none
    std::vector<float> cosine_;       // cosine of 2 pi k / size, k < size / 2
    std::vector<float> sine_;
    BatchFftLoop loop_;
};

}  // namespace ocean
