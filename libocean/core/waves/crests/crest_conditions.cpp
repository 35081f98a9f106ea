// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "waves/crests/crest_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

namespace {

constexpr CrestQuantity kCrest[] = {CrestQuantity::height,  CrestQuantity::slope_x,
                                    CrestQuantity::slope_y, CrestQuantity::rise,
                                    CrestQuantity::shift_x, CrestQuantity::shift_y};
constexpr CrestQuantity kLevel[] = {CrestQuantity::height, CrestQuantity::shift_x,
                                    CrestQuantity::shift_y};
constexpr CrestQuantity kNeighbour[] = {CrestQuantity::height};
constexpr std::size_t kRows = std::size(kCrest);

[[noreturn]] void refuse(std::size_t crest, const std::string& key, const std::string& value,
                         const std::string& what, const std::string& allowed) {
    throw Error(ErrorKind::invalid_value,
                {.what = what,
                 .parameter = "crests." + std::to_string(crest) + (key.empty() ? "" : "." + key),
                 .value = value,
                 .allowed = allowed});
}

/// Returns a moment within the period, so that phases of far places are exact.
CrestMoment moment_of(const Crest& crest, double patch_size) {
    return {std::remainder(crest.x, patch_size), std::remainder(crest.y, patch_size), crest.time};
}

/// Returns the sums of each crest over the waves that carry it. Throws for a crest without such
/// waves.
std::vector<CrestMeans> means_of_crests(const CrestWaves& waves) {
    const std::vector<Crest>& crests = waves.parameters().crests;
    std::vector<CrestMeans> sums(crests.size() + 1);  // the last one is of all waves
    std::vector<std::vector<CrestMeans>> shares(kCrestShares, sums);
    waves.for_each([&](std::size_t share, const CrestWave& wave) {
        for (std::size_t i = 0; i < crests.size(); ++i) {
            shares[share][i].add(wave, crest_weight(crests[i], wave));
        }
        shares[share].back().add(wave, 1.0);
    });
    for (const std::vector<CrestMeans>& share : shares) {
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += share[i];
    }
    constexpr double kMinShare = 0.02;
    const double all = sums.back().m0;
    if (!(all > 0.0)) refuse(0, "", "", "a flat sea has no waves that make a crest", "none here");
    for (std::size_t i = 0; i < crests.size(); ++i) {
        if (sums[i].m0 > kMinShare * all) continue;
        refuse(i, "direction", plain_text(*crests[i].direction) + " deg",
               "only " + significant_text(100.0 * sums[i].m0 / all, 2) +
                   " % of the energy travels that way, too little to carry a crest",
               "a direction of the sea's waves, or unset");
    }
    sums.pop_back();
    return sums;
}

CrestRows long_rows(const CrestWaves& waves, std::span<const CrestMeans> means) {
    const Parameters& parameters = waves.parameters();
    CrestRows rows;
    for (const Crest& crest : parameters.crests) {
        rows.add(kCrest, moment_of(crest, parameters.grid.patch_size));
    }
    for (std::size_t i = 0; i < means.size(); ++i) {
        const CrestMoment crest = rows.moments[i];
        for (const CrestMoment& near : crest_neighbours(crest, means[i]))
            rows.add(kNeighbour, near);
    }
    return rows;
}

/// Returns the mean values of all rows in seas whose first rows have the values `required`.
std::vector<double> mean_rows(const Gram& gram, std::span<const double> required) {
    const std::vector<double> lambda = DependentRows(gram).solve(required);
    std::vector<double> values(required.begin(), required.end());
    for (std::size_t row = required.size(); row < gram.size; ++row) {
        values.push_back(
            std::inner_product(lambda.begin(), lambda.end(), &gram.values[row * gram.size], 0.0));
    }
    return values;
}

/// Returns the covariance of each pair of some rows.
Gram part_of(const Gram& gram, std::span<const std::size_t> rows) {
    Gram part(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t j = 0; j < rows.size(); ++j) part.at(i, j) = gram.at(rows[i], rows[j]);
    }
    return part;
}

/// Gives the neighbours of a crest with a direction the shape that waves of that direction have.
void steer(const CrestWaves& waves, std::size_t crest, CrestConditions& conditions) {
    const std::size_t crests = waves.parameters().crests.size();
    const std::size_t neighbours = (conditions.rows.rows.size() - conditions.required) / crests;
    CrestRows rows;
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < kRows; ++i) own.push_back(crest * kRows + i);
    rows.add(kCrest, conditions.rows.moments[crest]);
    for (std::size_t i = 0; i < neighbours; ++i) {
        own.push_back(conditions.required + crest * neighbours + i);
        rows.add(kNeighbour, conditions.rows.moments[crests + crest * neighbours + i]);
    }
    const RowSums carried = sums_of(rows, waves, [&](const CrestWave& wave) {
        return crest_weight(waves.parameters().crests[crest], wave);
    });
    const auto required = std::span(conditions.targets).subspan(crest * kRows, kRows);
    const std::vector<double> steered = mean_rows(carried.gram, required);
    const std::vector<double> plain = mean_rows(part_of(conditions.sums.gram, own), required);
    for (std::size_t i = kRows; i < own.size(); ++i) {
        conditions.targets[own[i]] += steered[i] - plain[i];
    }
}

