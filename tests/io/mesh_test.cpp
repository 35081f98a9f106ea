// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: the patch mesh is the displaced surface to half its vertex grid, its seam closes in bits,
// it faces up; mesh2 text reads back as the same floats.

#include "ocean/io/mesh.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/io/mesh2.hpp"
#include "sample_surface.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

// A gentle sea: no folds, normals not needed to fit.
Surface gentle_surface(int n) {
    Surface surface = test::sample_surface(n);
    for (const Channel channel : {Channel::dx, Channel::dy, Channel::height}) {
        for (float& value : surface.channel(channel)) value *= 0.1f;
    }
    for (const Channel channel : {Channel::nx, Channel::ny}) {
        for (float& value : surface.channel(channel)) value = 0.01f * value;
    }
    for (float& value : surface.channel(Channel::nz)) value = 1.0f;
    return surface;
}

TEST(PatchMesh, IsTheDisplacedSurfaceOnAPowerOfTwoGrid) {
    const int n = 32;
    const Surface surface = gentle_surface(n);
    const io::Mesh mesh = io::make_patch_mesh(surface);
    ASSERT_EQ(mesh.positions.size(), 3u * 33 * 33);
    ASSERT_EQ(mesh.triangles.size(), 6u * 32 * 32);
    const double step = std::ldexp(1.0, -16);
    for (const auto [i, j] : test::pairs(n + 1, n + 1)) {
        const float* p = &mesh.positions[static_cast<std::size_t>(3 * (j * (n + 1) + i))];
        const auto at = static_cast<std::size_t>((j % n) * n + i % n);
        const double cell = test::kSamplePeriod / n;
        EXPECT_NEAR(p[0], i * cell + surface.channel(Channel::dx)[at], 0.51 * step);
        EXPECT_NEAR(p[1], j * cell + surface.channel(Channel::dy)[at], 0.51 * step);
        EXPECT_NEAR(p[2], surface.channel(Channel::height)[at], 0.51 * step);
        for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(p[c] / step, std::nearbyint(p[c] / step));
        }
    }
}

TEST(PatchMesh, SeamsHaveEqualBits) {
    const int n = 32;
    const io::Mesh mesh = io::make_patch_mesh(gentle_surface(n));
    const auto vertex = [&](int i, int j) {
        return &mesh.positions[static_cast<std::size_t>(3 * (j * (n + 1) + i))];
    };
    const auto period = static_cast<float>(test::kSamplePeriod);
    for (int k = 0; k <= n; ++k) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(vertex(0, k)[c] + (c == 0 ? period : 0.0f), vertex(n, k)[c]);
            EXPECT_EQ(vertex(k, 0)[c] + (c == 1 ? period : 0.0f), vertex(k, n)[c]);
        }
    }
}

TEST(PatchMesh, TrianglesFaceUpAndCoverThePeriod) {
    const io::Mesh mesh = io::make_patch_mesh(gentle_surface(32));
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        const auto corner = [&](std::size_t c, int axis) {
            return static_cast<double>(
                mesh.positions[static_cast<std::size_t>(3 * mesh.triangles[t + c] + axis)]);
        };
        const double twice = (corner(1, 0) - corner(0, 0)) * (corner(2, 1) - corner(0, 1)) -
                             (corner(2, 0) - corner(0, 0)) * (corner(1, 1) - corner(0, 1));
        EXPECT_GT(twice, 0.0);
        area += 0.5 * twice;
    }
    EXPECT_NEAR(area, test::kSamplePeriod * test::kSamplePeriod, 1e-6 * area);
}

TEST(PatchMesh, RefusesMissingHeightsAndASingleRow) {
    EXPECT_THROW(io::make_patch_mesh(Surface(Lattice{32, 10.0}, 0.0, {Channel::dx, Channel::dy})),
                 Error);
    const Domain row{{0.0, 0.0}, {10.0, 1.0}, {32, 1}, false};
    EXPECT_THROW(io::make_patch_mesh(Surface(row, 0.0, {Channel::height})), Error);
}

/// The value of an attribute at the vertex (i, j) of so many columns.
float value_at(const io::Attribute& attribute, int columns, int i, int j, int component = 0) {
    return attribute
        .values[static_cast<std::size_t>((j * columns + i) * attribute.components + component)];
}

