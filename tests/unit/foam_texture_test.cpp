// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Textures of foam: a cover equals its share of bilinear reads, textures have no seam, the bits do
// not depend on the number of threads, a finer texture is the same foam, kinds and seeds are
// independent, streaks follow the wind.
#include "ocean/internal/foam_texture.hpp"

#include "field/bilinear.hpp"
#include "ocean/internal/sha256.hpp"
#include "ocean/thread_pool.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"
#include "wave/wave.hpp"

namespace ocean {
namespace {

constexpr FoamTextureKind kKinds[] = {FoamTextureKind::lace, FoamTextureKind::bubbles,
                                      FoamTextureKind::streaks};

struct Texture {
    int size;
    std::vector<float> values;

    float at(int i, int j) const {
        const int mask = size - 1;
        return values[static_cast<std::size_t>((j & mask) * size + (i & mask))];
    }
    /// Reads as a host does, x and y in texels.
    double read(double x, double y) const {
        const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
        const double u = x - i, v = y - j;
        return bilinear(at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1), u, v);
    }
};

Texture texture_of(FoamTextureKind kind, int size, std::uint32_t seed = 1, int threads = 2) {
    ThreadPool pool(threads);
    return {size, make_foam_texture({kind, size, seed}, pool)};
}

double correlation(const std::vector<float>& a, const std::vector<float>& b) {
    test::LineFit fit;
    for (std::size_t i = 0; i < a.size(); ++i) fit.add(a[i], b[i]);
    return fit.correlation();
}

// Files of textures name their edition. If these hashes change, so must kFoamTextureEdition.
TEST(FoamTexture, AnEditionHasItsValues) {
    ASSERT_EQ(kFoamTextureEdition, 1);
    constexpr const char* kHashes[] = {"c4933e97c3cd8ff7", "2febfbe62f6f7fcf", "ab4d89cc705b3033"};
    for (std::size_t k = 0; k < std::size(kKinds); ++k) {
        const Texture texture = texture_of(kKinds[k], 128);
        EXPECT_EQ(sha256_hex(std::as_bytes(std::span(texture.values))).substr(0, 16), kHashes[k]);
    }
}

// The reads of this judge lie elsewhere than the library's: at random.
TEST(FoamTexture, CoverIsTheShareOfBilinearReadsBelowIt) {
    constexpr std::array kCovers = {0.003, 0.02, 0.1, 0.27, 0.5, 0.7, 0.9};
    constexpr std::array kErrors = {3e-4, 4e-4, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3};
    // A read in each of 1000 x 1000 squares of the texture errs less than four million anywhere.
    constexpr double kReads = 4e6;
    for (const FoamTextureKind kind : kKinds) {
        for (const int size : {64, 256, 1024}) {
            const Texture texture = texture_of(kind, size);
            // Two texels a bubble know little of each other: texels alone cannot settle reads.
            const bool unresolved = kind == FoamTextureKind::bubbles && size == 64;
            std::array<double, kCovers.size()> below{};
            for (const auto [i, j, n] : test::cells(1000, 1000)) {
                const auto bits = wave::double_precision::philox_4x32(static_cast<std::uint32_t>(n),
                                                                      0u, 0u, 0u, 7u, 0u);
                const double read = texture.read((i + bits.a * 0x1p-32) * 1e-3 * size,
                                                 (j + bits.b * 0x1p-32) * 1e-3 * size);
                for (std::size_t k = 0; k < kCovers.size(); ++k) {
                    below[k] += read < kCovers[k] ? 1e-6 : 0.0;
                }
            }
            for (std::size_t k = 0; k < kCovers.size(); ++k) {
                const double cover = kCovers[k];
                const double noise = 3.0 * std::sqrt(cover * (1.0 - cover) / kReads);
                EXPECT_NEAR(below[k], cover, (unresolved ? 6e-3 : kErrors[k]) + noise)
                    << foam_texture_info(kind).name << " " << size;
            }
        }
    }
}

TEST(FoamTexture, ValuesReachFromZeroToOne) {
    for (const FoamTextureKind kind : kKinds) {
        const std::vector<float> values = texture_of(kind, 256).values;
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        EXPECT_TRUE(*least >= 0.0f && *least < 0.01f) << *least;
        EXPECT_TRUE(*most <= 1.0f && *most > 0.99f) << *most;
    }
}

// Differences from texel to texel across the seam are those of any other line.
TEST(FoamTexture, HasNoSeam) {
    constexpr int kSize = 512;
    for (const FoamTextureKind kind : kKinds) {
        const Texture texture = texture_of(kind, kSize);
        std::vector<double> columns, rows;  // mean square differences across each line
        for (int line = 0; line < kSize; ++line) {
            double across_column = 0.0, across_row = 0.0;
            for (int k = 0; k < kSize; ++k) {
                across_column += std::pow(texture.at(line + 1, k) - texture.at(line, k), 2);
                across_row += std::pow(texture.at(k, line + 1) - texture.at(k, line), 2);
            }
            columns.push_back(across_column / kSize);
            rows.push_back(across_row / kSize);
        }
        for (auto* lines : {&columns, &rows}) {
            const double seam = lines->back();
            lines->pop_back();
            const auto [least, most] = std::minmax_element(lines->begin(), lines->end());
            EXPECT_TRUE(seam > *least && seam < *most) << foam_texture_info(kind).name << ": "
                                                       << *least << " < " << seam << " < " << *most;
        }
    }
}

TEST(FoamTexture, BitsAreThoseOfAnyNumberOfThreads) {
    for (const FoamTextureKind kind : kKinds) {
        const auto one = texture_of(kind, 256, 5, 1).values;
        EXPECT_EQ(one, texture_of(kind, 256, 5, 3).values);
        EXPECT_EQ(one, texture_of(kind, 256, 5, 1).values);
    }
}

TEST(FoamTexture, FinerTextureIsTheSameFoam) {
    for (const FoamTextureKind kind : kKinds) {
        const Texture coarse = texture_of(kind, 512), fine = texture_of(kind, 1024);
        std::vector<float> shrunk;
        for (const auto [i, j] : test::pairs(coarse.size, coarse.size)) {
            shrunk.push_back(static_cast<float>(fine.read(2 * i + 0.5, 2 * j + 0.5)));
        }
        EXPECT_GT(correlation(coarse.values, shrunk), 0.9) << foam_texture_info(kind).name;
    }
}

TEST(FoamTexture, SeedsAndKindsAreIndependent) {
    std::vector<std::vector<float>> textures;
    for (const FoamTextureKind kind : kKinds) {
        for (const std::uint32_t seed : {1u, 2u}) {
            textures.push_back(texture_of(kind, 512, seed).values);
        }
    }
    for (std::size_t a = 0; a < textures.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            EXPECT_LT(std::abs(correlation(textures[a], textures[b])), 0.06) << a << ", " << b;
        }
    }
}

