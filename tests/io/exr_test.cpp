// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: EXR bytes do not depend on the run or the thread count; the strings that were written
// come back; unfit requests and full disks are errors. What other readers see: test_exr_readers.py.
#include <gtest/gtest.h>

#include <map>

#include "ocean/error.hpp"
#include "ocean/io.hpp"
#include "sample_surface.hpp"

namespace ocean {
namespace {

using test::read_bytes;
using test::TemporaryFolder;

const std::string kSea = "libocean = 1\n# \xc3\xa4 sea, with a second line\n";

TEST(Exr, SameBytesForAnyThreadCountAndRun) {
    const TemporaryFolder folder;
    const Surface surface = test::sample_surface(512);
    const io::Frame frame{surface, kSea, 7, surface.time()};
    for (const auto compression : {io::ExrCompression::zip, io::ExrCompression::piz}) {
        std::string first;
        for (const int threads : {1, 2, 4, 0, 1}) {
            io::ExrOptions options;
            options.threads = threads;
            options.compression = compression;
            io::write_exr(frame, find_product("displacement"), folder.file("a.exr"), options);
            const std::string bytes = read_bytes(folder.file("a.exr"));
            if (first.empty()) first = bytes;
            EXPECT_TRUE(bytes == first) << threads << " threads";
        }
        EXPECT_GT(first.size(), 100000u);
    }
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Exr, HeaderStringsComeBack) {
    const TemporaryFolder folder;
    const Surface surface = test::sample_surface(32, 0.1);
    const io::Frame frame{surface, kSea, -3, 0.1};
    io::ExrOptions options;
    options.axes = io::Axes::yup;
    io::write_exr(frame, find_product("velocity"), folder.file("a.exr"), options);
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
    const io::Frame frame{surface, kSea, 12, 0.5, Backend::radix2};
    const Product* const products[] = {&find_product("displacement"), &find_product("slope")};
    const Lattice map{surface.resolution(), surface.period()};
    for (const bool layered : {false, true}) {
        for (const auto type : {io::PixelType::automatic, io::PixelType::half_float}) {
            io::ExrOptions options;
            options.type = type;
            options.compression = io::ExrCompression::piz;
            const std::span fields(products, layered ? 2 : 1);
            if (layered) {
                io::write_exr_layered(frame, fields, folder.file("a.exr"), options);
            } else {
                io::write_exr(frame, *fields[0], folder.file("a.exr"), options);
            }
            const std::string header = io::exr_header_bytes(
                {kSea, 12, 0.5, Backend::radix2, map, fields, layered}, options);
            const std::string bytes = read_bytes(folder.file("a.exr"));
            EXPECT_GT(header.size(), kSea.size());
            EXPECT_TRUE(bytes.starts_with(header));
        }
    }
}

// Without compression the pixels lie in the file as they are decoded, eight bytes before each row.
TEST(Exr, DecodesEveryPixelOfItsOwnFiles) {
    const TemporaryFolder folder;
    const Surface surface = test::sample_surface(512);
    const Product* const products[] = {&find_product("normal")};
    const Lattice map{surface.resolution(), surface.period()};
    const io::Frame frame{surface, kSea, 1, 0.0};
    std::string decoded[2], raw;
    for (const auto codec : {io::ExrCompression::none, io::ExrCompression::zip}) {
        io::ExrOptions options;
        options.compression = codec;
        io::write_exr(frame, *products[0], folder.file("a.exr"), options);
        const std::string header =
            io::exr_header_bytes({kSea, 1, 0.0, Backend::cpu, map, products, false}, options);
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

TEST(Exr, DamageAndOtherHeadersAreNotRead) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.exr");
    const Surface surface = test::sample_surface(64);
    const Product* const products[] = {&find_product("displacement")};
    const Lattice map{surface.resolution(), surface.period()};
    io::write_exr({surface, kSea, 1, 0.0}, *products[0], path, {});
    const std::string bytes = read_bytes(path);
    const auto refused = [&](const std::string& content, int number) {
        std::ofstream(path, std::ios::binary) << content;
        const std::string header =
            io::exr_header_bytes({kSea, number, 0.0, Backend::cpu, map, products, false}, {});
        try {
            io::read_exr_pixels(path, header, 1, [](std::string_view) {});
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::bad_file);
            return true;
        }
        return false;
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
    const TemporaryFolder folder;
    const Surface surface(Lattice{32, 10.0}, 0.0, {Channel::height});
    const io::Frame frame{surface, kSea, 1, 0.0};
    EXPECT_THROW(io::write_exr(frame, find_product("normal"), folder.file("a.exr"), {}), Error);
    EXPECT_THROW(io::write_exr_layered(frame, {}, folder.file("a.exr"), {}), Error);
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(Exr, FullDiskIsAnOutputError) {
    // Small enough that only the flush finds out, and large enough that a write does.
    for (const int n : {32, 512}) {
        const Surface surface = test::sample_surface(n);
        const io::Frame frame{surface, kSea, 1, 0.0};
        try {
            io::write_exr(frame, find_product("displacement"), "/dev/full", {});
            ADD_FAILURE() << "no error for " << n;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::output);
            EXPECT_NE(std::string(error.what()).find("No space left on device"), std::string::npos)
                << error.what();
        }
    }
}

TEST(Exr, NamesOfAxesAndCompression) {
    for (const char* name : {"tnb", "zup", "yup"}) {
        EXPECT_EQ(io::axes_name(io::find_axes(name)), name);
    }
    EXPECT_THROW(io::find_axes("xyz"), Error);
    EXPECT_EQ(io::find_exr_compression("pxr24"), io::ExrCompression::pxr24);
    for (const char* lossy : {"b44", "b44a", "dwaa", "dwab"}) {
        try {
            io::find_exr_compression(lossy);
            ADD_FAILURE() << lossy;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("lossy"), std::string::npos);
            EXPECT_NE(std::string(error.what()).find("allowed: none, rle"), std::string::npos);
        }
    }
    EXPECT_THROW(io::find_exr_compression("zip2"), Error);
}

}  // namespace
}  // namespace ocean
