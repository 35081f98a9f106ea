// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: chunks of a stage that are baked concurrently leave the files and the manifest of one
// bake of all frames, in any order of their starts and ends; a chunk that fails leaves the entries
// of the others unchanged.

#include <stdexcept>
#include <tuple>

#include "bakes.hpp"
#include "manifest.hpp"
#include "sha256.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

void bake_chunk(const TemporaryFolder& folder, const std::string& frames, BakeHost& host) {
    run_bake(
        make_bake_plan(test::sea_bake(folder.file("sea.usda"), frames, {{"products", "position"}}),
                       standard_catalogue()),
        host);
}

/// Bakes the chunk of another machine after `writes` of its own writes; the first one is that of
/// the shared files.
struct Interleaved : BakeHost {
    const TemporaryFolder& folder;
    std::string other;
    int writes_before = 1;
    bool leaves = false;  // after its first frame

    Interleaved(const TemporaryFolder& in, std::string frames, int writes)
        : folder(in), other(std::move(frames)), writes_before(writes) {}
    void run_uninterrupted(const std::function<void()>& write) override {
        write();
        if (--writes_before != 0) return;
        BakeHost silent;
        bake_chunk(folder, other, silent);
    }
    void frame_baked(int, double, const std::vector<std::string>&) override {
        if (leaves) throw std::runtime_error("the host left");
    }
};

std::map<std::string, std::string> contents(const TemporaryFolder& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        files[entry.path().filename().string()] = test::read_bytes(entry.path().string());
    }
    return files;
}

TEST(Chunks, BakedConcurrentlyLeaveTheFilesOfOneBake) {
    const TemporaryFolder whole;
    BakeHost silent;
    bake_chunk(whole, "1-4", silent);
    for (const auto& [begun_first, other, writes_before] :
         {std::tuple("3-4", "1-2", 1), std::tuple("1-2", "3-4", 1), std::tuple("3-4", "1-2", 2)}) {
        const TemporaryFolder parts;
        Interleaved host(parts, other, writes_before);
        bake_chunk(parts, begun_first, host);
        const auto baked = contents(parts);
        for (const auto& [name, content] : contents(whole)) {
            ASSERT_TRUE(baked.contains(name)) << name;
            EXPECT_TRUE(baked.at(name) == content) << name << " of " << begun_first << " first";
        }
    }
}

TEST(Chunks, KeepTheirEntriesWhenAnotherOneFails) {
    const TemporaryFolder folder;
    Interleaved host(folder, "1-2", 2);
    host.leaves = true;
    EXPECT_THROW(bake_chunk(folder, "3-4", host), std::runtime_error);
    const auto files = contents(folder);
    const ManifestEntries entries = parse_manifest(files.at("sea.manifest.json"));
    EXPECT_EQ(entries.size(), files.size() - 1);
    for (const auto& [name, entry] : entries) {
        EXPECT_EQ(entry.sha256, sha256_hex(files.at(name))) << name;
    }
    EXPECT_EQ(entries.at("sea.clips.usda").frame, 1);
}

}  // namespace
}  // namespace ocean
