// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: read_exr_header and read_exr_layout return the content of any bytes or throw Error
// bad_file, and allocate no more than the file's size; the layout is read back as written.

#include "ocean/error.hpp"
#include "ocean/internal/io/product_image.hpp"
#include "ocean/io/exr.hpp"
#include "refusal.hpp"
#include "sample_surface.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

std::string good_file(const TemporaryFolder& folder) {
    const Surface surface = test::sample_surface(32);
    const Product* const products[] = {&find_product("height")};
    io::write_exr(
        io::product_image(products, {}, {.kind = "sea", .text = "libocean = 1\n"}, surface),
        folder.file("good.exr"), io::ExrCompression::zip);
    return test::read_bytes(folder.file("good.exr"));
}

std::string refusal(const std::string& path) {
    test::message_of(ErrorKind::bad_file, [&] { io::read_exr_layout(path); });
    return test::message_of(ErrorKind::bad_file, [&] { io::read_exr_header(path); });
}

TEST(ExrHeader, ErrorsHaveTheReason) {
    const TemporaryFolder folder;
    const std::string bytes = good_file(folder);
    EXPECT_TRUE(test::says(refusal(folder.file("none.exr")), "cannot open"));
    EXPECT_TRUE(test::says(refusal(folder.path()), "directory"));
    const auto expect = [&folder](const std::string& content, const char* words) {
        EXPECT_TRUE(test::says(refusal(folder.write("bad.exr", content)), words));
    };
    expect("", "ends inside");
    expect("P5 16 16 255 and pixels", "not an OpenEXR file");
    expect(bytes.substr(0, 200), "ends inside");
    std::string foreign = bytes;
    for (std::size_t at = 0; (at = foreign.find("ocean:", at)) != std::string::npos;) {
        foreign[at] = 'O';
    }
    expect(foreign, "not written by libocean");
    // A claim of two gigabytes for the first attribute.
    std::string greedy = bytes;
    const std::size_t size_at = 8 + std::string("channels").size() + 1 + sizeof "chlist";
    greedy.replace(size_at, 4, "\xff\xff\xff\x7f");
    expect(greedy, "ends inside");
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
    folder.write("other.exr", other);
    EXPECT_EQ(io::read_exr_layout(path).compression, std::nullopt);
    for (const std::size_t corner : {0, 4, 8, 12}) {
        other = bytes;
        const std::size_t low_byte = value_of("dataWindow", "box2i") + corner;
        other[low_byte] ^= 1;
        folder.write("other.exr", other);
        EXPECT_NE(io::read_exr_layout(path).samples, (std::array{64, 64})) << corner;
        other[low_byte + 3] ^= 0x40;  // too large, or negative
        folder.write("other.exr", other);
        EXPECT_THROW(io::read_exr_layout(path), Error) << corner;
    }
    other = bytes;
    other[value_of("channels", "chlist") + 2] = 0;  // "Y\0", then the type: whole numbers
    folder.write("other.exr", other);
    EXPECT_THROW(io::read_exr_layout(path), Error);
}

TEST(ExrHeader, SurvivesEveryTruncationAndManyMutations) {
    const TemporaryFolder folder;
    const std::string bytes = good_file(folder);
    const std::size_t header = bytes.find("screenWindowWidth") + 40;
    ASSERT_LT(header, bytes.size());
    for (std::size_t size = 0; size < header; size += 3) {
        refusal(folder.write("bad.exr", bytes.substr(0, size)));
    }
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        std::string mutant = bytes;
        for (int change = 0; change < 4; ++change) {
            mutant[random() % header] = static_cast<char>(random());
        }
        refusal(folder.write("bad.exr", mutant));
    }
}

}  // namespace
}  // namespace ocean
