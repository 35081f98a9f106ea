// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Gauges: a reading is that of the displayed surface; the limits of an estimate from a series hold
// the truth as often as they promise.
#include "ocean/internal/gauge.hpp"

#include <cstdlib>

#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/gauge_series.hpp"
#include "ocean/query.hpp"
#include "test_seas.hpp"
#include "waves/gauge/chi_squared.hpp"

namespace ocean {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How often the sea's own value lies within the limits.
struct Coverage {
    int inside = 0;
    int all = 0;
    void add(const Estimate& estimate, double truth) {
        inside += estimate.lower <= truth && truth <= estimate.upper ? 1 : 0;
        ++all;
    }
    double share() const { return static_cast<double>(inside) / all; }
    /// Returns the standard error of a share of 0.95.
    double standard_error() const { return std::sqrt(0.95 * 0.05 / all); }
};

Estimate density_of(const GaugeSpectrum& spectrum, std::size_t i) {
    const Estimate limits = spectrum.limits();
    const double density = spectrum.density[i];
    return {density, density * limits.lower, density * limits.upper};
}

TEST(ChiSquared, QuantilesAreThoseOfTheTables) {
    // R's qchisq(), 10 digits. For two degrees of freedom -2 ln(1 - p).
    struct Row {
        double freedom, low, high;
    };
    for (const Row& row :
         {Row{1.0, 0.0009820691171, 5.023886187}, Row{2.0, 0.05063561596, 7.377758908},
          Row{5.0, 0.8312116134, 12.83250199}, Row{10.0, 3.246972781, 20.48317735},
          Row{30.0, 16.79077227, 46.97924224}, Row{100.0, 74.22192747, 129.5611972}}) {
        EXPECT_NEAR(chi_squared_quantile(0.025, row.freedom) / row.low, 1.0, 1e-8) << row.freedom;
        EXPECT_NEAR(chi_squared_quantile(0.975, row.freedom) / row.high, 1.0, 1e-8) << row.freedom;
    }
    // Many: a normal variable, with the first terms of [Abramowitz and Stegun 1964] eq. 26.4.17.
    const double many = 1e6;
    const double normal =
        many *
        std::pow(1.0 - 2.0 / (9.0 * many) + 1.959963985 * std::sqrt(2.0 / (9.0 * many)), 3.0);
    EXPECT_NEAR(chi_squared_quantile(0.975, many) / normal, 1.0, 1e-8);
}

std::vector<double> sampled(double rate, double duration, const auto& function) {
    std::vector<double> series;
    for (int i = 0; i < rate * duration; ++i) series.push_back(function(i / rate));
    return series;
}

TEST(WaveCount, ASineHasItsOwnHeightAndPeriodWhateverItsMean) {
    for (const double mean : {0.0, -3.0}) {
        const auto series = sampled(
            8.0, 100.3, [mean](double t) { return mean + 1.5 * std::sin(kTwoPi * t / 7.1 + 0.3); });
        const WaveCount count = count_waves(series, 8.0);
        EXPECT_EQ(count.waves, 13);  // whole ones between the up-crossings
        EXPECT_NEAR(count.mean_period.value, 7.1, 1e-3);
        EXPECT_NEAR(count.significant_period, 7.1, 2e-2);
        EXPECT_NEAR(count.mean_height, 3.0, 0.02);
        EXPECT_NEAR(count.significant_height, 3.0, 0.02);
        EXPECT_NEAR(count.highest_wave, 3.0, 0.02);
        EXPECT_NEAR(count.highest_crest, 1.5, 0.06);  // the mean over 14.1 waves is not quite 0
    }
}

TEST(WaveCount, ThirdsAndTenthsAreOfTheHighestWaves) {
    // 30 waves of 4 s with the heights 2, 4 .. 60, in a shuffled order.
    std::vector<double> series;
    for (int i = 0; i < 30; ++i) {
        const int height = 2 * ((i * 11) % 30 + 1);
        for (const double part : {0.0, 1.0, 0.0, -1.0}) series.push_back(0.5 * part * height);
    }
    series.insert(series.begin(), -1.0);
    series.insert(series.end(), {0.0, 1.0});
    const WaveCount count = count_waves(series, 1.0);
    EXPECT_EQ(count.waves, 30);
    EXPECT_DOUBLE_EQ(count.highest_wave, 60.0);
    EXPECT_DOUBLE_EQ(count.tenth_height, 58.0);
    EXPECT_DOUBLE_EQ(count.significant_height, 51.0);
    EXPECT_DOUBLE_EQ(count.mean_height, 31.0);
    EXPECT_DOUBLE_EQ(count.highest_crest, 30.0);
    EXPECT_NEAR(count.mean_period.value, 4.0, 1e-12);
}

TEST(WaveCount, CrossingsLieBetweenTheSamples) {
    const std::vector<double> series = {-1.0, 3.0, 1.0, -3.0, 1.0, 1.0, -2.0};
    const WaveCount count = count_waves(series, 2.0);  // from 0.25 to 3.75 samples
    EXPECT_EQ(count.waves, 1);
    EXPECT_DOUBLE_EQ(count.mean_period.value, 1.75);
    EXPECT_DOUBLE_EQ(count.mean_height, 6.0);
}

TEST(WaveCount, SeriesWithoutAWaveHaveNone) {
    for (const std::vector<double>& series :
         {std::vector<double>{}, {1.0}, {2.0, 2.0, 2.0}, {0.0, 1.0, 2.0, 3.0}}) {
        const WaveCount count = count_waves(series, 4.0);
        EXPECT_EQ(count.waves, 0);
        EXPECT_EQ(count.mean_period.value, 0.0);
        EXPECT_EQ(count.significant_height, 0.0);
    }
}

TEST(GaugeSpectrum, ItsSumIsTheVarianceAndItsPeakIsWhereTheWaveIs) {
    const auto series =
        sampled(4.0, 900.0, [](double t) { return 5.0 + 2.0 * std::cos(kTwoPi * 0.125 * t); });
    const GaugeSpectrum spectrum = estimate_spectrum(series, 4.0, 40.0);
    double sum = 0.0;
    for (const double density : spectrum.density) sum += density * spectrum.frequency_step;
    EXPECT_NEAR(sum, 2.0, 1e-3);
    const auto peak = std::ranges::max_element(spectrum.density) - spectrum.density.begin();
    EXPECT_NEAR(spectrum.frequency(static_cast<std::size_t>(peak)), 0.125,
                0.5 * spectrum.frequency_step);
    EXPECT_EQ(spectrum.frequency(spectrum.density.size() - 1), 2.0);
}

TEST(GaugeSpectrum, SegmentsAreTheLongestWithTheFreedomAskedFor) {
    // 36 n^2 / (19 n - 1): 2 for one segment, 3.89 for two, 1.895 n for many.
    EXPECT_EQ(gauge_segment(1024, 2.0), 1024u);
    EXPECT_EQ(gauge_segment(1535, 2.1), 512u);
    EXPECT_EQ(gauge_segment(1536, 3.8), 1024u);
    EXPECT_EQ(gauge_segment(14400, 40.0), 1024u);
    EXPECT_EQ(gauge_segment(100, 40.0), 0u) << "too short";
    EXPECT_EQ(gauge_segment(0, 2.0), 0u);
    EXPECT_TRUE(estimate_spectrum(std::vector<double>(100), 4.0, 40.0).density.empty());
    EXPECT_NEAR(estimate_spectrum(std::vector<double>(14400), 4.0, 40.0).degrees_of_freedom,
                36.0 * 27 * 27 / (19.0 * 27 - 1), 1e-9);
}

TEST(GaugeSpectrum, ScattersAsItsDegreesOfFreedomSay) {
    // White noise of variance 1 at 2 Hz: density 1 m^2/Hz, relative variance 2 / freedom.
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::vector<double> series(1 << 18);
    for (double& value : series) value = normal(random);
    const std::size_t piece = 2048;
    Coverage coverage;
    double squares = 0.0, last = 0.0, freedom = 0.0;
    for (std::size_t at = 0; at < series.size(); at += piece) {
        const GaugeSpectrum spectrum =
            estimate_spectrum(std::span(series).subspan(at, piece), 2.0, 14.0);
        freedom = spectrum.degrees_of_freedom;
        last += spectrum.density.back() / static_cast<double>(series.size() / piece);
        for (std::size_t i = 2; i + 2 < spectrum.density.size(); i += 3) {  // apart: independent
            coverage.add(density_of(spectrum, i), 1.0);
            squares += std::pow(spectrum.density[i] - 1.0, 2.0);
        }
    }
    EXPECT_NEAR(last, 0.5, 0.1) << "half the sampling rate has no negative frequency to add";
    EXPECT_GT(coverage.all, 5000);
    EXPECT_NEAR(squares / coverage.all, 2.0 / freedom, 0.06 * 2.0 / freedom);
    EXPECT_NEAR(coverage.share(), 0.95, 3.0 * coverage.standard_error());
}

TEST(SeaEstimate, StillWaterIsKnownExactlyAndShortSeriesHaveNoLimits) {
    const std::vector<double> still(1000, 2.5);
    const SeaEstimate flat = estimate_sea(still, 4.0, estimate_spectrum(still, 4.0, 20.0));
    EXPECT_EQ(flat.significant_wave_height.upper, 0.0);
    EXPECT_EQ(flat.zero_crossing_period.value, 0.0);
    const std::vector<double> few = {1.0, -1.0, 1.0, -1.0};
    const SeaEstimate sea = estimate_sea(few, 4.0, estimate_spectrum(few, 4.0, 20.0));
    EXPECT_DOUBLE_EQ(sea.significant_wave_height.value, 4.0);
    EXPECT_TRUE(std::isnan(sea.significant_wave_height.lower));
}

/// A Gaussian series of a JONSWAP spectrum with its peak at 0.1 Hz, from lines so dense that no
/// series of an hour can separate them.
class GaussianProcess {
  public:
    static constexpr int kSamples = 1 << 17;
    explicit GaussianProcess(double rate) : step_(rate / kSamples), fft_(kSamples) {}

