// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: what a child sends of a raster comes back, and no cut and no lie passes; a program
// that is executed has a pipe alone; names of SRTM tiles are corners; a written model reads back to
// the same bits.

#include <csignal>
#include <tuple>

#include "ocean/error.hpp"
#include "ocean/internal/elevation_import.hpp"
#include "ocean/internal/io/elevation.hpp"
#include "raster.hpp"
#include "temporary_folder.hpp"
#include "testing.hpp"

namespace ocean::elevation {
namespace {

/// A raster that was received.
struct Received {
    RasterFacts facts;
    std::vector<float> heights;
};

RasterReceiver receiver_of(Received& received) {
    return {.begin = [&](const RasterFacts& facts) { received.facts = facts; },
            .row =
                [&](std::span<const float> row) {
                    received.heights.insert(received.heights.end(), row.begin(), row.end());
                }};
}

Received decoded(std::string_view bytes) {
    Received received;
    decode(
        [&](void* to, std::size_t count) {
            if (count > bytes.size()) return false;
            std::memcpy(to, bytes.data(), count);
            bytes.remove_prefix(count);
            return true;
        },
        receiver_of(received));
    return received;
}

std::string encoded(const std::function<void(const RasterReceiver&)>& read) {
    std::string bytes;
    encode(read, [&](const void* from, std::size_t count) {
        bytes.append(static_cast<const char*>(from), count);
    });
    return bytes;
}

RasterFacts some_facts() {
    RasterFacts facts;
    facts.columns = 3;
    facts.rows = 2;
    facts.has_place = true;
    facts.south_west_centre = {15.0, -25.0};
    facts.cell = {10.0, 12.0};
    facts.is_geographic = false;
    facts.metres_per_unit = 0.3048;
    facts.ground_scale = {0.5, 0.75};
    facts.height_unit = 1200.0 / 3937.0;
    facts.sample_scale = {0.1, -50.0};
    facts.rows_from_south = true;
    facts.crs = "EPSG:2229";
    facts.definition = "PROJCS[...]";
    facts.notes = {"one", "two"};
    return facts;
}

std::string some_raster() {
    return encoded([](const RasterReceiver& receiver) {
        receiver.begin(some_facts());
        receiver.row(std::vector<float>{1, 2, 3});
        receiver.row(std::vector<float>{4, 5, 6});
    });
}

TEST(RasterWire, GivesBackWhatWasSent) {
    const Received received = decoded(some_raster());
    const auto all = [](const RasterFacts& f) {
        return std::tie(f.columns, f.rows, f.has_place, f.south_west_centre, f.cell,
                        f.is_geographic, f.metres_per_unit, f.ground_scale, f.height_unit,
                        f.sample_scale, f.rows_from_south, f.crs, f.definition, f.notes);
    };
    const RasterFacts expected = some_facts();
    EXPECT_EQ(all(received.facts), all(expected));
    EXPECT_EQ(received.heights, (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST(RasterWire, NoCutAndNoLiePasses) {
    const std::string whole = some_raster();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_THROW(decoded(whole.substr(0, size)), sandbox::WireError) << size;
    }
    std::string huge = whole;
    huge[8 + 4] = '\x01';  // columns beyond the limit
    EXPECT_THROW(decoded(huge), sandbox::WireError);
    std::string endless = whole;
    endless[8 + 8 + 8 + 8 + 7] = '\x7F';  // an origin that is not finite
    endless[8 + 8 + 8 + 8 + 6] = '\xF0';
    EXPECT_THROW(decoded(endless), sandbox::WireError);
}

TEST(RasterWire, AFaultIsPrintableEvenInTheMiddle) {
    const std::string bytes = encoded([](const RasterReceiver& receiver) {
        receiver.begin(some_facts());
        receiver.row(std::vector<float>{1, 2, 3});
        throw RasterFault("is cut\noff");
    });
    try {
        decoded(bytes);
        FAIL();
    } catch (const RasterFault& fault) {
        EXPECT_STREQ(fault.what(), "is cut?off");
    }
}

TEST(RasterWire, AFactorThatIsNoLengthIsRefused) {
    RasterFacts facts = some_facts();
    for (const double factor : {-1.0, 0.0, 1e9}) {
        facts.ground_scale[1] = factor;
        const std::string bytes =
            encoded([&](const RasterReceiver& receiver) { receiver.begin(facts); });
        EXPECT_THROW(decoded(bytes), sandbox::WireError) << factor;
    }
}

/// Returns what a program writes to its standard output.
std::string output_of(const std::vector<std::string>& arguments) {
    std::string output;
    sandbox::run_program({}, arguments, [&](const sandbox::Source& source) {
        for (char c = 0; source(&c, 1);) output += c;
    });
    return output;
}

TEST(RunProgram, AProgramHasItsArgumentsAPipeAndNothingElse) {
    EXPECT_EQ(output_of({"/bin/echo", "two words", "more"}), "two words more\n");
    EXPECT_EQ(output_of({"/usr/bin/env"}), "");
    EXPECT_EQ(output_of({"/bin/pwd"}), "/\n");
    // Those of its streams, and the one by which it lists them.
    const test::TemporaryFolder folder;
    std::ofstream open_file(folder.file("open"));
    EXPECT_EQ(output_of({"/bin/ls", "/proc/self/fd"}), "0\n1\n2\n3\n");
}

TEST(RunProgram, ItsEndIsTold) {
    const auto failure = [](const std::vector<std::string>& arguments) -> std::string {
        try {
            output_of(arguments);
        } catch (const sandbox::ChildFailure& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(failure({"/nowhere/program"}), "it stopped early");
    EXPECT_EQ(failure({"/bin/false"}), "it stopped early");
    EXPECT_EQ(failure({"/bin/sh", "-c", "kill -SEGV $$"}), "it crashed (signal 11)");
    // It writes no file.
    const test::TemporaryFolder folder;
    EXPECT_EQ(failure({"/bin/cp", "/bin/sh", folder.file("written")}),
              "it crashed (signal " + std::to_string(SIGXFSZ) + ")");
}

TEST(SrtmTile, ANameIsACorner) {
    EXPECT_EQ(corner_of_name("N34W119.hgt"), (std::array{-119.0, 34.0}));
    EXPECT_EQ(corner_of_name("s01e006.SRTMGL1.hgt"), (std::array{6.0, -1.0}));
    for (const char* name : {"", "N34", "N3XW119", "N34W19", "N34W999", "X34W119", "N95W119"}) {
        EXPECT_FALSE(corner_of_name(name)) << name;
    }
}

TEST(SrtmTile, AVoidIsAHoleAndTheFirstRowLiesInTheNorth) {
    constexpr std::size_t kSide = 1201;
    std::string bytes(2 * kSide * kSide, '\0');
    bytes[0] = '\x80';  // -32768
    bytes[3] = '\x07';
    std::istringstream stream(bytes);
    Received received;
    read_hgt(stream, bytes.size(), {-119.0, 34.0}, receiver_of(received));
    EXPECT_TRUE(std::isnan(received.heights[0]));
    EXPECT_EQ(received.heights[1], 7.0f);
    EXPECT_EQ(received.heights.size(), kSide * kSide);
    EXPECT_DOUBLE_EQ(received.facts.cell[0], 1.0 / 1200.0);
    std::istringstream cut(bytes.substr(0, 5000));
    EXPECT_THROW(read_hgt(cut, bytes.size(), {0.0, 0.0}, receiver_of(received)), RasterFault);
}

TEST(FloatGrid, AWrittenModelReadsBack) {
    const test::TemporaryFolder folder;
    for (const char* crs : {"", "EPSG:32611", "EPSG:2193", "PROJCS[\"mine\",UNIT[\"metre\",1]]"}) {
        ElevationModel model;
        model.domain = {.origin = {478015.25, 0.1},
                        .size = {3 * 30.1, 2 * 30.1},
                        .samples = {4, 3},
                        .wraps = false};
        model.crs = crs;
        for (int i = 0; i < 12; ++i) model.heights.push_back(0.1f * static_cast<float>(i));
        model.heights[5] = std::nanf("");
        io::write_elevation(model, folder.file("bed.flt"));
        const ElevationModel read =
            read_elevation(folder.file("bed.flt"), {.holes = HolePolicy::keep});
        EXPECT_EQ(std::memcmp(read.heights.data(), model.heights.data(), 12 * sizeof(float)), 0);
        EXPECT_EQ(read.domain.origin, model.domain.origin);
        EXPECT_DOUBLE_EQ(read.domain.step(0), 30.1);
        EXPECT_TRUE(test::says(read.crs, crs));
        EXPECT_TRUE(read.notes.empty());
        EXPECT_TRUE(io::is_written_elevation(folder.file("bed.flt")));
    }
    EXPECT_THROW(io::write_elevation({}, folder.file("bed.tif")), Error);
}

TEST(FloatGrid, TheDefinitionThatAReaderKnewIsWritten) {
    ElevationModel model;
    model.crs = "EPSG:32611";
    EXPECT_EQ(io::elevation_projection(model), "LOCAL_CS[\"EPSG:32611\",UNIT[\"metre\",1]]");
    model.crs_definition = "PROJCS[\"WGS 84 / UTM zone 11N\"]";
    EXPECT_EQ(io::elevation_projection(model), model.crs_definition);
}

TEST(FloatGrid, SmallCellsOfMetresAreNotTakenForDegrees) {
    const test::TemporaryFolder folder;
    ElevationModel model;
    model.domain = {.origin = {10.0, 20.0}, .size = {1.0, 1.0}, .samples = {3, 3}, .wraps = false};
    model.heights.assign(9, 1.0f);
    io::write_elevation(model, folder.file("pond.flt"));
    EXPECT_FALSE(read_elevation(folder.file("pond.flt")).was_degrees);
    // Without the .prj file beside it the numbers look like degrees.
    std::filesystem::remove(folder.file("pond.prj"));
    EXPECT_TRUE(read_elevation(folder.file("pond.flt")).was_degrees);
}

}  // namespace
}  // namespace ocean::elevation
