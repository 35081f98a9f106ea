// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The transforms keep the contract of fft.hpp: sign, scale, order.
#include "ocean/internal/fft.hpp"

#include <fftw3.h>

#include "direct_dft.hpp"

namespace ocean {
namespace {

using Complex = std::complex<double>;

std::vector<Complex> random_values(std::size_t n) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<Complex> values(n);
    for (Complex& value : values) value = {normal(random), normal(random)};
    return values;
}

double largest_difference(std::span<const Complex> a, std::span<const Complex> b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

TEST(Fft, InverseOfOneModeIsExpPlusIkx) {
    constexpr int kSize = 32;
    std::vector<Complex> data(kSize);
    data[3] = 1.0;
    Radix2Fft<double>(kSize).transform(data.data(), 1, FftDirection::inverse);
    for (int j = 0; j < kSize; ++j) {
        const Complex expected = std::polar(1.0, kTwoPi * 3 * j / kSize);
        EXPECT_NEAR(std::abs(data[static_cast<std::size_t>(j)] - expected), 0.0, 1e-14);
    }
}

TEST(Fft, AgreesWithTheDirectSumForEverySizeAndDirection) {
    for (int n = 2; n <= 4096; n *= 2) {
        if (n > 512 && n != 4096) continue;
        const std::vector<Complex> input = random_values(static_cast<std::size_t>(n));
        for (const FftDirection direction : {FftDirection::forward, FftDirection::inverse}) {
            std::vector<Complex> data = input;
            Radix2Fft<double>(n).transform(data.data(), 1, direction);
            EXPECT_LT(largest_difference(data, test::direct_dft(input, direction)), 1e-11 * n);
        }
    }
}

TEST(Fft, AgreesWithFftw) {
    constexpr int kSize = 64;
    std::vector<Complex> data = random_values(kSize * kSize);
    std::vector<Complex> expected = data;
    auto* raw = reinterpret_cast<fftw_complex*>(expected.data());
    fftw_plan plan = fftw_plan_dft_2d(kSize, kSize, raw, raw, FFTW_BACKWARD, FFTW_ESTIMATE);
    fftw_execute(plan);
    fftw_destroy_plan(plan);
    Radix2Fft<double>(kSize).transform_2d(data, FftDirection::inverse);
    EXPECT_LT(largest_difference(data, expected), 1e-10);
}

TEST(Fft, InverseOfForwardIsNTimesTheInput) {
    constexpr int kSize = 256;
    const std::vector<Complex> input = random_values(kSize);
    std::vector<Complex> data = input;
    const Radix2Fft<double> fft(kSize);
    fft.transform(data.data(), 1, FftDirection::forward);
    fft.transform(data.data(), 1, FftDirection::inverse);
    for (Complex& value : data) value /= kSize;
    EXPECT_LT(largest_difference(data, input), 1e-13);
}

TEST(Fft, ColumnsAreReadWithAStride) {
    constexpr int kSize = 16;
    const std::vector<Complex> input = random_values(kSize * 3);
    std::vector<Complex> data = input;
    Radix2Fft<double>(kSize).transform(data.data() + 1, 3, FftDirection::forward);
    std::vector<Complex> column;
    for (int i = 0; i < kSize; ++i) column.push_back(input[static_cast<std::size_t>(3 * i + 1)]);
    const std::vector<Complex> expected = test::direct_dft(column, FftDirection::forward);
    for (int i = 0; i < kSize; ++i) {
        const auto at = static_cast<std::size_t>(i);
        EXPECT_NEAR(std::abs(data[3 * at + 1] - expected[at]), 0.0, 1e-12);
        EXPECT_EQ(data[3 * at], input[3 * at]) << "a neighbour was touched";
    }
}

}  // namespace
}  // namespace ocean