    double moment(int order) const {
        double sum = 0.0;
        for (int i = 1; i < kSamples / 2; ++i) {
            sum += std::pow(i * step_, order) * density(i * step_) * step_;
        }
        return sum;
    }
    std::vector<double> series(unsigned seed) const {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        std::vector<std::complex<double>> data(kSamples);
        for (int i = 1; i < kSamples / 2; ++i) {
            const double re = normal(random);
            const double im = normal(random);
            const double amplitude = std::sqrt(density(i * step_) * step_);
            data[static_cast<std::size_t>(i)] = {amplitude * re, amplitude * im};
        }
        fft_.transform(data.data(), 1, FftDirection::inverse);
        std::vector<double> series;
        for (const std::complex<double>& value : data) series.push_back(value.real());
        return series;
    }

  private:
    static double density(double f) {
        constexpr double kPeak = 0.1;
        if (f < 0.3 * kPeak || f > 4.0 * kPeak) return 0.0;
        const double width = (f < kPeak ? 0.07 : 0.09) * kPeak;
        return std::pow(f / kPeak, -5.0) * std::exp(-1.25 * std::pow(f / kPeak, -4.0)) *
               std::pow(3.3, std::exp(-0.5 * std::pow((f - kPeak) / width, 2.0)));
    }

    double step_;
    Radix2Fft<double> fft_;
};

TEST(SeaEstimate, LimitsHoldTheTruthNineteenTimesInTwenty) {
    constexpr double kRate = 2.0;
    constexpr std::size_t kHour = 7200;
    const GaussianProcess process(kRate);
    const double m0 = process.moment(0);
    const double tz = std::sqrt(m0 / process.moment(2));
    const double significant = 4.0 * std::sqrt(m0);
    Coverage height, period, counted_period, rough_height;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const std::vector<double> all = process.series(seed);
        for (std::size_t at = 0; at + kHour <= all.size(); at += kHour) {
            const std::span<const double> series = std::span(all).subspan(at, kHour);
            const auto estimated = [&](double freedom) {
                return estimate_sea(series, kRate, estimate_spectrum(series, kRate, freedom));
            };
            const SeaEstimate sea = estimated(40.0);
            height.add(sea.significant_wave_height, significant);
            period.add(sea.zero_crossing_period, tz);
            counted_period.add(count_waves(series, kRate).mean_period, tz);
            // However rough the spectrum is that they are made from.
            rough_height.add(estimated(3.0).significant_wave_height, significant);
        }
    }
    EXPECT_EQ(height.all, 720);
    EXPECT_NEAR(height.share(), 0.95, 3.0 * height.standard_error());
    EXPECT_NEAR(rough_height.share(), 0.95, 3.0 * height.standard_error());
    EXPECT_NEAR(period.share(), 0.95, 3.0 * period.standard_error());
    // Crossings closer than a sample are missed: counted periods are a little long.
    EXPECT_NEAR(counted_period.share(), 0.95, 3.0 * counted_period.standard_error());
}

