// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Modes rebuilt for other waves equal those built at once, and data that does not depend on the
// waves is not touched.
#include "waves/modes/mode_lattice.hpp"

#include "ocean/internal/dispersion.hpp"
#include "simd_levels.hpp"
#include "test_seas.hpp"
#include "wave/wave.hpp"
#include "waves/modes/quadrant_sampler.hpp"

namespace ocean {
namespace {

/// Returns seas that differ in the parameters that a lattice depends on.
std::vector<Parameters> many_seas() {
    std::vector<Parameters> seas(5, test::wind_sea(64));
    seas[0].waves.front().wind_direction = -107.0;
    seas[1].waves.front() = WaveSystem{};  // phillips: no wave across the wind
    seas[1].water.depth = 4.0;
    seas[2].grid.cascades = 3;
    seas[2].grid.patch_size = 3000.0;
    seas[2].waves.front().opposing = 0.2;
    seas[3].surface.shortest_wavelength = 400.0 / 21.0;
    seas[3].surface.longest_wavelength = 400.0 / 5.0;
    seas[4].waves.push_back(seas[1].waves.front());
    seas[4].time.loop_period = 20.0;
    return seas;
}

template <typename Vector>
bool same_bits(const Vector& a, const Vector& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

void expect_same_bits(const Modes& a, const Modes& b, const std::string& what) {
    ASSERT_EQ(a.cascades.size(), b.cascades.size()) << what;
    EXPECT_EQ(a.wind_speed, b.wind_speed) << what;
    EXPECT_EQ(a.loop_period, b.loop_period) << what;
    for (std::size_t c = 0; c < a.cascades.size(); ++c) {
        EXPECT_TRUE(same_bits(a.cascades[c].h0, b.cascades[c].h0)) << what;
        EXPECT_TRUE(same_bits(a.cascades[c].rate_high, b.cascades[c].rate_high)) << what;
        EXPECT_TRUE(same_bits(a.cascades[c].rate_low, b.cascades[c].rate_low)) << what;
        EXPECT_TRUE(same_bits(a.cascades[c].displacement, b.cascades[c].displacement)) << what;
        EXPECT_TRUE(same_bits(a.cascades[c].shell_covariance, b.cascades[c].shell_covariance))
            << what;
    }
}

TEST(ModeLattice, VariancesAreTheModalVariancesInAllQuadrants) {
    for (const Parameters& parameters : many_seas()) {
        const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
        const QuadrantSampler sampler(spectrum);
        const auto bands = cascade_bands(parameters.grid);
        for (const auto memory : {ModeLattice::Memory::none, ModeLattice::Memory::keep}) {
            const ModeLattice lattice(parameters, memory, test::pool());
            double largest = 0.0, worst = 0.0;
            QuadrantVariances found;
            for (std::size_t c = 0; c < bands.size(); ++c) {
                for (int m = 0; m < 32; ++m) {
                    lattice.variances(sampler, c, m, found);
                    for (int n = 0; n < 32; ++n) {
                        const int modes[4][2] = {{n, m}, {-n, m}, {-n, -m}, {n, -m}};
                        for (int q = 0; q < 4; ++q) {
                            if ((n == 0 && (q == 1 || q == 2)) || (m == 0 && q >= 2)) continue;
                            const double exact = modal_variance(spectrum, parameters, modes[q][0],
                                                                modes[q][1], bands[c]);
                            const double v = found.quarter[q][static_cast<std::size_t>(n)];
                            largest = std::max(largest, exact);
                            worst = std::max(worst, std::abs(v - exact) / (exact + 1e-30));
                            ASSERT_EQ(v > 0.0, exact > 0.0) << modes[q][0] << " " << modes[q][1];
                        }
                    }
                }
            }
            EXPECT_LT(worst, 1e-10);
            EXPECT_GT(largest, 0.0);
        }
    }
}

TEST(ModeLattice, EveryModeIsItsOwnNoiseTimesTheRootOfItsOwnVariance) {
    for (const Parameters& parameters : many_seas()) {
        if (parameters.grid.cascades > 1) continue;  // their rings are scaled
        const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
        const Modes modes = test::modes_of(parameters, 1);
        for (const auto [n, m] : test::pairs({-31, 32}, {-31, 32})) {
            const auto xi = wave::double_precision::gaussian_noise(parameters.seed, 0, n, m);
            const double half_root = 0.5 * std::sqrt(modal_variance(spectrum, parameters, n, m));
            const std::size_t at = mode_index(n, m, 64);
            const std::complex<double> h0(modes.cascades.front().h0[at]);
            const std::complex<double> expected(half_root * xi.re, half_root * xi.im);
            ASSERT_LE(std::abs(h0 - expected), 2e-7 * std::abs(expected)) << n << " " << m;
        }
    }
}

TEST(ModeLattice, KeptOrNotTheBitsAreTheSame) {
    for (const Parameters& parameters : many_seas()) {
        const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
        const ModeLattice lattice(parameters, ModeLattice::Memory::keep, test::pool());
        Modes modes = lattice.still_modes(test::pool());
        lattice.set_waves(spectrum, strongest_wind(parameters).value_or(0.0), test::pool(), modes);
        expect_same_bits(modes, test::modes_of(parameters, 1), "kept");
    }
}

TEST(Rebuild, AfterAnyChangeTheBitsAreThoseOfAFreshBuild) {
    const std::pair<const char*, const char*> changes[] = {
        {"waves.0.wind_speed", "14.5"},
        {"waves.0.wind_direction", "-60"},
        {"waves.0.fetch", "20000"},
        {"waves.0.peak_enhancement", "6"},
        {"waves.0.spreading", "mitsuyasu"},
        {"waves.0.swell", "0.7"},
        {"waves.0.opposing", "0.3"},
        {"waves.0.significant_wave_height", "2.5"},
        {"waves.0.peak_period", "9"},
        {"surface.choppiness", "0.6"},
        {"waves.0.spectrum", "tma"},
        {"water.depth", "12"},
        {"random.seed", "77"},
        {"surface.shortest_wavelength", "9"},
        {"grid.cascades", "2"},
        {"time.loop_period", "30"},
        {"grid.resolution", "32"},
        {"waves.0.wind_speed", "0"},
        {"waves.0.wind_speed", "8"}};
    for (const int threads : {1, 3}) {
        Ocean sea(test::wind_sea(64), {.threads = threads});
        sea.modes();
        double period = 6.0;
        for (const auto& [name, value] : changes) {
            sea.set(name, value);
            expect_same_bits(sea.modes(), test::modes_of(sea.parameters(), 2), name);
            // Once more, so that whatever can be kept is kept at the next change.
            sea.set("waves.0.peak_period", std::to_string(period += 0.1));
            expect_same_bits(sea.modes(), test::modes_of(sea.parameters(), 2), name);
        }
    }
}

TEST(ModeLattice, WhereThereIsNoWaveThereIsNothingWhateverWasInMemory) {
    constexpr int kSize = 64;
    const Parameters parameters = test::wind_sea(kSize, 200.0);
    const auto spectrum = make_directional_spectrum(parameters);
    for (int attempt = 0; attempt < 3; ++attempt) {
        for (std::size_t i = 0; i < 8; ++i) {  // in the memory that the modes will have
            PageVector<float>((1 + i % 2) * kSize * kSize, 77.0f);
        }
        const Modes modes = make_modes(spectrum, parameters, test::pool());
        const CascadeModes& cascade = modes.cascades.front();
        for (int i = 0; i < kSize; ++i) {
            for (const int at : {kSize / 2 * kSize + i, i * kSize + kSize / 2, 0}) {
                const auto mode = static_cast<std::size_t>(at);
                ASSERT_EQ(cascade.h0[mode], 0.0f);
                ASSERT_EQ(cascade.rate_high[mode], 0.0f);
                ASSERT_EQ(cascade.rate_low[mode], 0.0f);
                ASSERT_EQ(cascade.displacement[mode], 0.0f);
            }
        }
    }
}

TEST(Rebuild, ALiveChangeLeavesRatesAndMemoryWhereTheyAre) {
    Ocean sea(test::wind_sea(64), {.threads = 2});
    const CascadeModes& cascade = sea.modes().cascades.front();
    const float* rates = cascade.rate_high.data();
    const float* displacements = cascade.displacement.data();
    const std::complex<float>* h0 = cascade.h0.data();
    const std::complex<float> before = h0[5];
    for (const char* wind : {"11", "12", "13"}) {
        sea.set("waves.0.wind_speed", wind);
        EXPECT_EQ(sea.modes().cascades.front().rate_high.data(), rates);
        EXPECT_EQ(sea.modes().cascades.front().displacement.data(), displacements);
        EXPECT_EQ(sea.modes().cascades.front().h0.data(), h0);
    }
    EXPECT_NE(h0[5], before);
}

TEST(Rebuild, SeasThatShareModesDoNotChangeEachOthers) {
    Ocean sea(test::wind_sea(64), {.threads = 1});
    const Modes before = sea.modes();
    Ocean fork(sea, {.threads = 2});
    EXPECT_EQ(&fork.modes(), &sea.modes()) << "nothing is shared: the test would see nothing";
    sea.set("waves.0.wind_speed", "15");
    expect_same_bits(sea.modes(), test::modes_of(sea.parameters(), 1), "the first");
    expect_same_bits(fork.modes(), before, "the fork");
    fork.set("waves.0.wind_speed", "5");
    expect_same_bits(fork.modes(), test::modes_of(fork.parameters(), 1), "the fork's own");
    expect_same_bits(sea.modes(), test::modes_of(sea.parameters(), 1), "the first again");
}

TEST(QuadrantSampler, IsTheTableItselfUpToRounding) {
    for (const Parameters& parameters : many_seas()) {
        const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
        const QuadrantSampler sampler(spectrum);
        const std::span<const double> rows = spectrum.angular_frequencies();
        std::vector<double> frequencies = {0.5 * rows.front(), rows.back(), 2.0 * rows.back()};
        for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
            frequencies.push_back(rows[i]);
            frequencies.push_back(0.3 * rows[i] + 0.7 * rows[i + 1]);
        }
        for (const double omega : frequencies) {
            for (const double turns : {0.0, 0.0313, 0.1875, 0.2499, 0.25}) {
                const double theta = kTwoPi * turns;
                const double directions[4] = {theta, kPi - theta, kPi + theta, -theta};
                const double one = 1.0;
                double found[4];
                sampler.write_variances({1, nullptr, 1, &omega, &turns, &one},
                                        {&found[0], &found[1], &found[2], &found[3]});
                for (std::size_t q = 0; q < 4; ++q) {
                    const double exact = spectrum.density(omega, directions[q]);
                    const double scale = spectrum.frequency_density(omega);
                    // Between two rows a billionth apart the table itself is rounded.
                    ASSERT_NEAR(found[q], exact, 1e-11 * exact + 1e-13 * scale)
                        << omega << " " << turns;
                }
            }
        }
    }
}

TEST(ModeRows, HaveTheSameBitsOnAllMachines) {
    const DirectionalSpectrum spectrum = make_directional_spectrum(test::wind_sea());
    const QuadrantSampler sampler(spectrum);
    constexpr std::size_t kCells = 150;
    std::vector<std::uint32_t> points_of;
    std::vector<double> omega, direction, weight;
    std::vector<float> noise, displacement;
    for (std::size_t cell = 0; cell < kCells; ++cell) {
        points_of.push_back(cell < 40 ? 9 - static_cast<std::uint32_t>(cell) / 5 : 1);
        for (std::uint32_t i = 0; i < points_of.back(); ++i) {
            omega.push_back(0.02 * static_cast<double>(omega.size()));
            direction.push_back(0.25 * std::fmod(0.37 * static_cast<double>(cell), 1.0));
            weight.push_back(1.0 + 0.1 * i);
        }
        displacement.push_back(3.0f / static_cast<float>(cell + 1));
        noise.push_back(static_cast<float>(std::sin(static_cast<double>(cell))));
        noise.push_back(static_cast<float>(std::cos(static_cast<double>(cell))));
    }
    const QuadrantCells cells{kCells,       points_of.data(), omega.size(),
                              omega.data(), direction.data(), weight.data()};
    const auto made = [&](SimdLevel level) {
        std::vector<double> variance[4], sums[kShellSums];
        for (std::vector<double>& v : variance) v.resize(kCells);
        for (std::vector<double>& sum : sums) sum.assign(kCells - 10, 0.25);
        double* const to[4] = {variance[0].data(), variance[1].data(), variance[2].data(),
                               variance[3].data()};
        double* const to_sums[kShellSums] = {sums[0].data(), sums[1].data(), sums[2].data(),
                                             sums[3].data(), sums[4].data()};
        std::vector<float> h0(4 * kCells);
        const ModeRowLoops& loops = mode_row_loops(level);
        sampler.write_variances(cells, to, level);
        loops.waves(to[0], 1, noise.data(), kCells, h0.data());
        loops.waves(to[1] + kCells - 1, -1, noise.data(), kCells, h0.data() + 2 * kCells);
        loops.shells({{to[0], to[1], to[2], to[3]}, displacement.data(), 0.1, 12, kCells - 7}, 10,
                     to_sums);
        std::vector<double> all(h0.begin(), h0.end());
        for (const auto& v : variance) all.insert(all.end(), v.begin(), v.end());
        for (const auto& sum : sums) all.insert(all.end(), sum.begin(), sum.end());
        return all;
    };
    const std::vector<double> expected = made(test::levels().front());
    EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 0.25);
    for (const SimdLevel level : test::levels()) {
        EXPECT_TRUE(same_bits(made(level), expected)) << simd_name(level);
    }
}

TEST(Dispersion, AtIsTheFunctionsTogether) {
    for (const double depth : {0.01, 1.0, 30.0, std::numeric_limits<double>::infinity()}) {
        const Dispersion water(Water{.depth = depth});
        for (double k = 1e-5; k < 1e5; k *= 1.7) {
            const DispersionPoint wave = water.at(k);
            EXPECT_NEAR(wave.angular_frequency / water.angular_frequency(k), 1.0, 1e-14);
            EXPECT_NEAR(wave.group_velocity / water.group_velocity(k), 1.0, 2e-14);
            EXPECT_NEAR(wave.horizontal_displacement / water.horizontal_displacement(k), 1.0,
                        1e-14);
        }
    }
}

}  // namespace
}  // namespace ocean
