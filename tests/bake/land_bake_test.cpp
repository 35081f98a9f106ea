// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: plan and bake of a land compute it once, whatever the plan needs of it, and a subject
// that is changed shows the change.

#include "bakes.hpp"
#include "ocean/terrainfile.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

constexpr const char* kStreams =
    "libocean = 1\n[terrain]\nkind = \"placed\"\nresolution = 64\npatch_size = 640.0\nrms = 20.0\n"
    "[terrain.stream]\nslope = 0.6\nhillslope_area = 600.0\n";

std::unique_ptr<Subject> streamed_land() {
    return parse_terrain_subject(kStreams, "streams");
}

/// A bake and its host, which counts how often the function of the land is begun.
struct LandBake : BakeHost {
    TemporaryFolder folder;
    BakeOptions options;
    int builds = 0;

    LandBake(const std::string& output, const test::FormatOptions& format_options) {
        options.source = "streams";
        options.output = folder.file(output);
        options.threads = 1;
        options.format_options = format_options;
        options.open_subject = [](const std::string&) { return streamed_land(); };
        options.build_progress = build_progress();
    }
    std::function<void(std::string_view, double)> build_progress() override {
        return [this](std::string_view work, double share) {
            builds += work == "waves" && share == 0.0 ? 1 : 0;
        };
    }
};

TEST(LandBake, ComputesItsLandOnce) {
    const std::map<std::string, test::FormatOptions> outputs = {
        {"land.exr", {}},
        {"land.vdb", {}},
        {"land.ply", {{"lod", "300,300,60"}}},
        {"land.usda", {{"lod", "300,300,60"}}}};
    for (const auto& [output, format_options] : outputs) {
        if (standard_catalogue().find_format(output.substr(4)) == nullptr) continue;  // not built
        LandBake land(output, format_options);
        run_bake(make_bake_plan(land.options, standard_catalogue()), land);
        EXPECT_EQ(land.builds, 1) << output;
    }
}

TEST(LandBake, AnExplicitBoxNeedsNoLandForItsPlan) {
    if (standard_catalogue().find_format(".vdb") == nullptr) GTEST_SKIP() << "without OpenVDB";
    LandBake land("land.vdb", {{"box", "0,0,-50,640,640,200"}});
    make_bake_plan(land.options, standard_catalogue());
    EXPECT_EQ(land.builds, 0);
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
