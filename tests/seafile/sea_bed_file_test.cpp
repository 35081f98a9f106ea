// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bed of a sea in files: read from elevation models and terrain files, inlined, known by its
// hash, refused in one sentence.

#include "helpers.hpp"
#include "ocean/sea_bed.hpp"
#include "temporary_folder.hpp"

namespace ocean::test {
namespace {

struct Grid {
    int columns = 12;
    int rows = 7;
    double cell = 4.0;
    std::string first = "-3.5";  // height of the north-west sample
    std::string header = "";     // in place of cellsize
};

/// Returns the height of sample (i, j), j from the south: a beach.
float height_at(int i, int j) {
    return 0.25f * static_cast<float>(i) - 1.5f + 0.125f * static_cast<float>(j % 3);
}

void write_asc(const std::string& path, const Grid& grid) {
    std::ofstream file(path);
    file << "ncols " << grid.columns << "\nnrows " << grid.rows << "\nxllcorner 500000\n"
         << "yllcorner 4000000\n"
         << (grid.header.empty() ? "cellsize " + to_text(grid.cell) + "\n" : grid.header)
         << "NODATA_value -9999\n";
    for (int j = grid.rows - 1; j >= 0; --j) {
        for (int i = 0; i < grid.columns; ++i) {
            const bool first = j == grid.rows - 1 && i == 0;
            file << (first ? grid.first : to_text(double{height_at(i, j)})) << ' ';
        }
        file << '\n';
    }
}

Sea sea_of(const std::string& water, const TemporaryFolder& folder) {
    return parse_sea("libocean = 1\n[water]\n" + water, "sea.toml", folder.path());
}

const SeaBed& bed_of(const Sea& sea) {
    return *sea.parameters.water.bed;
}

void expect_same_bed(const Sea& a, const Sea& b) {
    EXPECT_EQ(bed_of(a).heights, bed_of(b).heights);
    EXPECT_EQ(bed_of(a).domain, bed_of(b).domain);
    EXPECT_EQ(bed_of(a).sha256, bed_of(b).sha256);
    EXPECT_EQ(difference(a, b), "");
}

TEST(SeaBedFile, AnOpenSeaKeepsItsText) {
    const std::string text = write_sea(Sea{});
    for (const char* word : {"seabed", "bed_", "level", "shore", "swash"}) {
        EXPECT_FALSE(test::says(text, word));
    }
}

TEST(SeaBedFile, AnElevationModelIsTheBedFromItsOrigin) {
    const TemporaryFolder folder;
    write_asc(folder.file("bed.asc"), {.first = to_text(double{height_at(0, 6)})});
    const Sea text = sea_of("seabed = \"bed.asc\"\nseabed_origin = [-20.0, 30.0]\n", folder);
    const SeaBed& bed = bed_of(text);
    EXPECT_EQ(bed.domain.samples, (std::array{12, 7}));
    EXPECT_EQ(bed.domain.origin, (std::array{-20.0, 30.0}));
    EXPECT_EQ(bed.cell(), 4.0);
    EXPECT_EQ(bed.heights[12 + 3], height_at(3, 1)) << "row 1 from the south";
    EXPECT_EQ(named_files(text), std::vector<std::string>{"bed.asc"});
}

TEST(SeaBedFile, ASmallBedIsInlinedWithEveryBit) {
    const TemporaryFolder folder;
    write_asc(folder.file("bed.asc"), {.cell = 10.0 / 3.0});
    const Sea sea = sea_of(
        "seabed = \"bed.asc\"\nseabed_unit = \"ft\"\nseabed_sign = \"down\"\nlevel = 0.3\n"
        "[water.shore]\nswash = \"off\"\nsurf_foam_lifetime = 5.0\n",
        folder);
    EXPECT_FLOAT_EQ(bed_of(sea).heights[3], static_cast<float>(0.75 * 0.3048 - 0.3));
    const std::string text = write_sea(sea);
    const Sea again = parse_sea(text, "baked.exr", "/nowhere");
    expect_same_bed(again, sea);
    EXPECT_EQ(write_sea(again), text);
    EXPECT_EQ(again.parameters.water.shore.swash, Swash::off);
    Sea moved = again;
    set_parameter(moved.parameters, "level", "0");
    EXPECT_FLOAT_EQ(bed_of(moved).heights[3], static_cast<float>(0.75 * 0.3048))
        << "the tide needs no file";
    std::string lied = text;
    lied.replace(lied.find("heights = [") + 18, 8, "AAAAAAAA");
    EXPECT_TRUE(says(message_of([&] { parse_sea(lied, "", ""); }), "bed with the hash"));
}

TEST(SeaBedFile, ALargeBedIsKnownByItsHash) {
    const TemporaryFolder folder;
    write_asc(folder.file("bed.asc"), {.columns = 513, .rows = 512});
    const Sea sea = sea_of("seabed = \"bed.asc\"\n", folder);
    const std::string text = write_sea(sea);
    EXPECT_LT(text.size(), 2000u);
    EXPECT_TRUE(test::says(text, bed_of(sea).sha256));
    expect_same_bed(parse_sea(text, "", folder.path()), sea);
    const auto missing = refusal_of([&] { parse_sea(text, "baked.exr", "/nowhere"); });
    EXPECT_TRUE(missing.says("bed.asc"));
    EXPECT_TRUE(missing.says(bed_of(sea).sha256));
    write_asc(folder.file("bed.asc"), {.columns = 513, .rows = 512, .first = "-4"});
    const Sea other = sea_of("seabed = \"bed.asc\"\n", folder);
    const auto different = refusal_of([&] { parse_sea(text, "baked.exr", folder.path()); });
    EXPECT_TRUE(different.says(bed_of(sea).sha256));
    EXPECT_TRUE(different.says(bed_of(other).sha256));
}

constexpr const char* kTile =
    "libocean = 1\n[terrain]\nresolution = 32\npatch_size = 320.0\nrms = 4.0\nmean = -5.0\n";

TEST(SeaBedFile, ATerrainIsABedOnItsOwnGridAndItsTextIsInlined) {
    const TemporaryFolder folder;
    folder.write("coast.toml", kTile);
    const Sea tile = sea_of("seabed = \"coast.toml\"\nseabed_origin = [7.0, 8.0]\n", folder);
    EXPECT_EQ(bed_of(tile).domain.samples, (std::array{32, 32}));
    EXPECT_EQ(bed_of(tile).cell(), 10.0);
    EXPECT_EQ(bed_of(tile).domain.size[0], 310.0) << "a tile is placed once";
    EXPECT_NEAR(summarize(bed_of(tile), tile.parameters.water).mean, -5.0, 1e-3);
    folder.write(
        "placed.toml",
        kTile + std::string("kind = \"placed\"\norigin = [1000.0, 0.0]\nsize = [200.0, 100.0]\n"));
    const Sea placed = sea_of("seabed = \"placed.toml\"\n", folder);
    EXPECT_EQ(bed_of(placed).domain.origin, (std::array{0.0, 0.0})) << "seabed_origin places it";
    EXPECT_GT(bed_of(placed).domain.samples[0], bed_of(placed).domain.samples[1]);
    for (const Sea* sea : {&tile, &placed}) {
        const std::string text = write_sea(*sea);
        EXPECT_TRUE(test::says(text, "[water.bed_terrain]"));
        expect_same_bed(parse_sea(text, "baked.exr", "/nowhere"), *sea);
        EXPECT_EQ(write_sea(parse_sea(text, "baked.exr", "/nowhere")), text);
    }
}

TEST(SeaBedFile, ValuesCarryTheBed) {
    const TemporaryFolder folder;
    write_asc(folder.file("bed.asc"), {});
    folder.write("coast.toml", kTile);
    for (const char* file : {"bed.asc", "coast.toml"}) {
        const Sea sea = sea_of("seabed = \"" + std::string(file) + "\"\nlevel = 1.0\n", folder);
        const std::vector<NamedText> values = sea_values(sea);
        std::vector<NamedValue> named;
        for (const NamedText& value : values) named.push_back({value.name, value.value});
        expect_same_bed(parse_sea(text_of_values(named), "values", "/nowhere"), sea);
    }
}

TEST(SeaBedFile, ResolveFilesReadsABedThatWasNamedLater) {
    const TemporaryFolder folder;
    write_asc(folder.file("bed.asc"), {});
    Sea sea;
    set_parameter(sea.parameters, "seabed", "bed.asc");
    resolve_files(sea, folder.path());
    EXPECT_EQ(bed_of(sea).domain.samples[0], 12);
    set_parameter(sea.parameters, "seabed", "");
    resolve_files(sea, folder.path());
    EXPECT_EQ(sea.parameters.water.bed, nullptr);
}

TEST(SeaBedFile, BadBedsGetASentenceWithTheirLine) {
    const TemporaryFolder folder;
    write_asc(folder.file("bed.asc"), {});
    write_asc(folder.file("hole.asc"), {.first = "-9999"});
    write_asc(folder.file("nan.asc"), {.first = "nan"});
    write_asc(folder.file("oblong.asc"), {.header = "dx 4\ndy 5\n"});
    write_asc(folder.file("huge.asc"), {.cell = 20000.0});
    folder.write("sea.toml", "libocean = 1\n[water]\ndepth = 5.0\n");
    folder.write("endless.toml", "libocean = 1\n[terrain]\nkind = \"endless\"\n");
    folder.write("storm.take", "1 wind_speed 12\n");
    const std::pair<std::string, std::string> bad[] = {
        {"seabed = \"none.asc\"\n", "sea.toml:3: water.seabed = \"none.asc\": "},
        {"seabed = \"hole.asc\"\n", "1 of 84 heights"},
        {"seabed = \"nan.asc\"\n", "the first at x = 0 m, y = 24 m (column 0, row 6"},
        {"seabed = \"oblong.asc\"\n", "4 m long to the east and 5 m to the north"},
        {"seabed = \"huge.asc\"\n", "220000 m x 120000 m"},
        {"seabed = \"sea.toml\"\n", "is a sea file, not a terrain file"},
        {"seabed = \"endless.toml\"\n", "one of tile, placed"},
        {"seabed = \"bed.asc\"\nseabed_origin = [inf, 0.0]\n", "sea.toml:4: water.seabed_origin"},
        {"seabed = \"bed.asc\"\nseabed_origin = [1.0]\n", "sea.toml:4: water.seabed_origin"},
        {"seabed = \"bed.asc\"\nseabed_unit = \"yd\"\n", "one of m, ft, us_ft"},
        {"seabed = \"bed.asc\"\nseabed_sign = \"dwon\"\n", "did you mean down?"},
        {"seabed = \"bed.asc\"\nlevel = 1e6\n", "sea.toml:4: water.level"},
        {"seabed = \"bed.asc\"\n[time]\ntake = \"storm.take\"\n", "plays no take"},
        {"[water.shore]\nswash = \"up\"\n", "one of on, off"},
        {"[water.bed_heights]\nsha256 = \"12\"\n", "sea.toml:3: water.bed_heights"},
        {"[water.bed_heights]\nsha256 = \"" + std::string(64, '0') + "\"\n", "but no file"},
        {"[water.bed_terrain]\nlines = [1]\n", "sea.toml:3: water.bed_terrain"},
    };
    for (const auto& one : bad) {
        const std::string &water = one.first, &words = one.second;
        const Refusal refusal = refusal_of([&] { sea_of(water, folder); });
        EXPECT_TRUE(refusal.says("sea.toml")) << water << refusal.message;
        EXPECT_TRUE(refusal.says(words)) << water << refusal.message;
        EXPECT_EQ(std::ranges::count(refusal.message, '\n'), 0) << refusal.message;
    }
}

}  // namespace
}  // namespace ocean::test
