// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits a terrain to an elevation model: see terrain_fit.hpp.
#include "ocean/terrain_fit.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "fit_variance.hpp"
#include "land/law/expected_rings.hpp"
#include "law_fit.hpp"
#include "ocean/error.hpp"
#include "ocean/grid.hpp"
#include "ocean/ring_spectrum.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrain_law.hpp"
#include "ocean/text.hpp"
#include "relief.hpp"

namespace ocean {
namespace {

constexpr int kMaxSide = 2048;  // of tiles and windows: a seed then takes less than a second
constexpr int kMinFittedSide = 32;
constexpr int kFitRingsPerOctave = 4;
constexpr int kRingRounds = 12;  // a narrow dip between high rings needs many
constexpr int kLawRounds = 3;
constexpr int kVarianceRounds = 2;

/// Makes terrains and measures them as the elevation model was measured.
class Judge {
  public:
    Judge(const ElevationModel& bed, const TerrainFitOptions& options)
        : options_(options),
          land_(tile_for(bed), {.threads = options.threads}),
          domain_(part_for(bed, land_.model())) {
        RingOptions rings{.rings_per_octave = kFitRingsPerOctave, .max_side = kMaxSide};
        rings.limits = ring_limits(bed.domain, rings);
        ring_options_ = rings;
        bed_rings_ = measure_rings(bed.domain, bed.heights, land_.pool(), rings);
    }

    const TerrainModel& tile() const { return land_.model(); }
    const std::vector<Ring>& bed_rings() const { return bed_rings_; }

    /// Measures the terrain with each of the seeds. `use` gets the rings of each, and the heights
    /// of the part.
    template <typename Use>
    void measure(TerrainModel terrain, std::span<const std::uint32_t> seeds, const Use& use) {
        int done = 0;
        for (const std::uint32_t seed : seeds) {
            terrain.seed = seed;
            land_.set_model(terrain);
            const std::vector<float> heights = part();
            const auto rings = measure_rings(domain_, heights, land_.pool(), ring_options_);
            if (rings.size() != bed_rings_.size()) {
                throw Error(ErrorKind::invalid_value,
                            "the model has too few cells for its rings to be compared");
            }
            use(rings, heights);
            if (options_.progress) options_.progress(++done, static_cast<int>(seeds.size()));
        }
    }

    /// Returns the mean of all seeds in each ring: see expected_rings.
    std::vector<double> expected(const TerrainModel& terrain) {
        return expected_rings(terrain, domain_.samples, ring_options_, land_.pool());
    }
    const Domain& domain() const { return domain_; }
    ThreadPool& pool() { return land_.pool(); }

  private:
    static TerrainModel tile_for(const ElevationModel& bed) {
        const double cell = std::max(bed.domain.step(0), bed.domain.step(1));
        int samples = kMinFittedSide;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double cells = bed.domain.step(axis) * bed.domain.samples[axis] / cell;
            const auto held = static_cast<unsigned>(std::ceil(cells - 1e-9));
            samples = std::max(samples, static_cast<int>(std::bit_ceil(held)));
        }
        TerrainModel terrain;
        terrain.resolution = std::min(samples, kMaxSide);
        terrain.patch_size = cell * terrain.resolution;
        // The model has no waves that are much longer than itself.
        const double longest = std::max(bed.domain.step(0) * bed.domain.samples[0],
                                        bed.domain.step(1) * bed.domain.samples[1]);
        const double waves = std::round(terrain.patch_size / longest);
        if (waves > 1.0) terrain.longest_wavelength = terrain.patch_size / waves;
        return terrain;
    }

    /// Returns the part of a tile that has the size of the model, or of its windows.
    static Domain part_for(const ElevationModel& bed, const TerrainModel& terrain) {
        const double cell = terrain.patch_size / terrain.resolution;
        Domain part{.origin = {}, .size = {}, .samples = {}, .wraps = false};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double cells =
                bed.domain.step(axis) * std::min(bed.domain.samples[axis], kMaxSide) / cell;
            part.samples[axis] = std::clamp(static_cast<int>(std::lround(cells)),
                                            kMinFittedSide / 2, terrain.resolution);
            part.size[axis] = cell * (part.samples[axis] - 1);
        }
        return part;
    }

