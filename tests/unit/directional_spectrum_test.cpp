// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The table holds the energy and the density of the spectra that it was made from.
#include "ocean/internal/directional_spectrum.hpp"

#include "ocean/internal/spectrum.hpp"
#include "ocean/internal/spreading.hpp"
#include "ocean/thread_pool.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

std::shared_ptr<SpectrumRecord> bimodal_record() {
    auto record = std::make_shared<SpectrumRecord>();
    for (int i = 0; i < 40; ++i) {
        const double f = 0.035 + 0.01 * i + 0.0001 * i * i;
        record->frequency.push_back(f);
        record->density.push_back(std::exp(-std::pow((f - 0.08) / 0.01, 2.0)) +
                                  0.4 * std::exp(-std::pow((f - 0.22) / 0.04, 2.0)));
        const double direction = f < 0.15 ? 2.5 : -0.7;  // swell and wind sea
        record->a1.push_back(0.8 * std::cos(direction));
        record->b1.push_back(0.8 * std::sin(direction));
        record->a2.push_back(0.5 * std::cos(2.0 * direction));
        record->b2.push_back(0.5 * std::sin(2.0 * direction));
    }
    return record;
}

Parameters measured_sea() {
    Parameters parameters;
    parameters.waves.front().spectrum = SpectrumKind::measured;
    parameters.waves.front().measured = bimodal_record();
    return parameters;
}

/// Returns the sea with another record, a changed copy of its own.
Parameters with_record(Parameters parameters, const std::function<void(SpectrumRecord&)>& change) {
    auto record = std::make_shared<SpectrumRecord>(*parameters.waves.front().measured);
    change(*record);
    parameters.waves.front().measured = record;
    return parameters;
}

SpectralMoments moments_of(const Parameters& parameters) {
    return make_directional_spectrum(parameters).moments(parameters.water);
}

double trapezoid(const SpectrumRecord& record) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < record.frequency.size(); ++i) {
        sum += 0.5 * (record.density[i] + record.density[i + 1]) *
               (record.frequency[i + 1] - record.frequency[i]);
    }
    return sum;
}

TEST(DirectionalSpectrum, EnergyIsExactToOneHundredThousandth) {
    for (const SpectrumKind kind : {SpectrumKind::phillips, SpectrumKind::pierson_moskowitz,
                                    SpectrumKind::jonswap, SpectrumKind::tma}) {
        for (const double gamma : {1.0, 3.3, 10.0}) {
            Parameters parameters = test::wind_sea(128, 400.0, {.spectrum = kind, .depth = 40.0});
            parameters.waves.front().peak_enhancement = gamma;
            const double exact =
                make_frequency_spectrum(parameters.waves.front(), parameters.water, 100.0).m0;
            const double table = moments_of(parameters).m0;
            EXPECT_NEAR(table / exact, 1.0, 1e-5);
        }
    }
}

TEST(DirectionalSpectrum, DensityIsExactToOneTenThousandthOfThePeak) {
    for (const SpreadingKind spreading :
         {SpreadingKind::cosine_squared, SpreadingKind::mitsuyasu, SpreadingKind::hasselmann,
          SpreadingKind::donelan_banner}) {
        Parameters parameters = test::wind_sea();
        WaveSystem& system = parameters.waves.front();
        system.spreading = spreading;
        system.swell = 0.5;
        system.peak_enhancement = 7.0;
        const DirectionalSpectrum table = make_directional_spectrum(parameters);
        const double peak = jonswap_peak(system.wind(), system.fetch, 9.81);
        const double largest = table.density(peak, kPi / 6.0);
        std::vector<double> row(4096);
        for (double x = 0.5; x < 6.0; x *= 1.0137) {
            spreading_row(system, x, system.wind() * peak / 9.81, kPi / 6.0, row);
            const double s = jonswap_density(x * peak, system.wind(), system.fetch, 7.0, 9.81);
            for (std::size_t j = 3; j < row.size(); j += 117) {
                const double theta = kTwoPi * static_cast<double>(j) / 4096.0;
                ASSERT_NEAR(table.density(x * peak, theta), s * row[j], 2e-4 * largest)
                    << x << " " << theta;
            }
        }
    }
}

