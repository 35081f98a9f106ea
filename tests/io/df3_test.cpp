// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a DF3 file holds lengths to half a quantum, offsets on the grid of single precision,
// normals to 1e-8 even in folds, foam and cover exactly, slope tiles to half a quantum; it is
// big-endian and has its slices in order. Foam of a coarser map keeps its mean and its place.
// tests/povray renders such files.

#include <cstdint>

#include "ocean/internal/io/df3.hpp"
#include "ocean/internal/map_levels.hpp"
#include "refusal.hpp"
#include "sample_surface.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

std::uint64_t big_endian(const std::string& bytes, std::size_t at, int count) {
    std::uint64_t value = 0;
    for (int i = 0; i < count; ++i) {
        value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
    }
    return value;
}

/// Returns the value that POV-Ray reads, code / (2^32 - 1).
double read_voxel(const std::string& bytes, std::size_t at) {
    return static_cast<double>(big_endian(bytes, 6 + 4 * at, 4)) / 4294967295.0;
}
double metres(double value) {
    return (value * 4294967295.0 - 2147483648.0) / 2097152.0;
}
double projection(double value) {
    return (value * 4294967295.0 - 2147483648.0) / 268435456.0;
}

/// Unit normals all around, some of them downwards.
Surface tilted_surface(int n) {
    Surface surface = test::sample_surface(n);
    for (std::size_t at = 0; at < static_cast<std::size_t>(n * n); ++at) {
        const double turn = 0.37 * static_cast<double>(at);
        const double tilt = 2.4 * static_cast<double>(at % 17) / 17.0;  // to 137 degrees
        surface.channel(Channel::nx)[at] = static_cast<float>(std::sin(tilt) * std::cos(turn));
        surface.channel(Channel::ny)[at] = static_cast<float>(std::sin(tilt) * std::sin(turn));
        surface.channel(Channel::nz)[at] = static_cast<float>(std::cos(tilt));
        surface.channel(Channel::foam)[at] = static_cast<float>(at % 5) / 4.0f;
        surface.channel(Channel::cover)[at] = static_cast<float>(at % 9) / 8.0f;
    }
    return surface;
}

TEST(Df3, HoldsTheMapsInPovRaysAxes) {
    const TemporaryFolder folder;
    const int n = 32;
    const Surface surface = tilted_surface(n);
    io::write_df3(surface, folder.file("s.df3"));
    const std::string bytes = test::read_bytes(folder.file("s.df3"));
    ASSERT_EQ(bytes.size(), io::df3_bytes(n, 7));
    EXPECT_EQ(big_endian(bytes, 0, 2), 32u);
    EXPECT_EQ(big_endian(bytes, 2, 2), 32u);
    EXPECT_EQ(big_endian(bytes, 4, 2), 7u);
    const double grid = std::ldexp(1.0, -16);  // of a period of 100 m
    const std::size_t plane = 32 * 32;
    for (std::size_t at = 0; at < plane; ++at) {
        const auto truth = [&](Channel channel) { return double{surface.channel(channel)[at]}; };
        const auto voxel = [&](std::size_t slice) { return read_voxel(bytes, slice * plane + at); };
        EXPECT_NEAR(metres(voxel(0)), truth(Channel::height), 2.5e-7);
        EXPECT_NEAR(metres(voxel(1)), truth(Channel::dx), 0.5001 * grid);
        EXPECT_NEAR(metres(voxel(2)), truth(Channel::dy), 0.5001 * grid);
        EXPECT_NEAR(std::remainder(metres(voxel(1)), grid), 0.0, 1e-9);
        const double p = projection(voxel(3)), q = projection(voxel(4));
        const double scale = 1.0 / (1.0 + p * p + q * q);
        EXPECT_NEAR(2.0 * p * scale, truth(Channel::nx), 1e-7);
        EXPECT_NEAR(2.0 * q * scale, truth(Channel::ny), 1e-7);
        EXPECT_NEAR((1.0 - p * p - q * q) * scale, truth(Channel::nz), 1e-7);
        EXPECT_NEAR(voxel(5), truth(Channel::foam), 2e-10);
        EXPECT_NEAR(voxel(6), truth(Channel::cover), 2e-10);
    }
}

TEST(Df3, ThreeSlicesHoldThePosition) {
    const TemporaryFolder folder;
    const Surface surface = tilted_surface(32);
    io::write_df3(surface, folder.file("all.df3"));
    io::write_df3(surface, folder.file("three.df3"), io::df3_position_slices());
    const std::string all = test::read_bytes(folder.file("all.df3"));
    const std::string three = test::read_bytes(folder.file("three.df3"));
    ASSERT_EQ(three.size(), io::df3_bytes(32, 3));
    EXPECT_EQ(big_endian(three, 4, 2), 3u);
    EXPECT_EQ(three.substr(6), all.substr(6, three.size() - 6));
}

