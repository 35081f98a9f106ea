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
            io::write_exr(frame, find_field("displacement"), folder.file("a.exr"), options);
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
    io::write_exr(frame, find_field("velocity"), folder.file("a.exr"), options);
    std::map<std::string, std::string> header;
    for (const auto& [name, value] : io::read_exr_header(folder.file("a.exr"))) {
        header[name] = value;
    }
    EXPECT_EQ(header.size(), 8u);
    EXPECT_EQ(header["ocean:sea"], kSea);
    EXPECT_EQ(header["ocean:frame"], "-3");
    EXPECT_EQ(header["ocean:time"], "0.1");
    EXPECT_EQ(header["ocean:axes"], "yup");
    EXPECT_EQ(header["ocean:period"], "100");
    EXPECT_EQ(header["ocean:field"], "velocity");
    EXPECT_EQ(header["ocean:unit"], "m/s");
    EXPECT_TRUE(header.contains("ocean:version"));
}

TEST(Exr, RefusesChannelsThatWereNotEvaluated) {
    const TemporaryFolder folder;
    const Surface surface(Lattice{32, 10.0}, 0.0, {Channel::height});
    const io::Frame frame{surface, kSea, 1, 0.0};
    EXPECT_THROW(io::write_exr(frame, find_field("normal"), folder.file("a.exr"), {}), Error);
    EXPECT_THROW(io::write_exr_layered(frame, {}, folder.file("a.exr"), {}), Error);
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(Exr, FullDiskIsAnOutputError) {
    // Small enough that only the flush finds out, and large enough that a write does.
    for (const int n : {32, 512}) {
        const Surface surface = test::sample_surface(n);
        const io::Frame frame{surface, kSea, 1, 0.0};
        try {
            io::write_exr(frame, find_field("displacement"), "/dev/full", {});
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
