// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The rows of a wave system: linear interpolation between them keeps the density that they were
// made from, whatever wind, fetch, peak, depth and limit of the frequencies.
#include "waves/spectrum/wave_system_table.hpp"

#include "ocean/enum_words.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/grid.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

/// Uniform draws with the same bits under every standard library.
class Draws {
  public:
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
    }
    double by_factors(double low, double high) {
        return low * std::pow(high / low, between(0.0, 1.0));
    }
    bool once_in(double times) { return between(0.0, times) < 1.0; }

  private:
    std::mt19937_64 bits_;
};

struct SweptSea {
    WaveSystem system;
    Water water;
    double highest = 0.0;  // rad/s
};

std::string text_of(const SweptSea& sea) {
    const WaveSystem& s = sea.system;
    return std::string(word_of(s.spectrum)) + ", wind " + std::to_string(s.wind()) + ", fetch " +
           std::to_string(s.fetch) + ", gamma " + std::to_string(s.peak_enhancement) + ", depth " +
           std::to_string(sea.water.depth) + ", cut-off " + std::to_string(s.cutoff_wavelength) +
           ", highest " + std::to_string(sea.highest);
}

SweptSea drawn_sea(SpectrumKind kind, Draws& draws) {
    SweptSea sea;
    WaveSystem& system = sea.system;
    system.spectrum = kind;
    system.wind_speed = draws.by_factors(0.5, 75.0);
    system.fetch = draws.by_factors(1e3, 1e7);
    if (draws.once_in(3)) {  // the round numbers of people
        system.wind_speed = std::ceil(*system.wind_speed);
        system.fetch = 1e4 * std::ceil(system.fetch / 1e4);
    }
    if (draws.once_in(2)) system.peak_enhancement = draws.between(1.0, 10.0);
    if (draws.once_in(3)) system.significant_wave_height = draws.by_factors(0.05, 15.0);
    if (draws.once_in(3)) system.peak_period = draws.by_factors(1.0, 20.0);
    if (draws.once_in(2)) system.cutoff_wavelength = draws.by_factors(0.05, 20.0);
    if (draws.once_in(2)) sea.water.depth = draws.by_factors(0.5, 300.0);
    sea.highest = draws.by_factors(5.0, 160.0);
    return sea;
}

/// Largest errors of interpolation: of the largest density, and, from the peak on, of the density.
struct TableError {
    double of_peak = 0.0;
    double of_tail = 0.0;
};

template <typename Density>
TableError table_error(const WaveSystemTable& table, const Density& density, double peak) {
    constexpr int kParts = 7;  // of an interval; shares that the refinement does not check
    TableError error;
    const double largest = density(peak);
    for (std::size_t i = 0; i + 1 < table.rows.size(); ++i) {
        const double low = table.density[i];
        const double high = table.density[i + 1];
        const bool is_tail = std::max(low, high) < 1e-3 * largest;
        if (is_tail && std::max(low, high) < 1e-9 * largest) continue;
        for (int part = is_tail ? 4 : 1; part < (is_tail ? 5 : kParts); ++part) {
            const double share = static_cast<double>(part) / kParts;
            const double omega = table.rows[i] + share * (table.rows[i + 1] - table.rows[i]);
            const double exact = density(omega);
            const double wrong = std::abs(low + share * (high - low) - exact);
            error.of_peak = std::max(error.of_peak, wrong / largest);
            if (omega > peak) error.of_tail = std::max(error.of_tail, wrong / exact);
        }
    }
    return error;
}

double trapezoid(const std::vector<double>& x, const std::vector<double>& y) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
        sum += 0.5 * (y[i] + y[i + 1]) * (x[i + 1] - x[i]);
    return sum;
}

// 2000 seas of four formulas; with one test in the middle of an interval 49 of 10000 were off by
// more than 1e-3 of their peak, the worst by 6e-2.
TEST(WaveSystemTable, InterpolationIsWithinOneTenThousandthOfThePeakInASweepOfSeas) {
    Draws draws;
    for (int i = 0; i < 2000; ++i) {
        const SweptSea sea = drawn_sea(static_cast<SpectrumKind>(i % 4), draws);
        const FrequencySpectrum spectrum =
            make_frequency_spectrum(sea.system, sea.water, sea.highest);
        const Rescaling scale = make_rescaling(sea.system, spectrum.peak, spectrum.m0);
        const WaveSystemTable table = make_wave_system_table(sea.system, sea.water, sea.highest);
        const TableError error = table_error(
            table,
            [&](double omega) {
                return spectrum.density(omega / scale.stretch) * scale.energy / scale.stretch;
            },
            spectrum.peak * scale.stretch);
        ASSERT_LE(error.of_peak, 1e-4) << text_of(sea);
        ASSERT_LE(error.of_tail, 1.1e-3) << text_of(sea);
        // The factor that DirectionalSpectrum scales the rows with.
        ASSERT_NEAR(table.m0 / trapezoid(table.rows, table.density), 1.0, 2e-4) << text_of(sea);
    }
}

