// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// parse_sea reads back every bit that write_sea writes: no baked sea is another sea.

#include <clocale>
#include <locale>

#include "helpers.hpp"
#include "ocean/internal/hull_rules.hpp"

namespace ocean::test {
namespace {

Sea written_and_read(const Sea& sea) {
    return parse_sea(write_sea(sea), "written", "/nowhere");
}

Sea buoy_sea() {
    return parse(
        "[[waves]]\nspectrum = \"measured\"\nfile = \"ndbc_41010.data_spec\"\n"
        "record = \"2020-06-07T09:40\"\n");
}

/// A value that differs from the default and is inside the range, with bits in every place.
ParameterValue other_value(const ParameterInfo& info, const ParameterValue& usual) {
    if (!info.choices().empty()) {
        const std::string last(info.choices().back());
        return usual == ParameterValue(last) ? std::string(info.choices().front()) : last;
    }
    if (const bool* const truth = std::get_if<bool>(&usual)) return !*truth;
    if (info.type() == "numbers") {
        return std::vector<double>{1.0 / 3.0, std::max(info.min, -2.0e6) / 7.0};
    }
    if (info.type() == "wave_height") return std::string("-0.7 Hs");
    if (info.type() == "text") return std::string("a \"b\"\\ \xC3\xA9 #'.x");
    if (info.rule == NumberRule::power_of_two) return std::int64_t{128};
    if (info.rule == NumberRule::even) return std::int64_t{14};
    if (info.type() == "int") return static_cast<std::int64_t>(info.max) - 1;
    return info.min + (std::min(info.max, 1e5) - info.min) / 3.0;
}

/// Keys that validate refuses beside others, or without a file.
bool refused_beside_others(const ParameterInfo& info) {
    return info.key == "cascades" || info.key == "cascade_divisors" || info.key == "take" ||
           info.key == "seabed" || info.key == "second_order";
}

TEST(SeaFileRoundTrip, EveryKeyNonDefaultKeepsEveryBit) {
    Sea sea;
    sea.parameters.waves.assign(3, WaveSystem{});
    sea.parameters.crests.resize(1);
    sea.parameters.hulls.assign(3, Hull{});
    Parameters defaults;
    defaults.crests.resize(1);
    defaults.hulls.resize(1);
    for (const ParameterInfo& info : parameter_table()) {
        if (refused_beside_others(info)) continue;
        for (std::size_t item = 0; item < info.member.items(sea.parameters); ++item) {
            const ParameterRef ref{&info, item};
            assign(sea.parameters, ref, other_value(info, value_of(sea.parameters, ref)));
        }
    }
    sea.parameters.surface.longest_wavelength = 2.0 * sea.parameters.surface.shortest_wavelength;
    for (WaveSystem& system : sea.parameters.waves) system.spectrum = SpectrumKind::tma;
    const double loop = sea.parameters.time.loop_period;
    for (Hull& hull : sea.parameters.hulls) {
        hull.track = std::make_shared<const HullTrack>(HullTrack{
            {{1.0 / 3.0, 0.1, 0.2}, {0.5 * loop, 1e4 / 7.0, 2.0}, {loop + 1.0 / 3.0, 0.1, 0.2}},
            {{1.0 / 7.0, 0.3}, {90.0, 0.7}, {-30.0, 0.1}}});
    }
    for (const ParameterInfo& info : parameter_table()) {
        if (refused_beside_others(info)) continue;
        const bool usual =
            same_value(value_of(sea.parameters, {&info, 0}), value_of(defaults, {&info, 0}));
        EXPECT_FALSE(usual) << info.path();
    }
    EXPECT_EQ(difference(written_and_read(sea), sea), "") << write_sea(sea);
    EXPECT_EQ(write_sea(written_and_read(sea)), write_sea(sea));
}

TEST(SeaFileRoundTrip, AnUnsetWindStaysUnset) {
    const Sea swell = parse(
        "[[waves]]\nspectrum = \"jonswap\"\nsignificant_wave_height = 1.0\npeak_period = 14.0\n");
    for (const Sea& sea : {swell, buoy_sea()}) {
        EXPECT_FALSE(test::says(write_sea(sea), "wind_speed"));
        EXPECT_EQ(difference(written_and_read(sea), sea), "");
        EXPECT_EQ(written_and_read(sea).parameters.waves.front().wind_above(), std::nullopt);
        Sea blown = sea;
        set_parameter(blown.parameters, "wind_speed", "12");
        EXPECT_EQ(difference(written_and_read(blown), blown), "");
    }
}

TEST(SeaFileRoundTrip, AwkwardNumbersKeepTheirBits) {
    const double awkward[] = {-0.0,        0.1,         1.0 / 3.0, 5e-324, 2.2250738585072014e-308,
                              1e6 - 1e-10, 123456789.0, 1e-5,      -1e9};
    for (double value : awkward) {
        Sea sea;
        sea.parameters.time.start = value;
        EXPECT_EQ(difference(written_and_read(sea), sea), "") << value << "\n" << write_sea(sea);
    }
}

TEST(SeaFileRoundTrip, EveryPresetIsReadAndRoundTrips) {
    for (const Preset& preset : presets()) {
        const Sea sea = parse_sea(preset.toml, preset.name, "");
        EXPECT_EQ(difference(written_and_read(sea), sea), "") << preset.name;
    }
}

TEST(SeaFileRoundTrip, MeasuredSeaNeedsItsFileNoMore) {
    const Sea sea = buoy_sea();
    ASSERT_NE(sea.parameters.waves[0].measured, nullptr);
    EXPECT_EQ(sea.parameters.waves[0].measured->time, "2020-06-07T09:50");
    EXPECT_EQ(difference(written_and_read(sea), sea), "");
    const Sea again = written_and_read(written_and_read(sea));
    EXPECT_EQ(difference(again, sea), "");
    EXPECT_TRUE(std::isnan(again.parameters.waves[0].measured->a1.front())) << "missing bin kept";
}

TEST(SeaFileRoundTrip, RecordWithPlaceAndDepthKeepsThem) {
    SpectrumRecord record = *buoy_sea().parameters.waves[0].measured;
    record.latitude = 28.878;
    record.longitude = -78.467;
    record.depth = 890.0;
    record.station = "41010 \"Canaveral East\"";
    Sea sea = buoy_sea();
    sea.parameters.waves[0].measured = std::make_shared<const SpectrumRecord>(record);
    EXPECT_EQ(difference(written_and_read(sea), sea), "") << write_sea(sea);
}

TEST(SeaFileRoundTrip, EachSystemKeepsItsOwnRecord) {
    Sea sea = buoy_sea();
    sea.parameters.waves.insert(sea.parameters.waves.begin(), WaveSystem{});
    SpectrumRecord plain = *sea.parameters.waves[1].measured;
    plain.a1 = plain.b1 = plain.a2 = plain.b2 = {};
    sea.parameters.waves.push_back(sea.parameters.waves[1]);
    sea.parameters.waves[2].measured = std::make_shared<const SpectrumRecord>(plain);
    EXPECT_EQ(difference(written_and_read(sea), sea), "");
}

TEST(SeaFileRoundTrip, EveryKeyThatIsSetAndNotNeutralIsWritten) {
    const Sea sea = buoy_sea();
    const std::string text = "\n" + write_sea(sea);
    for (const ParameterInfo& info : parameter_table()) {
        if (info.member.items(sea.parameters) == 0) continue;
        const bool left_out = info.member_type.optional || info.neutral.has_value();
        const bool written = text.find("\n" + std::string(info.key) + " = ") != std::string::npos;
        EXPECT_EQ(written, !left_out) << info.key;
    }
}

TEST(SeaFileRoundTrip, TextThatIsNotUtf8IsRefusedByTheWriter) {
    Sea sea;
    sea.parameters.waves[0].file = "caf\xE9";
    EXPECT_TRUE(says(message_of([&] { write_sea(sea); }), "not UTF-8"));
}

TEST(SeaFileRoundTrip, AGermanLocaleChangesNothing) {
    class CommaPoint : public std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::string before = write_sea(buoy_sea());
    const std::string c_locale = std::setlocale(LC_ALL, nullptr);
    const std::locale usual = std::locale::global(std::locale(std::locale(), new CommaPoint));
    std::setlocale(LC_ALL, "de_DE.UTF-8");  // where it is installed
    const std::string during = write_sea(parse_sea(before, "written", "/nowhere"));
    std::locale::global(usual);
    std::setlocale(LC_ALL, c_locale.c_str());
    EXPECT_EQ(during, before);
}

TEST(MeasuredRecord, InlinedWinsOverAFileThatIsGone) {
    std::string text = write_sea(buoy_sea());
    text.replace(text.find("ndbc_41010"), 10, "ndbc_gone_");
    EXPECT_EQ(parse_sea(text, "t", "/nowhere").parameters.waves[0].measured->station, "41010");
}

TEST(MeasuredRecord, FullSpectrumComesBackInEveryBit) {
    Sea sea = buoy_sea();
    SpectrumRecord record = *sea.parameters.waves[0].measured;
    record.a1 = record.b1 = record.a2 = record.b2 = {};
    record.latitude = record.longitude = record.depth = 1.0 / 3.0;  // NaN equals nothing
    record.direction = {0.1, 120.0 / 7.0, 200.3};
    for (std::size_t i = 0; i < 3 * record.frequency.size(); ++i) {
        record.directional_density.push_back(std::exp(-0.1 * static_cast<double>(i)) / 3.0);
    }
    sea.parameters.waves[0].measured = std::make_shared<const SpectrumRecord>(record);
    const Sea again = parse_sea(write_sea(sea), "written", "/nowhere");
    EXPECT_EQ(*again.parameters.waves[0].measured, record);
}

TEST(MeasuredRecord, OfTheLargestSizeFitsIntoASeaFile) {
    Sea sea = buoy_sea();
    SpectrumRecord record;
    record.latitude = record.longitude = record.depth = 1.0 / 3.0;
    const std::size_t frequencies = kMaxDirectionalValues / 512;
    for (std::size_t j = 0; j < 512; ++j) {
        record.direction.push_back(static_cast<double>(j) * (360.0 / 512.3));
    }
    for (std::size_t i = 0; i < frequencies; ++i) {
        record.frequency.push_back(0.01 + static_cast<double>(i) / 300.0);
        record.density.push_back(1.0 / static_cast<double>(i + 3));
        for (std::size_t j = 0; j < 512; ++j) {
            record.directional_density.push_back(1e-5 / static_cast<double>(i + j + 3));
        }
    }
    ASSERT_EQ(record_fault(record), "");
    sea.parameters.waves[0].measured = std::make_shared<const SpectrumRecord>(record);
    sea.parameters.waves[0].record = "";
    const std::string text = write_sea(sea);
    EXPECT_EQ(*parse_sea(text, "t", "").parameters.waves[0].measured, record) << text.size();
}

TEST(MeasuredRecord, ThatIsNotTheOneAskedForIsRefused) {
    std::string text = write_sea(buoy_sea());
    text.replace(text.find("2020-06-07T09:40"), 16, "2020-06-05T18:50");
    const Refusal refusal = refusal_of([&] { parse_sea(text, "t", ""); });
    EXPECT_TRUE(refusal.says("2020-06-05T18:50", "2020-06-07T09:50", "waves.0."));
}

TEST(MeasuredRecord, WithAFaultIsRefusedWithItsLine) {
    const std::string head = "[[waves]]\nspectrum = \"measured\"\n[waves.measured_record]\n";
    const std::string f = "frequency = [0.1, 0.2]\n";
    const std::string s = "density = [1.0, 2.0]\n";
    const std::string d = "direction = [0, 120, 240]\n";
    const std::string e = "directional_density = [1, 2, 3, 4, 5, 6]\n";
    EXPECT_FALSE(refusal_of_sea(head + f + s).refused);
    EXPECT_FALSE(refusal_of_sea(head + f + s + d + e).refused);
    const std::pair<std::string, std::string> faults[] = {
        {s, "at least 2 frequencies"},
        {"frequency = [0.1]\ndensity = [1.0]\n", "at least 2 frequencies"},
        {f + "density = [1.0]\n", "differ in length"},
        {"frequency = [0.2, 0.1]\n" + s, "does not ascend"},
        {"frequency = [0.1, 0.1]\n" + s, "does not ascend"},
        {"frequency = [0.0, 0.1]\n" + s, "not within 1e-5 .. 100 Hz"},
        {"frequency = [0.1, nan]\n" + s, "test.toml:5: waves.0.measured_record.frequency = nan"},
        {f + "density = [-1.0, 2.0]\n", "not within 0 .. 1e6"},
        {f + "density = [1.0, inf]\n", "test.toml:6: waves.0.measured_record.density = inf"},
        {f + "density = [1.0, \"2\"]\n", "test.toml:6: waves.0.measured_record.density = \"2\""},
        {f + "density = 3\n", "test.toml:6: waves.0.measured_record.density = 3"},
        {f + s + "a1 = [0.1, 0.2]\n", "differ in length"},
        {f + s + "a1=[0,2]\nb1=[0,0]\na2=[0,0]\nb2=[0,0]\n", "beyond 1"},
        {f + s + "a1=[0]\nb1=[0]\na2=[0]\nb2=[0]\n", "differ in length"},
        {f + s + "a1=[0,inf]\nb1=[0,0]\na2=[0,0]\nb2=[0,0]\n", "test.toml:7: "},
        {f + s + d, "has not a value for each"},
        {f + s + "directional_density=[1,2,3,4,5,6]\n", "at least 3 directions"},
        {f + s + "direction=[0,120]\ndirectional_density=[1,2,3,4]\n", "at least 3 directions"},
        {f + s + "direction=[0,240,120]\n" + e, "do not ascend"},
        {f + s + "direction=[0,120,360]\n" + e, "do not ascend"},
        {f + s + "direction=[-1,120,240]\n" + e, "do not ascend"},
        {f + s + d + "directional_density=[1,2,3,4,5,-6]\n", "directional density of bin 2"},
        {f + s + d + e + "a1=[0,0]\nb1=[0,0]\na2=[0,0]\nb2=[0,0]\n", "moments and a density"},
        {f + s + d + "directional_density=[1,2,3,4,5,nan]\n", "test.toml:8: "},
        {f + s + "latitude = 91\n", "latitude"},
        {f + s + "longitude = nan\n", "test.toml:7: waves.0.measured_record.longitude = nan"},
        {f + s + "depth = -3\n", "depth"},
        {f + s + "time = \"noon\"\n", "2020-06-08T03:50"},
        {f + s + "densty = 3\n",
         "test.toml:7: waves.0.measured_record.densty: no such key; did you "
         "mean density?"},
    };
    for (const auto& [body, words] : faults) {
        const Refusal refusal = refusal_of_sea(head + body);
        ASSERT_TRUE(refusal.refused) << body;
        EXPECT_TRUE(refusal.says(words, "test.toml:"));
    }
}

TEST(SeaFileRoundTrip, CrestsKeepEveryBitInTextAndInValues) {
    const Sea sea = parse(
        "[[waves]]\n[[crests]]\ntime = 12.5\nx = 0.1\nheight = \"1.3 Hs\"\n[[crests]]\n"
        "height = -2\ndirection = 30\n");
    ASSERT_EQ(sea.parameters.crests.size(), 2u);
    EXPECT_EQ(sea.parameters.crests[0], (Crest{12.5, 0.1, 0.0, {1.3, true}, {}}));
    EXPECT_EQ(sea.parameters.crests[1], (Crest{0.0, 0.0, 0.0, {-2.0, false}, 30.0}));
    EXPECT_EQ(difference(written_and_read(sea), sea), "");
    EXPECT_NE(write_sea(sea).find("\n[[crests]]\ntime = 12.5\nx = 0.1\ny = 0.0\n"
                                  "height = \"1.3 Hs\"\n"),
              std::string::npos)
        << write_sea(sea);
    std::vector<NamedValue> values;
    const std::vector<NamedText> kept = sea_values(sea);
    for (const NamedText& text : kept) values.push_back({text.name, text.value});
    const Sea again = parse_sea(text_of_values(values), "values", "/nowhere");
    EXPECT_EQ(write_sea(again), write_sea(sea));
    EXPECT_EQ(write_sea(Sea{}).find("crest"), std::string::npos) << "no crest, no word";
}

/// A host keeps the values alone: records of several systems, with a take behind them.
TEST(SeaFileRoundTrip, ValuesMakeTheSameSea) {
    Sea sea = buoy_sea();
    add_wave_system(sea, "waves.0");
    sea.parameters.waves.push_back(sea.parameters.waves[1]);
    sea.parameters.time.take = "storm.take";
    sea.take =
        parse_take("1 wind_speed 12.5\n2.5 waves.0.fetch 50000\n", "storm.take", sea.parameters);
    std::vector<NamedValue> values;
    const std::vector<NamedText> kept = sea_values(sea);
    for (const NamedText& text : kept) values.push_back({text.name, text.value});
    const Sea again = parse_sea(text_of_values(values), "values", "/nowhere");
    EXPECT_EQ(difference(again, sea), "");
    EXPECT_EQ(write_sea(again), write_sea(sea));
}

TEST(SeaFileRoundTrip, ValuesKeepTheirSpellingAndLeaveOutTheEmpty) {
    const std::vector<NamedValue> values = {
        {"fps", "2.50e1"}, {"depth", ""}, {"waves.0.fetch", "1e5"}, {"resolution", "64"}};
    EXPECT_EQ(text_of_values(values),
              "libocean = 1\n\n[grid]\nresolution = 64\n\n[time]\nfps = 2.50e1\n\n[[waves]]\n"
              "fetch = 1e5\n");
    for (const ParameterInfo& info : parameter_table()) {
        if (!info.neutral) continue;
        const std::string name = info.path();
        const std::vector<NamedValue> neutral = {{name, *info.neutral}};
        EXPECT_FALSE(test::says(text_of_values(neutral), info.key)) << name;
        if (info.type() != "float") continue;
        // Hosts spell numbers in their own way.
        const std::string spelled = *info.neutral == "0" ? "0.0" : std::string(*info.neutral);
        const std::vector<NamedValue> other = {{name, spelled}};
        EXPECT_FALSE(test::says(text_of_values(other), info.key)) << name;
    }
}

}  // namespace
}  // namespace ocean::test