TEST(PatchMesh, HasUvFrom0To1AndEveryProductOfTheSurface) {
    const int n = 32;
    const Surface surface = gentle_surface(n);
    const io::Mesh mesh = io::make_patch_mesh(surface);
    EXPECT_EQ(mesh.domain, Domain::tile(test::kSamplePeriod, n));
    const io::Attribute* uv = mesh.find("uv");
    ASSERT_TRUE(uv != nullptr);
    ASSERT_EQ(uv->values.size(), 2u * 33 * 33);
    for (const auto [i, j] : test::pairs(n + 1, n + 1)) {
        EXPECT_EQ(value_at(*uv, n + 1, i, j, 0), static_cast<float>(i) / n);
        EXPECT_EQ(value_at(*uv, n + 1, i, j, 1), static_cast<float>(j) / n);
    }
    std::vector<std::string> names;
    for (const io::Attribute& attribute : mesh.attributes) {
        names.push_back(attribute.name);
        EXPECT_EQ(attribute.values.size(),
                  33u * 33u * static_cast<std::size_t>(attribute.components));
        EXPECT_EQ(attribute.vector, attribute.name == "velocity");
    }
    EXPECT_EQ(names, (std::vector<std::string>{"uv", "slope", "jacobian", "whitecap", "foam",
                                               "velocity", "derivatives", "cover"}));
    EXPECT_EQ(value_at(*mesh.find("velocity"), n + 1, 3, n, 1), surface.channel(Channel::vy)[3]);
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_EQ(io::make_patch_mesh(surface, io::Faces::none).find("uv"), nullptr);
}

// A terrain or a coast: heights of a place, nothing that repeats.
TEST(PatchMesh, OfADomainThatDoesNotWrapHasItsSamplesOnly) {
    const int columns = 32, rows = 11;
    const Domain domain{{500100.0, -20.0}, {62.0, 5.0}, {columns, rows}, false};
    Surface plane(domain, 0.0, {Channel::height});
    for (const auto [i, j, at] : test::cells(columns, rows)) {
        plane.channel(Channel::height)[at] =
            0.1f * static_cast<float>(i) - 3.0f * static_cast<float>(j);
    }
    const io::Mesh mesh = io::make_patch_mesh(plane);
    ASSERT_EQ(mesh.vertices(), 32u * 11u);
    EXPECT_EQ(mesh.domain, domain);
    EXPECT_EQ(mesh.triangles.size(), 6u * 31 * 10);
    EXPECT_EQ(*std::ranges::max_element(mesh.triangles), 32 * 11 - 1);
    EXPECT_TRUE(mesh.normals.empty());
    ASSERT_EQ(mesh.attributes.size(), 1u);
    const io::Attribute& uv = mesh.attributes[0];
    for (const auto [i, j, v] : test::cells(columns, rows)) {
        EXPECT_EQ(mesh.positions[3 * v], static_cast<float>(500100.0 + 2.0 * i));
        EXPECT_EQ(mesh.positions[3 * v + 1], static_cast<float>(-20.0 + 0.5 * j));
        EXPECT_EQ(mesh.positions[3 * v + 2], plane.channel(Channel::height)[v]) << "as it was";
        EXPECT_EQ(value_at(uv, columns, i, j, 0), static_cast<float>(i / 31.0));
        EXPECT_EQ(value_at(uv, columns, i, j, 1), static_cast<float>(j / 10.0));
    }
    const std::size_t last = mesh.vertices() - 1;
    EXPECT_EQ(mesh.positions[3 * last], 500162.0f) << "the far corner is that of the domain";
    EXPECT_EQ(mesh.positions[3 * last + 1], -15.0f);
}

TEST(PatchMesh, SquaresWhoseDiagonalIsDryAreCut) {
    // Three squares in a row; vertices 0 .. 3 south, 4 .. 7 north. Diagonals: 1-4, 2-5 and 3-6.
    const Domain domain{{0.0, 0.0}, {3.0, 1.0}, {4, 2}, false};
    std::vector<int> triangles = io::patch_triangles(domain);
    const std::vector<int> all = triangles;
    const std::vector<float> dry = {1.0f, 0.2f, 0.5f, 0.9f, 1.0f, 1.0f, 0.4f, 1.0f};
    io::cut_dry_squares(domain, dry, triangles);
    const std::vector<int> first(all.begin(), all.begin() + 6), last(all.end() - 6, all.end());
    std::vector<int> expected = first;
    expected.insert(expected.end(), last.begin(), last.end());
    EXPECT_EQ(triangles, expected);
    io::cut_dry_squares(domain, std::vector<float>(8, 1.0f), triangles);
    EXPECT_TRUE(triangles.empty());
}

TEST(PatchMesh, OfATileAwayFromTheOriginClosesItsSeamThere) {
    const int n = 32;
    const Surface at_origin = gentle_surface(n);
    Surface moved(Domain{{-300.0, 40.0}, {100.0, 100.0}, {n, n}, true}, 0.0,
                  {Channel::dx, Channel::dy, Channel::height});
    for (const Channel channel : {Channel::dx, Channel::dy, Channel::height}) {
        std::ranges::copy(at_origin.channel(channel), moved.channel(channel).begin());
    }
    const io::Mesh here = io::make_patch_mesh(at_origin);
    const io::Mesh there = io::make_patch_mesh(moved);
    ASSERT_EQ(there.positions.size(), here.positions.size());
    for (std::size_t v = 0; v < here.vertices(); ++v) {
        EXPECT_NEAR(there.positions[3 * v], here.positions[3 * v] - 300.0f, 1e-4);
        EXPECT_NEAR(there.positions[3 * v + 1], here.positions[3 * v + 1] + 40.0f, 1e-4);
    }
    for (std::size_t row = 0; row <= 32; ++row) {
        EXPECT_EQ(there.positions[3 * 33 * row] + 100.0f, there.positions[3 * (33 * row + 32)]);
    }
}

