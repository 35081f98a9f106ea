// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits a terrain to an elevation model: see terrain_fit.hpp.
#include "ocean/internal/terrain_fit.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "fit_judge.hpp"
#include "fit_variance.hpp"
#include "fit_warnings.hpp"
#include "law_fit.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/measured_rings.hpp"
#include "ocean/internal/ring_spectrum.hpp"
#include "ocean/internal/terrain_law.hpp"
#include "ocean/internal/text.hpp"
#include "relief.hpp"

namespace ocean {
namespace {

constexpr int kRingRounds = 12;  // a narrow dip between high rings needs many
constexpr int kLawRounds = 3;
constexpr int kVarianceRounds = 2;

/// The table law: rings, and one point for waves too long for rings. The point lies at the longest
/// wave of the tile, so that the law is a line from there to the first ring.
class RingTable {
  public:
    RingTable(double longest_wavenumber, const std::vector<Ring>& bed)
        : longest_wavenumber_(longest_wavenumber),
          longest_density_(bed.front().density),
          rings_(bed) {}

    std::shared_ptr<const MeasuredRings> measured() const {
        MeasuredRings table{{longest_wavenumber_}, {longest_density_}};
        for (const Ring& ring : rings_) {
            table.wavenumber.push_back(ring.wavenumber);
            table.density.push_back(ring.density);
        }
        return std::make_shared<const MeasuredRings>(std::move(table));
    }

    /// Corrects each density by the mean over all seeds: window, edges and the finite width of
    /// rings then cancel. Returns the largest relative change of a density.
    double correct_rings(const std::vector<Ring>& bed, const std::vector<double>& expected) {
        double change = 0.0;
        for (std::size_t i = 0; i < rings_.size(); ++i) {
            if (!(expected[i] > 0.0)) continue;
            const double before = rings_[i].density;
            // A dip that land under this window cannot have would be deepened without end.
            rings_[i].density = bed[i].density * limited(before / expected[i]);
            change = std::max(change, std::abs(rings_[i].density / before - 1.0));
        }
        return change;
    }
    /// Gives the longest waves the variance that the tile lacks [m^2].
    void correct_variance(double variance, TerrainModel& terrain) {
        constexpr double kLargestFactor = 1000.0;
        constexpr int kHalvings = 24;
        const double first = rings_.front().density;
        double low = first / kLargestFactor, high = first * kLargestFactor;
        for (int i = 0; i < kHalvings; ++i) {
            longest_density_ = std::sqrt(low * high);
            terrain.rings = measured();
            (law_variance(terrain) < variance ? low : high) = longest_density_;
        }
    }

  private:
    static double limited(double factor) { return std::clamp(factor, 1.0 / 12.0, 12.0); }

