// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: each format says by one parser which products its files can hold, and why not others.
#include <gtest/gtest.h>

#include "formats/formats.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/error.hpp"
#include "ocean/sea_subject.hpp"
#include "ocean/seafile.hpp"

namespace ocean {
namespace {

/// Returns the products of the plan, or the error.
std::string asked(const std::string& extension, const std::string& list) {
    BakeOptions options;
    options.source = "preset:beaufort_4";
    options.output = "sea" + extension;
    options.resolution = "32";
    options.of_format["products"] = list;
    options.open_subject = [](const std::string&) {
        return parse_sea_subject(find_preset("beaufort_4").toml, "beaufort_4");
    };
    try {
        const BakePlan plan = make_bake_plan(options, standard_catalogue());
        std::string names;
        for (const Product* product : plan.format->products(plan)) {
            names += (names.empty() ? "" : ",") + std::string(product->name);
        }
        return names.empty() ? "nothing" : names;
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(ProductChoice, IsTheListOrTheDefaultOfTheFormat) {
    EXPECT_EQ(asked(".exr", ""), "displacement,normal,foam");
    EXPECT_EQ(asked(".exr", " cover, slope"), "cover,slope");
    EXPECT_EQ(asked(".ply", ""), "normal,foam,velocity");
    EXPECT_EQ(asked(".ply", "position"), "nothing");
    EXPECT_EQ(asked(".ply", "spray"), "spray");
}

TEST(ProductChoice, SaysWhatAnImageIsNotOf) {
    EXPECT_TRUE(asked(".exr", "spray").starts_with("unknown product 'spray'; known: height, "));
    EXPECT_EQ(asked(".exr", "foam,foam"), "--products foam,foam: foam is there twice");
}

TEST(ProductChoice, SaysWhatAMeshDoesNotHave) {
    EXPECT_EQ(asked(".ply", "normal,slope"),
              "--products normal,slope: a mesh has no slope; allowed are position, "
              "normal,foam,velocity");
    EXPECT_TRUE(asked(".ply", "position,foam").starts_with("unknown product 'position'; "));
    EXPECT_EQ(asked(".ply", "foam, spray"),
              "--products foam, spray: spray is points of its own; allowed is --products spray "
              "alone");
}

TEST(ProductChoice, SaysWhatAVolumeIsOf) {
    if (standard_catalogue().find_format(".vdb") == nullptr) GTEST_SKIP() << "not built";
    EXPECT_EQ(asked(".vdb", "density,surface"), "surface,density");
    EXPECT_EQ(asked(".vdb", "spray"), "spray");
    for (const std::string list : {"foam", "vel,vel", "surface,,vel", "surface,vel,density,vel"}) {
        EXPECT_EQ(
            asked(".vdb", list),
            "--products " + list + ": of a volume allowed are surface, vel and density, each once");
    }
}

}  // namespace
}  // namespace ocean
