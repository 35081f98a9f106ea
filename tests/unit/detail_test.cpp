// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Slope tiles: the waves too short for a map, none of them twice, none left out; and how a material
// reads them.
#include "ocean/detail.hpp"

#include <bit>

#include "field/bilinear.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/dispersion.hpp"
#include "test_seas.hpp"
#include "wave/wave.hpp"
#include "waves/detail/detail_plan.hpp"

namespace ocean {
namespace {

namespace formula = wave::double_precision;

/// The presets' seas: Beaufort 4 and 7.
Parameters beaufort(int force) {
    Parameters parameters = test::wind_sea(512, force == 4 ? 230.0 : 870.0);
    WaveSystem& waves = parameters.waves.front();
    waves.wind_speed = force == 4 ? 6.7 : 15.5;
    waves.fetch = force == 4 ? 54e3 : 170e3;
    waves.opposing = 0.0;
    waves.wind_direction = 0.0;
    return parameters;
}

struct NamedSea {
    std::string name;
    Parameters parameters;
};

/// Returns seas that differ in all that changes where a map ends and what lies beyond.
std::vector<NamedSea> seas() {
    std::vector<NamedSea> seas = {{"beaufort_4", beaufort(4)}, {"beaufort_7", beaufort(7)}};
    const auto add = [&](const std::string& name, Parameters parameters) -> Parameters& {
        return seas.emplace_back(NamedSea{name, std::move(parameters)}).parameters;
    };
    add("low resolution", test::wind_sea(64, 400.0));
    add("diagonal wind", beaufort(4)).waves.front().wind_direction = 45.0;
    add("three cascades", test::wind_sea(128, 400.0)).grid.cascades = 3;
    add("shallow", test::wind_sea(128, 60.0)).water.depth = 0.3;
    Parameters& limited = add("limited", test::wind_sea(256, 20.0));
    limited.surface.shortest_wavelength = 0.05;
    limited.waves.front().wind_direction = 45.0;
    Parameters& two = add("two systems", beaufort(4));
    two.waves.push_back(two.waves.front());
    two.waves.back().spectrum = SpectrumKind::pierson_moskowitz;
    two.waves.back().wind_direction = 100.0;
    two.waves.back().wind_speed = 4.0;
    return seas;
}

/// A tile as materials read it, straight lines from sample to sample, at a place in tiles.
std::complex<double> read_tile(std::span<const float> slopes, int samples, double x, double y) {
    const auto n = static_cast<std::size_t>(samples);
    x = (x - std::floor(x)) * samples;
    y = (y - std::floor(y)) * samples;
    const double u = x - std::floor(x), v = y - std::floor(y);
    const auto at = [&](double column, double row) {
        const std::size_t i = static_cast<std::size_t>(column) % n;
        const std::size_t j = static_cast<std::size_t>(row) % n;
        return std::complex<double>(slopes[2 * (j * n + i)], slopes[2 * (j * n + i) + 1]);
    };
    return bilinear(at(x, y), at(x + 1.0, y), at(x, y + 1.0), at(x + 1.0, y + 1.0), u, v);
}

/// Mean products over all places, between samples too: of straight lines from sample to sample the
/// mean is that of a sample with its neighbours, weighted by 1/6, 2/3 and 1/6 along each axis.
SlopeVariance measured(std::span<const float> slopes) {
    const auto n =
        static_cast<std::size_t>(std::lround(std::sqrt(0.5 * static_cast<double>(slopes.size()))));
    constexpr double kWeights[] = {1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0};
    double xx = 0.0, yy = 0.0, xy = 0.0;
    for (const auto [i, j, at] : test::cells<std::size_t>(n, n)) {
        double x = 0.0, y = 0.0;
        for (const auto [a, b] : test::pairs<std::size_t>(3, 3)) {
            const std::size_t beside = (j + b + n - 1) % n * n + (i + a + n - 1) % n;
            x += kWeights[a] * kWeights[b] * double{slopes[2 * beside]};
            y += kWeights[a] * kWeights[b] * double{slopes[2 * beside + 1]};
        }
        xx += x * double{slopes[2 * at]};
        yy += y * double{slopes[2 * at + 1]};
        xy += x * double{slopes[2 * at + 1]};
    }
    const auto count = static_cast<double>(n * n);
    return {xx / count, yy / count, xy / count};
}

TEST(Detail, BandsFollowEachOtherFromTheMapToTheRipples) {
    for (const auto& [name, parameters] : seas()) {
        const std::vector<DetailBand> bands = detail_bands(parameters, {});
        ASSERT_FALSE(bands.empty()) << name;
        const double map_ends =
            shortest_wave(parameters.grid, default_map_resolution(parameters.grid));
        EXPECT_NEAR(bands.front().longest_wave / map_ends, 1.0, 0.03) << name;
        for (std::size_t i = 0; i < bands.size(); ++i) {
            const DetailBand& band = bands[i];
            if (i > 0) {
                EXPECT_EQ(band.longest_wave, bands[i - 1].shortest_wave) << name;
            }
            if (i + 1 < bands.size()) {
                EXPECT_NEAR(band.longest_wave / band.shortest_wave, 6.0, 1e-9) << name;
            }
            EXPECT_DOUBLE_EQ(band.tile, std::max(1.0, 8.3 * band.longest_wave)) << name;
            EXPECT_GT(band.shortest_wave, band.tile / 256.0) << name << ": two samples a wave";
        }
        const double end = std::max(kShortestDetail, parameters.surface.shortest_wavelength);
        const double longest = bands.front().longest_wave;
        EXPECT_EQ(bands.size(), longest <= 12.0 * end ? 1u : longest <= 2.0 ? 2u : 3u) << name;
        EXPECT_EQ(bands.back().shortest_wave, end) << name;
    }
    EXPECT_EQ(detail_bands(test::wind_sea(512, 25.0), {}).size(), 1u);
    EXPECT_TRUE(detail_bands(test::wind_sea(1024, 5.0), {}).empty());
    // A map so coarse that the last tile's samples end first.
    EXPECT_GT(detail_bands(test::wind_sea(32, 800.0), {}).back().shortest_wave, kShortestDetail);
}

TEST(Detail, SettingsOutOfRangeAreRefused) {
    Ocean ocean(test::wind_sea(64, 100.0), {1});
    for (const DetailSettings& settings :
         {DetailSettings{0, 300}, DetailSettings{0, 128}, DetailSettings{0, 2048},
          DetailSettings{100, 512}, DetailSettings{16, 512}}) {
        EXPECT_THROW(ocean.detail(0.0, settings), Error);
    }
    std::vector<float> map(512 * 512);
    const MapOutput height{map.data(), 1, {{{Channel::height, 1.0f}}}};
    const MapOutput slope{map.data(), 1, {{{Channel::slope_x, 1.0f}}}};
    EXPECT_THROW(ocean.detail_into(0.0, {&height, 1}), Error);
    EXPECT_THROW(ocean.detail_into(0.0, std::vector(4, slope)), Error);
    EXPECT_NO_THROW(ocean.detail_into(0.0, {&slope, 1}));
}

// Summed over a fine lattice of the wavenumber plane, cell by cell.
TEST(Detail, ABandHasTheSlopesOfItsPartOfThePlane) {
    for (const auto& [name, parameters] : seas()) {
        const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
        const Dispersion dispersion(parameters.water);
        Ocean ocean(parameters, {1});
        const DetailBand first = ocean.detail_budget(0.0).bands.front();
        const double edge = kTwoPi / first.longest_wave, end = kTwoPi / first.shortest_wave;
        constexpr int kCells = 600;
        const double step = end / kCells;
        SlopeVariance sum;
        for (const auto [n, m] : test::pairs({-kCells, kCells}, {-kCells, kCells})) {
            const double kx = (n + 0.5) * step, ky = (m + 0.5) * step, k = std::hypot(kx, ky);
            if (k > end || std::max(std::abs(kx), std::abs(ky)) < edge) continue;
            const DispersionPoint wave = dispersion.at(k);
            const double variance = spectrum.density(wave.angular_frequency, std::atan2(ky, kx)) *
                                    wave.group_velocity / k * step * step;
            sum.x += kx * kx * variance;
            sum.y += ky * ky * variance;
            sum.xy += kx * ky * variance;
        }
        const double all = sum.mean_square_slope();
        EXPECT_NEAR(first.variance.mean_square_slope() / all, 1.0, 0.005) << name;
        EXPECT_NEAR(first.variance.x / all, sum.x / all, 0.01) << name;
        EXPECT_NEAR(first.variance.y / all, sum.y / all, 0.01) << name;
        EXPECT_NEAR(first.variance.xy / all, sum.xy / all, 0.01) << name;
    }
}

TEST(Detail, MapBandsAndResidualAreTheSlopesOfTheSea) {
    for (const auto& [name, parameters] : seas()) {
        Ocean ocean(parameters, {1});
        const SeaState state = ocean.state();
        for (const int resolution : {64, 256, 1024}) {
            const DetailBudget budget = ocean.detail_budget(0.0, {resolution, 512});
            const double map = state
                                   .map_slopes[static_cast<std::size_t>(
                                       std::bit_width(static_cast<unsigned>(resolution)) - 1)]
                                   .mean_square_slope;
            double sum = map + budget.residual;
            for (const DetailBand& band : budget.bands) sum += band.variance.mean_square_slope();
            EXPECT_NEAR(sum / state.mean_square_slope.asked, 1.0, 0.01) << name << resolution;
            EXPECT_GE(budget.residual, 0.0) << name;
        }
    }
}

// The standard error of the mean over the seeds is 0.4 %.
TEST(Detail, ATileHasTheVarianceOfItsBand) {
    constexpr int kSeeds = 48;
    for (Parameters parameters : {beaufort(4), test::wind_sea(64, 400.0)}) {
        DetailBudget budget;
        std::vector<SlopeVariance> sum;
        for (int seed = 1; seed <= kSeeds; ++seed) {
            parameters.seed = static_cast<std::uint32_t>(seed);
            Ocean ocean(parameters, {2});
            const Detail detail = ocean.detail(7.0, {0, 256});
            budget = ocean.detail_budget(7.0, {0, 256});
            sum.resize(budget.bands.size());
            for (std::size_t i = 0; i < sum.size(); ++i) {
                const SlopeVariance one = measured(detail.slopes(i));
                sum[i].x += one.x / kSeeds;
                sum[i].y += one.y / kSeeds;
                sum[i].xy += one.xy / kSeeds;
            }
        }
        for (std::size_t i = 0; i < sum.size(); ++i) {
            const SlopeVariance expected = budget.bands[i].variance;
            const double all = expected.mean_square_slope();
            EXPECT_NEAR(sum[i].mean_square_slope() / all, 1.0, 0.02) << i;
            EXPECT_NEAR(sum[i].x / all, expected.x / all, 0.02) << i;
            EXPECT_NEAR(sum[i].xy / all, expected.xy / all, 0.02) << i;
        }
    }
}

/// A band of a detail at labels in metres, as shaders/wave/slope_tiles.glsl reads it.
class BlendedBand {
  public:
    BlendedBand(const Detail& detail, std::size_t band)
        : map_(detail.slopes(band)), samples_(detail.samples()), tile_(detail.bands()[band].tile) {}

