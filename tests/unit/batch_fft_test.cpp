// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The transform of sixteen columns against the reference transform.
#include "base/batch_fft.hpp"

#include "ocean/internal/fft.hpp"
#include "ocean/internal/grid.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

// The transform of sixteen columns is that of the reference, for any share of zeros.
TEST(BatchFft, IsTheInverseTransform) {
    std::mt19937 numbers(3);
    std::normal_distribution<float> normal;
    for (const auto& [size, reach] : {std::pair{16, 0},
                                      {16, 1},
                                      {16, 2},
                                      {32, 5},
                                      {64, 31},
                                      {64, 32},
                                      {128, 15},
                                      {256, 16},
                                      {512, 85}}) {
        constexpr std::size_t kStride = 3;
        const auto waves = static_cast<std::size_t>(2 * reach + 1);
        std::vector<BatchRow> spectrum(waves * kStride);
        std::vector<std::vector<std::complex<double>>> columns(
            kFftBatch, std::vector<std::complex<double>>(static_cast<std::size_t>(size)));
        for (int k = -reach; k <= reach; ++k) {
            if (2 * k == -size) continue;
            BatchRow& row = spectrum[static_cast<std::size_t>(k + reach) * kStride];
            for (std::size_t c = 0; c < columns.size(); ++c) {
                row.real()[c] = normal(numbers);
                row.imaginary()[c] = normal(numbers);
                columns[c][static_cast<std::size_t>(fft_index(k, size))] = {row.real()[c],
                                                                            row.imaginary()[c]};
            }
        }
        std::vector<BatchRow> work(static_cast<std::size_t>(size));
        BatchFft(size, reach).transform(spectrum.data(), kStride, work.data());
        const double scale = std::sqrt(2.0 * static_cast<double>(waves));
        for (std::size_t c = 0; c < columns.size(); ++c) {
            Radix2Fft<double>(size).transform(columns[c].data(), 1, FftDirection::inverse);
            for (std::size_t j = 0; j < work.size(); ++j) {
                EXPECT_NEAR(work[j].real()[c], columns[c][j].real(), 2e-6 * scale);
                EXPECT_NEAR(work[j].imaginary()[c], columns[c][j].imag(), 2e-6 * scale);
            }
        }
    }
}

}  // namespace
}  // namespace ocean