TEST(Gauges, ReadTheShownSurface) {
    Parameters parameters = test::wind_sea(64, 300.0, {.choppiness = 0.7});
    WaveSum sea(test::modes_of(parameters), parameters.water);
    sea.set_time(4.0);
    const WaterLevel level = sea.water_level(-2.0);
    const auto read = [&](double x, double y) { return read_gauge(sea, 0.7, x, y, level); };
    for (int i = 0; i < 40; ++i) {
        const double u = 7.3 * i, v = 300.0 - 11.9 * i;
        const LinearSample label = sea.at_label(u, v);
        const double x = u - 0.7 * label.displacement_x, y = v - 0.7 * label.displacement_y;
        const GaugeReading reading = read(x, y);
        EXPECT_NEAR(reading.elevation, label.height, 1e-7);
        constexpr double kStep = 1e-3;
        EXPECT_NEAR(reading.slope_x,
                    (read(x + kStep, y).elevation - read(x - kStep, y).elevation) / (2.0 * kStep),
                    1e-5);
        EXPECT_NEAR(reading.slope_y,
                    (read(x, y + kStep).elevation - read(x, y - kStep).elevation) / (2.0 * kStep),
                    1e-5);
        EXPECT_EQ(reading.water.pressure, sea.water_motion(x, y, -2.0).pressure)
            << "at the place itself, displaced or not";
    }
}

