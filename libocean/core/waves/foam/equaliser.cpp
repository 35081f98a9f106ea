// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Counts are whole numbers, so that they depend neither on the order nor on the threads.
//
// Bilinear reads: let F be the share of reads below a value. If each texel T were replaced by F(T),
// the reads would be uniform except for the curvature of F within a texel; a few iterations
// converge, where F is the identity.
#include "waves/foam/equaliser.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

constexpr int kPlaces = 1024;

/// The places where the distribution of reads is known; a cover of 0.003 spans fifty of them.
constexpr int kBins = 1 << 14;
/// Reads per side of a texel, on a lattice. Small textures need more, because each of their texels
/// counts more.
constexpr int kMinReads = 4, kMaxReads = 32;
constexpr int kReadsAlong = 4096;
/// Iterations end when the largest deviation from F(c) = c is below this, or after this many turns.
constexpr double kSettled = 2e-4;
constexpr int kMaxTurns = 24;

/// The positions of reads in a panel of four: Chebyshev's quadrature of equal weights, exact to the
/// fifth degree [Abramowitz and Stegun 1964] 25.4.28. Reads at the middles of quarters would never
/// be near a texel and would miss extremes: up to 1e-3 of the area.
constexpr std::array<float, 4> kPanel = {0.102672764f, 0.406203763f, 0.593796237f, 0.897327236f};
float place_of_read(int read, int reads) {
    const int panel = read / 4;
    return (static_cast<float>(panel) + kPanel[static_cast<std::size_t>(read % 4)]) * 4.0f /
           static_cast<float>(reads);
}

using Counts = std::vector<std::uint32_t>;

/// Counts the reads between a row of texels and the next row, and from column to column.
void count_reads(const float* row, const float* next, int size, int reads, Counts& counts) {
    const auto columns = static_cast<std::size_t>(size);
    std::vector<float> between(columns + 1);
    std::vector<std::int32_t> bins(columns);  // separate from the counts, for the vectoriser
    for (int r = 0; r < reads; ++r) {
        const float v = place_of_read(r, reads);
        for (std::size_t i = 0; i < columns; ++i) {
            between[i] = (row[i] + (next[i] - row[i]) * v) * static_cast<float>(kBins);
        }
        between[columns] = between[0];
        for (int s = 0; s < reads; ++s) {
            const float u = place_of_read(s, reads);
            for (std::size_t i = 0; i < columns; ++i) {
                const float read = between[i] + (between[i + 1] - between[i]) * u;
                bins[i] = static_cast<std::int32_t>(std::min(read, kBins - 1.0f));
            }
            for (const std::int32_t bin : bins) ++counts[static_cast<std::size_t>(bin)];
        }
    }
}

/// Returns the share of the reads below k / kBins, for each k.
std::vector<double> distribution_of_reads(std::span<const float> texture, int size,
                                          ThreadPool& pool) {
    const int reads = std::clamp(kReadsAlong / size, kMinReads, kMaxReads);
    std::vector<Counts> counts(static_cast<std::size_t>(pool.size()), Counts(kBins));
    pool.for_each_item(size, [&](int j, int thread) {
        const float* row = texture.data() + std::ptrdiff_t{j} * size;
        const float* next = texture.data() + std::ptrdiff_t{(j + 1) % size} * size;
        count_reads(row, next, size, reads, counts[static_cast<std::size_t>(thread)]);
    });
    std::vector<double> share(kBins + 1);
    const double all = static_cast<double>(size) * size * reads * reads;
    std::uint64_t below = 0;
    for (std::size_t k = 0; k < kBins; ++k) {
        for (const Counts& of_thread : counts) below += of_thread[k];
        share[k + 1] = static_cast<double>(below) / all;
    }
    return share;
}

double departure(const std::vector<double>& share) {
    double largest = 0.0;
    for (std::size_t k = 0; k < share.size(); ++k) {
        largest = std::max(largest, std::abs(share[k] - static_cast<double>(k) / kBins));
    }
    return largest;
}

}  // namespace

void Equaliser::learn(std::span<const float> values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    lowest_ = *least;
    per_unit_ = *most > *least ? static_cast<float>(kPlaces) / (*most - *least) : 0.0f;
    std::vector<std::size_t> count(kPlaces);
    for (const float value : values) {
        const auto place = static_cast<std::size_t>((value - lowest_) * per_unit_);
        ++count[std::min<std::size_t>(place, kPlaces - 1)];
    }
    share_.assign(kPlaces + 1, 0.0f);
    std::size_t below = 0;
    for (std::size_t k = 0; k < kPlaces; ++k) {
        below += count[k];
        share_[k + 1] = static_cast<float>(below) / static_cast<float>(values.size());
    }
}

void Equaliser::equalise(std::span<float> values) {
    if (share_.empty()) learn(values);
    for (float& value : values) {
        const float x =
            std::clamp((value - lowest_) * per_unit_, 0.0f, static_cast<float>(kPlaces));
        const int k = std::min(static_cast<int>(x), kPlaces - 1);
        const float* share = share_.data() + k;
        value = share[0] + (share[1] - share[0]) * (x - static_cast<float>(k));
    }
}

void settle_reads(std::span<float> texture, int size, ThreadPool& pool) {
    for (int turn = 0; turn < kMaxTurns; ++turn) {
        const std::vector<double> share = distribution_of_reads(texture, size, pool);
        if (departure(share) <= kSettled) return;
        pool.for_each_item(size, [&](int j, int) {
            for (float& value :
                 texture.subspan(static_cast<std::size_t>(j) * static_cast<std::size_t>(size),
                                 static_cast<std::size_t>(size))) {
                const double x = static_cast<double>(value) * kBins;
                const auto k = static_cast<std::size_t>(std::min(static_cast<int>(x), kBins - 1));
                value = static_cast<float>(share[k] + (share[k + 1] - share[k]) *
                                                          (x - static_cast<double>(k)));
            }
        });
    }
}

}  // namespace ocean