TEST(DirectionalSpectrum, TailKeepsItsRelativeAccuracy) {
    const Parameters parameters = test::wind_sea();
    const DirectionalSpectrum table = make_directional_spectrum(parameters);
    for (double omega = 2.0; omega < 60.0; omega *= 1.07) {
        EXPECT_NEAR(
            table.frequency_density(omega) / jonswap_density(omega, 10.0, 100000.0, 3.3, 9.81), 1.0,
            1.5e-3);
    }
}

/// The table of one wave system of a sea alone.
DirectionalSpectrum table_of(Parameters parameters, std::size_t system) {
    parameters.waves = {parameters.waves[system]};
    return make_directional_spectrum(parameters);
}

TEST(DirectionalSpectrum, TheTableOfSeveralSystemsIsTheSumOfTheirTables) {
    // A narrow swell, which needs twice the directions, and a sea between whose rows its own lie.
    Parameters both = test::wind_sea();
    WaveSystem swell = both.waves.front();
    swell.spreading = SpreadingKind::mitsuyasu;
    swell.wind_speed = 6.0;
    swell.peak_period = 11.0;
    swell.wind_direction = -120.0;
    both.waves.push_back(swell);
    const DirectionalSpectrum sum = make_directional_spectrum(both);
    const DirectionalSpectrum one = table_of(both, 0);
    const DirectionalSpectrum two = table_of(both, 1);
    ASSERT_NE(one.directions(), two.directions());
    const double peak = two.density(kTwoPi / 11.0, -120.0 * kPi / 180.0);
    for (double omega = 0.2; omega < 20.0; omega *= 1.0137) {
        for (double theta = -3.1; theta < 3.1; theta += 0.0937) {
            ASSERT_NEAR(sum.density(omega, theta),
                        one.density(omega, theta) + two.density(omega, theta), 1e-9 * peak)
                << omega << " " << theta;
        }
    }
}

TEST(DirectionalSpectrum, MeasuredEnergyIsTheTrapezoidAndEachFrequencyKeepsItsDirection) {
    const Parameters parameters = measured_sea();
    const DirectionalSpectrum table = make_directional_spectrum(parameters);
    EXPECT_NEAR(table.moments(parameters.water).m0 / trapezoid(*parameters.waves[0].measured), 1.0,
                1e-7);
    EXPECT_EQ(table.frequency_density(kTwoPi * 0.03), 0.0) << "no tail is added";
    EXPECT_EQ(table.frequency_density(kTwoPi * 0.70), 0.0);
    const auto mean_at = [&](double frequency) {
        std::complex<double> sum = 0.0;
        for (int j = 0; j < 720; ++j) {
            const double theta = kTwoPi * j / 720;
            sum += table.density(kTwoPi * frequency, theta) * std::polar(1.0, theta);
        }
        return std::arg(sum);
    };
    EXPECT_NEAR(mean_at(0.08), 2.5, 0.01);
    EXPECT_NEAR(mean_at(0.22), -0.7, 0.01);
}

TEST(DirectionalSpectrum, TurningAMeasuredSeaKeepsTheShapeOfEveryRow) {
    Parameters parameters = measured_sea();
    const DirectionalSpectrum as_measured = make_directional_spectrum(parameters);
    const double mean = as_measured.moments(parameters.water).mean_direction;
    const double turn = kTwoPi * 200.0 / as_measured.directions();  // whole columns
    parameters.waves.front().wind_direction = (mean + turn) * 180.0 / kPi;
    const DirectionalSpectrum turned = make_directional_spectrum(parameters);
    for (const double frequency : {0.08, 0.15, 0.22}) {
        const double omega = kTwoPi * frequency;
        const double scale = as_measured.frequency_density(omega);
        for (double theta = 0.0; theta < kTwoPi; theta += 0.1) {
            EXPECT_NEAR(turned.density(omega, theta + turn), as_measured.density(omega, theta),
                        2e-3 * scale);
        }
    }
}

