// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: EXR bytes do not depend on the run or the thread count; strings are read back; invalid
// requests and full disks are errors. test_exr_readers.py reads the files by other programs.

#include "ocean/io/exr.hpp"
#include "ocean/internal/caustics.hpp"
#include "ocean/internal/io/product_image.hpp"
#include "refusal.hpp"
#include "sample_surface.hpp"

namespace ocean {
namespace {

using test::read_bytes;
using test::TemporaryFolder;

using Products = std::vector<const Product*>;

const std::string kSea = "libocean = 1\n# \xc3\xa4 sea, with a second line\n";

io::Provenance label_of(const Surface& surface, int number, const std::string& backend = "cpu") {
    return {.kind = "sea",
            .text = kSea,
            .frame = number,
            .time = surface.time(),
            .domain = Domain::tile(surface.period()),
            .backend = backend};
}

io::Image image_of(const Surface& surface, const std::string& product, int number = 1,
                   const io::ProductLayout& layout = {}) {
    return io::product_image(Products{&find_product(product)}, layout, label_of(surface, number),
                             surface);
}

std::string string_of(const io::Image& image, std::string_view name) {
    for (const io::HeaderString& string : image.header_strings()) {
        if (string.name == name) return string.text;
    }
    return "(missing)";
}

TEST(Exr, SameBytesForAnyThreadCountAndRun) {
    const TemporaryFolder folder;
    const Surface surface = test::sample_surface(512);
    const io::Image image = image_of(surface, "displacement", 7);
    for (const auto compression : {io::ExrCompression::zip, io::ExrCompression::piz}) {
        std::string first;
        for (const int threads : {1, 2, 4, 0, 1}) {
            io::write_exr(image, folder.file("a.exr"), compression, threads);
            const std::string bytes = read_bytes(folder.file("a.exr"));
            if (first.empty()) first = bytes;
            EXPECT_TRUE(bytes == first) << threads << " threads";
        }
        EXPECT_GT(first.size(), 100000u);
    }
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Exr, HeaderStringsAreReadBack) {
    const TemporaryFolder folder;
    const Surface surface = test::sample_surface(32, 0.1);
    io::write_exr(image_of(surface, "velocity", -3, {.axes = io::Axes::yup}), folder.file("a.exr"),
                  io::ExrCompression::zip);
    std::map<std::string, std::string> header;
    for (const auto& [name, value] : io::read_exr_header(folder.file("a.exr"))) {
        header[name] = value;
    }
    EXPECT_EQ(header.size(), 9u);
    EXPECT_EQ(header["ocean:backend"], "cpu");
    EXPECT_EQ(header["ocean:sea"], kSea);
    EXPECT_EQ(header["ocean:frame"], "-3");
    EXPECT_EQ(header["ocean:time"], "0.1");
    EXPECT_EQ(header["ocean:axes"], "yup");
    EXPECT_EQ(header["ocean:period"], "100");
    EXPECT_EQ(header["ocean:field"], "velocity");
    EXPECT_EQ(header["ocean:unit"], "m/s");
    EXPECT_TRUE(header.contains("ocean:version"));
}

TEST(Exr, TheHeaderIsKnownWithoutASurface) {
    const TemporaryFolder folder;
    const Surface surface = test::sample_surface(64, 0.5);
    const io::Provenance label = label_of(surface, 12, "radix2");
    for (const bool layered : {false, true}) {
        for (const std::optional<io::PixelType> type :
             {std::optional<io::PixelType>(), {io::PixelType::half_float}}) {
            const io::ProductLayout layout{.type = type, .layered = layered};
            Products products{&find_product("displacement"), &find_product("slope")};
            products.resize(layered ? 2 : 1);
            io::write_exr(io::product_image(products, layout, label, surface), folder.file("a.exr"),
                          io::ExrCompression::piz);
            const io::Image empty = io::product_image(products, layout, label, 64);
            const std::string header = io::exr_header_bytes(empty, io::ExrCompression::piz);
            const std::string bytes = read_bytes(folder.file("a.exr"));
            EXPECT_GT(header.size(), kSea.size());
            EXPECT_TRUE(bytes.starts_with(header));
            EXPECT_LE(bytes.size(), io::max_exr_bytes(empty, io::ExrCompression::piz));
        }
    }
}

// Without compression the pixels lie in the file as they are decoded, eight bytes before each row.
TEST(Exr, DecodesEveryPixelOfItsOwnFiles) {
    const TemporaryFolder folder;
    const Surface surface = test::sample_surface(512);
    const io::Image image = image_of(surface, "normal");
    std::string decoded[2], raw;
    for (const auto codec : {io::ExrCompression::none, io::ExrCompression::zip}) {
        io::write_exr(image, folder.file("a.exr"), codec);
        const std::string header = io::exr_header_bytes(image, codec);
        std::string& pixels = decoded[codec == io::ExrCompression::zip];
        io::read_exr_pixels(folder.file("a.exr"), header, 2,
                            [&](std::string_view bytes) { pixels += bytes; });
        if (codec != io::ExrCompression::none) continue;
        const std::string bytes = read_bytes(folder.file("a.exr"));
        const std::size_t row = 512 * 3 * 2, table = header.size() + 512 * 8;
        for (std::size_t y = 0; y < 512; ++y) raw += bytes.substr(table + y * (row + 8) + 8, row);
    }
    EXPECT_EQ(raw.size(), 512u * 512u * 6u);
    EXPECT_TRUE(decoded[0] == raw);
    EXPECT_TRUE(decoded[1] == raw);
}

// A picture that is no product and no square is written by the same code.
TEST(Exr, WritesAnyImage) {
    const TemporaryFolder folder;
    const std::vector<float> samples = {1, 2, 3, 4, 5, 6};
    io::Image image{3, 2, {}, {{"Y", io::PixelType::full_float, samples, -2.0f}}, {}};
    image.planes.push_back({.name = "A", .constant = 0.5f});
    image.strings = {{"ocean:field", "mask"}};
    io::write_exr(image, folder.file("a.exr"), io::ExrCompression::none);
    std::vector<float> decoded;
    io::read_exr_pixels(folder.file("a.exr"), io::exr_header_bytes(image, io::ExrCompression::none),
                        1, [&](std::string_view bytes) {
                            const auto* floats = reinterpret_cast<const float*>(bytes.data());
                            decoded.insert(decoded.end(), floats, floats + bytes.size() / 4);
                        });
    // Rows from the top, which is the image's last; A before Y.
    EXPECT_EQ(decoded, (std::vector<float>{.5, .5, .5, -8, -10, -12, .5, .5, .5, -2, -4, -6}));
    EXPECT_EQ(io::read_exr_header(folder.file("a.exr")).front().text, "mask");
}

TEST(Exr, RefusesDamagedFilesAndOtherHeaders) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.exr");
    const Surface surface = test::sample_surface(64);
    io::write_exr(image_of(surface, "displacement"), path, io::ExrCompression::zip);
    const std::string bytes = read_bytes(path);
    const auto refused = [&](const std::string& content, int number) {
        folder.write("a.exr", content);
        const std::string header = io::exr_header_bytes(image_of(surface, "displacement", number),
                                                        io::ExrCompression::zip);
        return !test::message_of(ErrorKind::bad_file, [&] {
                    io::read_exr_pixels(path, header, 1, [](std::string_view) {});
                }).empty();
    };
    EXPECT_FALSE(refused(bytes, 1));
    EXPECT_TRUE(refused(bytes, 2));
    EXPECT_TRUE(refused("", 1));
    for (std::size_t missing = 1; missing < bytes.size(); missing += 997) {
        EXPECT_TRUE(refused(bytes.substr(0, bytes.size() - missing), 1)) << missing;
    }
    std::string flipped = bytes;
    flipped[bytes.size() * 3 / 4] ^= 1;
    EXPECT_TRUE(refused(flipped, 1));
}

TEST(Exr, RefusesChannelsThatWereNotEvaluated) {
    const Surface surface(Lattice{32, 10.0}, 0.0, {Channel::height});
    EXPECT_THROW(image_of(surface, "normal"), Error);
    EXPECT_THROW(io::product_image({}, {.layered = true}, label_of(surface, 1), surface), Error);
}

// A product without channels (kCausticsProduct) is a map that somebody made of the surface.
TEST(Exr, WritesMadeMapsUnchanged) {
    const Surface surface = test::sample_surface(32);
    const Products products{&kCausticsProduct, &find_product("height")};
    std::vector<float> samples(32 * 32, 0.25f);
    io::MadeMap made[] = {{&kCausticsProduct, samples}};
    const io::Provenance label = label_of(surface, 1);
    const io::Image alone =
        io::product_image(std::span(products).first(1), {}, label, surface, made);
    ASSERT_EQ(alone.planes.size(), 1u);
    EXPECT_EQ(alone.planes[0].name, "Y");
    EXPECT_EQ(alone.planes[0].type, io::PixelType::half_float);
    EXPECT_EQ(alone.planes[0].samples.data(), samples.data());
    EXPECT_EQ(string_of(alone, "ocean:field"), "caustics");
    EXPECT_EQ(string_of(alone, "ocean:unit"), "1");
    const io::Image layered = io::product_image(products, {.layered = true}, label, surface, made);
    ASSERT_EQ(layered.planes.size(), 2u);
    EXPECT_EQ(layered.planes[0].name, "caustics.V");
    EXPECT_EQ(io::exr_channels(layered),
              io::exr_channels(io::product_image(products, {.layered = true}, label, 32)));
    EXPECT_THROW(io::product_image(products, {.layered = true}, label, surface), Error);
    made[0].samples = made[0].samples.first(32 * 32 - 1);
    EXPECT_THROW(io::product_image(products, {.layered = true}, label, surface, made), Error);
}

TEST(Exr, FullDiskIsAnOutputError) {
    // Small enough that only the flush finds out, and large enough that a write does.
    for (const int n : {32, 512}) {
        const Surface surface = test::sample_surface(n);
        const std::string message = test::message_of(ErrorKind::output, [&] {
            io::write_exr(image_of(surface, "displacement"), "/dev/full", io::ExrCompression::zip);
        });
        EXPECT_TRUE(test::says(message, "No space left on device")) << n;
    }
}

TEST(Exr, NamesOfAxesAndCompression) {
    for (const char* name : {"tnb", "zup", "yup"}) {
        EXPECT_EQ(io::axes_name(io::find_axes(name)), name);
    }
    EXPECT_THROW(io::find_axes("xyz"), Error);
    EXPECT_EQ(io::find_exr_compression("pxr24"), io::ExrCompression::pxr24);
    for (const char* lossy : {"b44", "b44a", "dwaa", "dwab"}) {
        const std::string message = test::message_of([&] { io::find_exr_compression(lossy); });
        EXPECT_TRUE(test::says(message, "lossy")) << lossy;
        EXPECT_TRUE(test::says(message, "allowed: none, rle"));
    }
    EXPECT_THROW(io::find_exr_compression("zip2"), Error);
}

}  // namespace
}  // namespace ocean