// A terrain stands still and has no foam: its file has no planes of zeros for them. Its heights
// have codes of their own range, so that land higher than 1024 m fits.
TEST(Df3, HasTheSlicesOfTheSubject) {
    const TemporaryFolder folder;
    const Surface all = tilted_surface(32);
    Surface land(Lattice{32, 100.0}, 0.0, {Channel::height, Channel::nx, Channel::ny, Channel::nz});
    for (const Channel channel : {Channel::height, Channel::nx, Channel::ny, Channel::nz}) {
        std::ranges::copy(all.channel(channel), land.channel(channel).begin());
    }
    for (float& height : land.channel(Channel::height)) height = 700.0f * height + 2500.0f;
    EXPECT_THROW(io::write_df3(land, folder.file("sea.df3")), Error);
    io::write_df3(land, folder.file("land.df3"), io::df3_slices("terrain"));
    io::write_df3(all, folder.file("all.df3"));
    const std::string three = test::read_bytes(folder.file("land.df3"));
    const std::string seven = test::read_bytes(folder.file("all.df3"));
    const std::size_t slice = 32 * 32 * 4;
    ASSERT_EQ(three.size(), io::df3_bytes(32, 3));
    const io::Df3Heights codes = io::df3_heights(land);
    for (std::size_t at = 0; at < land.channel(Channel::height).size(); ++at) {
        const double height =
            codes.base + codes.quantum() * static_cast<double>(big_endian(three, 6 + 4 * at, 4));
        EXPECT_NEAR(height, land.channel(Channel::height)[at], 0.501 * codes.quantum());
    }
    EXPECT_LT(codes.quantum(), 1e-5);
    EXPECT_EQ(three.substr(6 + slice), seven.substr(6 + 3 * slice, 2 * slice));
}

TEST(Df3, SlopeTilesHaveTwoSlicesForEachBand) {
    const TemporaryFolder folder;
    DetailBudget budget;
    budget.bands.resize(2);
    Detail detail(0.0, 256, budget);
    for (std::size_t band = 0; band < 2; ++band) {
        for (std::size_t at = 0; at < detail.slopes(band).size(); ++at) {
            detail.slopes(band)[at] = 0.001f * static_cast<float>(at % 997) - 0.4f;
        }
    }
    detail.slopes(1)[7] = -77.0f;
    io::write_slopes_df3(detail, folder.file("slopes.df3"));
    const std::string bytes = test::read_bytes(folder.file("slopes.df3"));
    ASSERT_EQ(bytes.size(), io::slopes_df3_bytes(256, 2));
    EXPECT_EQ(big_endian(bytes, 0, 2), 256u);
    EXPECT_EQ(big_endian(bytes, 2, 2), 256u);
    EXPECT_EQ(big_endian(bytes, 4, 2), 4u);
    for (std::size_t at = 0; at < 4 * 256 * 256; ++at) {
        const std::size_t slice = at / (256 * 256), place = at % (256 * 256);
        const double code = static_cast<double>(big_endian(bytes, 6 + 2 * at, 2));
        const double slope = detail.slopes(slice / 2)[2 * place + slice % 2];
        const double held = slope < -1.0 ? -3.99 : slope;  // steeper than a file holds
        ASSERT_NEAR((code - 32768.0) / 8192.0, held, 6.2e-5) << at;
    }
}

TEST(Df3, RefusesLengthsOutOfRange) {
    const TemporaryFolder folder;
    const auto refused = [&](Channel channel, float value) {
        Surface surface = tilted_surface(32);
        surface.channel(channel)[77] = value;
        EXPECT_THROW(io::write_df3(surface, folder.file("s.df3")), Error) << value;
        EXPECT_EQ(folder.entries(), 0u);
    };
    refused(Channel::height, 1024.0f);
    refused(Channel::dx, -1500.0f);
    refused(Channel::dy, std::nanf(""));
    refused(Channel::height, INFINITY);
    const Surface none(Lattice{32, 10.0}, 0.0, {Channel::height});
    EXPECT_THROW(io::write_df3(none, folder.file("s.df3")), Error);
}

TEST(Df3, FullDiskIsAnOutputError) {
    const auto refusal = test::refusal_of([] { io::write_df3(tilted_surface(128), "/dev/full"); });
    EXPECT_EQ(refusal.kind, ErrorKind::output);
}

TEST(AverageFoam, KeepsTheMeanAndThePlace) {
    Surface fine(Lattice{64, 10.0}, 0.0, {Channel::foam});
    Surface coarse(Lattice{32, 10.0}, 0.0, {Channel::foam});
    std::ranges::fill(fine.channel(Channel::foam), 0.0f);
    fine.channel(Channel::foam)[10 * 64 + 20] = 1.0f;  // on a sample of the coarse map
    fine.channel(Channel::foam)[0] = 1.0f;             // and at the seam
    average_channel(Channel::foam, fine, coarse);
    double sum = 0.0;
    for (const float foam : coarse.channel(Channel::foam)) sum += foam;
    EXPECT_NEAR(sum / 1024.0, 2.0 / 4096.0, 1e-9);
    EXPECT_EQ(coarse.channel(Channel::foam)[5 * 32 + 10], 0.25f);
    EXPECT_EQ(coarse.channel(Channel::foam)[0], 0.25f);
    Surface odd(Lattice{64, 10.0}, 0.0, {Channel::foam});
    EXPECT_THROW(average_channel(Channel::foam, fine, odd), Error);
}

}  // namespace
}  // namespace ocean
