// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: plan and bake of a land compute it once, whatever the plan needs of it, and a subject
// that is changed shows the change.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bake/run.hpp"
#include "ocean/terrainfile.hpp"
#include "temporary_folder.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

constexpr const char* kStreams =
    "libocean = 1\n[terrain]\nkind = \"placed\"\nresolution = 64\npatch_size = 640.0\nrms = 20.0\n"
    "[terrain.stream]\nslope = 0.6\nhillslope_area = 600.0\n";

std::unique_ptr<Subject> streamed_land() {
    return parse_terrain_subject(kStreams, "streams");
}

/// Counts how often the function of a land is begun.
struct Builds : BakeHost {
    int count = 0;

    std::function<void(std::string_view, double)> build_progress() override {
        return [this](std::string_view work, double share) {
            if (work == "waves" && share == 0.0) ++count;
        };
    }
};

TEST(LandBake, ComputesItsLandOnce) {
    const std::map<std::string, std::map<std::string, std::string>> outputs = {
        {"land.exr", {}},
        {"land.vdb", {}},
        {"land.ply", {{"lod", "300,300,60"}}},
        {"land.usda", {{"lod", "300,300,60"}}}};
    for (const auto& [output, format_options] : outputs) {
        if (output.ends_with(".vdb") && standard_catalogue().find_format(".vdb") == nullptr) {
            continue;
        }
        const TemporaryFolder folder;
        Builds builds;
        BakeOptions options;
        options.source = "streams";
        options.output = folder.file(output);
        options.threads = 1;
        options.format_options = format_options;
        options.open_subject = [](const std::string&) { return streamed_land(); };
        options.build_progress = builds.build_progress();
        run_bake(make_bake_plan(options, standard_catalogue()), builds);
        EXPECT_EQ(builds.count, 1) << output;
    }
}

TEST(LandBake, AnExplicitBoxNeedsNoLandForItsPlan) {
    if (standard_catalogue().find_format(".vdb") == nullptr) GTEST_SKIP() << "without OpenVDB";
    const TemporaryFolder folder;
    Builds builds;
    BakeOptions options;
    options.source = "streams";
    options.output = folder.file("land.vdb");
    options.threads = 1;
    options.format_options = {{"box", "0,0,-50,640,640,200"}};
    options.open_subject = [](const std::string&) { return streamed_land(); };
    options.build_progress = builds.build_progress();
    make_bake_plan(options, standard_catalogue());
    EXPECT_EQ(builds.count, 0);
}

TEST(LandBake, ASubjectThatIsChangedShowsTheChange) {
    const auto heights_of = [](const Subject& subject) {
        const auto maps = subject.open({.threads = 1});
        const Surface map = maps->levels(0.0, {Channel::height}, std::array{64}).front();
        const auto heights = map.channel(Channel::height);
        return std::vector<float>(heights.begin(), heights.end());
    };
    const auto subject = streamed_land();
    const std::vector<float> before = heights_of(*subject);
    subject->set("terrain.stream.seed", "2");
    const std::vector<float> changed = heights_of(*subject);
    EXPECT_NE(changed, before);
    const auto fresh = streamed_land();
    fresh->set("terrain.stream.seed", "2");
    EXPECT_EQ(changed, heights_of(*fresh));
}

}  // namespace
}  // namespace ocean
