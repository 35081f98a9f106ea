// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectra from NetCDF: what variables and units mean, on contents made by hand; real files of the
// classic and the HDF5 kind through the child process; and a child that crashes, hangs or lies.
#include "ocean/internal/netcdf_spectra.hpp"

#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <new>

#include "../temporary_folder.hpp"
#include "cf_units.hpp"
#include "contents.hpp"
#include "netcdf_layout.hpp"
#include "netcdf_wire.hpp"
#include "ocean/internal/child_process.hpp"
#include "ocean/seafile.hpp"
#include "paths.hpp"
#include "refusal.hpp"
#ifdef OCEAN_TEST_NETCDF
#include <netcdf.h>
#endif

namespace ocean::netcdf {
namespace {

using sandbox::ChildFailure;
using sandbox::ChildLimits;
using sandbox::run_in_child;
using test::TemporaryFolder;

TEST(NetcdfRecords, ARecordForEachTimeAndPlaceTimesOutermost) {
    const std::vector<SpectrumRecord> records = records_from(wavespectra());
    ASSERT_EQ(records.size(), 4u);
    EXPECT_TRUE(records[0].warnings.empty()) << "wavespectra's directions are known";
    EXPECT_EQ(records[0].time, "2020-02-28T22:00");
    EXPECT_EQ(records[1].time, "2020-02-28T22:00");
    EXPECT_EQ(records[3].time, "2020-02-29T01:00");
    EXPECT_EQ(records[1].latitude, 50.0);
    EXPECT_EQ(records[2].longitude, 174.0);
    for (const auto [f, r] : test::pairs<std::size_t>(2, 4)) {
        const double base = static_cast<double>(r / 2 * 1000 + r % 2 * 100 + f * 10);
        EXPECT_EQ(value_from(records[r], f, 90.0), base + 1.0) << r;
        EXPECT_EQ(value_from(records[r], f, 270.0), base + 3.0) << r;
        EXPECT_DOUBLE_EQ(records[r].density[f], 90.0 * (4.0 * base + 6.0)) << r;
    }
}

TEST(NetcdfRecords, DimensionsComeInAnyOrderAndFrequenciesToo) {
    const Content straight = wavespectra();
    Content turned = straight;
    Variable& efth = find(turned, "efth");
    efth.dimensions = {3, 1, 2, 0};  // dir, site, freq, time
    find(turned, "freq").values = {0.2, 0.1};
    const Variable& original = straight.variables[0];
    for (std::size_t i = 0; i < 32; ++i) {
        const std::size_t d = i / 8, s = i / 4 % 2, f = i / 2 % 2, t = i % 2;
        efth.values[i] = original.values[t * 16 + s * 8 + (1 - f) * 4 + d];
    }
    EXPECT_EQ(records_from(turned), records_from(straight));
}

Content ecmwf() {
    Content content;
    content.dimensions = {
        {"time", 1}, {"frequency", 30}, {"direction", 24}, {"latitude", 2}, {"longitude", 1}};
    std::vector<double> values(30 * 24 * 2, kMissing);
    values[(3 * 24 + 6) * 2 + 1] = 0.5;  // fourth frequency, seventh direction, second latitude
    std::vector<double> frequency(30), direction(24);
    for (std::size_t i = 0; i < 30; ++i) frequency[i] = static_cast<double>(i + 1);
    for (std::size_t j = 0; j < 24; ++j) direction[j] = static_cast<double>(j + 1);
    content.variables = {
        numbers("d2fd", {0, 1, 2, 3, 4}, {{"units", "m**2 s radian**-1"}}, values),
        numbers("time", {0}, {{"units", "hours since 1900-01-01 00:00:00.0"}}, {1051896.0}),
        numbers("frequency", {1}, {}, frequency),
        numbers("direction", {2}, {}, direction),
        numbers("latitude", {3}, {}, {50.0, 49.5}),
        numbers("longitude", {4}, {}, {350.0}),
    };
    return content;
}

TEST(NetcdfRecords, EcmwfIsALogarithmOverNumberedBins) {
    const std::vector<SpectrumRecord> records = records_from(ecmwf());
    ASSERT_EQ(records.size(), 1u) << "a place without any value is land";
    const SpectrumRecord& record = records[0];
    EXPECT_EQ(record.time, "2020-01-01T00:00");
    EXPECT_EQ(record.latitude, 49.5);
    EXPECT_EQ(record.longitude, 350.0);
    ASSERT_EQ(record.frequency.size(), 30u);
    EXPECT_NEAR(record.frequency[0], 0.03453, 1e-12);
    EXPECT_NEAR(record.frequency[3], 0.03453 * 1.331, 1e-12);
    // The seventh direction is 97.5 degrees, where waves travel to: from 277.5.
    EXPECT_NEAR(value_from(record, 3, 277.5), std::pow(10.0, 0.5) * kDegree, 1e-12);
    EXPECT_NEAR(record.density[3], std::pow(10.0, 0.5) * 15.0 * kDegree, 1e-12);
    EXPECT_EQ(record.density[4], 0.0) << "missing is no energy";
}

TEST(NetcdfRecords, EcmwfCoordinatesWithValuesAreTakenAsTheyAre) {
    Content content = ecmwf();
    for (double& f : find(content, "frequency").values) f *= 0.01;
    for (double& d : find(content, "direction").values) d = 15.0 * (d - 1.0);
    const SpectrumRecord record = records_from(content)[0];
    EXPECT_EQ(record.frequency[3], 0.04);
    EXPECT_NEAR(value_from(record, 3, 270.0), std::pow(10.0, 0.5) * kDegree, 1e-12);
}

TEST(NetcdfRecords, WavewatchPackedAsLogarithmIsUnpacked) {
    Content content = wavespectra();
    Variable& efth = find(content, "efth");
    efth.attributes["units"] = "log10(m2 s rad-1 +1E-12)";
    for (std::size_t i = 0; i < 32; ++i) efth.values[i] = i % 2 == 0 ? -12.0 : 0.0;
    const SpectrumRecord record = records_from(content)[0];
    EXPECT_EQ(value_from(record, 0, 0.0), 0.0);
    EXPECT_NEAR(value_from(record, 0, 90.0), kDegree, 1e-9);
}

TEST(NetcdfRecords, WithoutDirectionsTheSpectrumHasOneDimension) {
    Content content = wavespectra();
    content.variables.pop_back();
    content.dimensions[3].name = "unused";
    content.variables[0] = numbers("ef", {0, 1, 2}, {{"units", "m2 s"}},
                                   {1.0, 2.0, kMissing, kMissing, 5.0, 6.0, 7.0, kMissing});
    const std::vector<SpectrumRecord> records = records_from(content);
    ASSERT_EQ(records.size(), 2u) << "one has no values, one has a single value";
    EXPECT_FALSE(records[0].is_directional());
    EXPECT_EQ(records[1].density, (std::vector<double>{5.0, 6.0}));
}

/// NDBC's: one time and place, three frequencies; waves from the west, the south and the east.
Content ndbc() {
    Content content;
    content.dimensions = {{"time", 1}, {"frequency", 3}, {"latitude", 1}, {"longitude", 1}};
    const auto over_all = [](const std::string& name, const std::string& units,
                             std::vector<double> values) {
        return numbers(name, {0, 1, 2, 3}, {{"units", units}}, std::move(values));
    };
    content.variables = {
        over_all("spectral_wave_density", "(meter * meter)/Hz", {1.0, 2.0, 3.0}),
        over_all("mean_wave_dir", "degrees_true", {270.0, 180.0, 90.0}),
        over_all("principal_wave_dir", "degrees_true", {270.0, 180.0, 45.0}),
        over_all("wave_spectrum_r1", "", {0.9, 0.8, 1.02}),
        over_all("wave_spectrum_r2", "", {0.6, 0.5, 0.4}),
        numbers("time", {0}, {{"units", "seconds since 1970-01-01T00:00:00+00:00"}}, {1.6e9}),
        numbers("frequency", {1}, {{"units", "Hz"}}, {0.1, 0.2, 0.3}),
        numbers("latitude", {2}, {}, {27.59}),
        numbers("longitude", {3}, {}, {-82.931}),
    };
    return content;
}

TEST(NetcdfRecords, DirectionsOfABuoyAreItsMoments) {
    const std::vector<SpectrumRecord> records = records_from(ndbc());
    ASSERT_EQ(records.size(), 1u);
    const SpectrumRecord& record = records[0];
    EXPECT_EQ(record.time, "2020-09-13T12:27");
    EXPECT_EQ(record.latitude, 27.59);
    EXPECT_EQ(record.density, (std::vector<double>{1.0, 2.0, 3.0}));
    // To the east, the north and the west; twice the angle from the north-east is to the north.
    const auto expect = [&](std::size_t i, double a1, double b1, double a2, double b2) {
        EXPECT_NEAR(record.a1[i], a1, 1e-12) << i;
        EXPECT_NEAR(record.b1[i], b1, 1e-12) << i;
        EXPECT_NEAR(record.a2[i], a2, 1e-12) << i;
        EXPECT_NEAR(record.b2[i], b2, 1e-12) << i;
    };
    expect(0, 0.9, 0.0, 0.6, 0.0);
    expect(1, 0.0, 0.8, -0.5, 0.0);
    expect(2, -1.0, 0.0, 0.0, 0.4);
    // Frequencies in any order keep their directions.
    Content turned = ndbc();
    find(turned, "frequency").values = {0.3, 0.2, 0.1};
    const SpectrumRecord other = records_from(turned).front();
    EXPECT_EQ(other.density, (std::vector<double>{3.0, 2.0, 1.0}));
    EXPECT_NEAR(other.a1[0], -1.0, 1e-12);
    EXPECT_NEAR(other.a1[2], 0.9, 1e-12);
}

TEST(NetcdfRecords, DirectionsOfABuoyMayBeMissingInABinOrAltogether) {
    for (const char* name :
         {"mean_wave_dir", "principal_wave_dir", "wave_spectrum_r1", "wave_spectrum_r2"}) {
        Content content = ndbc();
        find(content, name).values[1] = kMissing;
        const SpectrumRecord bin = records_from(content).front();
        EXPECT_TRUE(std::isnan(bin.a1[1]) && std::isnan(bin.b2[1])) << name;
        EXPECT_NEAR(bin.a1[0], 0.9, 1e-12) << name;
        find(content, name).values.assign(3, kMissing);
        EXPECT_FALSE(records_from(content).front().has_moments()) << name;
        find(content, name).dimensions = {0, 2, 3};
        find(content, name).values.assign(1, 200.0);
        const bool mean = name == std::string("mean_wave_dir");
        EXPECT_EQ(records_from(content).front().has_moments(), !mean) << "not over frequency";
    }
    Content content = ndbc();
    find(content, "spectral_wave_density").values[0] = kMissing;
    const SpectrumRecord record = records_from(content).front();
    EXPECT_EQ(record.frequency, (std::vector<double>{0.2, 0.3}));
    EXPECT_NEAR(record.b1[0], 0.8, 1e-12) << "the directions of its own bin";
}

TEST(NetcdfRecords, PlacesMayMoveAndStationsHaveNames) {
    Content content = wavespectra();
    find(content, "lat") = numbers("latitude", {0, 1}, {}, {1.0, 2.0, 3.0, 4.0});
    find(content, "lon") = numbers("longitude", {0, 1}, {}, {5.0, 6.0, 7.0, kMissing});
    content.variables.push_back(numbers("site", {1}, {}, {7.0, 9.0}));
    find(content, "dpt").values[1] = -2.0;
    EXPECT_EQ(records_from(content)[1].station, "9");
    content.variables.push_back({"station_name", {1}, {}, true, {}, {"ab\xE9", "cd"}});
    const std::vector<SpectrumRecord> records = records_from(content);
    EXPECT_EQ(records[0].station, "ab?") << "latin-1 is no UTF-8";
    EXPECT_EQ(records[1].station, "cd");
    EXPECT_EQ(records[2].latitude, 3.0);
    EXPECT_EQ(records[2].depth, 55.0);
    EXPECT_TRUE(std::isnan(records[1].depth)) << "dry";
    EXPECT_TRUE(std::isnan(records[3].longitude));
}

using Break = std::function<void(Content&)>;

Break value(const char* name, std::size_t index, double number) {
    return [=](Content& c) { find(c, name).values[index] = number; };
}
Break values(const char* name, const std::vector<double>& numbers) {
    return [=](Content& c) { find(c, name).values = numbers; };
}
Break attribute(const char* name, const char* key, const char* text) {
    return [=](Content& c) { find(c, name).attributes[key] = text; };
}

TEST(NetcdfRecords, BrokenContentsAreRefusedAndNamed) {
    const std::pair<Break, std::string> broken[] = {
        {value("efth", 5, -50.0), "efth: record 2020-02-28T22:00"},
        {value("efth", 5, 1e300), "a density of 1"},
        {value("efth", 5, HUGE_VAL), "a density of inf"},
        {attribute("efth", "units", "m2"), "efth: units 'm2'"},
        {attribute("efth", "units", "m2 s"),
         "efth: units 'm2 s': m^2 s is not a unit of a density over frequency and direction"},
        {[](Content& c) {
             find(c, "efth").attributes["units"] = "m";
             find(c, "efth").name = "hs";
         },
         "holds no wave spectrum"},
        {[](Content& c) { find(c, "efth").dimensions[1] = 0; }, "a dimension twice"},
        {values("efth", std::vector<double>(32, kMissing)), "all values are missing"},
        {values("freq", {0.0, 0.2}), "at least 2 frequencies"},
        {values("freq", {0.2, 0.2}), "freq: a frequency is there"},
        {values("freq", {0.2, kMissing}), "freq: a frequency of"},
        {attribute("freq", "units", "m"), "freq: units 'm'"},
        {[](Content& c) { find(c, "freq").name = "fr"; }, "no variable with its frequencies"},
        {value("dir", 1, 0.0), "dir: a direction appears twice"},
        {value("dir", 1, 1e9), "dir: a direction is not"},
        {attribute("dir", "units", "m"), "dir: units 'm'"},
        {value("lat", 1, 95.0), "lat: 95.0"},
        {value("lon", 1, -181.0), "lon: -181.0"},
        {value("time", 1, 1e300), "is no time in 1800 .. 2999"},
        {value("time", 1, kMissing), "time: nan is no time"},
        {attribute("time", "units", "hours"), "time: units 'hours'"},
        {attribute("time", "calendar", "noleap"), "'noleap'"},
        {[](Content& c) {
             c.dimensions[1].name = "part";
             for (const char* name : {"lat", "lon"}) find(c, name).dimensions = {0};
         },
         "the dimension part of 2 is neither time nor place"},
    };
    ASSERT_EQ(fault_of(wavespectra()), "");
    for (const auto& [breaks, words] : broken) {
        Content content = wavespectra();
        breaks(content);
        EXPECT_TRUE(test::says(fault_of(content), words));
    }
}

TEST(NetcdfRecords, CountsAreBounded) {
    Content content = wavespectra();
    const std::size_t frequencies = 4096;
    content.dimensions = {{"time", 1}, {"site", 1}, {"freq", frequencies}, {"dir", 36}};
    for (Variable& v : content.variables) v.values.assign(points(content, v), 0.0);
    for (std::size_t i = 0; i < frequencies; ++i) {
        find(content, "freq").values[i] = 0.01 * static_cast<double>(i + 1);
    }
    for (std::size_t j = 0; j < 36; ++j) {
        find(content, "dir").values[j] = 10.0 * static_cast<double>(j);
    }
    EXPECT_TRUE(test::says(fault_of(content), "131072"));
    content.dimensions[2].size = 4097;
    for (Variable& v : content.variables) v.values.resize(points(content, v), 1.0);
    EXPECT_TRUE(test::says(fault_of(content), "more than 4096"));
}

TEST(CfUnits, DensitiesMayBeLogarithms) {
    const DensityUnits plain = parse_density_units("m2/Hz", DensityOver::frequency);
    EXPECT_EQ(plain.fault, "");
    EXPECT_FALSE(plain.log10);
    EXPECT_EQ(plain.factor, 1.0);
    const DensityUnits packed =
        parse_density_units("log10(m2 s rad-1 +1E-12)", DensityOver::frequency_and_direction);
    EXPECT_EQ(packed.fault, "");
    EXPECT_TRUE(packed.log10);
    EXPECT_DOUBLE_EQ(packed.factor, kDegree);
    for (const char* other : {"", "m2", "log10(m2 s rad-1)", "log10(m2 s rad-1 +1E-6)", "log10(",
                              "log10(+1e-12)", "log10(m2 +1E-12)"}) {
        EXPECT_NE(parse_density_units(other, DensityOver::frequency_and_direction).fault, "")
            << other;
    }
}

TEST(CfUnits, TimesAreReadInManySpellings) {
    const auto text = [](const char* units, double value) {
        const auto parsed = parse_time_units(units);
        if (!parsed) return std::string("no units");
        const auto time = time_at(*parsed, value);
        return time ? time->text() : "no time";
    };
    EXPECT_EQ(text("days since 1990-01-01", 11016.125), "2020-02-29T03:00");
    EXPECT_EQ(text("days since 1990-01-01T00:00:00Z", 1.0 / 3.0), "1990-01-01T08:00");
    EXPECT_EQ(text("hours since 1900-01-01 00:00:00.0", 1051896.0), "2020-01-01T00:00");
    EXPECT_EQ(text("seconds since 1970-01-01", 951782400.0), "2000-02-29T00:00");
    EXPECT_EQ(text("minutes since 2020-1-1 0:30", -31.0), "2019-12-31T23:59");
    EXPECT_EQ(text("nanoseconds since 1970-01-01 00:00:00 UTC", 6e13), "1970-01-01T16:40");
    EXPECT_EQ(text("days since 1990-01-01", 1e6), "no time") << "beyond 2999";
    EXPECT_EQ(text("days since 1990-01-01", kMissing), "no time");
    for (const char* units : {"", "days", "days since", "years since 1990-01-01",
                              "days since 1990-02-30", "days since 0001-01-01",
                              "days since 1990-01-01 25:00", "days since 1990-01-01 00:00 +02:00",
                              "days since 1990-01-01 00:00:99", "days since 1990/01/01"}) {
        EXPECT_EQ(text(units, 0.0), "no units") << units;
    }
}

/// The bytes of encode, and a source that ends after them.
std::string wire(const Content& content) {
    std::string bytes;
    encode(content, [&](const void* from, std::size_t count) {
        bytes.append(static_cast<const char*>(from), count);
    });
    return bytes;
}
Content decode_bytes(std::string_view bytes) {
    return decode([&](void* to, std::size_t count) {
        if (count > bytes.size()) return false;
        std::memcpy(to, bytes.data(), count);
        bytes.remove_prefix(count);
        return true;
    });
}

TEST(NetcdfWire, GivesBackWhatWasSentAndRefusesEveryCutAndEveryLie) {
    Content content = wavespectra();
    content.variables.push_back({"station_name", {1}, {}, true, {}, {"a", ""}});
    const std::string bytes = wire(content);
    EXPECT_EQ(wire(decode_bytes(bytes)), bytes);
    EXPECT_EQ(records_from(decode_bytes(bytes)), records_from(content));
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        EXPECT_THROW(decode_bytes(std::string_view(bytes).substr(0, size)), WireError) << size;
    }
    using Lie = std::function<void(Content&)>;
    for (const Lie& lie : {Lie([](Content& c) { c.variables[0].values.pop_back(); }),
                           Lie([](Content& c) { c.variables[0].dimensions[0] = 4; }),
                           Lie([](Content& c) { c.dimensions[0].size = SIZE_MAX / 2; }),
                           Lie([](Content& c) { c.variables.back().texts.pop_back(); }),
                           Lie([](Content& c) { c.dimensions.resize(1025); })}) {
        Content lying = content;
        lie(lying);
        EXPECT_THROW(decode_bytes(wire(lying)), WireError);
    }
    EXPECT_THROW(decode_bytes("this is no content at all"), WireError);
}

/// How run_in_child failed.
std::string failure_of(const std::function<void(const Sink&)>& produce, ChildLimits limits = {}) {
    try {
        run_in_child(limits, produce, [](const Source& source) { decode(source); });
    } catch (const ChildFailure& failure) {
        return failure.what();
    }
    return "";
}

TEST(NetcdfChild, ACrashALimitAndNonsenseAreFailuresOfTheChildAlone) {
    EXPECT_EQ(failure_of([](const Sink& sink) { encode(wavespectra(), sink); }), "");
    EXPECT_EQ(failure_of([](const Sink&) { std::raise(SIGSEGV); }), "it crashed (signal 11)");
    EXPECT_EQ(failure_of([](const Sink&) { std::abort(); }), "it crashed (signal 6)");
    EXPECT_EQ(failure_of([](const Sink&) {}), "it stopped early");
    EXPECT_EQ(failure_of([](const Sink&) { throw 1; }), "it stopped early");
    EXPECT_EQ(failure_of([](const Sink& sink) {
                  const std::string junk(1000000, 'x');
                  for (;;) sink(junk.data(), junk.size());
              }),
              "it gave nonsense");
    EXPECT_EQ(failure_of([](const Sink& sink) {
                  encode(wavespectra(), sink);
                  const std::string more(100000, 'x');
                  sink(more.data(), more.size());
                  std::raise(SIGSEGV);
              }),
              "it crashed (signal 13)")
        << "more than a content: nobody reads it";
    const std::string slow = failure_of(
        [](const Sink&) {
            while (::getppid() > 0) {
            }
        },
        {std::uint64_t{1} << 30, 1});
    EXPECT_TRUE(test::says(slow, "more than 1 seconds"));
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "no child is left";
}

TEST(NetcdfChild, HasALimitOfMemoryNoFilesToWriteAndNoStreams) {
    const TemporaryFolder folder;
    const std::string target = folder.file("written");
    EXPECT_EQ(failure_of(
                  [&](const Sink& sink) {
                      std::vector<std::string> held;
                      try {
                          for (int i = 0; i < 300; ++i) held.emplace_back(1 << 20, 'x');
                      } catch (const std::bad_alloc&) {
                          encode(wavespectra(), sink);
                      }
                  },
                  {std::uint64_t{200} << 20, 20}),
              "")
        << "the memory ended, as it should";
    EXPECT_EQ(failure_of([&](const Sink& sink) {
                  std::ofstream(target) << "x";
                  encode(wavespectra(), sink);
              }),
              "it crashed (signal " + std::to_string(SIGXFSZ) + ")");
    testing::internal::CaptureStdout();
    EXPECT_EQ(failure_of([](const Sink& sink) {
                  if (::write(1, "x", 1) != 1) throw 1;
                  encode(wavespectra(), sink);
              }),
              "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(NetcdfChild, SignalsBlockedInTheProgramReachIt) {
    sigset_t interrupt, before;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    ::pthread_sigmask(SIG_BLOCK, &interrupt, &before);
    const auto interrupted = [] {
        failure_of([](const Sink&) {
            ::raise(SIGINT);
            std::abort();
        });
    };
    const test::Refusal refusal = test::refusal_of(interrupted);
    EXPECT_TRUE(refusal.refused && refusal.kind == ErrorKind::interrupted);
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

TEST(NetcdfSpectra, IsRecognisedByItsFirstBytes) {
    using namespace std::string_view_literals;
    for (const auto good : {"CDF\1\0\0\0\0"sv, "CDF\2"sv, "CDF\5"sv, "\x89HDF\r\n\x1a\n"sv}) {
        EXPECT_TRUE(is_netcdf(good));
    }
    for (const auto other : {""sv, "CDF"sv, "CDF\3"sv, "cdf\1"sv, "\x89HDF\r\n"sv, "#YY MM"sv}) {
        EXPECT_FALSE(is_netcdf(other));
    }
}

std::string error_of(const std::string& path, ErrorKind kind = ErrorKind::bad_file) {
    const test::Refusal refusal = test::refusal_of([&] { read_netcdf_spectra(path); });
    EXPECT_TRUE(!refusal.refused || refusal.kind == kind) << refusal.message;
    return refusal.message;
}

TEST(NetcdfSpectra, WhatIsNoNetcdfFileIsSaid) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("text")) << "hello, this is text";
    EXPECT_EQ(error_of(folder.file("none")), folder.file("none") + ": no such file");
    EXPECT_TRUE(test::says(error_of("/tmp"), "is not a file"));
    EXPECT_TRUE(test::says(error_of(folder.file("text")), "is not a NetCDF file"));
    EXPECT_TRUE(test::says(error_of("http://localhost/a.nc"), "no such file"));
}

#ifdef OCEAN_TEST_NETCDF

void check(int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

/// A content as a file. Spectra are packed as ECMWF does: shorts, a scale, an offset, a fill value.
void write_file(const std::string& path, const Content& content, int kind) {
    int file = 0;
    check(nc_create(path.c_str(), kind, &file));
    for (const auto& [key, value] : content.attributes) {
        check(nc_put_att_text(file, NC_GLOBAL, key.c_str(), value.size(), value.data()));
    }
    std::vector<int> dimensions;
    for (const Dimension& d : content.dimensions) {
        check(nc_def_dim(file, d.name.c_str(), d.size, &dimensions.emplace_back()));
    }
    for (const Variable& v : content.variables) {
        int id = 0;
        std::vector<int> ids;
        for (const std::size_t d : v.dimensions) ids.push_back(dimensions[d]);
        const bool packed = v.name == "d2fd";
        const nc_type type = v.is_text ? NC_CHAR : packed ? NC_SHORT : NC_DOUBLE;
        check(
            nc_def_var(file, v.name.c_str(), type, static_cast<int>(ids.size()), ids.data(), &id));
        for (const auto& [key, value] : v.attributes) {
            check(nc_put_att_text(file, id, key.c_str(), value.size(), value.data()));
        }
        const short fill = -32767;
        const double scale = 0.001, offset = -2.0;
        if (packed) {
            check(nc_put_att_short(file, id, "_FillValue", NC_SHORT, 1, &fill));
            check(nc_put_att_double(file, id, "scale_factor", NC_DOUBLE, 1, &scale));
            check(nc_put_att_double(file, id, "add_offset", NC_DOUBLE, 1, &offset));
        }
        check(nc_enddef(file));
        std::vector<double> values = v.values;
        if (packed) {
            for (double& x : values) x = std::isnan(x) ? fill : std::round((x - offset) / scale);
        }
        if (v.is_text) {
            check(nc_put_var_text(file, id, v.texts[0].data()));
        } else if (!values.empty()) {
            check(nc_put_var_double(file, id, values.data()));
        }
        check(nc_redef(file));
    }
    check(nc_close(file));
}

/// Returns the records of a content by way of a file.
std::vector<SpectrumRecord> written(const Content& content, int kind = 0) {
    const TemporaryFolder folder;
    write_file(folder.file("sea"), content, kind);
    return read_netcdf_spectra(folder.file("sea"));
}

TEST(NetcdfSpectra, FilesOfEveryKindGiveTheRecordsOfTheirContent) {
    for (const int kind : {0, NC_64BIT_OFFSET, NC_64BIT_DATA, NC_NETCDF4}) {
        const std::vector<SpectrumRecord> records = written(wavespectra(), kind);
        const std::vector<SpectrumRecord> wanted = records_from(wavespectra());
        ASSERT_EQ(records.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            EXPECT_EQ(records[i].time, wanted[i].time);
            EXPECT_EQ(records[i].latitude, wanted[i].latitude);
            EXPECT_EQ(records[i].directional_density, wanted[i].directional_density);
        }
    }
}

TEST(NetcdfSpectra, AFileOfTheBuoyCenterHasItsStationAndDirections) {
    const std::string path = test::data_dir() + "/spectra/42098w9999.nc";
    const std::vector<SpectrumRecord> records = read_netcdf_spectra(path);
    ASSERT_EQ(records.size(), 100u);
    for (std::size_t i = 0; i < records.size(); ++i) {
        EXPECT_EQ(records[i].station, "42098") << "an attribute of the whole file";
        EXPECT_EQ(records[i].has_moments(), i > 10) << "the first eleven have no directions: " << i;
    }
    const SpectrumRecord& record = records[50];
    EXPECT_EQ(record.time, "2015-06-11T13:00");
    EXPECT_NEAR(record.latitude, 27.59, 1e-5);
    EXPECT_NEAR(record.longitude, -82.931, 1e-5);
    ASSERT_EQ(record.frequency.size(), 64u);
    // At 0.21 Hz: 0.505 m^2/Hz, alpha1 200, alpha2 196, r1 0.91, r2 0.72.
    EXPECT_NEAR(record.frequency[26], 0.21, 1e-6);
    EXPECT_NEAR(record.density[26], 0.505, 1e-12);
    EXPECT_NEAR(record.a1[26], 0.91 * std::cos((270.0 - 200.0) * kDegree), 1e-12);
    EXPECT_NEAR(record.b1[26], 0.91 * std::sin((270.0 - 200.0) * kDegree), 1e-12);
    EXPECT_NEAR(record.a2[26], 0.72 * std::cos(2.0 * (270.0 - 196.0) * kDegree), 1e-12);
    EXPECT_NEAR(record.b2[26], 0.72 * std::sin(2.0 * (270.0 - 196.0) * kDegree), 1e-12);
}

TEST(NetcdfSpectra, ANameOfTheWholeFileYieldsToNamesOfStations) {
    const TemporaryFolder folder;
    Content content = wavespectra();
    content.dimensions.push_back({"string4", 4});
    content.variables.push_back({"station_name", {1, 4}, {}, true, {}, {"ab  xy  "}});
    const auto name_all = [](const std::string& path) {
        int file = 0;
        check(nc_open(path.c_str(), NC_WRITE, &file));
        check(nc_redef(file));
        check(nc_put_att_text(file, NC_GLOBAL, "station", 5, "42098"));
        check(nc_close(file));
        return read_netcdf_spectra(path);
    };
    write_file(folder.file("names"), content, 0);
    EXPECT_EQ(name_all(folder.file("names"))[1].station, "xy");
    write_file(folder.file("none"), wavespectra(), 0);
    EXPECT_EQ(name_all(folder.file("none"))[1].station, "42098");
}

TEST(NetcdfSpectra, PackedValuesAreUnpackedAndFillValuesMissing) {
    const std::vector<SpectrumRecord> records = written(ecmwf());
    ASSERT_EQ(records.size(), 1u);
    EXPECT_NEAR(value_from(records[0], 3, 277.5), std::pow(10.0, 0.5) * kDegree, 1e-12);
}

TEST(NetcdfSpectra, AttributesOfTheFileAndNumbersOfFlagsReachTheReader) {
    const TemporaryFolder folder;
    Content content = wavespectra();
    find(content, "dir").name = "direction";
    content.attributes["wave_direction_convention"] = "going to";
    content.attributes["history"] = std::string(5000, 'x');
    content.variables.push_back(
        numbers("efth_QC", {0}, {{"flag_meanings", "fine bad"}}, {7.0, 6.0}));
    const std::string path = folder.file("flags");
    write_file(path, content, NC_NETCDF4);
    int file = 0, variable = 0;
    check(nc_open(path.c_str(), NC_WRITE, &file));
    check(nc_inq_varid(file, "efth_QC", &variable));
    const int values[] = {6, 7};
    check(nc_put_att_int(file, variable, "flag_values", NC_INT, 2, values));
    check(nc_close(file));
    const std::vector<SpectrumRecord> records = read_netcdf_spectra(path);
    ASSERT_EQ(records.size(), 4u);
    EXPECT_EQ(records[0].fault, path + ": efth_QC: record 2020-02-28T22:00: its flag is 7, bad");
    EXPECT_EQ(records[2].fault, "");
    EXPECT_EQ(value_from(records[2], 0, 270.0), 1001.0) << "travelling to 90";
    EXPECT_TRUE(records[2].warnings.empty());
    const double bad[] = {7.0, 7.0};
    check(nc_open(path.c_str(), NC_WRITE, &file));
    check(nc_put_var_double(file, variable, bad));
    check(nc_close(file));
    EXPECT_EQ(error_of(path), records[0].fault) << "of a file without a good record";
}

TEST(NetcdfSpectra, ASpectrumMayLieInAGroupAndItsCoordinatesInTheFile) {
    const TemporaryFolder folder;
    const std::string path = folder.file("groups");
    int file = 0, payload = 0, sensor = 0, dimensions[2], id = 0;
    check(nc_create(path.c_str(), NC_NETCDF4, &file));
    check(nc_def_dim(file, "time_wpm_20", 2, &dimensions[0]));
    check(nc_def_dim(file, "wave_wpm", 3, &dimensions[1]));
    check(nc_def_grp(file, "payload_1", &payload));
    check(nc_def_grp(payload, "wave_sensor_1", &sensor));
    const auto put = [&](int group, const char* name, int rank, const int* over, const char* units,
                         std::vector<double> values) {
        check(nc_def_var(group, name, NC_DOUBLE, rank, over, &id));
        check(nc_put_att_text(group, id, "units", std::strlen(units), units));
        check(nc_put_var_double(group, id, values.data()));
    };
    put(file, "time_wpm_20", 1, &dimensions[0], "seconds since 1970-01-01", {0.0, 3600.0});
    put(file, "wave_wpm", 1, &dimensions[1], "Hz", {0.1, 0.2, 0.3});
    put(sensor, "c11", 2, dimensions, "m2/Hz", {1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
    put(sensor, "alpha1", 2, dimensions, "degrees_true", std::vector<double>(6, 270.0));
    put(sensor, "r1", 2, dimensions, "percent", std::vector<double>(6, 80.0));
    check(nc_close(file));
    const std::vector<SpectrumRecord> records = read_netcdf_spectra(path);
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[1].time, "1970-01-01T01:00");
    EXPECT_EQ(records[1].density, (std::vector<double>{4.0, 5.0, 6.0}));
    EXPECT_NEAR(records[1].a1[2], 0.8, 1e-12) << "from the west, to the east";
}

TEST(NetcdfSpectra, CharactersComeBeforeOrAfterTheirStations) {
    for (const bool first : {false, true}) {
        Content content = wavespectra();
        content.dimensions.push_back({"string4", 4});
        Variable names{"station_name", {1, 4}, {}, true, {}, {"ab  xy  "}};
        if (first) {
            names.dimensions = {4, 1};
            names.texts[0] = std::string("axby\0 \0 ", 8);
        }
        content.variables.push_back(names);
        const std::vector<SpectrumRecord> records = written(content);
        EXPECT_EQ(records[0].station, "ab") << first;
        EXPECT_EQ(records[1].station, "xy") << first;
    }
}

TEST(NetcdfSpectra, HugeClaimsAndCutFilesAreRefusedAtOnce) {
    const TemporaryFolder folder;
    Content content = wavespectra();
    content.dimensions[0].size = 10'000'000;
    for (Variable& v : content.variables) {
        if (v.name == "efth" || v.name == "time") v.values.clear();
    }
    const std::string huge = folder.file("huge");
    const auto largest = [] {  // KiB, so far, of this process and those that read for it
        rusage self{};
        rusage children{};
        ::getrusage(RUSAGE_SELF, &self);
        ::getrusage(RUSAGE_CHILDREN, &children);
        return std::max(self.ru_maxrss, children.ru_maxrss);
    };
    const long before = largest();
    // No values are written: the file is small, whatever it claims.
    write_file(huge, content, NC_NETCDF4 | NC_NOFILL);
    EXPECT_TRUE(
        test::says(error_of(huge), "efth: has 10000000 x 2 x 2 x 4 values; at most 67108864"));
    EXPECT_LT(largest() - before, 512L * 1024);  // its values would be 1.2 GiB
    for (const int kind : {0, NC_64BIT_OFFSET, NC_64BIT_DATA, NC_NETCDF4}) {
        const std::string whole = folder.file("whole");
        write_file(whole, wavespectra(), kind);
        std::string bytes = test::read_bytes(whole);
        for (const std::size_t size :
             {std::size_t{8}, bytes.size() / 4, bytes.size() / 2, bytes.size() - 8}) {
            std::ofstream(folder.file("cut"), std::ios::binary) << bytes.substr(0, size);
            const std::string message = error_of(folder.file("cut"));
            EXPECT_NE(message, "") << kind << " cut at " << size;
            // libnetcdf reads the lost end of a classic file as zeros.
            if (kind == NC_NETCDF4 || size + 8 < bytes.size()) continue;
            EXPECT_TRUE(test::says(message, "the file is cut off"));
        }
    }
}

#else

TEST(NetcdfSpectra, AProgramWithoutTheLibrarySaysSo) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("sea"), std::ios::binary) << std::string("CDF\1\0\0\0\0", 8);
    const std::string message = error_of(folder.file("sea"), ErrorKind::unsupported);
    EXPECT_TRUE(test::says(message, "built without NetCDF"));
}

#endif

}  // namespace
}  // namespace ocean::netcdf
