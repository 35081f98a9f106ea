// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: read_exr_header and read_exr_layout return the content of any bytes or throw Error
// bad_file, and allocate no more than the file's size; the layout is read back as written.
#include <gtest/gtest.h>

#include <random>

#include "ocean/error.hpp"
#include "ocean/internal/io/product_image.hpp"
#include "ocean/io/exr.hpp"
#include "sample_surface.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

void spit(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

std::string good_file(const TemporaryFolder& folder) {
    const Surface surface = test::sample_surface(32);
    const Product* const products[] = {&find_product("height")};
    io::write_exr(
        io::product_image(products, {}, {.kind = "sea", .text = "libocean = 1\n"}, surface),
        folder.file("good.exr"), io::ExrCompression::zip);
    return test::read_bytes(folder.file("good.exr"));
}

std::string refusal(const std::string& path) {
    try {
        io::read_exr_layout(path);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_file);
    }
    try {
        io::read_exr_header(path);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_file);
        return error.what();
    }
    return "";
}

TEST(ExrHeader, ErrorsHaveTheReason) {
    const TemporaryFolder folder;
    const std::string bytes = good_file(folder), path = folder.file("bad.exr");
    EXPECT_NE(refusal(folder.file("none.exr")).find("cannot open"), std::string::npos);
    EXPECT_NE(refusal(folder.path()).find("directory"), std::string::npos);
    spit(path, "");
    EXPECT_NE(refusal(path).find("ends inside"), std::string::npos);
    spit(path, "P5 16 16 255 and pixels");
    EXPECT_NE(refusal(path).find("not an OpenEXR file"), std::string::npos);
    spit(path, bytes.substr(0, 200));
    EXPECT_NE(refusal(path).find("ends inside"), std::string::npos);
    std::string foreign = bytes;
    for (std::size_t at = 0; (at = foreign.find("ocean:", at)) != std::string::npos;) {
        foreign[at] = 'O';
    }
    spit(path, foreign);
    EXPECT_NE(refusal(path).find("not written by libocean"), std::string::npos);
    // A claim of two gigabytes for the first attribute.
    std::string greedy = bytes;
    const std::size_t size_at = 8 + std::string("channels").size() + 1 + sizeof "chlist";
    greedy.replace(size_at, 4, "\xff\xff\xff\x7f");
    spit(path, greedy);
    EXPECT_NE(refusal(path).find("ends inside"), std::string::npos);
}

TEST(ExrHeader, LayoutIsReadBackAsWritten) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.exr");
    const Surface surface = test::sample_surface(64);
    const Product* const products[] = {&find_product("displacement"), &find_product("normal")};
    const io::Image image = io::product_image(products, {.layered = true},
                                              {.kind = "sea", .text = "libocean = 1\n"}, surface);
    const io::Image floats = io::product_image(
        products, {.type = io::PixelType::full_float, .layered = true}, {}, surface);
    for (const char* codec : {"none", "rle", "zips", "zip", "piz", "pxr24"}) {
        const io::ExrCompression compression = io::find_exr_compression(codec);
        EXPECT_EQ(io::exr_compression_name(compression), codec);
        io::write_exr(image, path, compression);
        const io::ExrLayout layout = io::read_exr_layout(path);
        EXPECT_EQ(layout.samples, (std::array{64, 64}));
        EXPECT_EQ(layout.compression, compression);
        EXPECT_EQ(layout.channels, io::exr_channels(image));
        EXPECT_NE(layout.channels, io::exr_channels(floats));
    }
}

// A codec that we lack is reported as absent; an image that is not square is refused.
TEST(ExrHeader, ReadsTheLayoutOfForeignFiles) {
    const TemporaryFolder folder;
    const std::string bytes = good_file(folder), path = folder.file("other.exr");
    const auto value_of = [&bytes](std::string name, std::string type) {
        const std::string key = name + '\0' + type + '\0';
        return bytes.find(key) + key.size() + 4;
    };
    std::string other = bytes;
    other[value_of("compression", "compression")] = 8;
    spit(path, other);
    EXPECT_EQ(io::read_exr_layout(path).compression, std::nullopt);
    for (const std::size_t corner : {0, 4, 8, 12}) {
        other = bytes;
        const std::size_t low_byte = value_of("dataWindow", "box2i") + corner;
        other[low_byte] ^= 1;
        spit(path, other);
        EXPECT_NE(io::read_exr_layout(path).samples, (std::array{64, 64})) << corner;
        other[low_byte + 3] ^= 0x40;  // too large, or negative
        spit(path, other);
        EXPECT_THROW(io::read_exr_layout(path), Error) << corner;
    }
    other = bytes;
    other[value_of("channels", "chlist") + 2] = 0;  // "Y\0", then the type: whole numbers
    spit(path, other);
    EXPECT_THROW(io::read_exr_layout(path), Error);
}

TEST(ExrHeader, SurvivesEveryTruncationAndManyMutations) {
    const TemporaryFolder folder;
    const std::string bytes = good_file(folder), path = folder.file("bad.exr");
    const std::size_t header = bytes.find("screenWindowWidth") + 40;
    ASSERT_LT(header, bytes.size());
    for (std::size_t size = 0; size < header; size += 3) {
        spit(path, bytes.substr(0, size));
        refusal(path);
    }
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        std::string mutant = bytes;
        for (int change = 0; change < 4; ++change) {
            mutant[random() % header] = static_cast<char>(random());
        }
        spit(path, mutant);
        refusal(path);
    }
}

}  // namespace
}  // namespace ocean