    double longest_wavenumber_;  // [rad/m]
    double longest_density_;     // [m^4]
    std::vector<Ring> rings_;
};

/// Returns the longest wave of a tile [m].
double longest_wave(const TerrainModel& terrain) {
    return terrain.longest_wavelength > 0.0 ? terrain.longest_wavelength : terrain.patch_size;
}

/// Fits the table law, with a variance of the tile [m^2].
void fit_table(FitJudge& judge, double variance, TerrainModel& terrain) {
    constexpr double kBelow = 1.0 - 1e-9;  // the wave itself lies within the table
    RingTable table(kBelow * kTwoPi / longest_wave(terrain), judge.bed_rings());
    const auto fit_rings = [&] {
        constexpr double kFineEnough = 0.01;
        double change = 1.0;
        terrain.rings = table.measured();
        for (int round = 0; round < kRingRounds && change > kFineEnough; ++round) {
            change = table.correct_rings(judge.bed_rings(), judge.expected(terrain));
            terrain.rings = table.measured();
        }
    };
    fit_rings();
    for (int round = 0; round < kVarianceRounds; ++round) {
        table.correct_variance(variance, terrain);
        fit_rings();
    }
    table.correct_variance(variance, terrain);
}

/// Fits a law of parameters, and returns them with its level.
LawFit fit_parameters(FitJudge& judge, FitLaw law_kind, bool ridge, TerrainModel& terrain) {
    std::vector<Ring> rings = judge.bed_rings();
    LawFit fit = fit_law(rings, law_kind, ridge, terrain);
    for (int round = 0; round < kLawRounds; ++round) {
        // Divides the law's own spectrum under the window out, and fits the law again.
        const std::vector<double> expected = judge.expected(terrain);
        const TerrainLaw law(terrain);
        for (std::size_t i = 0; i < rings.size(); ++i) {
            if (!(expected[i] > 0.0)) continue;
            rings[i].density =
                judge.bed_rings()[i].density * law.density(rings[i].wavenumber, 0.0) / expected[i];
        }
        fit = fit_law(rings, law_kind, ridge, terrain);
    }
    return fit;
}

/// Returns the rms that the tile keeps: about the mean, or, for a land that is tilted more than the
/// waves of a tile are, about its plane [m].
double kept_rms(FitJudge& judge, const Relief& bed) {
    // The plane's variance is the sum of two squared slopes and has an exponential distribution: it
    // is 6 times its mean in one land of 400.
    constexpr double kLargestTilt = 6.0;
    // A sine from border to border, one wave of the tile, divides into a plane and a remainder,
    // with variances of at most 6 / pi^2 and 1 - 6 / pi^2.
    constexpr double kTiltOfASine = 6.0 / (kPi * kPi - 6.0);
    TerrainModel one = judge.tile();
    fit_law(judge.bed_rings(), FitLaw::one, false, one);
    const double largest =
        std::min(kLargestTilt * expected_tilt(one, judge.domain().samples), kTiltOfASine);
    const double about_plane = bed.rms * bed.rms;
    const double plane = bed.rms_about_mean * bed.rms_about_mean - about_plane;
    return plane > largest * about_plane ? bed.rms : bed.rms_about_mean;
}

/// Sums over seeds.
struct FitSums {
    double density = 0.0;
    double logarithm = 0.0;
    double square = 0.0;
};

void judge_fit(FitJudge& judge, std::span<const std::uint32_t> seeds, TerrainFit& fit) {
    std::vector<FitSums> sums(judge.bed_rings().size());
    const auto count = static_cast<double>(seeds.size());
    fit.model.anisotropy = 0.0;
    judge.measure(fit.terrain, seeds,
                  [&](const std::vector<Ring>& rings, const std::vector<float>& heights) {
                      for (std::size_t i = 0; i < rings.size(); ++i) {
                          const double logarithm = std::log10(std::max(rings[i].density, 1e-300));
                          sums[i].density += rings[i].density / count;
                          sums[i].logarithm += logarithm / count;
                          sums[i].square += logarithm * logarithm / count;
                      }
                      add(fit.model, relief_of(judge.domain(), heights), 1.0 / count);
                  });
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const Ring& ring = judge.bed_rings()[i];
        const double variance = sums[i].square - sums[i].logarithm * sums[i].logarithm;
        fit.rings.push_back({ring.wavenumber, ring.density, ring.count, sums[i].density,
                             std::sqrt(std::max(variance, 0.0) * count / (count - 1.0))});
    }
}

/// Groups rings by octaves from the lowest ring on; a ring's weight is its number of waves.
std::vector<FittedOctave> octaves_of(const std::vector<FittedRing>& rings, double lowest) {
    std::vector<FittedOctave> octaves;
    std::vector<double> waves;
    for (const FittedRing& ring : rings) {
        const auto octave = static_cast<std::size_t>(
            std::max(0.0, std::floor(std::log2(ring.wavenumber / lowest) + 1e-9)));
        while (octaves.size() <= octave) {
            octaves.push_back({kTwoPi / lowest / std::exp2(static_cast<double>(octaves.size()))});
            waves.push_back(0.0);
        }
        octaves[octave].error += ring.count * ring.residual() * ring.residual();
        octaves[octave].scatter += ring.count * ring.scatter * ring.scatter;
        waves[octave] += ring.count;
    }
    for (std::size_t i = 0; i < octaves.size(); ++i) {
        octaves[i].error = std::sqrt(octaves[i].error / std::max(waves[i], 1.0));
        octaves[i].scatter = std::sqrt(octaves[i].scatter / std::max(waves[i], 1.0));
    }
    return octaves;
}

void check(const ElevationModel& model, const TerrainFitOptions& options) {
    const auto [columns, rows] = model.domain.samples;
    if (std::min(columns, rows) < FitJudge::kMinSide) {
        throw Error(ErrorKind::invalid_value, "a fit needs at least 32 x 32 cells, not " +
                                                  std::to_string(columns) + " x " +
                                                  std::to_string(rows));
    }
    if (options.seeds < kMinFitSeeds || options.seeds > kMaxFitSeeds) {
        throw Error(ErrorKind::invalid_value, {.what = "is out of range",
                                               .parameter = "seeds",
                                               .value = std::to_string(options.seeds),
                                               .allowed = "4 .. 256"});
    }
}

}  // namespace