// Reads the numbers of "<a,b,c>" after `start`, `count` times.
std::vector<float> read_vectors(const std::string& text, const std::string& start,
                                std::size_t count) {
    std::vector<float> values;
    std::size_t at = text.find(start);
    for (std::size_t v = 0; v < count && at != std::string::npos; ++v) {
        at = text.find('<', at + 1);
        std::istringstream numbers(text.substr(at + 1, text.find('>', at) - at - 1));
        for (std::string number; std::getline(numbers, number, ',');) {
            values.push_back(std::stof(number));
        }
    }
    return values;
}

TEST(Mesh2, TextGivesTheSameFloatsInPovRayAxes) {
    const TemporaryFolder folder;
    const Surface surface = gentle_surface(32);
    const io::Provenance label{
        .kind = "sea", .frame = 4, .time = 12.25, .domain = Domain::tile(surface.period())};
    const io::Mesh mesh = io::make_patch_mesh(surface);
    io::write_mesh2(mesh, label, folder.file("sea 0004.inc"));
    const std::string text = test::read_bytes(folder.file("sea 0004.inc"));
    EXPECT_TRUE(test::says(text, {"#declare Ocean_Time = 12.25;", "#declare Ocean_Period = 100;",
                                  "#declare Ocean_Frame_Number = 4;"}));
    const auto positions = read_vectors(text, "vertex_vectors", mesh.positions.size() / 3);
    const auto normals = read_vectors(text, "normal_vectors", mesh.positions.size() / 3);
    ASSERT_EQ(positions.size(), mesh.positions.size());
    ASSERT_EQ(normals.size(), mesh.normals.size());
    const std::size_t to_pov[] = {0, 2, 1};
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const std::size_t from = i - i % 3 + to_pov[i % 3];
        EXPECT_EQ(positions[i], mesh.positions[from]);
        EXPECT_NEAR(normals[i], mesh.normals[from], 0.51e-4);
    }
    io::View view;
    view.x = 3.0;
    view.heading = 90.0;
    io::write_mesh2(mesh, label, folder.file("v.inc"), {.view = &view});
    EXPECT_TRUE(
        test::says(test::read_bytes(folder.file("v.inc")), "#declare Ocean_Eye = <3, 6, 0>;"));
    EXPECT_FALSE(test::says(text, "uv_vectors"));
    io::write_mesh2(mesh, label, folder.file("u.inc"), {.u = "cover"});
    const auto covers =
        read_vectors(test::read_bytes(folder.file("u.inc")), "uv_vectors", mesh.vertices());
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        const float cover = std::clamp(mesh.find("cover")->values[v], -1.0f, 1.0f);
        EXPECT_NEAR(covers[2 * v], cover, 0.51e-4);
    }
    EXPECT_THROW(io::write_mesh2(io::Mesh{}, label, folder.file("e.inc")), Error);
    EXPECT_THROW(io::write_mesh2(mesh, label, "/dev/full"), Error);
    EXPECT_EQ(folder.entries(), 3u);
}

TEST(Mesh2, DeclaresItsDomainUnderTheNamesOfItsSubject) {
    const TemporaryFolder folder;
    const Domain domain{{100.5, -20.0}, {64.0, 32.0}, {3, 3}, false};
    const io::Mesh mesh{.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0},
                        .normals = {0, 0, 1, 0, 0, 1, 0, 0, 1},
                        .triangles = {0, 1, 2}};
    io::write_mesh2(mesh, {.kind = "terrain", .id = "ab", .domain = domain}, folder.file("t.inc"));
    const std::string text = test::read_bytes(folder.file("t.inc"));
    for (const char* words :
         {"//   Desc: The surface of a terrain, by libocean ", "#declare Terrain_Surface = mesh2 {",
          "#declare Terrain_Origin = <100.5, -20>;", "#declare Terrain_Size = <64, 32>;",
          "#declare Terrain_Frame_Terrain_ = \"ab\";", "#version Terrain_Mesh_Inc_Temp;"}) {
        EXPECT_TRUE(test::says(text, words));
    }
    EXPECT_FALSE(test::says(text, "Ocean_"));
    EXPECT_THROW(io::write_mesh2(mesh, {.kind = "terrain"}, folder.file("none.inc")), Error);
}

}  // namespace
}  // namespace ocean
