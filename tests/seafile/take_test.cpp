// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes as text: accepted lines, refused lines and their messages, and the take inside a saved sea.

#include "helpers.hpp"
#include "temporary_folder.hpp"

namespace ocean::test {
namespace {

Take take_of(const std::string& text, std::size_t systems = 1) {
    Parameters parameters;
    parameters.waves.resize(systems);
    return parse_take(text, "storm.take", parameters);
}
Refusal refusal_of_take(const std::string& text) {
    return refusal_of([&] { take_of(text); });
}

TEST(TakeFile, HoldsLinesOfTimeNameAndValue) {
    const Take take = take_of(
        "\xEF\xBB\xBF# a storm\r\n"
        "0 wind_speed 14\r\n"
        "\r\n"
        "  1.5\twaves.1.spreading   mitsuyasu   # turns\r\n"
        "1.5 surface.choppiness +0.25\r\n"
        "2e1 foam_coverage threshold",
        2);
    ASSERT_EQ(take.events.size(), 4u);
    EXPECT_EQ(take.events[0].seconds, 0.0);
    EXPECT_EQ(take.events[0].parameter.info->key, "wind_speed");
    EXPECT_EQ(take.events[0].parameter.item, 0u);
    EXPECT_EQ(std::get<double>(take.events[0].value), 14.0);
    EXPECT_EQ(take.events[1].parameter.item, 1u);
    EXPECT_EQ(std::get<std::string>(take.events[1].value), "mitsuyasu");
    EXPECT_EQ(take.events[2].seconds, 1.5);
    EXPECT_EQ(std::get<double>(take.events[2].value), 0.25);
    EXPECT_EQ(take.events[3].seconds, 20.0);
}

TEST(TakeFile, MayBeEmptyAndBeginBeforeZero) {
    EXPECT_TRUE(take_of("").empty());
    EXPECT_TRUE(take_of("# nothing\n\n").empty());
    EXPECT_EQ(take_of("-3.5 swell 1\n").events.front().seconds, -3.5);
}

TEST(TakeFile, TooManyEventsOrBytesAreRefused) {
    std::string many;
    for (int i = 0; i < 32768; ++i) many += "1 swell 0\n";
    EXPECT_EQ(take_of(many).events.size(), 32768u);
    EXPECT_TRUE(refusal_of_take(many + "1 swell 0\n").says("storm.take:32769: "));
    EXPECT_TRUE(refusal_of_take(std::string((2 << 20) + 1, '\n')).says("2 MiB"));
}

TEST(TakeFile, IsWrittenWithFullNamesAndReadsBackToTheSameBits) {
    const Take take = take_of(
        "-0.1 fetch 300000\n0.30000000000000004 waves.1.swell -0.0\n1 spreading hasselmann\n", 2);
    EXPECT_EQ(write_take(take),
              "-0.1 waves.0.fetch 300000\n0.30000000000000004 waves.1.swell -0\n"
              "1 waves.0.spreading hasselmann\n");
    EXPECT_EQ(write_take(take_of(write_take(take), 2)), write_take(take));
    Sea a;
    Sea b;
    a.take = take;
    b.take = take_of(write_take(take), 2);
    EXPECT_EQ(difference(a, b), "");
}

TEST(SeaWithTake, FindsItBesideTheSeaFile) {
    const TemporaryFolder folder;
    folder.write("storm.take", "1 wind_speed 20\n");
    folder.write("sea.toml", "libocean = 1\n[time]\ntake = \"storm.take\"\n");
    const Sea sea = read_sea(folder.path() + "/sea.toml");
    ASSERT_EQ(sea.take.events.size(), 1u);
    EXPECT_EQ(sea.at(100.0).waves.front().wind_speed, 20.0);
    EXPECT_EQ(sea.parameters.waves.front().wind_speed, std::nullopt);
}

TEST(SeaWithTake, NamesTheLineOfAFileThatIsNotThereAndThatOfAFaultInIt) {
    const TemporaryFolder folder;
    folder.write("bad.take", "# a fault\n1 resolution 64\n");
    const auto refused = [&](const std::string& file) {
        const std::string toml = "libocean = 1\n[time]\ntake = \"" + file + "\"\n";
        return refusal_of([&] { parse_sea(toml, "sea.toml", folder.path()); });
    };
    expect_bad_file(refused("none.take"),
                    "sea.toml:3: time.take = \"none.take\": ", "no such file");
    EXPECT_TRUE(refused("bad.take").says("bad.take:2: grid.resolution = 64: is not live"));
}

TEST(SeaWithTake, IsWrittenSelfContainedAndReadsBackInEveryBit) {
    const TemporaryFolder folder;
    folder.write("storm.take", "0.1 wind_speed 20.000000000000004\n0.1 spreading mitsuyasu\n");
    for (const char* body : {"[time]\ntake = \"storm.take\"\n[[waves]]\n[[waves]]\nfetch = 1e5\n",
                             "[time]\ntake = \"storm.take\"\nglide = 0.0\n"}) {
        const Sea sea = parse_sea("libocean = 1\n" + std::string(body), "t", folder.path());
        const std::string written = write_sea(sea);
        EXPECT_TRUE(test::says(written, "take = \"storm.take\""));
        const Sea back = parse_sea(written, "t", "/nowhere");
        EXPECT_EQ(difference(sea, back), "");
        EXPECT_EQ(back.take.events.size(), 2u);
        EXPECT_EQ(write_sea(back), written);
    }
}

TEST(SeaWithTake, KeepsATakeWithoutEvents) {
    const TemporaryFolder folder;
    folder.write("still.take", "# nothing happens\n");
    const Sea sea = parse_sea("libocean = 1\n[time]\ntake = \"still.take\"\n", "t", folder.path());
    EXPECT_EQ(difference(sea, parse_sea(write_sea(sea), "t", "/nowhere")), "");
}

TEST(SeaWithTake, MayHoldItFromTheBeginning) {
    const Sea sea =
        parse("[take]\nlines = [\"# a storm\", \"2 waves.1.swell 1\"]\n[[waves]]\n[[waves]]\n");
    ASSERT_EQ(sea.take.events.size(), 1u);
    EXPECT_EQ(sea.take.events.front().parameter.item, 1u);
    EXPECT_EQ(difference(sea, parse(write_sea(sea).substr(write_sea(sea).find("[water]")))), "");
}

TEST(SeaWithTake, DoesNotLoop) {
    EXPECT_TRUE(refusal_of_sea("[time]\nloop_period = 10.0\n[take]\nlines = [\"1 swell 0\"]\n")
                    .says("test.toml:3: time.loop_period = 10 s: a loop repeats"));
}

TEST(SeaWithTake, ReadsAnotherTakeWhenItsNameIsSet) {
    const TemporaryFolder folder;
    folder.write("a.take", "1 swell 0.25\n");
    folder.write("b.take", "1 swell 0.75\n2 swell 0\n");
    Sea sea;
    set_parameter(sea.parameters, "time.take", "a.take");
    resolve_files(sea, folder.path());
    EXPECT_EQ(sea.take.events.size(), 1u);
    folder.write("a.take", "");
    resolve_files(sea, folder.path());
    EXPECT_EQ(sea.take.events.size(), 1u) << "one that is there stays";
    set_parameter(sea.parameters, "time.take", "b.take");
    resolve_files(sea, folder.path());
    EXPECT_EQ(sea.take.events.size(), 2u);
    set_parameter(sea.parameters, "time.take", "");
    resolve_files(sea, folder.path());
    EXPECT_TRUE(sea.take.empty());
}

}  // namespace
}  // namespace ocean::test
