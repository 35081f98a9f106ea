// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Layouts as their centres publish them, made by hand: names, flags and units of CDIP, Copernicus,
// NDBC, FRF, WAVEWATCH III, Spotter archives and the WPTO hindcast.

#include "contents.hpp"
#include "netcdf_layout.hpp"
#include "ocean/seafile.hpp"
#include "refusal.hpp"

namespace ocean::netcdf {
namespace {

constexpr const char* kDensity = "sea_surface_wave_variance_spectral_density";
const std::vector<std::string> kNone;
constexpr double kTravel = 70.0;  // degrees from east, of waves from 200

void expect_says(const SpectrumRecord& record, const std::string& words) {
    EXPECT_TRUE(test::says(record.warnings, words));
}

/// First moment r1 and second moment r2 about the travel direction; NaN: not known.
void expect_moments(const SpectrumRecord& record, std::size_t bin, double r1, double r2) {
    ASSERT_TRUE(record.has_moments());
    EXPECT_NEAR(record.a1[bin], r1 * std::cos(kTravel * kDegree), 1e-9);
    EXPECT_NEAR(record.b1[bin], r1 * std::sin(kTravel * kDegree), 1e-9);
    if (std::isnan(r2)) {
        EXPECT_TRUE(std::isnan(record.a2[bin]));
        return;
    }
    EXPECT_NEAR(record.a2[bin], r2 * std::cos(2.0 * kTravel * kDegree), 1e-9);
    EXPECT_NEAR(record.b2[bin], r2 * std::sin(2.0 * kTravel * kDegree), 1e-9);
}

/// A density of 1 over three times and four frequencies, and whatever is beside it.
Content with_bins(const std::string& spectrum, std::vector<Variable> beside) {
    Content content;
    content.dimensions = {{"time", 3}, {"frequency", 4}};
    content.variables = {
        numbers("time", {0}, {{"units", "seconds since 1970-01-01 00:00:00"}},
                {1709294400.0, 1709296200.0, 1709298000.0}),
        numbers("frequency", {1}, {{"units", "Hz"}}, {0.1, 0.15, 0.2, 0.25}),
        numbers(spectrum, {0, 1}, {{"units", "m2 s"}, {"standard_name", kDensity}},
                std::vector<double>(12, 1.0)),
    };
    for (Variable& v : beside) content.variables.push_back(std::move(v));
    return content;
}

Variable bins(const std::string& name, double value,
              std::map<std::string, std::string> attributes = {}) {
    return numbers(name, {0, 1}, std::move(attributes), std::vector<double>(12, value));
}

/// CDIP's, from 200 degrees: a1 to the north and b1 to the east of where waves come from.
Content cdip() {
    const double from = 200.0 * kDegree;
    Content content = with_bins(
        "waveEnergyDensity",
        {
            bins("waveMeanDirection", 200.0,
                 {{"units", "degreeT"}, {"standard_name", "sea_surface_wave_from_direction"}}),
            bins("waveA1Value", 0.8 * std::cos(from)),
            bins("waveB1Value", 0.8 * std::sin(from)),
            bins("waveA2Value", 0.5 * std::cos(2.0 * from)),
            bins("waveB2Value", 0.5 * std::sin(2.0 * from)),
            numbers("waveFlagPrimary", {0},
                    {{"flag_values", "1 2 3 4 9"},
                     {"flag_meanings", "good not_evaluated questionable bad missing"}},
                    {1.0, 4.0, 3.0}),
            numbers("waveFlagSecondary", {0}, {}, {0.0, 4.0, 4.0}),
            numbers("waveFrequencyFlagPrimary", {1}, {}, {1.0, 1.0, 1.0, 9.0}),
            numbers("metaWaterDepth", {}, {{"units", "meter"}}, {549.0}),
            numbers("metaStationLatitude", {}, {{"standard_name", "latitude"}}, {32.9}),
            numbers("metaStationLongitude", {}, {{"standard_name", "longitude"}}, {-117.4}),
            {"metaStationName", {}, {}, true, {}, {"TORREY PINES OUTER, CA"}},
        });
    find(content, "time").attributes["standard_name"] = "time";
    find(content, "time").name = "waveTime";
    return content;
}

TEST(PublishedLayouts, CdipHasMomentsPlaceAndFlags) {
    Content content = cdip();
    find(content, "waveEnergyDensity").attributes["units"] = "meter^2 second";
    const std::vector<SpectrumRecord> records = records_from(content);
    ASSERT_EQ(records.size(), 3u);
    const SpectrumRecord& good = records[0];
    EXPECT_EQ(good.time, "2024-03-01T12:00");
    EXPECT_EQ(good.station, "TORREY PINES OUTER, CA");
    EXPECT_EQ(good.latitude, 32.9);
    EXPECT_EQ(good.depth, 549.0);
    EXPECT_EQ(good.frequency, (std::vector<double>{0.1, 0.15, 0.2})) << "a band is flagged";
    expect_moments(good, 0, 0.8, 0.5);
    expect_says(good, "1 of 4 frequencies are flagged as bad by waveFrequencyFlagPrimary");
    EXPECT_EQ(records[1].time, "2024-03-01T12:30");
    EXPECT_EQ(records[1].fault,
              "waveFlagPrimary: record 2024-03-01T12:30 TORREY PINES OUTER, CA: "
              "its flag is 4, bad");
    EXPECT_TRUE(records[1].frequency.empty());
    EXPECT_EQ(records[2].fault, "");
    expect_says(records[2], "flagged as doubtful by waveFlagPrimary");
}

TEST(PublishedLayouts, OpeningPassesOverAFlaggedRecordUnlessItsTimeIsAsked) {
    Content content = cdip();
    find(content, "waveFlagPrimary").values = {4.0, 1.0, 1.0};
    const std::vector<SpectrumRecord> records = records_from(content);
    EXPECT_EQ(choose_record(records, {"", ""}, "f").time, "2024-03-01T12:30");
    EXPECT_EQ(test::message_of([&] {
                  choose_record(records, {"2024-03-01T12:00", ""}, "f");
              }),
              records[0].fault + "; a record that can be read is that of 2024-03-01T12:30");
    find(content, "waveFlagPrimary").values = {4.0, 4.0, 9.0};
    EXPECT_THROW(choose_record(records_from(content), {"", ""}, "f"), Error);
}

TEST(PublishedLayouts, FlagsOfBandsLeaveDirectionalRowsOut) {
    Content content = wavespectra();
    content.variables.push_back(numbers("efth_QC", {0, 1, 2}, {}, {1, 1, 1, 1, 1, 1, 4, 4}));
    content.dimensions.push_back({"unused", 7});
    const std::vector<SpectrumRecord> records = records_from(content);
    EXPECT_EQ(records[2].fault, "");
    EXPECT_TRUE(test::says(records[3].fault, "at least 2 frequencies"));
}

TEST(PublishedLayouts, CopernicusHasBothDirectionsWithTheirSpreads) {
    const double spread1 = std::sqrt(2.0 * (1.0 - 0.8)) / kDegree;
    const double spread2 = std::sqrt(0.5 * (1.0 - 0.5)) / kDegree;
    const std::string from = "sea_surface_wave_from_direction";
    Content content = with_bins("VSPEC1D", {bins("THETA1", 200.0, {{"standard_name", from}}),
                                            bins("STHETA1", spread1, {{"units", "degree"}}),
                                            bins("THETA2", 200.0, {{"standard_name", from}}),
                                            bins("STHETA2", spread2, {{"units", "degree"}})});
    content.attributes["platform_code"] = "6200069";
    content.dimensions.push_back({"LATITUDE", 3});
    Variable& frequency = find(content, "frequency");
    frequency =
        numbers("FREQ", {0, 1}, {{"units", "s-1"}, {"standard_name", "wave_frequency"}}, {});
    for (int i = 0; i < 3; ++i) {
        for (const double f : {0.1, 0.15, 0.2, 0.25}) frequency.values.push_back(f);
    }
    content.dimensions[1].name = "FREQUENCY";
    content.variables.push_back(
        numbers("LATITUDE", {2}, {{"standard_name", "latitude"}}, {48.0, 48.1, 48.2}));
    Variable qc = bins("VSPEC1D_QC", 1.0,
                       {{"flag_values", "0 1 2 3 4 5 7 8 9"},
                        {"flag_meanings",
                         "no_qc_performed good_data probably_good_data "
                         "bad_data_that_are_potentially_correctable bad_data "
                         "value_changed nominal_value interpolated_value "
                         "missing_value"}});
    qc.values[4] = 4.0;
    content.variables.push_back(qc);
    Variable theta_qc = bins("THETA1_QC", 1.0);
    theta_qc.values[8] = 4.0;
    content.variables.push_back(theta_qc);
    const std::vector<SpectrumRecord> records = records_from(content);
    ASSERT_EQ(records.size(), 3u);
    EXPECT_EQ(records[1].station, "6200069");
    EXPECT_EQ(records[1].latitude, 48.1) << "a position for each time";
    expect_moments(records[0], 3, 0.8, 0.5);
    EXPECT_EQ(records[1].frequency.size(), 3u);
    expect_says(records[1], "1 of 4 frequencies are flagged as bad by VSPEC1D_QC");
    EXPECT_TRUE(std::isnan(records[2].a1[0])) << "its direction is flagged";
    expect_moments(records[2], 1, 0.8, 0.5);
    find(content, "FREQ").values[5] = 0.16;
    EXPECT_TRUE(test::says(fault_of(content), "FREQ: the frequencies of the records differ"));
}

TEST(PublishedLayouts, WavewatchHasDirectionsOfBothMoments) {
    Content content = with_bins(
        "ef",
        {bins("th1m", 200.0,
              {{"units", "degree"}, {"long_name", "mean wave direction from spectral moments"}}),
         bins("sth1m", std::sqrt(2.0 * (1.0 - 0.8)) / kDegree),
         bins("th2m", 20.0),  // 180 degrees off: the second moment has two of them
         bins("sth2m", std::sqrt(0.5 * (1.0 - 0.5)) / kDegree)});
    expect_moments(records_from(content)[0], 2, 0.8, 0.5);
    EXPECT_EQ(records_from(content)[0].warnings, kNone);
    find(content, "sth2m").name = "other";
    expect_moments(records_from(content)[0], 2, 0.8, kMissing);
}

TEST(PublishedLayouts, NdbcHasShortNamesAndRatiosThatMayBePercent) {
    const auto read = [](double unit, const char* units) {
        const Content content = with_bins("c11", {bins("alpha1", 200.0), bins("alpha2", 200.0),
                                                  bins("r1", 0.8 * unit, {{"units", units}}),
                                                  bins("r2", 0.5 * unit, {{"units", units}})});
        return records_from(content)[0];
    };
    expect_moments(read(1.0, "1"), 0, 0.8, 0.5);
    expect_moments(read(100.0, "percent"), 0, 0.8, 0.5);
    EXPECT_EQ(read(100.0, "%").warnings, kNone);
    expect_says(read(100.0, ""), "'r1' reaches 80: it is taken as per cent");
    expect_moments(read(100.0, ""), 0, 0.8, 0.5);
}

TEST(PublishedLayouts, PartsOfDirectionsGiveWhatTheyCan) {
    const auto read = [](std::vector<Variable> beside) {
        return records_from(with_bins("ef", std::move(beside)))[0];
    };
    const Variable mean = bins("mean_wave_direction", 200.0, {{"long_name", "coming from"}});
    const Variable radians =
        bins("mean_direction", 200.0 * kDegree,
             {{"units", "radians"}, {"standard_name", "sea_surface_wave_from_direction"}});
    const Variable ratio = bins("r1", 0.8), silent = bins("mean_direction", 200.0);
    expect_moments(read({mean, ratio}), 0, 0.8, kMissing);
    expect_moments(read({mean, bins("spread", 4.0, {{"units", "1"}})}), 0, 0.8, kMissing);
    expect_moments(read({radians, ratio}), 0, 0.8, kMissing);
    expect_moments(read({silent, ratio}), 0, 0.8, kMissing);
    expect_says(read({silent, ratio}),
                "nothing in the file says whether waves come from the direction 'mean_direction'");
    expect_moments(read({mean}), 0, 8.0 / (3.0 * std::numbers::pi), kMissing);
    expect_says(read({mean}), "31.5 degrees are taken, as cos^2 spreads");
    EXPECT_FALSE(read({bins("alpha1", 999.0), bins("r1", 999.0)}).has_moments());
    for (const auto& [name, value] : {std::pair("alpha1", 800.0), std::pair("r1", -0.2)}) {
        Content broken = with_bins("ef", {bins("alpha1", 200.0), bins("r1", 0.8)});
        find(broken, name).values[7] = value;
        const std::vector<SpectrumRecord> records = records_from(broken);
        EXPECT_EQ(records[0].fault, "");
        EXPECT_TRUE(test::says(records[1].fault, name));
        EXPECT_EQ(records[2].fault, "");
    }
}

/// Moments about the travel direction from east are those of a Spotter.
Content archive(double angle, std::vector<Variable> beside) {
    Content content =
        with_bins("variance_density", {bins("a1", 0.8 * std::cos(angle * kDegree)),
                                       bins("b1", 0.8 * std::sin(angle * kDegree)),
                                       bins("a2", 0.5 * std::cos(2.0 * angle * kDegree)),
                                       bins("b2", 0.5 * std::sin(2.0 * angle * kDegree))});
    for (Variable& v : beside) content.variables.push_back(std::move(v));
    return content;
}

TEST(PublishedLayouts, MomentsWithoutAWordAreThoseOfASpotterUnlessTheirMeanSaysElse) {
    const SpectrumRecord silent = records_from(archive(kTravel, {}))[0];
    expect_moments(silent, 0, 0.8, 0.5);
    expect_says(silent,
                "nothing in the file says how 'a1' is measured: where waves travel to, "
                "counter-clockwise from east, is taken, as Spotter buoys have it");
    const Variable mean = bins("direction", 200.0, {{"long_name", "coming from"}});
    const SpectrumRecord spotter = records_from(archive(kTravel, {mean}))[0];
    expect_moments(spotter, 0, 0.8, 0.5);
    EXPECT_EQ(spotter.warnings, kNone) << "the mean confirms it";
    const SpectrumRecord nautical = records_from(archive(200.0, {mean}))[0];
    expect_moments(nautical, 0, 0.8, 0.5);
    expect_says(nautical, "as 'direction' has it");
    Content worded = archive(200.0, {});
    find(worded, "a1").attributes["long_name"] = "a1, coming from, positive north";
    expect_moments(records_from(worded)[0], 0, 0.8, 0.5);
    EXPECT_EQ(records_from(worded)[0].warnings, kNone);
    Content first = archive(kTravel, {mean});
    find(first, "b2").name = "other";
    expect_moments(records_from(first)[0], 0, 0.8, kMissing);
}

TEST(PublishedLayouts, OfTwoDensitiesTheDirectionalOneIsTaken) {
    Content content = wavespectra();
    content.dimensions[2].name = "waveFrequency";
    content.dimensions[3].name = "waveDirectionBins";
    find(content, "freq").name = "waveFrequency";
    Variable& bins = find(content, "dir");
    bins.name = "waveDirectionBins";
    bins.attributes["long_name"] = "wave directions from, clockwise from true north";
    Variable& density = find(content, "efth");
    density.name = "directionalWaveEnergyDensity";
    density.attributes["units"] = "m2/Hz/deg";
    content.variables.insert(
        content.variables.begin(),
        numbers("waveEnergyDensity", {0, 1, 2}, {{"units", "m2/Hz"}}, std::vector<double>(8, 5.0)));
    const std::vector<SpectrumRecord> records = records_from(content);
    const std::vector<SpectrumRecord> wanted = records_from(wavespectra());
    ASSERT_EQ(records.size(), 4u);
    EXPECT_EQ(records[3].directional_density, wanted[3].directional_density);
    EXPECT_TRUE(records[0].warnings.empty());
}

TEST(PublishedLayouts, DensitiesOfUnknownNamesAreFoundByTheirUnits) {
    Content content = with_bins("S", {});
    find(content, "S").attributes = {{"units", "cm^2/Hz"}};
    EXPECT_EQ(records_from(content)[0].density, std::vector<double>(4, 1e-4));
    find(content, "S").attributes = {{"units", "J/m2/Hz"}};
    EXPECT_DOUBLE_EQ(records_from(content)[0].density[0], 1.0 / (1025.0 * 9.81));
    find(content, "S").attributes.clear();
    EXPECT_TRUE(test::says(fault_of(content), "holds no wave spectrum"));
}

TEST(PublishedLayouts, AngularFrequenciesAreConvertedWithTheirDensity) {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    for (const char* units : {"m2 s", "m2/(rad/s)", "m2 s rad-1"}) {
        Content content = with_bins("ef", {});
        find(content, "ef").attributes["units"] = units;
        Variable& frequency = find(content, "frequency");
        frequency.attributes["units"] = "rad s-1";
        for (double& f : frequency.values) f *= kTurn;
        const SpectrumRecord record = records_from(content)[0];
        EXPECT_NEAR(record.frequency[3], 0.25, 1e-12);
        EXPECT_NEAR(record.density[0], kTurn, 1e-12) << units;
        EXPECT_EQ(record.warnings.empty(), units != std::string("m2 s"));
    }
}

TEST(PublishedLayouts, TheWptoHindcastHasNoUnits) {
    Content content = wavespectra();
    content.dimensions[0].name = "time_index";
    content.dimensions[1].name = "gid";
    find(content, "time").name = "time_index";
    for (const char* name : {"dir", "freq", "efth"}) find(content, name).attributes.clear();
    find(content, "dir").name = "direction";
    find(content, "efth").name = "spectral_density";
    content.variables.push_back(numbers("gid", {1}, {}, {58.0, 59.0}));
    const std::vector<SpectrumRecord> records = records_from(content);
    EXPECT_EQ(records[1].station, "59");
    EXPECT_EQ(records[3].directional_density, records_from(wavespectra())[3].directional_density);
    expect_says(records[0], "spectral_density has no unit: m2/Hz/degree is taken");
    expect_says(records[0], "nothing in the file says whether waves come from");
}

TEST(PublishedLayouts, OneBadRecordCostsNoOther) {
    Content content = wavespectra();
    find(content, "efth").values[5] = -50.0;  // far below the noise of an estimator
    find(content, "lat").values[1] = 95.0;    // of the second place
    const std::vector<SpectrumRecord> records = records_from(content);
    ASSERT_EQ(records.size(), 4u);
    EXPECT_TRUE(test::says(records[0].fault, "efth: record 2020-02-28T22:00: "));
    EXPECT_EQ(records[0].time, "2020-02-28T22:00");
    EXPECT_TRUE(records[0].frequency.empty());
    EXPECT_TRUE(test::says(records[1].fault, "lat: 95.0"));
    EXPECT_EQ(records[2].fault, "");
    EXPECT_EQ(records[2], records_from(wavespectra())[2]);
}

TEST(PublishedLayouts, ANameThatBeginsWithAZeroHidesNoFault) {
    Content content = wavespectra();
    find(content, "efth").values[5] = -50.0;
    find(content, "efth").name = std::string("\0efth", 5);
    EXPECT_TRUE(test::says(records_from(content)[0].fault, "a density of -50"));
}

TEST(PublishedLayouts, NegativeNoiseAndABinOfZeroHertzAreCleaned) {
    Content content = with_bins("ef", {bins("alpha1", 200.0), bins("r1", 0.8)});
    find(content, "ef").values = {0.0, 1.0, 2.0, -0.1, 1, 1, 1, 1, 1, 1, 1, 1};
    find(content, "frequency").values[0] = 0.0;
    const SpectrumRecord record = records_from(content)[0];
    EXPECT_EQ(record.fault, "");
    EXPECT_EQ(record.frequency, (std::vector<double>{0.15, 0.2, 0.25}));
    EXPECT_EQ(record.density[2], 0.0);
    EXPECT_EQ(record.a1.size(), 3u);
    expect_says(record, "1 of 3 densities are below 0, the lowest by 5.00 % of the highest");
    // The trapezoid keeps its energy: 0.05 * (0.5 + 2 - 0.05).
    EXPECT_NEAR(0.05 * (0.5 * record.density[0] + record.density[1]), 0.05 * 2.45, 1e-12);
}

}  // namespace
}  // namespace ocean::netcdf