// The fifth spectrum: 2000 records, whose frequencies are the rows.
TEST(WaveSystemTable, MeasuredRowsAreTheRecordsInASweepOfRecords) {
    Draws draws;
    for (int i = 0; i < 2000; ++i) {
        auto record = std::make_shared<SpectrumRecord>();
        double frequency = draws.between(0.02, 0.05);
        for (int bin = 0; bin < 40; ++bin) {
            record->frequency.push_back(frequency);
            record->density.push_back(draws.once_in(8) ? 0.0 : draws.by_factors(1e-6, 10.0));
            frequency += draws.between(0.002, 0.02);
        }
        WaveSystem system;
        system.spectrum = SpectrumKind::measured;
        system.measured = record;
        double energy = 1.0, stretch = 1.0;
        if (draws.once_in(3)) {
            system.significant_wave_height = draws.by_factors(0.05, 15.0);
            energy = std::pow(*system.significant_wave_height / 4.0, 2.0) /
                     trapezoid(record->frequency, record->density);
        }
        if (draws.once_in(3)) {
            system.peak_period = draws.by_factors(1.0, 20.0);
            const auto top = std::max_element(record->density.begin(), record->density.end());
            const auto bin = static_cast<std::size_t>(top - record->density.begin());
            stretch = 1.0 / (*system.peak_period * record->frequency[bin]);
        }
        const WaveSystemTable table = make_wave_system_table(system, {}, 160.0);
        ASSERT_EQ(table.rows.size(), record->frequency.size());
        for (std::size_t bin = 0; bin < table.rows.size(); ++bin) {
            const double omega = kTwoPi * record->frequency[bin] * stretch;
            const double density = record->density[bin] * energy / stretch / kTwoPi;
            ASSERT_NEAR(table.rows[bin], omega, 1e-12 * omega);
            ASSERT_NEAR(table.density[bin], density, 1e-12 * density);
        }
        ASSERT_NEAR(table.m0 / trapezoid(table.rows, table.density), 1.0, 1e-12);
    }
}

// Closed formula of jonswap_density [Hasselmann 1973] eq. 2.4.1. The chord over the upper flank of
// this peak crosses the density in its middle: the table lacked 5.8 % of the peak at 1.03 omega_p
// and was 0.35 % too high elsewhere.
TEST(WaveSystemTable, APeakWhoseChordCrossesItInTheMiddleIsWhole) {
    for (const double height : {0.0, 2.5}) {
        Parameters parameters;
        parameters.grid.resolution = 256;
        WaveSystem& system = parameters.waves.front();
        system.spectrum = SpectrumKind::jonswap;
        system.wind_speed = 20.0;
        system.fetch = 50e3;
        if (height > 0.0) system.significant_wave_height = height;
        const DirectionalSpectrum table = make_directional_spectrum(parameters);
        const double peak = jonswap_peak(20.0, 50e3, 9.81);
        WaveSystem natural = system;
        natural.significant_wave_height.reset();
        const double m0 = make_frequency_spectrum(natural, {}, 160.0).m0;
        const double energy = height > 0.0 ? std::pow(height / 4.0, 2.0) / m0 : 1.0;
        const double largest = energy * jonswap_density(peak, 20.0, 50e3, 3.3, 9.81);
        for (double x = 0.5; x < 4.0; x += 0.001) {
            ASSERT_NEAR(table.frequency_density(x * peak),
                        energy * jonswap_density(x * peak, 20.0, 50e3, 3.3, 9.81), 2e-4 * largest)
                << x;
        }
    }
}

// Rows of seas that the test in the middle alone served: their number and the sum of their angular
// frequencies, as it left them.
TEST(WaveSystemTable, SeasThatTheMiddleServesKeepTheirRows) {
    struct Golden {
        SpectrumKind kind;
        double wind;
        double fetch;
        double depth;
        std::size_t rows;
        double sum;  // rad/s
    };
    constexpr double kDeep = std::numeric_limits<double>::infinity();
    constexpr Golden kGolden[] = {
        {SpectrumKind::phillips, 5.0, 300e3, kDeep, 526, 7571.19541556088},
        {SpectrumKind::phillips, 10.0, 300e3, kDeep, 665, 8596.43840394845},
        {SpectrumKind::phillips, 18.0, 300e3, 40.0, 694, 8383.93760129414},
        {SpectrumKind::pierson_moskowitz, 8.0, 300e3, kDeep, 693, 11311.6844111132},
        {SpectrumKind::pierson_moskowitz, 10.0, 300e3, kDeep, 706, 10953.3311114402},
        {SpectrumKind::jonswap, 6.0, 40e3, kDeep, 630, 9893.90706737},
        {SpectrumKind::jonswap, 10.0, 100e3, kDeep, 750, 11250.1464272957},
        {SpectrumKind::jonswap, 15.0, 200e3, kDeep, 771, 10300.1232357353},
        {SpectrumKind::tma, 10.0, 100e3, 10.0, 748, 11349.121626185},
        {SpectrumKind::tma, 12.0, 80e3, 20.0, 755, 11278.8643095784},
    };
    for (const Golden& golden : kGolden) {
        WaveSystem system;
        system.spectrum = golden.kind;
        system.wind_speed = golden.wind;
        system.fetch = golden.fetch;
        const WaveSystemTable table =
            make_wave_system_table(system, Water{.depth = golden.depth}, 100.0);
        EXPECT_EQ(table.rows.size(), golden.rows) << word_of(golden.kind) << golden.wind;
        const double sum = std::accumulate(table.rows.begin(), table.rows.end(), 0.0);
        EXPECT_NEAR(sum, golden.sum, 1e-12 * golden.sum) << word_of(golden.kind) << golden.wind;
    }
}

}  // namespace
}  // namespace ocean