double FittedRing::residual() const {
    return std::log10(model / density);
}

double TerrainFit::error_above_lowest() const {
    double largest = 0.0;
    for (std::size_t i = 1; i < octaves.size(); ++i) largest = std::max(largest, octaves[i].error);
    return largest;
}

TerrainFit fit_terrain(const ElevationModel& model, const TerrainFitOptions& options) {
    check(model, options);
    FitJudge judge(model, options);
    for (const Ring& ring : judge.bed_rings()) {
        if (ring.density > 0.0) continue;
        throw Error(ErrorKind::invalid_value, "the model has no waves of " +
                                                  significant_text(kTwoPi / ring.wavenumber, 4) +
                                                  " m: flat land has no spectrum to fit");
    }
    TerrainFit fit;
    fit.terrain = judge.tile();
    fit.bed = relief_of_parts(model, FitJudge::kMaxSide);
    fit.kept_rms = kept_rms(judge, fit.bed);
    const double variance = fit.kept_rms * fit.kept_rms;
    double unit = 1.0;  // unit of the law's density [m^4]
    if (options.law == FitLaw::table) {
        fit_table(judge, variance, fit.terrain);
        // A table has no exponent; this is the exponent of its land, in case the table is removed.
        TerrainModel one = judge.tile();
        fit_parameters(judge, FitLaw::one, false, one);
        fit.terrain.beta = one.beta;
    } else {
        const LawFit law = fit_parameters(judge, options.law, options.ridge, fit.terrain);
        fit.parameters = law.parameters;
        if (options.law == FitLaw::broken && !law.has_break) {
            fit.warnings.push_back("the rings have no break" +
                                   std::string(options.ridge ? " and no ridge" : "") +
                                   ": the law describes them no better than chance would, and "
                                   "the terrain has one exponent, " +
                                   significant_text(fit.terrain.beta, 4));
        }
        fit.terrain.rms = fit.kept_rms;
        unit = std::exp(law.level);
    }
    const auto seeds = seeds_of_variance(fit.terrain, variance / unit, options.seeds, judge.pool());
    fit.terrain.mean = summarize(model).mean;
    fit.cell = fit.terrain.patch_size / fit.terrain.resolution;
    judge_fit(judge, seeds, fit);
    fit.terrain.seed = seeds.front();
    fit.rms =
        fit.terrain.rms ? *fit.terrain.rms : std::sqrt(seed_variance(fit.terrain, judge.pool()));
    fit.octaves =
        octaves_of(fit.rings, ring_limits(model.domain, {.max_side = FitJudge::kMaxSide})[0]);
    add_warnings(model, fit);
    return fit;
}

}  // namespace ocean
