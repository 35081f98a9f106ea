// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a GeoTIFF holds every float of its map to the bit, the northern row first, also where the
// image ends within a tile; its keys say where the samples lie, and that they are points; its
// header is read without libtiff, and damaged or foreign files are errors. tests/cli judges such
// files by rasterio and tifffile.
#include <tiffio.h>

#include "ocean/internal/io/geotiff.hpp"
#include "ocean/internal/io/product_image.hpp"
#include "refusal.hpp"
#include "sample_surface.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

constexpr int kColumns = 300, kRows = 70;  // two tiles, both cut
const Domain kPlace{{1000.0, -500.0}, {598.0, 207.0}, {kColumns, kRows}, false};

std::vector<float> sample_heights() {
    std::vector<float> heights;
    for (const auto [i, j] : test::pairs(kColumns, kRows)) {
        heights.push_back(2000.0f + 0.37f * static_cast<float>(i) - 1.1f * static_cast<float>(j));
    }
    return heights;
}

io::Image image_of(const std::vector<float>& heights) {
    return {
        .width = kColumns,
        .height = kRows,
        .domain = kPlace,
        .planes = {{.name = "Y", .samples = heights}},
        .provenance = {.kind = "terrain", .text = "libocean = 1\n[terrain]\n", .domain = kPlace}};
}

std::vector<float> read_rows(const std::string& path) {
    std::vector<float> rows;
    io::read_geotiff(path, kPlace, [&rows](std::string_view bytes) {
        const auto* const first = reinterpret_cast<const float*>(bytes.data());
        rows.insert(rows.end(), first, first + bytes.size() / sizeof(float));
    });
    return rows;
}

TEST(Geotiff, HoldsEveryFloatTheNorthernRowFirst) {
    const TemporaryFolder folder;
    const std::vector<float> heights = sample_heights();
    io::write_geotiff(image_of(heights), folder.file("t.tif"));
    EXPECT_EQ(folder.entries(), 1u);
    const std::vector<float> rows = read_rows(folder.file("t.tif"));
    ASSERT_EQ(rows.size(), heights.size());
    for (const auto [i, j, at] : test::cells(kColumns, kRows)) {
        ASSERT_EQ(rows[at], heights[static_cast<std::size_t>((kRows - 1 - j) * kColumns + i)]);
    }
    const auto size = test::read_bytes(folder.file("t.tif")).size();
    EXPECT_LE(size, io::max_geotiff_bytes(kPlace));
}

TEST(Geotiff, SaysWhereItsSamplesLieAndThatTheyArePoints) {
    const TemporaryFolder folder;
    io::write_geotiff(image_of(sample_heights()), folder.file("t.tif"));
    TIFFSetWarningHandler(nullptr);  // of tags that libtiff does not know
    const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(folder.file("t.tif").c_str(), "r"),
                                                      TIFFClose);
    ASSERT_NE(tiff, nullptr);
    std::uint16_t count = 0;
    const double* numbers = nullptr;
    ASSERT_EQ(TIFFGetField(tiff.get(), 33550, &count, &numbers), 1);
    ASSERT_EQ(count, 3);
    EXPECT_EQ(numbers[0], 2.0);
    EXPECT_EQ(numbers[1], 3.0);
    ASSERT_EQ(TIFFGetField(tiff.get(), 33922, &count, &numbers), 1);
    ASSERT_EQ(count, 6);
    EXPECT_EQ(std::vector<double>(numbers, numbers + 6),
              (std::vector<double>{0.0, 0.0, 0.0, 1000.0, -500.0 + 207.0, 0.0}));
    const std::uint16_t* keys = nullptr;
    ASSERT_EQ(TIFFGetField(tiff.get(), 34735, &count, &keys), 1);
    std::map<int, int> values;
    for (int key = 1; key <= keys[3]; ++key) values[keys[4 * key]] = keys[4 * key + 3];
    EXPECT_EQ(values[1024], 1);      // projected
    EXPECT_EQ(values[1025], 2);      // PixelIsPoint
    EXPECT_EQ(values[3072], 32767);  // user-defined
    EXPECT_EQ(values[3076], 9001);   // metres
    std::uint16_t tag = 0;
    TIFFGetField(tiff.get(), TIFFTAG_PREDICTOR, &tag);
    EXPECT_EQ(tag, PREDICTOR_FLOATINGPOINT);
    TIFFGetField(tiff.get(), TIFFTAG_COMPRESSION, &tag);
    EXPECT_EQ(tag, COMPRESSION_ADOBE_DEFLATE);
}

TEST(Geotiff, NamesItsSubject) {
    const TemporaryFolder folder;
    const std::string path = folder.file("t.tif");
    io::write_geotiff(image_of(sample_heights()), path);
    const auto provenance = io::find_provenance(io::read_geotiff_header(path), path);
    ASSERT_TRUE(provenance);
    EXPECT_EQ(provenance->kind, "terrain");
    EXPECT_EQ(provenance->domain, kPlace);
    EXPECT_TRUE(test::says(provenance->text, "[terrain]"));
}

TEST(Geotiff, DamagedAndForeignFilesAreErrors) {
    const TemporaryFolder folder;
    const std::string path = folder.file("t.tif");
    io::write_geotiff(image_of(sample_heights()), path);
    const std::string bytes = test::read_bytes(path);
    const auto rejects = [&](const std::string& content) {
        folder.write("t.tif", content);
        EXPECT_THROW(io::read_geotiff_header(path), Error) << content.size();
        EXPECT_THROW(read_rows(path), Error) << content.size();
    };
    for (std::size_t size = 0; size < bytes.size() - 100; size += 997)
        rejects(bytes.substr(0, size));
    rejects(std::string("MM\0*", 4) + std::string(40, '\xff'));
    rejects(std::string("II*\0\x08\0\0\0\0\0\0\0\0\0", 14));  // no entry at all
    folder.write("t.tif", bytes);
    const Domain other{{0.0, 0.0}, {1.0, 1.0}, {kRows, kColumns}, false};
    EXPECT_THROW(io::read_geotiff(path, other, [](std::string_view) {}), Error);
    EXPECT_THROW(io::write_geotiff(image_of({}), path), Error);
    const auto full = [] { io::write_geotiff(image_of(sample_heights()), "/dev/full"); };
    EXPECT_TRUE(test::says(test::message_of(full), "No space left"));
}

TEST(ProductImage, HeightsAreFloatsWhereNothingElseMovesTheSurface) {
    const Product* const height[] = {&find_product("height")};
    const Product* const normal[] = {&find_product("normal")};
    const auto type = [](std::span<const Product* const> products, io::ProductLayout layout) {
        return io::product_image(products, layout, {}, 32).planes.front().type;
    };
    EXPECT_EQ(type(height, {}), io::PixelType::half_float);
    EXPECT_EQ(type(height, {.full_heights = true}), io::PixelType::full_float);
    EXPECT_EQ(type(normal, {.full_heights = true}), io::PixelType::half_float);
    EXPECT_EQ(type(height, {.type = io::PixelType::half_float, .full_heights = true}),
              io::PixelType::half_float);
}

}  // namespace
}  // namespace ocean
