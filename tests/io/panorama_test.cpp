// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: read_exr_panorama returns the written light without negative values and NaN, and throws
// Error bad_file for any other bytes.
#include "ocean/internal/io/panorama.hpp"

#include "ocean/io/exr.hpp"
#include "refusal.hpp"
#include "sample_surface.hpp"

namespace ocean {
namespace {

using namespace std::string_literals;
using test::TemporaryFolder;

struct Written {
    std::vector<float> r, g, b;
};

/// Red grows to the right, green to the top.
Written write(const std::string& path, int width, int height, const char* names = "RGB",
              io::PixelType type = io::PixelType::full_float) {
    Written written;
    for (const auto [i, j] : test::pairs(width, height)) {
        written.r.push_back(static_cast<float>(i));
        written.g.push_back(static_cast<float>(j));
        written.b.push_back(0.5f);
    }
    written.b[0] = -3.0f;
    written.b[1] = std::numeric_limits<float>::quiet_NaN();
    written.b[2] = std::numeric_limits<float>::infinity();
    io::Image image{.width = width, .height = height, .planes = {}};
    for (const auto* plane : {&written.r, &written.g, &written.b}) {
        image.planes.push_back({std::string(1, *names++), type, *plane});
    }
    io::write_exr(image, path, io::ExrCompression::zip);
    return written;
}

std::string refusal(const std::string& path) {
    return test::message_of(ErrorKind::bad_file, [&] { io::read_exr_panorama(path); });
}

TEST(ExrPanorama, ReturnsTheWrittenLight) {
    const TemporaryFolder folder;
    for (const io::PixelType type : {io::PixelType::full_float, io::PixelType::half_float}) {
        const Written written = write(folder.file("a.exr"), 64, 32, "RGB", type);
        const io::Panorama read = io::read_exr_panorama(folder.file("a.exr"));
        ASSERT_EQ(read.width, 64);
        ASSERT_EQ(read.height, 32);
        for (std::size_t i = 0; i < written.r.size(); ++i) {
            EXPECT_EQ(read.rgb[3 * i], written.r[i]);
            EXPECT_EQ(read.rgb[3 * i + 1], written.g[i]);
            EXPECT_EQ(read.rgb[3 * i + 2], i < 2 ? 0.0f : i == 2 ? 65504.0f : 0.5f);
        }
    }
}

TEST(ExrPanorama, ErrorsHaveTheReason) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.exr");
    EXPECT_TRUE(test::says(refusal(folder.file("none.exr")), "cannot open"));
    write(path, 32, 32);
    EXPECT_TRUE(test::says(refusal(path), "32 x 32; a panorama is twice as wide as high"));
    write(path, 6, 3);
    EXPECT_TRUE(test::says(refusal(path), "6 x 3"));
    write(path, 64, 32, "RGZ");
    EXPECT_TRUE(test::says(refusal(path), "no channel B"));

    write(path, 64, 32);
    const std::string good = test::read_bytes(path);
    const auto with = [&](const std::string& bytes) {
        return refusal(folder.write("a.exr", bytes));
    };
    EXPECT_FALSE(with(good.substr(0, good.size() - 100)).empty());
    std::string deep = good;
    deep[5] = '\x08';
    EXPECT_TRUE(test::says(with(deep), "deep"));
    // A window of 2^31 x 2^30 samples in a file of a few kilobytes.
    std::string huge = good;
    const std::size_t window = huge.find("dataWindow\0box2i\0"s) + 17 + 4;
    huge.replace(window + 8, 8, std::string("\xff\xff\xff\x7f\xff\xff\xff\x3f", 8));
    EXPECT_TRUE(test::says(with(huge), "2147483648 x 1073741824"));
}

TEST(ExrPanorama, AnyBytesAreAPanoramaOrAnError) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.exr");
    write(path, 16, 8);
    const std::string good = test::read_bytes(path);
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        std::string bytes = good;
        for (int flips = 1 + i % 4; flips > 0; --flips) {
            bytes[random() % bytes.size()] = static_cast<char>(random());
        }
        folder.write("a.exr", bytes);
        test::message_of(ErrorKind::bad_file, [&] {
            for (const float light : io::read_exr_panorama(path, 1).rgb) {
                ASSERT_TRUE(light >= 0.0f && light <= 65504.0f);
            }
        });
    }
}

}  // namespace
}  // namespace ocean