TEST(DirectionalSpectrum, VarianceIsTheFirstOfTheMoments) {
    for (const Parameters& parameters : {test::wind_sea(), measured_sea()}) {
        const DirectionalSpectrum table = make_directional_spectrum(parameters);
        for (const auto& [shortest, longest] :
             {std::pair(0.0, 0.0), std::pair(31.0, 0.0), std::pair(0.0, 77.0),
              std::pair(20.0, 90.0), std::pair(2000.0, 0.0)}) {
            EXPECT_NEAR(table.variance(parameters.water, shortest, longest),
                        table.moments(parameters.water, shortest, longest).m0, 1e-12)
                << shortest << " " << longest;
        }
    }
}

TEST(DirectionalSpectrum, MeanSquareSlopeIsTheIntegralOfKSquared) {
    // A spectrum so narrow that k is one number: m0 k^2.
    Parameters parameters;
    auto record = std::make_shared<SpectrumRecord>();
    record->frequency = {0.0999, 0.1001};
    record->density = {500.0, 500.0};
    parameters.waves.front().spectrum = SpectrumKind::measured;
    parameters.waves.front().measured = record;
    const SpectralMoments moments = moments_of(parameters);
    const double k = std::pow(kTwoPi * 0.1, 2.0) / 9.81;
    EXPECT_NEAR(moments.m0, 0.1, 1e-9);
    EXPECT_NEAR(moments.mean_square_slope / (0.1 * k * k), 1.0, 1e-4);
}

TEST(DirectionalSpectrum, MissingMomentsAreFilledFromTheNeighbours) {
    const Parameters parameters = measured_sea();
    const DirectionalSpectrum whole = make_directional_spectrum(parameters);
    const auto forget = [](SpectrumRecord& record) {
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{5}}) {
            record.a1[i] = record.a2[i] = std::nan("");
        }
    };
    const DirectionalSpectrum filled = make_directional_spectrum(with_record(parameters, forget));
    const double omega = kTwoPi * parameters.waves.front().measured->frequency[5];
    EXPECT_NEAR(filled.density(omega, 2.5), whole.density(omega, 2.5), 1e-9);
}

TEST(DirectionalSpectrum, MeasuredWithoutDirectionsTakesTheWind) {
    Parameters parameters = with_record(measured_sea(), [](SpectrumRecord& record) {
        for (auto* moments : {&record.a1, &record.b1, &record.a2, &record.b2}) moments->clear();
    });
    parameters.waves.front().wind_direction = -45.0;
    const SpectralMoments moments = moments_of(parameters);
    EXPECT_NEAR(moments.mean_direction * 180.0 / kPi, -45.0, 0.1);
    EXPECT_NEAR(moments.m0 / trapezoid(*parameters.waves.front().measured), 1.0, 1e-7);
}

/// Swell in a narrow lobe and a wind sea in a broad one, at uneven directions and frequencies.
std::shared_ptr<SpectrumRecord> full_record() {
    auto record = std::make_shared<SpectrumRecord>();
    record->frequency = {0.05, 0.06, 0.075, 0.09, 0.12, 0.2, 0.35};
    for (double d = 2.0; d < 360.0; d += d < 90.0 ? 5.0 : 13.0) record->direction.push_back(d);
    const auto lobe = [](double degrees, double mean, double exponent) {
        return std::pow(std::abs(std::cos(0.5 * (degrees - mean) * kPi / 180.0)), exponent);
    };
    const std::vector<double>& d = record->direction;
    for (const double f : record->frequency) {
        double sum = 0.0;
        for (std::size_t j = 0; j < d.size(); ++j) {
            const double before = j > 0 ? d[j - 1] : d.back() - 360.0;
            const double after = j + 1 < d.size() ? d[j + 1] : d.front() + 360.0;
            const double value =
                f < 0.1 ? 0.3 * lobe(d[j], 30.0, 120.0) * (0.1 - f) : 0.02 * lobe(d[j], 250.0, 4.0);
            record->directional_density.push_back(value);
            sum += 0.5 * (after - before) * value;
        }
        record->density.push_back(sum);
    }
    return record;
}