TEST(Gauges, ReadTheTopSheetWhereCrestsFold) {
    // In water of 0.3 m waves of ten metres are displaced far more than they are high.
    Parameters shallow = test::wind_sea(64, 60.0, {.depth = 0.3});
    Parameters choppy = test::wind_sea(128, 100.0, {.height = 8.0, .choppiness = 4.0});
    for (const Parameters& parameters : {shallow, choppy}) {
        Ocean ocean(parameters, {.threads = 2});
        std::vector<Gauge> gauges;
        std::vector<WorldPoint> points;
        for (int i = 0; i < 40; ++i) {
            points.push_back({1.3 * i - 20.0, std::fmod(7.7 * i, 60.0)});
            gauges.push_back({"g", {{0.0, {points.back().x, points.back().y, -0.1}}}, 0.0, 0.0});
        }
        const SampleTimes times{0.0, 5.0, 1.0};
        const GaugeSeries series =
            read_gauge_series(ocean, gauges, times, test::pool(), [](std::size_t) {});
        int folded = 0;
        for (std::size_t i = 0; i < series.times; ++i) {
            const auto samples =
                test::query(ocean, times.at(i), points, {.exact = true, .foam = false});
            for (std::size_t g = 0; g < gauges.size(); ++g) {
                EXPECT_FALSE(samples[g].undecided);
                folded += samples[g].folded ? 1 : 0;
                EXPECT_NEAR(series.reading(i, g)[GaugeSeries::kElevation], samples[g].height, 1e-6)
                    << "at " << times.at(i) << " s, gauge " << g;
            }
        }
        EXPECT_GT(folded, 15);
    }
}

}  // namespace
}  // namespace ocean
