// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Terrain files: strict reading with line numbers, round trips, presets, and the subject.
#include "ocean/terrainfile.hpp"

#include "helpers.hpp"
#include "ocean/domain.hpp"
#include "ocean/internal/measured_rings.hpp"
#include "ocean/internal/terrain_base.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrain_table.hpp"
#include "temporary_folder.hpp"

namespace ocean::test {
namespace {

/// Parses `body` under the lines "libocean = 1" and "[terrain]": it begins on line 3.
TerrainModel parse_body(const std::string& body) {
    return parse_terrain("libocean = 1\n[terrain]\n" + body, "test.toml", "");
}

constexpr const char* kRings =
    "[terrain.measured_rings]\nwavenumber = [0.01, 0.1, 1.0]\ndensity = [5.0, 0.5, 0.001]\n";

struct BadFile {
    std::string body;
    std::string says;  // with the line where it stands
};

class BadTerrain : public testing::TestWithParam<BadFile> {};
INSTANTIATE_TEST_SUITE_P(
    TerrainFile, BadTerrain,
    testing::Values(
        BadFile{"betta = 2.0\n", "test.toml:3: terrain.betta = 2.0: unknown parameter"},
        BadFile{"\nbeta = 7\n", "test.toml:4: terrain.beta = 7: is out of range"},
        BadFile{"beta = -1\n", "0 .. 6"}, BadFile{"beta = nan\n", "terrain.beta"},
        BadFile{"beta = \"2\"\n", "is not a number"},
        BadFile{"resolution = 500\n", "is not a power of two"},
        BadFile{"resolution = 16\n", "is out of range"},
        BadFile{"resolution = 512.5\n", "is not a whole number"},
        BadFile{"kind = \"endless\"\n", "one of tile"},
        BadFile{"kind = \"tiles\"\n", "did you mean tile?"},
        BadFile{"patch_size = 0\n", "is out of range"}, BadFile{"rms = -3\n", "is out of range"},
        BadFile{"range = [3, 1]\n", "test.toml:3: terrain.range = [3, 1]: is not a range"},
        BadFile{"range = [3]\n", "test.toml:3: terrain.range = [3]: is not a range"},
        BadFile{"range = [1, 2, 3]\n", "more than 2 numbers"},
        BadFile{"range = 5\n", "is not a list of numbers"},
        BadFile{"range = [\"a\", 2]\n", "is not a list of numbers"},
        BadFile{"rms = 3\nrange = [1, 2]\n", "test.toml:4: terrain.range = [1, 2]: contradicts"},
        BadFile{"mean = 3\nrange = [1, 2]\n", "contradicts terrain.mean"},
        BadFile{"breaks = [500, 2.5]\n", "is not a list of pairs"},
        BadFile{"breaks = [[500, 2.5, 1]]\n", "is not a list of pairs"},
        BadFile{"breaks = [[500, 9]]\n", "holds 9, out of range"},
        BadFile{"breaks = [[20, 2], [500, 1]]\n", "are not ordered"},
        BadFile{"longest_wavelength = 5\nshortest_wavelength = 9\n", "test.toml:3:"},
        BadFile{"measured = \"missing.csv\"\n", "test.toml:3: terrain.measured = \"missing.csv\":"},
        BadFile{"[[terrain.layer]]\nperiod = 300\n", "test.toml:4: terrain.layer.0.period = 300"},
        BadFile{"[[terrain.layer]]\nperiod = 500\n[[terrain.layer]]\nperiod = 2000\n",
                "test.toml:6: terrain.layer.1.period = 2000"},
        BadFile{"[terrain.layer]\nperiod = 500\n", "[[terrain.layer]], in double brackets"},
        BadFile{"[terrain.measured_rings]\nwavenumber = [1, 2]\n", "is not a measured spectrum"},
        BadFile{"[terrain.measured_rings]\nwavenumber = [2, 1]\ndensity = [1, 1]\n",
                "test.toml:3: terrain.measured_rings"},
        BadFile{std::string("breaks = [[50, 2]]\n") + kRings, "has no effect beside"},
        BadFile{std::string("outer_scale = 50\n") + kRings, "has no effect beside"},
        BadFile{"[waves]\n", "test.toml:3: is a sea file, not a terrain file"},
        BadFile{"[colour]\n", "no such section"}, BadFile{"seed = 1\nseed = 2\n", "test.toml:4"},
        BadFile{"[terrain.gullies]\ndepth = 1\n", "terrain.gullies"},
        // Without a place, or without effect.
        BadFile{"island = 5\n", "terrain.kind = \"placed\""},
        BadFile{"[terrain.stream]\n", "needs a land that exists once"},
        BadFile{"kind = \"placed\"\norigin = [1]\n", "two numbers"},
        BadFile{"kind = \"placed\"\nsize = [0, 5]\n", "out of range"},
        BadFile{"kind = \"placed\"\nbase_error = 1\n", "without terrain.base"},
        BadFile{"kind = \"placed\"\nbase = \"none.flt\"\n", "none.flt"},
        BadFile{"[terrain.gullies]\noctaves = 0\n", "out of range"},
        BadFile{"[terrain.gullies]\nlongest = 900\n", "too long for the tile"},
        BadFile{"kind = \"placed\"\nsize = [2000, 500]\n", "larger than the patch"},
        BadFile{"kind = \"placed\"\n[terrain.stream]\n[terrain.gullies]\n",
                "contradicts terrain.stream"},
        BadFile{"kind = \"placed\"\nrange = [0, 10]\n[terrain.stream]\n", "erosion does not scale"},
        BadFile{"[terrain.river]\n", "terrain.river"}));

TEST_P(BadTerrain, GetsASentenceWithItsLine) {
    const Refusal refusal = refusal_of([] { parse_body(GetParam().body); });
    EXPECT_TRUE(refusal.refused);
    EXPECT_TRUE(refusal.says("test.toml:"));
    EXPECT_TRUE(refusal.says(GetParam().says));
}

TEST(TerrainFile, ASeaSaysThatItIsNone) {
    const auto terrain = [](const std::string& text) {
        return message_of([&] { parse_terrain(text, "x.toml", ""); });
    };
    EXPECT_TRUE(
        says(terrain("libocean = 1\n[water]\n"), "x.toml:2: is a sea file, not a terrain file"));
    EXPECT_TRUE(says(message_of([] { parse_sea("libocean = 1\n[terrain]\n", "x.toml", ""); }),
                     "x.toml:2: is a terrain file, not a sea file"));
    EXPECT_TRUE(says(terrain("[terrain]\n"), "the line 'libocean = 1' is missing"));
    EXPECT_EQ(kind_of_file_text("libocean = 1\n[terrain]\n"), "terrain");
    EXPECT_EQ(kind_of_file_text("libocean = 1\n[[waves]]\n"), "sea");
    EXPECT_EQ(kind_of_file_text("libocean = "), "");
}

TEST(TerrainFile, AWrittenTerrainReadsBackToTheSameText) {
    const std::string body =
        "resolution = 64\npatch_size = 1200.0\nbeta = 1.7\nrms = 33.25\nmean = -4\n"
        "breaks = [[300, 2.5], [20.5, 1.9]]\nridge_wavelength = 100\nridge_direction = 30\n"
        "outer_scale = 900\nanisotropy = 1.5\ndirection = -20\n"
        "[[terrain.layer]]\nperiod = 400\ngain = 0.5\n[[terrain.layer]]\nperiod = 1200\nseed = 9\n";
    const TerrainModel terrain = parse_body(body);
    EXPECT_EQ(terrain.breaks[1][0], 20.5);
    EXPECT_EQ(terrain.layers.size(), 2u);
    const std::string written = write_terrain(terrain);
    EXPECT_EQ(write_terrain(parse_terrain(written, "written.toml", "")), written);
    EXPECT_TRUE(test::says(written, "breaks = [[300.0, 2.5], [20.5, 1.9]]"));
}

TEST(TerrainFile, MeasuredRingsAreInlined) {
    const TemporaryFolder folder;
    folder.write("rings.csv", "wavenumber,density,count\n0.01,5,4\n0.1,0.5,40\n1,0.001,400\n");
    const TerrainModel terrain = read_terrain(folder.write(
        "land.toml", "libocean = 1\n[terrain]\nresolution = 64\nmeasured = \"rings.csv\"\n"));
    EXPECT_EQ(named_files(terrain), std::vector<std::string>{"rings.csv"});
    const TerrainModel again = parse_terrain(write_terrain(terrain), "written.toml", "/nowhere");
    EXPECT_EQ(*again.rings, *terrain.rings);
    Terrain a(terrain), b(again);
    const Surface one = a.surface({Channel::height}), two = b.surface({Channel::height});
    EXPECT_TRUE(std::ranges::equal(one.channel(Channel::height), two.channel(Channel::height)));
    TerrainModel other = again;
    set_parameter(other, "measured", "else.csv");
    EXPECT_EQ(other.rings, nullptr);  // they belong to the other name
}

TEST(TerrainFile, AGeoTiffIsAnsweredWithTheCommandThatConvertsIt) {
    const TemporaryFolder folder;
    folder.write("land.tif", "II*");
    const char* const text = "libocean = 1\n[terrain]\nmeasured = \"land.tif\"\n";
    EXPECT_TRUE(says(message_of([&] { parse_terrain(text, "land.toml", folder.path()); }),
                     "ocean terrain import"));
}

/// Writes an ASCII grid of side x side heights.
void write_grid(const std::string& path, int side) {
    std::ofstream file(path);
    file << "ncols " << side << "\nnrows " << side << "\nxllcorner 500000\nyllcorner 4000000\n"
         << "cellsize 30\n";
    for (const auto [i, j] : pairs(side, side)) {
        file << 0.25 * ((i * i * 7 + j * j * 3 + i * j) % 397) << ' ';
    }
}

TEST(TerrainFile, AnElevationModelIsMeasuredWhenItIsNamed) {
    const TemporaryFolder folder;
    write_grid(folder.file("bed.asc"), 32);
    const TerrainModel terrain =
        parse_terrain("libocean = 1\n[terrain]\nresolution = 32\nmeasured = \"bed.asc\"\n",
                      "land.toml", folder.path());
    ASSERT_NE(terrain.rings, nullptr);
    EXPECT_GE(terrain.rings->wavenumber.size(), 4u);
    EXPECT_GT(Terrain(terrain).state().rms.resolved, 1.0);
}

TEST(TerrainPresets, AreWholeFilesWithTheirSource) {
    ASSERT_GE(terrain_presets().size(), 6u);
    for (const Preset& preset : terrain_presets()) {
        const TerrainModel terrain = parse_terrain(preset.toml, preset.name, "");
        EXPECT_TRUE(preset.toml.starts_with("# " + preset.name + ": " + preset.description));
        Terrain land(terrain);
        const TerrainState state = land.state();
        EXPECT_EQ(state.warnings, std::vector<std::string>{}) << preset.name;
        if (terrain.is_shaped()) {
            EXPECT_GT(state.rms.resolved, 0.5 * *terrain.rms) << preset.name;
        } else {
            EXPECT_NEAR(state.rms.resolved / *terrain.rms, 1.0, 1e-6) << preset.name;
        }
    }
    EXPECT_EQ(parse_terrain(find_terrain_preset("seed_smooth").toml, "", "").beta, 2.4);
    EXPECT_EQ(parse_terrain(find_terrain_preset("seed_rough").toml, "", "").beta, 2.0);
    EXPECT_TRUE(says(message_of([] { find_terrain_preset("tujungo"); }), "did you mean tujunga?"));
}

TEST(TerrainPresets, HaveTheSlopesOfTheirLand) {
    const auto median = [](const char* name) {
        Terrain land(parse_terrain(find_terrain_preset(name).toml, name, ""));
        return land.state().slope_angles[0].asked;
    };
    EXPECT_NEAR(median("tujunga"), 22.1, 0.5);    // of its elevation model, cells of 30 m
    EXPECT_NEAR(median("jacksboro"), 13.3, 0.5);  // cells of 90 m
}

// ---- Lands with a place, gullies, streams and a shore

TEST(LandFile, ASectionAloneSwitchesOnAndItsOwnKeysOverrule) {
    EXPECT_FALSE(parse_body("").has_gullies());
    EXPECT_EQ(parse_body("patch_size = 8000\n[terrain.gullies]\n").gullies.depth, 0.055);
    EXPECT_EQ(parse_body("patch_size = 8000\n[terrain.gullies]\ndepth = 0.1\n").gullies.depth, 0.1);
    EXPECT_FALSE(parse_body("[terrain.gullies]\ndepth = 0\nlongest = 700\n").has_gullies());
    const TerrainModel land = parse_body("kind = \"placed\"\n[terrain.stream]\n[terrain.coast]\n");
    EXPECT_EQ(land.stream.slope, 0.62);
    EXPECT_EQ(land.coast.beach_slope, 1.0 / 30.0);
}

TEST(LandFile, TextsReadBackToTheSameLandSwitchedOffOrOn) {
    TerrainModel land = parse_body(
        "kind = \"placed\"\norigin = [-500, 20.5]\nsize = [900, 800]\nisland = 30\n"
        "detail_wavelength = 0.5\n[terrain.stream]\nage = 0.25\n[terrain.coast]\nlevel = -3\n");
    const std::string text = write_terrain(land);
    EXPECT_EQ(write_terrain(parse_terrain(text, "", "")), text);
    EXPECT_EQ(first_dirty_stage(land, parse_terrain(text, "", "")), std::nullopt);
    land.stream.slope = 0.0;  // its other keys stay
    const std::string off = write_terrain(land);
    EXPECT_TRUE(test::says(off, "slope = 0.0\nage = 0.25"));
    EXPECT_FALSE(parse_terrain(off, "", "").has_streams());
    EXPECT_FALSE(test::says(write_terrain(TerrainModel{}), "terrain.stream"));
    EXPECT_FALSE(test::says(write_terrain(TerrainModel{}), "origin"));
}

TEST(LandFile, ASmallBaseIsInlinedAndALargeOneIsKnownByItsHash) {
    const TemporaryFolder folder;
    const std::string keys = "libocean = 1\n[terrain]\nkind = \"placed\"\nbase = \"bed.asc\"\n";
    write_grid(folder.file("bed.asc"), 40);
    const TerrainModel small = parse_terrain(keys, "land.toml", folder.path());
    ASSERT_NE(small.base_model, nullptr);
    EXPECT_EQ(terrain_domain(small).samples, (std::array{40, 40}));
    EXPECT_EQ(terrain_domain(small).origin, (std::array{0.0, 0.0}));
    const std::string text = write_terrain(small);
    const TerrainModel again = parse_terrain(text, "baked.exr", "/nowhere");
    EXPECT_EQ(again.base_model->hash, small.base_model->hash);
    EXPECT_EQ(again.base_model->model.heights, small.base_model->model.heights);
    EXPECT_EQ(write_terrain(again), text);
    std::string lied = text;
    lied.replace(lied.find("heights = [") + 18, 8, "AAAAAAAA");
    EXPECT_TRUE(
        refusal_of([&] { parse_terrain(lied, "", ""); }).says("not the one that it states"));

    write_grid(folder.file("bed.asc"), 520);
    const TerrainModel large = parse_terrain(keys, "land.toml", folder.path());
    const std::string by_hash = write_terrain(large);
    EXPECT_EQ(by_hash.find("heights"), by_hash.find("heights]"));
    EXPECT_EQ(write_terrain(parse_terrain(by_hash, "", folder.path())), by_hash);
    EXPECT_TRUE(says(message_of([&] { parse_terrain(by_hash, "", "/nowhere"); }), "bed.asc"));
    write_grid(folder.file("bed.asc"), 521);
    const auto other = refusal_of([&] { parse_terrain(by_hash, "", folder.path()); });
    EXPECT_TRUE(other.says("is another elevation model", large.base_model->hash));
}

TEST(LandFile, ABaseIsLargeEnoughForItsSpectrumAndHasNoHoles) {
    const TemporaryFolder folder;
    write_grid(folder.file("bed.asc"), 8);
    const char* const text = "libocean = 1\n[terrain]\nkind = \"placed\"\nbase = \"bed.asc\"\n";
    EXPECT_TRUE(
        says(message_of([&] { parse_terrain(text, "", folder.path()); }), "at least 16 samples"));
}

TEST(TerrainSubject, ShowsARegionAtItsCell) {
    TerrainModel terrain;
    terrain.resolution = 64;
    const auto subject = make_region_subject(terrain, {{-100.0, 50.0}, {500.0, 200.0}, 4.0});
    const Domain domain = subject->domain(subject->default_resolution());
    EXPECT_EQ(domain.samples, (std::array{126, 51}));
    EXPECT_EQ(domain.origin, (std::array{-100.0, 50.0}));
    EXPECT_FALSE(domain.wraps);
    const int resolutions[] = {subject->default_resolution()};
    const auto maps = subject->open({});
    const Surface map = std::move(maps->levels(0.0, {Channel::height}, resolutions).front());
    EXPECT_EQ(map.channel(Channel::height).size(), 126u * 51u);
    terrain.kind = TerrainKind::placed;
    EXPECT_TRUE(refusal_of([&] {
                    make_region_subject(terrain, {{-100.0, 50.0}, {500.0, 200.0}, 4.0});
                }).says("the region reaches from x = -100"));
    EXPECT_TRUE(refusal_of([&] {
                    make_region_subject(terrain, {{0.0, 0.0}, {900.0, 900.0}, 0.001});
                }).says("900001 samples along x"));
}

TEST(TerrainSubject, RepeatsItsTile) {
    TerrainModel terrain;
    terrain.resolution = 64;
    const auto subject = make_subject(terrain, {2, 3});
    EXPECT_EQ(subject->kind(), "terrain");
    const Domain domain = subject->domain(32);
    EXPECT_EQ(domain.samples, (std::array{64, 96}));
    EXPECT_EQ(domain.size, (std::array{2000.0, 3000.0}));
    const auto maps = subject->open({});
    const int resolutions[] = {32};
    const Surface map = maps->levels(0.0, {Channel::height, Channel::nz}, resolutions).front();
    const auto h = std::as_const(map).channel(Channel::height);
    ASSERT_EQ(h.size(), 64u * 96u);
    for (const auto [i, j] : test::pairs<std::size_t>(32, 64)) {
        ASSERT_EQ(h[j * 64 + i], h[j * 64 + i + 32]);
        ASSERT_EQ(h[j * 64 + i], h[(j + 32) * 64 + i]);
    }
    const auto back = parse_terrain_subject(subject->text(), "again");
    EXPECT_EQ(back->text(), subject->text());
    EXPECT_EQ(find_terrain(*back)->resolution, 64);
}

}  // namespace
}  // namespace ocean::test
