// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: comments hold any text of several lines; a mesh is turned with all its vectors; files
// that are not our meshes are refused by name.
#include "ocean/io/mesh.hpp"

#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/io/usd.hpp"
#include "refusal.hpp"
#include "sample_surface.hpp"

namespace ocean {
namespace {

TEST(CommentLines, HoldTextsOfSeveralLines) {
    const std::vector<io::HeaderString> strings = {
        {"ocean:sea", "a = 1\n\n[b]\n  c = \"x y\""}, {"ocean:empty", ""}, {"ocean:time", "0.5"}};
    const std::string lines = io::comment_lines(strings, "comment");
    EXPECT_EQ(lines,
              "comment ocean:sea a = 1\ncomment ocean:sea \ncomment ocean:sea [b]\n"
              "comment ocean:sea   c = \"x y\"\ncomment ocean:empty \ncomment ocean:time 0.5\n");
    const auto read = io::parse_comment_lines(
        "ply\n" + lines + "element vertex 3\ncomment\n" + "comment x\ncommentocean:sea y\n",
        "comment");
    ASSERT_EQ(read.size(), strings.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(read[i].name, strings[i].name);
        EXPECT_EQ(read[i].text, strings[i].text);
    }
}

TEST(MeshFiles, HoldTheirProvenance) {
    const test::TemporaryFolder folder;
    const io::Mesh mesh = io::make_patch_mesh(test::sample_surface(16));
    ASSERT_EQ(mesh.find("velocity")->values.size(), mesh.positions.size());
    const std::vector<io::HeaderString> strings = {{"ocean:sea", "libocean = 1\n[grid]"}};
    io::write_ply(mesh, strings, folder.file("a.ply"));
    io::write_obj(mesh, strings, folder.file("a.obj"));
    EXPECT_EQ(io::read_ply_header(folder.file("a.ply")).front().text, strings.front().text);
    EXPECT_EQ(io::read_obj_header(folder.file("a.obj")).front().text, strings.front().text);
    EXPECT_THROW(io::read_ply_header(folder.file("a.obj")), Error);
    EXPECT_THROW(io::read_obj_header(folder.file("a.ply")), Error);
    io::write_ply(mesh, {}, folder.file("b.ply"));
    EXPECT_THROW(io::read_ply_header(folder.file("b.ply")), Error);
    const std::uint64_t vertices = mesh.positions.size() / 3;
    const std::uint64_t triangles = mesh.triangles.size() / 3;
    const auto size = [&](const char* name) {
        return std::filesystem::file_size(folder.file(name));
    };
    std::uint64_t floats = 3 + 3;
    for (const io::Attribute& attribute : mesh.attributes) {
        floats += static_cast<std::uint64_t>(attribute.components);
    }
    EXPECT_LE(size("b.ply"), io::ply_bytes(vertices, floats, triangles));
    EXPECT_GE(size("b.ply") + 1024, io::ply_bytes(vertices, floats, triangles));
    io::write_obj(mesh, {}, folder.file("b.obj"));
    EXPECT_THROW(io::read_obj_header(folder.file("b.obj")), Error);
    EXPECT_LE(size("b.obj"), io::max_obj_bytes(vertices, 9, triangles));
}

TEST(UsdFiles, HoldTheirProvenanceAndRefuseAMutatedTable) {
    const test::TemporaryFolder folder;
    const io::Mesh mesh = io::make_patch_mesh(test::sample_surface(16));
    const std::vector<io::HeaderString> strings = {{"ocean:sea", "libocean = 1\n[grid]"}};
    const std::string path = folder.file("a.usdc");
    io::write_usd_frame(mesh, strings, 3.0, path);
    EXPECT_EQ(io::read_usd_header(path).front().text, strings.front().text);
    EXPECT_THROW(io::read_usd_header(folder.file("none.usdc")), Error);
    const std::string whole = test::read_bytes(path);
    // Any byte of what says where things are may be another: an Error, or the strings.
    std::mt19937 random(5);
    for (int i = 0; i < 3000; ++i) {
        std::string changed = whole;
        const std::size_t tail = std::min<std::size_t>(whole.size(), 2000);
        const bool head = random() % 4 == 0;
        const std::size_t at = head ? random() % 88 : whole.size() - 1 - random() % tail;
        changed[at] = static_cast<char>(random());
        if (random() % 8 == 0) changed.resize(random() % changed.size());
        folder.write("b.usdc", changed);
        test::message_of(ErrorKind::bad_file, [&] { io::read_usd_header(folder.file("b.usdc")); });
    }
}

TEST(UsdStage, QuotesTheTextOfTheSea) {
    const std::vector<io::HeaderString> strings = {{"ocean:sea", "a = \"b\"\\\n"}};
    io::UsdSequence sequence;
    sequence.numbers = {1};
    const std::string stage = io::usd_stage(sequence, strings);
    EXPECT_TRUE(test::says(stage, "\"\"\"a = \\\"b\\\"\\\\\n\"\"\""));
}

TEST(UsdStage, ListsUnevenFramesOneByOne) {
    io::UsdSequence sequence;
    sequence.frames = "s.##.usdc";
    sequence.numbers = {1, 2, 5, 100};
    EXPECT_EQ(io::even_step(sequence.numbers), std::nullopt);
    const std::string stage = io::usd_stage(sequence, {});
    EXPECT_TRUE(test::says(
        stage, {"startTimeCode = 1\n", "endTimeCode = 100\n",
                "assetPaths = [@./s.01.usdc@, @./s.02.usdc@, @./s.05.usdc@, @./s.100.usdc@]",
                "active = [(1, 0), (2, 1), (5, 2), (100, 3)]",
                "times = [(1, 1), (2, 2), (5, 5), (100, 100)]"}));
    EXPECT_FALSE(test::says(stage, "template"));
    sequence.numbers = {4, 8, 12};
    EXPECT_EQ(io::even_step(sequence.numbers), 4);
    EXPECT_TRUE(test::says(io::usd_stage(sequence, {}), "templateStride = 4"));
}

TEST(MeshFiles, AreTurnedWithAllTheirVectors) {
    io::Mesh mesh;
    mesh.positions = {1, 2, 3, 4, 5, 6};
    mesh.normals = {0, 0, 1, 0, 1, 0};
    mesh.attributes = {{"velocity", 3, {7, 8, 9, -1, -2, -3}, true},
                       {"colour", 3, {1, 2, 3, 4, 5, 6}},
                       {"uv", 2, {0, 0, 1, 1}}};
    io::turn_y_up(mesh);
    EXPECT_EQ(mesh.positions, (std::vector<float>{1, 3, -2, 4, 6, -5}));
    EXPECT_EQ(mesh.normals, (std::vector<float>{0, 1, 0, 0, 0, -1}));
    EXPECT_EQ(mesh.attributes[0].values, (std::vector<float>{7, 9, -8, -1, -3, 2}));
    EXPECT_EQ(mesh.attributes[1].values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(mesh.attributes[2].values, (std::vector<float>{0, 0, 1, 1}));
}

io::Mesh triangle() {
    return {.positions = {0, 0, 5, 2, 0, -1, 0, 3, 0},
            .attributes = {{"uv", 2, {0, 0, 1, 0, 0, 1}},
                           {"snow", 1, {0.25f, 0.5f, 0.75f}},
                           {"current", 3, {1, 2, 3, 4, 5, 6, 7, 8, 9}, true},
                           {"strata", 2, {1, 2, 3, 4, 5, 6}}},
            .triangles = {0, 1, 2}};
}

const std::vector<io::HeaderString> kTerrainStrings = {{"ocean:terrain", "beta = 2"},
                                                       {"ocean:subject", "terrain"}};

// A writer knows no attribute by name: what a later subject brings is written as well.
TEST(MeshFiles, HaveAnyAttributeUnderTheNamesOfItsSubject) {
    const test::TemporaryFolder folder;
    io::write_ply(triangle(), kTerrainStrings, folder.file("a.ply"));
    const std::string ply = test::read_bytes(folder.file("a.ply"));
    std::string header = "ply\nformat binary_little_endian 1.0\n";
    header += "comment ocean:terrain beta = 2\ncomment ocean:subject terrain\nelement vertex 3\n";
    for (const char* name : {"x", "y", "z", "s", "t", "snow", "current_x", "current_y", "current_z",
                             "strata_x", "strata_y"}) {
        header += std::string("property float ") + name + "\n";
    }
    ASSERT_EQ(ply.substr(0, header.size()), header);
    const std::size_t data = ply.find("end_header\n") + 11;
    float last[11];
    std::memcpy(last, ply.data() + data + 2 * sizeof last, sizeof last);
    EXPECT_EQ((std::vector<float>(last, last + 11)),
              (std::vector<float>{0, 3, 0, 0, 1, 0.75f, 7, 8, 9, 5, 6}));

    io::write_obj(triangle(), kTerrainStrings, folder.file("a.obj"));
    EXPECT_EQ(test::read_bytes(folder.file("a.obj")),
              "# The surface of a terrain, by libocean\n# ocean:terrain beta = 2\n"
              "# ocean:subject terrain\no terrain\nv 0 0 5 0.25 0.25 0.25\nv 2 0 -1 0.5 0.5 0.5\n"
              "v 0 3 0 0.75 0.75 0.75\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    for (const char* name : {"a.ply", "a.obj"}) {
        const auto found = io::read_provenance(folder.file(name));
        ASSERT_TRUE(found) << name;
        EXPECT_EQ(found->kind, "terrain");
        EXPECT_EQ(found->text, "beta = 2");
    }
}

TEST(UsdFiles, HaveAnyAttributeUnderTheNamesOfTheirSubject) {
    const test::TemporaryFolder folder;
    io::UsdSequence sequence;
    sequence.numbers = {1};
    sequence.attributes = triangle().attributes;
    sequence.attributes.erase(sequence.attributes.begin());  // uv: the topology has it
    sequence.words = io::subject_words("terrain");
    const std::string clips = io::usd_clip_manifest(sequence);
    const std::string stage = io::usd_stage(sequence, kTerrainStrings);
    for (const char* words : {"float[] primvars:snow", "vector3f[] primvars:current",
                              "float2[] primvars:strata", "float3[] extentsHint"}) {
        EXPECT_TRUE(test::says(clips, words));
        EXPECT_TRUE(test::says(stage, words));
    }
    EXPECT_TRUE(test::says(clips, "What the frames of a terrain by libocean have"));
    EXPECT_TRUE(test::says(stage, {"texCoord2f[] primvars:st", "def Mesh \"Terrain\""}));
    EXPECT_FALSE(test::says(stage, "Ocean"));
    io::write_usd_frame(triangle(), kTerrainStrings, 1.0, folder.file("a.usdc"));
    const std::string frame = test::read_bytes(folder.file("a.usdc"));
    const float box[] = {0, 0, -1, 2, 3, 5};
    EXPECT_TRUE(test::says(frame, std::string(reinterpret_cast<const char*>(box), sizeof box)));
    EXPECT_TRUE(test::says(frame, "Terrain"));
    EXPECT_FALSE(test::says(frame, "Ocean"));
    EXPECT_EQ(io::read_provenance(folder.file("a.usdc"))->text, "beta = 2");
}

io::Points two_points() {
    return {.positions = {1, 2, 3, 4, 5, 6},
            .velocities = {7, 8, 9, -1, -2, -3},
            .ages = {0.5f, 0.25f},
            .lives = {2, 1},
            .radii = {1e-4f, 2e-4f},
            .ids = {0x0123456789ABCDEFu, 42u}};
}

TEST(PointFiles, HoldEveryAttributeOfEachPoint) {
    const test::TemporaryFolder folder;
    const io::Points points = two_points();
    const std::string path = folder.file("a.ply");
    io::write_ply(points, std::vector<io::HeaderString>{{"ocean:sea", "libocean = 1"}}, path);
    EXPECT_EQ(io::read_ply_header(path).front().text, "libocean = 1");
    const std::string bytes = test::read_bytes(path);
    const std::string end = "end_header\n";
    const std::size_t data = bytes.find(end) + end.size();
    EXPECT_TRUE(test::says(bytes, {"element vertex 2\nproperty float x\n",
                                   "property uint id_low\nproperty uint id_high\nend"}));
    ASSERT_EQ(bytes.size() - data, 2 * 44u);
    const auto value = [&](std::size_t place, auto zero) {
        std::memcpy(&zero, bytes.data() + data + 44 + place, sizeof zero);
        return zero;
    };
    const float wanted[] = {4, 5, 6, -1, -2, -3, 0.25f, 1, 2e-4f};
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(value(4 * i, 0.0f), wanted[i]);
    EXPECT_EQ(value(36, 0u), 42u);
    EXPECT_EQ(value(40, 0u), 0u);
    const char* first = bytes.data() + data + 36;
    EXPECT_EQ(static_cast<unsigned char>(first[0]), 0xEF) << "the low half comes first";
    EXPECT_EQ(static_cast<unsigned char>(first[7]), 0x01);
    EXPECT_LE(bytes.size(), io::points_ply_bytes(2));
    EXPECT_EQ(io::points_bytes(2), 2 * 44u);
    io::write_ply(io::Points(), {}, folder.file("none.ply"));
    EXPECT_TRUE(test::says(test::read_bytes(folder.file("none.ply")), "element vertex 0\n"));
    EXPECT_THROW(io::write_ply(points, {}, "/dev/full"), Error);
}

TEST(PointFiles, AreTurnedWithAllTheirVectors) {
    io::Points points = two_points();
    io::turn_y_up(points);
    EXPECT_EQ(points.positions, (std::vector<float>{1, 3, -2, 4, 6, -5}));
    EXPECT_EQ(points.velocities, (std::vector<float>{7, 9, -8, -1, -3, 2}));
}

}  // namespace
}  // namespace ocean