Parameters full_sea() {
    Parameters parameters = measured_sea();
    parameters.waves.front().measured = full_record();
    return parameters;
}

TEST(DirectionalSpectrum, FullSpectrumIsTakenAsItIsWithTheEnergyOfEveryRow) {
    const Parameters parameters = full_sea();
    const SpectrumRecord& record = *parameters.waves.front().measured;
    const DirectionalSpectrum table = make_directional_spectrum(parameters);
    EXPECT_NEAR(table.moments(parameters.water).m0 / trapezoid(record), 1.0, 1e-7);
    const std::size_t width = record.direction.size();
    // m^2/Hz/degree as m^2 s/rad^2.
    const double unit = 180.0 / kPi / kTwoPi;
    for (std::size_t i = 0; i + 1 < record.frequency.size(); ++i) {
        const double omega = kTwoPi * record.frequency[i];
        EXPECT_NEAR(table.frequency_density(omega) * kTwoPi, record.density[i],
                    1e-6 * record.density[i]);
        const double* row = record.directional_density.data() + i * width;
        const double largest = *std::max_element(row, row + width) * unit;
        for (std::size_t j = 0; j < width; ++j) {
            const double next = j + 1 < width ? record.direction[j + 1] : 360.0 + 2.0;
            const double middle = 0.5 * (record.direction[j] + next) * kPi / 180.0;
            EXPECT_NEAR(table.density(omega, record.direction[j] * kPi / 180.0), row[j] * unit,
                        0.01 * largest);
            EXPECT_NEAR(table.density(omega, middle), 0.5 * (row[j] + row[(j + 1) % width]) * unit,
                        0.01 * largest)
                << "linear between the listed directions, across 360 degrees too";
        }
    }
}

TEST(DirectionalSpectrum, GivenWindDirectionReplacesTheMeasuredMean) {
    for (Parameters parameters : {measured_sea(), full_sea()}) {
        const SpectralMoments before = moments_of(parameters);
        EXPECT_GT(std::abs(before.mean_direction * 180.0 / kPi + 170.0), 20.0);
        parameters.waves.front().wind_direction = -170.0;
        const SpectralMoments turned = moments_of(parameters);
        EXPECT_NEAR(turned.mean_direction * 180.0 / kPi, -170.0, 0.1);
        EXPECT_NEAR(turned.directional_spread, before.directional_spread, 1e-3);
        EXPECT_NEAR(turned.m0 / before.m0, 1.0, 1e-9);
    }
}

TEST(DirectionalSpectrum, FullSpectrumRowWithoutEnergyIsNoWaves) {
    const Parameters parameters = with_record(full_sea(), [](SpectrumRecord& record) {
        const auto width = static_cast<std::ptrdiff_t>(record.direction.size());
        std::fill_n(record.directional_density.begin() + 3 * width, width, 0.0);
        record.density[3] = 0.0;
    });
    const DirectionalSpectrum table = make_directional_spectrum(parameters);
    const auto& frequency = parameters.waves.front().measured->frequency;
    EXPECT_EQ(table.frequency_density(kTwoPi * frequency[3]), 0.0);
    EXPECT_GT(table.frequency_density(kTwoPi * frequency[2]), 0.0);
    EXPECT_TRUE(std::isfinite(table.moments(parameters.water).directional_spread));
}

TEST(DirectionalSpectrum, FlatSeaIsZeroEverywhere) {
    Parameters parameters = test::wind_sea(128, 400.0, {.wind = 0.0});
    const DirectionalSpectrum table = make_directional_spectrum(parameters);
    EXPECT_TRUE(table.flat());
    EXPECT_EQ(table.density(1.0, 0.0), 0.0);
    EXPECT_EQ(table.moments(parameters.water).m0, 0.0);
}

}  // namespace
}  // namespace ocean
