// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: all formats have one parser of --products, which names the reason for each refusal.

#include "bakes.hpp"
#include "formats/formats.hpp"

namespace ocean {
namespace {

std::string products_or_error(const std::string& extension, const std::string& list) {
    std::string names;
    const std::string message = test::message_of([&] {
        const BakePlan plan = make_bake_plan(
            test::sea_bake("sea" + extension, "", {{"products", list}}), standard_catalogue());
        for (const Product* product : plan.format->products(plan)) {
            names += (names.empty() ? "" : ",") + std::string(product->name);
        }
        if (names.empty()) names = "nothing";
    });
    return message + names;
}

TEST(ProductChoice, IsTheListOrTheDefaultOfTheFormat) {
    EXPECT_EQ(products_or_error(".exr", ""), "displacement,normal,foam");
    EXPECT_EQ(products_or_error(".exr", " cover, slope"), "cover,slope");
    EXPECT_EQ(products_or_error(".ply", ""), "normal,foam,velocity");
    EXPECT_EQ(products_or_error(".ply", "position"), "nothing");
    EXPECT_EQ(products_or_error(".ply", "spray"), "spray");
}

TEST(ProductChoice, RefusesProductsThatImagesCannotHold) {
    EXPECT_TRUE(
        products_or_error(".exr", "spray").starts_with("unknown product 'spray'; known: height, "));
    EXPECT_EQ(products_or_error(".exr", "foam,foam"), "--products foam,foam: foam is repeated");
}

TEST(ProductChoice, RefusesProductsThatMeshesCannotHold) {
    EXPECT_EQ(products_or_error(".ply", "normal,slope"),
              "--products normal,slope: a mesh has no slope; allowed are position, "
              "normal,foam,velocity and the masks of a land");
    EXPECT_EQ(products_or_error(".ply", "normal,beach"),
              "--products beach: only a terrain has it, and this is a sea");
    EXPECT_TRUE(
        products_or_error(".ply", "position,foam").starts_with("unknown product 'position'; "));
    EXPECT_EQ(products_or_error(".ply", "foam, spray"),
              "--products foam, spray: spray is a file of points; allowed is --products spray "
              "alone");
}

TEST(ProductChoice, RefusesProductsThatVolumesCannotHold) {
    if (standard_catalogue().find_format(".vdb") == nullptr) GTEST_SKIP() << "not built";
    EXPECT_EQ(products_or_error(".vdb", "density,surface"), "surface,density");
    EXPECT_EQ(products_or_error(".vdb", "spray"), "spray");
    for (const std::string list : {"foam", "vel,vel", "surface,,vel", "surface,vel,density,vel"}) {
        EXPECT_EQ(products_or_error(".vdb", list),
                  "--products " + list +
                      ": allowed for a volume are surface, vel and density, each once");
    }
}

}  // namespace
}  // namespace ocean
