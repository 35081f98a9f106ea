// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Errors of settings that are no parameters of a sea: a program reads their parts, people the
// sentence.
#include "ocean/error.hpp"

#include "ocean/internal/float_pose.hpp"
#include "ocean/internal/foam_texture.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/spray.hpp"
#include "refusal.hpp"

namespace ocean {
namespace {

struct Refusal {
    std::function<void()> setting;
    std::string sentence;
    ErrorFields fields;
};

class SettingErrors : public testing::TestWithParam<Refusal> {};

TEST_P(SettingErrors, HaveTheirPartsAsFields) {
    const Refusal& expected = GetParam();
    const test::Refusal error = test::refusal_of(expected.setting);
    EXPECT_EQ(error.message, expected.sentence);
    EXPECT_EQ(error.fields.what, expected.fields.what);
    EXPECT_EQ(error.fields.parameter, expected.fields.parameter);
    EXPECT_EQ(error.fields.value, expected.fields.value);
    EXPECT_EQ(error.fields.allowed, expected.fields.allowed);
}

INSTANTIATE_TEST_SUITE_P(
    Each, SettingErrors,
    testing::Values(
        Refusal{
            [] { require_resolution(33); },
            "resolution = 33; allowed: a power of two, 32 .. 8192",
            {.parameter = "resolution", .value = "33", .allowed = "a power of two, 32 .. 8192"}},
        Refusal{[] { parse_number("9", "--sun", 0.0, 5.0); },
                "--sun = 9; allowed: a number, 0 .. 5",
                {.parameter = "--sun", .value = "9", .allowed = "a number, 0 .. 5"}},
        Refusal{[] { parse_whole_number("2.5", "--side", 0, 5); },
                "--side = 2.5; allowed: a whole number",
                {.parameter = "--side", .value = "2.5", .allowed = "a whole number"}},
        Refusal{[] {
                    require_body({0.0, 0.0, 0.0, -1.0, 1.0});
                },
                "length = -1; allowed: 0 .. 100000 m",
                {.parameter = "length", .value = "-1", .allowed = "0 .. 100000 m"}},
        Refusal{[] { validate(SpraySettings{.lifetime = 20.0}); },
                "spray: lifetime = 20; allowed: 0.05 .. 10",
                {.parameter = "lifetime", .value = "20", .allowed = "0.05 .. 10"}},
        Refusal{[] { require_foam_texture_size(65); },
                "foam texture: size = 65; allowed: a power of two, 64 .. 4096",
                {.parameter = "size", .value = "65", .allowed = "a power of two, 64 .. 4096"}}));

}  // namespace
}  // namespace ocean
