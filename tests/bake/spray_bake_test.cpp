// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: spray is baked in order of its frames, on the sea's own lattice for any resolution; a
// file is kept for its own settings only; the forecast is an upper bound.

#include "bakes.hpp"
#include "ocean/internal/bake/estimate.hpp"
#include "ocean/internal/bake/existing_frames.hpp"
#include "ocean/io/mesh.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

BakeOptions spray_bake(const TemporaryFolder& folder) {
    BakeOptions options = test::sea_bake(folder.file("s.####.ply"), "1-2",
                                         {{"products", "spray"}, {"spray-lifetime", "0.2"}});
    options.source = "preset:beaufort_8";
    options.resolution = "";
    options.threads = 2;
    options.open_subject = [](const std::string&) {
        Sea sea = parse_sea(find_preset("beaufort_8").toml, "beaufort_8", "");
        sea.parameters.grid.resolution = 64;
        sea.parameters.grid.patch_size = 150.0;
        return make_subject(std::move(sea));
    };
    return options;
}

BakePlan plan_of(const BakeOptions& options) {
    return make_bake_plan(options, standard_catalogue());
}

std::string content_of(const BakeOptions& options) {
    test::bake(options);
    std::string all;
    for (const BakeFile& file : files_that_may_exist(plan_of(options)))
        all += test::read_bytes(file.path);
    return all;
}

TEST(SprayBake, IsSequentialAndOnTheSeasOwnLattice) {
    const TemporaryFolder folder;
    BakeOptions options = spray_bake(folder);
    const BakePlan plan = plan_of(options);
    EXPECT_EQ(share_work(plan).frames_at_a_time, 1);
    EXPECT_EQ(plan.maps.resolutions, std::vector<int>{64});
    const std::string expected = content_of(options);
    for (const char* resolution : {"32", "512"}) {
        options.resolution = resolution;
        EXPECT_EQ(content_of(options), expected);
    }
    EXPECT_EQ(plan_of(options).maps.resolutions, std::vector<int>{64});
}

TEST(SprayBake, HasARecipeOfItsSettings) {
    const TemporaryFolder folder;
    const BakeOptions defaults = spray_bake(folder);
    const auto recipe = [](const BakeOptions& options) {
        const BakePlan plan = plan_of(options);
        return plan.format->recipe(plan, plan.format->files(plan, 1).front());
    };
    const std::string expected = recipe(defaults);
    EXPECT_EQ(recipe(defaults), expected);
    const std::pair<const char*, const char*> kOther[] = {
        {"spray-lifetime", "0.3"}, {"spray-density", "2"}, {"spray-most", "10"}, {"axes", "yup"}};
    for (const auto& [name, value] : kOther) {
        BakeOptions other = defaults;
        other.format_options[name] = value;
        EXPECT_NE(recipe(other), expected) << name;
        EXPECT_NE(content_of(other), content_of(defaults)) << name;
        // The header has all settings.
        content_of(other);
        BakeOptions again = spray_bake(folder);
        again.format_options.clear();
        again.source.clear();
        again.from = folder.file("s.0001.ply");
        again.open_subject = [](const std::string& path) {
            return parse_sea_subject(io::read_ply_header(path).front().text, path);
        };
        EXPECT_EQ(recipe(again), recipe(other)) << name;
    }
}

TEST(SprayBake, FitsIntoItsForecast) {
    const TemporaryFolder folder;
    for (const char* most : {"1000000", "30"}) {
        BakeOptions options = spray_bake(folder);
        options.format_options["spray-density"] = "10";
        options.format_options["spray-most"] = most;
        const BakeForecast before = forecast_bake(plan_of(options));
        const std::size_t bytes = content_of(options).size();
        EXPECT_LE(bytes, before.bytes) << most;
        EXPECT_GE(8 * bytes, before.bytes) << most;
    }
}

TEST(SprayBake, OfARegionWithAHullIsSplitLikeOthers) {
    const TemporaryFolder folder;
    BakeOptions options = spray_bake(folder);
    options.open_subject = [](const std::string&) {
        Sea sea = parse_sea(find_preset("beaufort_8").toml, "beaufort_8", "");
        sea.parameters.grid.resolution = 64;
        sea.parameters.grid.patch_size = 150.0;
        Hull& hull = sea.parameters.hulls.emplace_back();
        hull.wake_resolution = 64;
        auto track = std::make_shared<HullTrack>();
        track->rows = {{-20.0, 880.0, 0.0}, {20.0, 1120.0, 0.0}};
        hull.track = track;
        return make_region_subject(std::move(sea),
                                   {.origin = {950.0, -40.0}, .size = {120.0, 80.0}, .cell = 2.0});
    };
    const BakeForecast before = forecast_bake(plan_of(options));
    const std::string expected = content_of(options);
    EXPECT_GT(expected.size(), 4000u);
    EXPECT_LE(expected.size(), before.bytes);
    std::string split;
    for (const char* frame : {"2", "1"}) {
        options.frames = frame;
        split.insert(0, content_of(options));
    }
    EXPECT_EQ(split, expected);
}

TEST(SprayBake, IsRefusedBesideOtherProducts) {
    const TemporaryFolder folder;
    const auto refused = [&](const char* products) {
        BakeOptions options = spray_bake(folder);
        options.format_options["products"] = products;
        EXPECT_THROW(plan_of(options), Error) << products;
    };
    refused("spray,normal");
    refused("normal, spray");
    refused("normal");  // with a lifetime of spray
    BakeOptions mesh = spray_bake(folder);
    mesh.format_options = {{"products", "normal"}};
    EXPECT_FALSE(plan_of(mesh).is_sequential());
}

}  // namespace
}  // namespace ocean
