// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The transform of sixteen columns against the reference transform.
#include "base/batch_fft.hpp"

#include "ocean/internal/fft.hpp"
#include "ocean/internal/grid.hpp"
#include "simd_levels.hpp"
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
                row.re[c] = normal(numbers);
                row.im[c] = normal(numbers);
                columns[c][static_cast<std::size_t>(fft_index(k, size))] = {row.re[c], row.im[c]};
            }
        }
        std::vector<BatchRow> work(static_cast<std::size_t>(size));
        BatchFft(size, reach).transform(spectrum.data(), kStride, {.work = work.data()});
        const double scale = std::sqrt(2.0 * static_cast<double>(waves));
        for (std::size_t c = 0; c < columns.size(); ++c) {
            Radix2Fft<double>(size).transform(columns[c].data(), 1, FftDirection::inverse);
            for (std::size_t j = 0; j < work.size(); ++j) {
                EXPECT_NEAR(work[j].re[c], columns[c][j].real(), 2e-6 * scale);
                EXPECT_NEAR(work[j].im[c], columns[c][j].imag(), 2e-6 * scale);
            }
        }
    }
}

// Numbers side by side are those of the rows; rows that nobody needs are left as they were.
TEST(BatchFft, EveryInstructionSetMakesTheBitsOfTheNeededRows) {
    constexpr std::size_t kPitch = kFftBatch + 3;
    constexpr float kBefore = 99.0f;
    std::mt19937 random(4);
    std::normal_distribution<float> normal;
    for (const auto& [size, reach] :
         {std::pair{16, 0}, {32, 9}, {64, 32}, {512, 85}, {2048, 94}, {4096, 30}}) {
        std::vector<BatchRow> spectrum(static_cast<std::size_t>(2 * reach + 1));
        for (BatchRow& row : spectrum) {
            for (float& re : row.re) re = normal(random);
            for (float& im : row.im) im = normal(random);
        }
        const auto rows = static_cast<std::size_t>(size);
        std::vector<BatchRow> whole(rows), work(rows);
        BatchFft(size, reach, SimdLevel::portable)
            .transform(spectrum.data(), 1, {.work = whole.data()});
        std::vector<std::uint8_t> needed(rows);
        for (std::size_t j = 0; j < rows; j += 13) needed[j] = 1;
        for (const SimdLevel level : test::levels()) {
            const BatchFft fft(size, reach, level);
            std::vector<float> numbers(2 * kPitch * rows, kBefore);
            fft.transform(spectrum.data(), 1, {work.data(), needed.data(), numbers.data(), kPitch});
            fft.transform(spectrum.data(), 1, {work.data(), needed.data()});
            for (std::size_t j = 0; j < rows; ++j) {
                for (std::size_t c = 0; c < kFftBatch; ++c) {
                    const float* const number = &numbers[2 * (j * kPitch + c)];
                    const bool is_needed = needed[j] != 0;
                    ASSERT_EQ(number[0], is_needed ? whole[j].re[c] : kBefore) << simd_name(level);
                    ASSERT_EQ(number[1], is_needed ? whole[j].im[c] : kBefore) << simd_name(level);
                    if (!is_needed) continue;
                    ASSERT_EQ(work[j].re[c], whole[j].re[c]) << simd_name(level);
                    ASSERT_EQ(work[j].im[c], whole[j].im[c]) << simd_name(level);
                }
            }
        }
    }
}

}  // namespace
}  // namespace ocean
