// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: the patch mesh is the displaced surface to half its vertex grid, its seam closes in bits,
// it faces up; mesh2 text gives the same floats again.
#include <gtest/gtest.h>

#include <sstream>

#include "ocean/error.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/io/mesh2.hpp"
#include "sample_surface.hpp"

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
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
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
}

TEST(PatchMesh, SeamsCloseInBits) {
    const int n = 32;
    const io::Mesh mesh = io::make_patch_mesh(gentle_surface(n));
    const auto vertex = [&](int i, int j) {
        return &mesh.positions[static_cast<std::size_t>(3 * (j * (n + 1) + i))];
    };
    const auto period = static_cast<float>(test::kSamplePeriod);
    for (int k = 0; k <= n; ++k) {
        EXPECT_EQ(vertex(0, k)[0] + period, vertex(n, k)[0]);
        EXPECT_EQ(vertex(0, k)[1], vertex(n, k)[1]);
        EXPECT_EQ(vertex(0, k)[2], vertex(n, k)[2]);
        EXPECT_EQ(vertex(k, 0)[1] + period, vertex(k, n)[1]);
        EXPECT_EQ(vertex(k, 0)[0], vertex(k, n)[0]);
        EXPECT_EQ(vertex(k, 0)[2], vertex(k, n)[2]);
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

TEST(PatchMesh, RefusesMissingChannels) {
    EXPECT_THROW(io::make_patch_mesh(Surface(Lattice{32, 10.0}, 0.0, {Channel::height})), Error);
}

// Reads "<a,b,c>" after `start`, `count` times.
std::vector<float> read_vectors(const std::string& text, const std::string& start,
                                std::size_t count) {
    std::vector<float> values;
    std::size_t at = text.find(start);
    for (std::size_t v = 0; v < count && at != std::string::npos; ++v) {
        at = text.find('<', at + 1);
        std::istringstream numbers(text.substr(at + 1, 80));
        std::string number;
        for (const char end : {',', ',', '>'}) {
            std::getline(numbers, number, end);
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
    EXPECT_NE(text.find("#declare Ocean_Time = 12.25;"), std::string::npos);
    EXPECT_NE(text.find("#declare Ocean_Period = 100;"), std::string::npos);
    EXPECT_NE(text.find("#declare Ocean_Frame_Number = 4;"), std::string::npos);
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
    io::write_mesh2(mesh, label, folder.file("v.inc"), &view);
    EXPECT_NE(test::read_bytes(folder.file("v.inc")).find("#declare Ocean_Eye = <3, 6, 0>;"),
              std::string::npos);
    EXPECT_THROW(io::write_mesh2(io::Mesh{}, label, folder.file("e.inc")), Error);
    EXPECT_THROW(io::write_mesh2(mesh, label, "/dev/full"), Error);
    EXPECT_EQ(folder.entries(), 2u);
}

}  // namespace
}  // namespace ocean