/// Returns the mean square difference of values at a distance of (x, y) texels.
double variogram(const Texture& texture, int x, int y) {
    double sum = 0.0;
    for (const auto [i, j] : test::pairs(texture.size, texture.size)) {
        sum += std::pow(texture.at(i + x, j + y) - texture.at(i, j), 2);
    }
    return sum / (texture.size * texture.size);
}

TEST(FoamTexture, StreaksLieAlongTheWind) {
    const Texture streaks = texture_of(FoamTextureKind::streaks, 512);
    EXPECT_LT(variogram(streaks, 12, 0), variogram(streaks, 0, 3));
    const Texture lace = texture_of(FoamTextureKind::lace, 512);
    for (const int distance : {2, 8}) {
        const double ratio = variogram(lace, distance, 0) / variogram(lace, 0, distance);
        EXPECT_TRUE(ratio > 0.9 && ratio < 1.1) << ratio;
    }
}

/// The share of the texels on one side of the cover that hang together in the largest piece: foam
/// over corners too, water not.
double largest_piece(const Texture& texture, float cover, bool foam) {
    const int count = texture.size * texture.size, mask = texture.size - 1;
    std::vector<bool> taken(static_cast<std::size_t>(count));
    std::vector<int> piece;
    const auto take = [&](int i, int j) {
        const int at = (j & mask) * texture.size + (i & mask);
        if (taken[static_cast<std::size_t>(at)] || (texture.at(i, j) < cover) != foam) return;
        taken[static_cast<std::size_t>(at)] = true;
        piece.push_back(at);
    };
    std::size_t all = 0, largest = 0;
    for (int start = 0; start < count; ++start) {
        piece.clear();
        take(start % texture.size, start / texture.size);
        for (std::size_t next = 0; next < piece.size(); ++next) {
            const int i = piece[next] % texture.size, j = piece[next] / texture.size;
            for (const auto [x, y] : test::pairs({-1, 2}, {-1, 2})) {
                if (foam || x == 0 || y == 0) take(i + x, j + y);
            }
        }
        all += piece.size();
        largest = std::max(largest, piece.size());
    }
    return static_cast<double>(largest) / static_cast<double>(all);
}

// Foam of a third of the area is a net that holds its holes apart, not dots in the water.
TEST(FoamTexture, LaceIsANet) {
    const Texture lace = texture_of(FoamTextureKind::lace, 512);
    EXPECT_GT(largest_piece(lace, 0.3f, true), 0.7);
    EXPECT_LT(largest_piece(lace, 0.3f, false), 0.2);
}

TEST(FoamTexture, WhatIsNotAllowedIsRefused) {
    for (const int size : {-64, 0, 1, 32, 63, 100, 8192, std::numeric_limits<int>::max(),
                           std::numeric_limits<int>::min()}) {
        const test::Refusal refusal = test::refusal_of([&] {
            make_foam_texture({FoamTextureKind::lace, size, 1}, test::pool());
        });
        EXPECT_EQ(refusal.kind, ErrorKind::invalid_value);
        EXPECT_TRUE(test::says(refusal.message, std::to_string(size)));
        EXPECT_TRUE(test::says(refusal.message, "64 .. 4096"));
    }
    EXPECT_TRUE(
        test::says(test::message_of([] { find_foam_texture("laces"); }), "did you mean lace?"));
    for (const FoamTextureInfo& info : kFoamTextures) {
        EXPECT_EQ(find_foam_texture(info.name), info.kind);
        EXPECT_EQ(foam_texture_info(info.kind).name, info.name);
    }
}

}  // namespace
}  // namespace ocean