    std::complex<double> at(double x, double y) const {
        std::complex<double> sum;
        for (int corner = 0; corner < 3; ++corner) {
            const auto read = formula::slope_tile_read(x / tile_, y / tile_, corner);
            sum += read.weight * sample(read.x, read.y);
        }
        return sum;
    }
    /// Without the blending.
    std::complex<double> alone(double x, double y) const { return sample(x / tile_, y / tile_); }

  private:
    std::complex<double> sample(double x, double y) const {
        return read_tile(map_, samples_, x, y);
    }

    std::span<const float> map_;
    int samples_;
    double tile_;
};

/// Largest |correlation| of a field of slopes with itself at lags of near .. far metres, from
/// n x n samples 0.1 m apart.
template <typename Field>
double largest_autocorrelation(int n, double near, double far, const Field& field) {
    const int padded = 2 * n;
    constexpr double step = 0.1;
    // |transform|^2 of x + iy: its inverse has the correlations of x and of y in its real part.
    std::vector<std::complex<double>> data(Lattice{padded, 1.0}.size());
    for (const auto [i, j] : test::pairs(n, n)) {
        data[mode_index(i, j, padded)] = field((i + 0.5) * step, (j + 0.5) * step);
    }
    const Radix2Fft<double> fft(padded);
    fft.transform_2d(data, FftDirection::forward);
    for (auto& value : data) value = std::norm(value);
    fft.transform_2d(data, FftDirection::inverse);
    const double whole = data[0].real() / (static_cast<double>(n) * n);
    double largest = 0.0;
    const int reach = static_cast<int>(far / step);
    for (const auto [i, j] : test::pairs({-reach, reach + 1}, {-reach, reach + 1})) {
        const double lag = step * std::hypot(i, j);
        if (lag < near || lag > far) continue;
        const double pairs = double(n - std::abs(i)) * (n - std::abs(j));
        largest =
            std::max(largest, std::abs(data[mode_index(i, j, padded)].real()) / pairs / whole);
    }
    return largest;
}

TEST(SlopeTiles, NoTileIsSeenAgain) {
    Ocean ocean(beaufort(4), {2});
    const Detail detail = ocean.detail(20.0);
    const BlendedBand band(detail, 0);
    const auto blended = [&](double x, double y) { return band.at(x, y); };
    const auto alone = [&](double x, double y) { return band.alone(x, y); };
    EXPECT_LT(largest_autocorrelation(1024, 1.5, 32.0, blended), 0.1);
    EXPECT_GT(largest_autocorrelation(512, 1.5, 32.0, alone), 0.9);
}

TEST(SlopeTiles, BlendingKeepsTheVariance) {
    Ocean ocean(beaufort(4), {2});
    const Detail detail = ocean.detail(20.0);
    for (std::size_t b = 0; b < detail.bands().size(); ++b) {
        const BlendedBand band(detail, b);
        const double tile = detail.bands()[b].tile;
        constexpr int n = 1024;
        double sum = 0.0;
        for (const auto [i, j] : test::pairs(n, n)) {
            sum += std::norm(band.at(0.0371 * tile * i, 0.0371 * tile * j));
        }
        EXPECT_NEAR(sum / (n * n) / measured(detail.slopes(b)).mean_square_slope(), 1.0, 0.02) << b;
    }
}

TEST(SlopeTiles, FadesFromAQuarterOfTheMiddleWaveTo12TenthsOfIt) {
    const auto fade = [](double waves) { return formula::slope_tile_fade(waves * 0.2, 0.1, 0.4); };
    EXPECT_EQ(fade(0.0), 1.0);
    EXPECT_EQ(fade(0.25), 1.0);
    EXPECT_NEAR(fade(0.725), 0.5, 1e-12);
    EXPECT_EQ(fade(1.2), 0.0);
    EXPECT_EQ(fade(100.0), 0.0);
    EXPECT_NEAR(formula::slope_footprint(100.0, 0.001, -0.25), 0.2, 1e-12);
    EXPECT_NEAR(formula::slope_footprint(100.0, 0.001, 0.0), 1.0, 1e-12);
}

// The slopes shown and the slopes handed to the roughness add up to the sea's at every distance.
TEST(SlopeTiles, ShownAndRoughSlopesAreTheSeasAtEveryDistance) {
    constexpr double kPixel = 0.00131, kEye = 2.0;
    constexpr int kSeeds = 8;
    for (auto& [name, parameters] : seas()) {
        std::vector<double> shown;
        DetailBudget budget;
        SeaState state;
        for (int seed = 1; seed <= kSeeds; ++seed) {
            parameters.seed = static_cast<std::uint32_t>(seed);
            Ocean ocean(parameters, {2});
            if (seed == 1) state = ocean.state();
            const Detail detail = ocean.detail(3.0, {0, 256});
            budget = ocean.detail_budget(3.0, {0, 256});
            shown.resize(budget.bands.size());
            for (std::size_t i = 0; i < shown.size(); ++i) {
                const BlendedBand band(detail, i);
                constexpr int n = 200;
                double sum = 0.0;
                for (int at = 0; at < n * n; ++at) {
                    const double tile = budget.bands[i].tile;
                    sum += std::norm(band.at(0.0713 * tile * (at % n), 0.0713 * tile * (at / n)));
                }
                shown[i] += sum / (n * n) / kSeeds;
            }
        }
        const auto power = std::bit_width(static_cast<unsigned>(state.map_resolution)) - 1;
        const double mesh = state.map_slopes[static_cast<std::size_t>(power)].mean_square_slope;
        for (const double distance : {1.0, 10.0, 100.0, 1e3, 1e4}) {
            const double footprint =
                formula::slope_footprint(distance, kPixel, std::min(1.0, kEye / distance));
            double slopes = 0.0, roughness = budget.residual;
            for (std::size_t i = 0; i < shown.size(); ++i) {
                const DetailBand& band = budget.bands[i];
                const double fade =
                    formula::slope_tile_fade(footprint, band.shortest_wave, band.longest_wave);
                slopes += fade * fade * shown[i];
                roughness += formula::slope_tile_left(fade, band.variance.mean_square_slope());
            }
            EXPECT_NEAR((mesh + slopes + roughness) / state.mean_square_slope.asked, 1.0, 0.01)
                << name << " at " << distance << " m";
        }
    }
}

bool same_bits(const Detail& a, const Detail& b) {
    if (a.bands().size() != b.bands().size()) return false;
    for (std::size_t i = 0; i < a.bands().size(); ++i) {
        if (!std::ranges::equal(a.slopes(i), b.slopes(i))) return false;
    }
    return true;
}

TEST(Detail, AFrameAloneIsThatOfTheSequenceOfACopyOfTheLoopAndOfAnyThreads) {
    const Parameters parameters = test::wind_sea(64, 100.0, {.loop = 8.0});
    Ocean sequence(parameters, {1});
    Detail last;
    for (int frame = 0; frame < 3; ++frame) last = sequence.detail(5.0 + frame / 24.0, {0, 256});
    const double time = 5.0 + 2 / 24.0;
    Ocean alone(parameters, {3});
    EXPECT_TRUE(same_bits(alone.detail(time, {0, 256}), last));
    EXPECT_FALSE(same_bits(alone.detail(5.0, {0, 256}), last));
    // Another map beside it has bands of its own.
    alone.detail(5.0, {32, 256});
    EXPECT_TRUE(same_bits(alone.detail(time + 8.0, {0, 256}), last));
    EXPECT_TRUE(same_bits(Ocean(sequence, {2}).detail(time, {0, 256}), last));
    Ocean slow(parameters, {.backend = Backend::radix2});
    const Detail other = slow.detail(time, {0, 256});
    for (std::size_t i = 0; i < last.bands().size(); ++i) {
        EXPECT_LT(test::relative_error(last.slopes(i), other.slopes(i)), 2e-6);
    }
}

// As for the surface: slopes before the change stay, later ones are those of the performed sea's
// text.
TEST(Detail, APerformedWindChangesIt) {
    const Parameters parameters = test::wind_sea(64, 100.0);
    Ocean ocean(parameters, {1});
    const Detail before = ocean.detail(2.0, {0, 256});
    const double variance = before.bands().front().variance.mean_square_slope();
    ocean.perform(2.0, "wind_speed", "16");
    const Detail after = ocean.detail(6.0, {0, 256});
    EXPECT_GT(after.bands().front().variance.mean_square_slope(), 1.1 * variance);
    EXPECT_NEAR(measured(after.slopes(0)).mean_square_slope() /
                    after.bands().front().variance.mean_square_slope(),
                1.0, 0.1);
    EXPECT_TRUE(same_bits(ocean.detail(2.0, {0, 256}), before));
    Ocean again(ocean.sea(), {2});
    EXPECT_TRUE(same_bits(again.detail(6.0, {0, 256}), after));
    // Another sea of the same lattices.
    ocean.set("seed", "77");
    EXPECT_FALSE(same_bits(ocean.detail(6.0, {0, 256}), after));
}

TEST(Detail, CalmWaterHasFlatTiles) {
    Ocean ocean(test::wind_sea(64, 100.0, {.wind = 0.0}), {1});
    const Detail detail = ocean.detail(1.0);
    ASSERT_EQ(detail.bands().size(), 3u);
    EXPECT_EQ(detail.residual(), 0.0);
    for (const DetailBand& band : detail.bands()) {
        EXPECT_EQ(band.variance.mean_square_slope(), 0.0);
    }
    EXPECT_EQ(measured(detail.slopes(0)).mean_square_slope(), 0.0);
}

// The noise of a tile is its own: not that of the sea's modes of the same numbers, nor another's.
TEST(Detail, TilesAreNoPicturesOfTheSea) {
    Ocean ocean(test::wind_sea(256, 400.0), {2});
    const Detail detail = ocean.detail(0.0, {0, 256});
    const auto spectrum = [&](const auto& at) {
        std::vector<std::complex<double>> data(Lattice{256, 1.0}.size());
        for (std::size_t i = 0; i < data.size(); ++i) data[i] = at(i);
        Radix2Fft<double>(256).transform_2d(data, FftDirection::forward);
        return data;
    };
    const Surface surface = ocean.evaluate(0.0, {Channel::slope_x}, 256);
    std::vector<std::vector<std::complex<double>>> fields;
    fields.push_back(spectrum([&](std::size_t i) { return surface.channel(Channel::slope_x)[i]; }));
    for (std::size_t b = 0; b < detail.bands().size(); ++b) {
        fields.push_back(spectrum([&](std::size_t i) { return detail.slopes(b)[2 * i]; }));
    }
    for (std::size_t a = 0; a < fields.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            std::complex<double> sum;
            double count = 0.0;
            for (std::size_t i = 0; i < fields[a].size(); ++i) {
                const double weight = std::abs(fields[a][i]) * std::abs(fields[b][i]);
                if (weight < 1.0) continue;  // rounding where there are no modes
                sum += fields[a][i] * std::conj(fields[b][i]) / weight;
                count += 1.0;
            }
            ASSERT_GT(count, 400.0);
            EXPECT_LT(std::abs(sum) / count, 0.15) << a << b;
        }
    }
}

}  // namespace
}  // namespace ocean
