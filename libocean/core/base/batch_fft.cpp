// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The transform of sixteen columns; see batch_fft.hpp.
#include "base/batch_fft.hpp"

#include <cmath>

#include "ocean/internal/grid.hpp"

namespace ocean {

BatchFft::BatchFft(int size, int reach, SimdLevel level)
    : size_(size), reach_(reach), group_(1), loop_(batch_fft_loop(level)) {
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

void BatchFft::transform(const BatchRow* spectrum, std::size_t stride,
                         const BatchOutput& out) const {
    loop_({size_, reach_, group_, wave_of_group_.data(), cosine_.data(), sine_.data(), spectrum,
           stride, out});
}

}  // namespace ocean