    std::vector<float> part() {
        const Surface surface = land_.surface({Channel::height});
        const std::span<const float> tile = surface.channel(Channel::height);
        const std::size_t stride = static_cast<std::size_t>(land_.model().resolution);
        const std::size_t columns = static_cast<std::size_t>(domain_.samples[0]);
        std::vector<float> heights;
        heights.reserve(domain_.count());
        for (int j = 0; j < domain_.samples[1]; ++j) {
            const std::span<const float> row =
                tile.subspan(static_cast<std::size_t>(j) * stride, columns);
            heights.insert(heights.end(), row.begin(), row.end());
        }
        return heights;
    }

    const TerrainFitOptions& options_;
    Terrain land_;
    Domain domain_;
    RingOptions ring_options_;
    std::vector<Ring> bed_rings_;
};

/// The table law: rings, and one point for the waves that are too long for them. It lies at the
/// longest wave of the tile, so that the law is a line from there to the first ring.
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

    /// Corrects each density by what the mean of all seeds has: window, edges and the finite width
    /// of rings then cancel.
    /// Returns the largest change of a density, as a share of it.
    double correct_rings(const std::vector<Ring>& bed, const std::vector<double>& expected) {
        double change = 0.0;
        for (std::size_t i = 0; i < rings_.size(); ++i) {
            if (!(expected[i] > 0.0)) continue;
            const double before = rings_[i].density;
            // A dip that no land has under this window would be deepened for ever.
            rings_[i].density = bed[i].density * limited(before / expected[i]);
            change = std::max(change, std::abs(rings_[i].density / before - 1.0));
        }
        return change;
    }
    /// Gives the longest waves what the variance of the tile lacks [m^2].
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
void fit_table(Judge& judge, double variance, TerrainModel& terrain) {
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
LawFit fit_parameters(Judge& judge, FitLaw law_kind, bool ridge, TerrainModel& terrain) {
    std::vector<Ring> rings = judge.bed_rings();
    LawFit fit = fit_law(rings, law_kind, ridge, terrain);
    for (int round = 0; round < kLawRounds; ++round) {
        // The law's own spectrum under the window is divided out, and the law fitted again.
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

/// Returns the rms that the tile keeps: that about the mean, but of a land that is tilted by more
/// than the waves of a tile are, that about its plane [m].
double kept_rms(Judge& judge, const Relief& bed) {
    // The plane's variance is that of two slopes, of an exponential distribution: it is 6 times its
    // mean in one land of 400.
    constexpr double kLargestTilt = 6.0;
    // A plane and what is left of one wave of the tile, a sine from border to border, have
    // variances of at most 6 / pi^2 and 1 - 6 / pi^2.
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
struct RingSums {
    double density = 0.0;
    double logarithm = 0.0;
    double square = 0.0;
};

void judge_fit(Judge& judge, std::span<const std::uint32_t> seeds, TerrainFit& fit) {
    std::vector<RingSums> sums(judge.bed_rings().size());
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

/// Groups rings by octaves from the lowest one; a ring weighs as many waves as it has.
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

std::string length_text(double metres) {
    return metres < 10'000.0 ? significant_text(metres, 4) + " m"
                             : significant_text(metres / 1e3, 4) + " km";
}

/// Warns of each part of the land's variance that the terrain does not keep.
void add_variance_warnings(const ElevationModel& bed, TerrainFit& fit) {
    constexpr double kKept = 0.025;  // of the rms, 5 % of the variance
    const double length = std::max(bed.domain.size[0], bed.domain.size[1]);
    if (length > 1.1 * fit.terrain.patch_size) {
        fit.warnings.push_back(
            "the model is " + length_text(length) + " long and the terrain repeats after " +
            length_text(fit.terrain.patch_size) + ": waves longer than " +
            length_text(fit.terrain.patch_size / 2.0) +
            " are not fitted, and the rms of the heights is " + significant_text(fit.rms, 4) +
            " m, not the " +
            significant_text(relief_of(bed.domain, bed.heights).rms_about_mean, 4) +
            " m of the whole model; a model with larger cells has them");
    }
    if (fit.kept_rms < (1.0 - kKept) * fit.bed.rms_about_mean) {
        fit.warnings.push_back(
            "the land is tilted: its rms is " + significant_text(fit.bed.rms_about_mean, 4) +
            " m, and " + significant_text(fit.kept_rms, 4) +
            " m about its plane, which the terrain has: land that repeats has no plane");
    }
    if (std::abs(fit.rms / fit.kept_rms - 1.0) > kKept) {
        fit.warnings.push_back("the rms of the land is " + significant_text(fit.kept_rms, 4) +
                               " m, that of the terrain " + significant_text(fit.rms, 4) +
                               " m: no seed of the law comes closer");
    }
}

void add_warnings(const ElevationModel& bed, TerrainFit& fit) {
    constexpr double kGoodError = 0.05, kClearAnisotropy = 1.3, kClearSkewness = 0.5;
    for (const FittedParameter& parameter : fit.parameters) {
        if (!parameter.is_at_bound) continue;
        fit.warnings.push_back(parameter.name + " = " + significant_text(parameter.value, 4) +
                               " is at the bound of its range: this law does not describe the "
                               "land; choose another");
    }
    if (fit.error_above_lowest() > kGoodError) {
        fit.warnings.push_back("above the longest octave the density is off by up to " +
                               fixed_text(fit.error_above_lowest(), 2) +
                               " in log10 in an octave; " +
                               (fit.terrain.rings != nullptr ? "the model has few waves there"
                                                             : "the table law follows the rings"));
    }
    add_variance_warnings(bed, fit);
    if (fit.bed.anisotropy > kClearAnisotropy) {
        fit.warnings.push_back("the land is steeper along " + fixed_text(fit.bed.direction, 0) +
                               " degrees than across, by " + fixed_text(fit.bed.anisotropy, 2) +
                               "; the fit is the same in all directions: see anisotropy");
    }
    if (std::abs(fit.bed.skewness - fit.model.skewness) > kClearSkewness) {
        fit.warnings.push_back("the heights of the land have a skewness of " +
                               fixed_text(fit.bed.skewness, 2) +
                               ", which no spectrum holds: peaks and valleys of the terrain are "
                               "alike");
    }
}

void check(const ElevationModel& model, const TerrainFitOptions& options) {
    const auto [columns, rows] = model.domain.samples;
    if (std::min(columns, rows) < kMinFittedSide) {
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
    Judge judge(model, options);
    for (const Ring& ring : judge.bed_rings()) {
        if (ring.density > 0.0) continue;
        throw Error(ErrorKind::invalid_value, "the model has no waves of " +
                                                  significant_text(kTwoPi / ring.wavenumber, 4) +
                                                  " m: flat land has no spectrum to fit");
    }
    TerrainFit fit;
    fit.terrain = judge.tile();
    fit.bed = relief_of_parts(model, kMaxSide);
    fit.kept_rms = kept_rms(judge, fit.bed);
    const double variance = fit.kept_rms * fit.kept_rms;
    double unit = 1.0;  // of the law's density [m^4]
    if (options.law == FitLaw::table) {
        fit_table(judge, variance, fit.terrain);
        // A table has no exponent; this one is that of its land, should the table be taken away.
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
    fit.octaves = octaves_of(fit.rings, ring_limits(model.domain, {.max_side = kMaxSide})[0]);
    add_warnings(model, fit);
    return fit;
}

}  // namespace ocean
