// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: the PNG holds every height to half the quantum that the side file states, first row far,
// last row and column wrapped, in three quarters of the codes. tests/povray renders
// such files.
#include <png.h>

#include <cstdint>
#include <cstdio>

#include "ocean/internal/io/height_field.hpp"
#include "ocean/internal/io/product_image.hpp"
#include "refusal.hpp"
#include "sample_surface.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

double side_value(const std::string& text, const std::string& key) {
    const std::size_t at = text.find("\n" + key + " = ");
    EXPECT_NE(at, std::string::npos) << key;
    return std::stod(text.substr(at + key.size() + 4));
}

// By the low-level reader: no gamma, no conversion.
std::vector<std::uint16_t> read_grey16(const std::string& path, int& width) {
    std::FILE* file = std::fopen(path.c_str(), "rb");
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_read_png(png, info, PNG_TRANSFORM_SWAP_ENDIAN, nullptr);
    EXPECT_EQ(png_get_bit_depth(png, info), 16);
    EXPECT_EQ(png_get_color_type(png, info), PNG_COLOR_TYPE_GRAY);
    width = static_cast<int>(png_get_image_width(png, info));
    std::vector<std::uint16_t> codes;
    for (png_uint_32 row = 0; row < png_get_image_height(png, info); ++row) {
        const auto* line = reinterpret_cast<const std::uint16_t*>(png_get_rows(png, info)[row]);
        codes.insert(codes.end(), line, line + width);
    }
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
    return codes;
}

/// Refers to the surface.
io::Image image_of(const Surface& surface) {
    const Product* const products[] = {&find_product("height")};
    return io::product_image(
        products, {},
        {.kind = "sea", .frame = 1, .time = 0.0, .domain = Domain::tile(surface.period())},
        surface);
}

TEST(HeightField, HoldsEveryHeightToHalfAQuantum) {
    const TemporaryFolder folder;
    const int n = 64;
    const Surface surface = test::sample_surface(n);
    io::write_height_field(image_of(surface), folder.file("h.png"));
    EXPECT_EQ(folder.entries(), 1u);
    const std::string side = io::height_field_description(image_of(surface));
    const double scale = side_value(side, "scale"), base = side_value(side, "base");
    const double quantum = side_value(side, "quantum");
    EXPECT_NEAR(scale / (side_value(side, "hi") - side_value(side, "lo")), 4.0 / 3.0, 1e-9);
    EXPECT_NEAR(quantum, scale / 65536.0, 1e-12);

    int width = 0;
    const auto codes = read_grey16(folder.file("h.png"), width);
    ASSERT_EQ(width, n + 1);
    ASSERT_EQ(codes.size(), static_cast<std::size_t>(width * width));
    double worst = 0.0;
    for (const auto [i, row] : test::pairs(n + 1, n + 1)) {
        const double height =
            base + scale * codes[static_cast<std::size_t>(row * width + i)] / 65536.0;
        const double truth = test::sample_value(2, i % n, (n - row) % n, n);
        worst = std::max(worst, std::abs(height - truth));
    }
    EXPECT_LE(worst, 0.5 * quantum * 1.0001);
    EXPECT_GE(worst, 0.4 * quantum);  // or the quantum is stated too large
}

TEST(HeightField, CodesAreReadBackAndDamagedFilesRefused) {
    const TemporaryFolder folder;
    const std::string path = folder.file("h.png");
    const Surface surface = test::sample_surface(64);
    io::write_height_field(image_of(surface), path);
    int width = 0;
    const auto codes = read_grey16(path, width);
    std::string decoded;
    const io::ByteSink sink = [&decoded](std::string_view bytes) { decoded += bytes; };
    io::read_height_field(path, sink);
    const std::string_view truth(reinterpret_cast<const char*>(codes.data()),
                                 codes.size() * sizeof codes[0]);
    EXPECT_TRUE(decoded == truth);
    const std::string bytes = test::read_bytes(path);
    for (std::size_t size = 0; size < bytes.size() - 12; size += 499) {  // 12: the end mark
        folder.write("h.png", bytes.substr(0, size));
        EXPECT_THROW(io::read_height_field(path, sink), Error) << size;
    }
}

TEST(HeightField, FlatSeaAndErrors) {
    const TemporaryFolder folder;
    Surface flat(Lattice{32, 10.0}, 0.0, {Channel::height});
    std::ranges::fill(flat.channel(Channel::height), 0.0f);
    io::write_height_field(image_of(flat), folder.file("flat.png"));
    int width = 0;
    for (const auto code : read_grey16(folder.file("flat.png"), width)) EXPECT_EQ(code, 32768);
    Surface broken = flat;
    broken.channel(Channel::height)[5] = std::nanf("");
    EXPECT_THROW(io::write_height_field(image_of(broken), folder.file("nan.png")), Error);
    io::Image none = image_of(flat);
    none.planes[0].samples = {};
    EXPECT_THROW(io::write_height_field(none, folder.file("none.png")), Error);
    io::Image oblong = image_of(flat);
    oblong.height = 16;
    EXPECT_THROW(io::write_height_field(oblong, folder.file("oblong.png")), Error);
    EXPECT_EQ(folder.entries(), 1u);
}

// A terrain or a coast is there once: no row and no column is repeated, and it has a place.
TEST(HeightField, OfADomainThatDoesNotWrapHasItsSamplesOnly) {
    const TemporaryFolder folder;
    const int n = 33;
    std::vector<float> heights;
    for (const auto [i, j] : test::pairs(n, n)) {
        heights.push_back(static_cast<float>(i - 2 * j));
    }
    io::Image image{.width = n,
                    .height = n,
                    .domain = Domain{{100.0, -20.0}, {64.0, 64.0}, {n, n}, false},
                    .planes = {{.name = "Y", .samples = heights}},
                    .provenance = {.kind = "terrain", .text = "x"}};
    io::write_height_field(image, folder.file("h.png"));
    const std::string side = io::height_field_description(image);
    int width = 0;
    const auto codes = read_grey16(folder.file("h.png"), width);
    ASSERT_EQ(width, n);
    for (const auto [i, row, at] : test::cells(n, n)) {
        const double height =
            side_value(side, "base") + side_value(side, "scale") * codes[at] / 65536.0;
        EXPECT_NEAR(height, i - 2 * (n - 1 - row), side_value(side, "quantum"));
    }
    EXPECT_EQ(side_value(side, "samples"), n);
    EXPECT_TRUE(test::says(side, {"scale <64, ", "translate <100, ", ", -20> }"}));
    const std::string scene = io::height_field_declarations(image);
    EXPECT_TRUE(test::says(scene, "#declare Terrain_Base = "));
    EXPECT_FALSE(test::says(scene, "Ocean"));
}

// A small image fails at the flush; a large one inside libpng, whose word for it is less telling.
TEST(HeightField, FullDiskIsAnOutputError) {
    for (const int n : {32, 512}) {
        const Surface surface = test::sample_surface(n);
        const auto full = [&] { io::write_height_field(image_of(surface), "/dev/full"); };
        EXPECT_TRUE(test::says(test::message_of(ErrorKind::output, full), "No space left")) << n;
    }
}

}  // namespace
}  // namespace ocean