/// Throws if the waves would have to be far less likely than each crest alone makes them: crests
/// that contradict each other, or a direction against the waves.
void require_likely(const CrestWaves& waves, const CrestConditions& conditions) {
    constexpr double kMaxRatio = 4.0;  // of the squares of heights
    const std::vector<Crest>& crests = waves.parameters().crests;
    const Gram& gram = conditions.sums.gram;
    const std::vector<double> lambda = DependentRows(gram).solve(conditions.targets);
    double together = 0.0;  // target G^-1 target: twice the exponent of the density
    for (std::size_t row = 0; row < gram.size; ++row)
        together += lambda[row] * conditions.targets[row];
    double alone = 0.0;
    std::size_t worst = 0;
    double most = 0.0;
    for (std::size_t i = 0; i < crests.size(); ++i) {
        const double target = conditions.targets[i * kRows];
        const double own = target * target / gram.at(i * kRows, i * kRows);
        alone += own;
        const double ratio = lambda[i * kRows] * target / own;
        if (ratio > most) worst = i;
        most = std::max(most, ratio);
    }
    if (together <= kMaxRatio * alone) {
        // A row that depends on others holds only if these agree with it.
        for (std::size_t row = 0; row < conditions.required; ++row) {
            const double held = std::inner_product(lambda.begin(), lambda.end(),
                                                   &gram.values[row * gram.size], 0.0);
            const double scale = std::sqrt(gram.at(row, row));
            if (std::abs(held - conditions.targets[row]) > 1e-4 * scale) {
                together = std::numeric_limits<double>::infinity();
                worst = row / kRows;
            }
        }
    }
    if (together <= kMaxRatio * alone) return;
    const std::string rare = std::isfinite(together)
                                 ? ": the waves would be as rare as a single crest of " +
                                       significant_text(std::sqrt(together) / 4.0, 2) + " Hs"
                                 : "";
    if (crests.size() > 1) {
        refuse(worst, "", "", "contradicts the crests near it" + rare,
               "lower crests, or more apart in place or time");
    }
    refuse(worst, "direction", plain_text(crests[worst].direction.value_or(0.0)) + " deg",
           "is not a way of this sea's waves" + rare, "a direction of its waves, or unset");
}

}  // namespace

CrestConditions long_conditions(const CrestWaves& waves) {
    const Parameters& parameters = waves.parameters();
    const std::vector<Crest>& crests = parameters.crests;
    const SurfaceSettings& limits = parameters.surface;
    const double hs =
        waves.spectrum()
            .moments(parameters.water, limits.shortest_wavelength, limits.longest_wavelength)
            .significant_wave_height();
    CrestConditions conditions;
    conditions.rows = long_rows(waves, means_of_crests(waves));
    conditions.sums = sums_of(conditions.rows, waves, [](const CrestWave&) { return 1.0; });
    conditions.required = crests.size() * kRows;
    const double held = 4.0 * std::sqrt(conditions.sums.gram.at(0, 0));
    std::vector<double> required(conditions.required);
    for (std::size_t i = 0; i < crests.size(); ++i) {
        const double metres = crests[i].height.metres(hs);
        if (std::abs(metres) > kMaxCrestHeight * hs * (1.0 + 1e-9)) {
            refuse(i, "height", significant_text(metres, 4) + " m",
                   "is " + significant_text(std::abs(metres) / hs, 3) +
                       " Hs, higher than waves get: one crest in 10^14 exceeds 2 Hs",
                   "at most " + significant_text(kMaxCrestHeight * hs, 4) + " m");
        }
        if (std::abs(metres) > kMaxCrestHeight * held) {
            refuse(i, "height", significant_text(metres, 4) + " m",
                   "is too high for the waves that the grid holds, whose Hs is " +
                       significant_text(held, 3) + " m",
                   "a finer or larger grid, or at most " +
                       significant_text(kMaxCrestHeight * held, 3) + " m");
        }
        required[i * kRows] = metres;
    }
    conditions.targets = mean_rows(conditions.sums.gram, required);
    for (std::size_t i = 0; i < crests.size(); ++i) {
        if (crests[i].direction) steer(waves, i, conditions);
    }
    require_likely(waves, conditions);
    return conditions;
}

CrestConditions short_conditions(const CrestWaves& waves) {
    const Parameters& parameters = waves.parameters();
    CrestConditions conditions;
    for (const Crest& crest : parameters.crests) {
        conditions.rows.add(kLevel, moment_of(crest, parameters.grid.patch_size));
    }
    conditions.required = conditions.rows.rows.size();
    conditions.sums = sums_of(conditions.rows, waves, [](const CrestWave&) { return 1.0; });
    conditions.targets.assign(conditions.required, 0.0);
    return conditions;
}

}  // namespace ocean
