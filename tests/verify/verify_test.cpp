// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The public verification suite: its groups pass, and it says so where a claim does not hold. What
// a group judges no other test does.
#include "ocean/internal/verify.hpp"

#include <set>

#include "ocean/error.hpp"
#include "testing.hpp"

namespace ocean::verify {
namespace {

class VerifyGroup : public testing::TestWithParam<std::string_view> {};

TEST_P(VerifyGroup, HasNoRowThatFails) {
    const std::vector<Row> rows = run({.only = {std::string(GetParam())}});
    EXPECT_GT(std::ranges::count(rows, Verdict::pass, &Row::verdict), 3);
    for (const Row& row : rows) {
        EXPECT_NE(row.verdict(), Verdict::fail)
            << row.id << ": " << row.measured << " for " << row.expected << " +- " << row.tolerance;
    }
}

// All but the given sea.
INSTANTIATE_TEST_SUITE_P(Each, VerifyGroup,
                         testing::Values("spectra", "statistics", "propagation", "foam", "terrain",
                                         "coast", "hulls", "backends"),
                         [](const auto& info) { return std::string(info.param); });

TEST(Verify, WavesOfALoopInCascadesHaveTheFrequenciesOfWholeTurns) {
    Sea sea;
    sea.parameters.grid = {
        .resolution = 32, .patch_size = 200.0, .cascades = 2, .cascade_divisors = {}};
    sea.parameters.time.loop_period = 20.0;
    std::set<std::string> passed;
    for (const Row& row : run({.only = {"sea"}, .sea = sea})) {
        if (row.verdict() == Verdict::pass) passed.insert(row.id);
    }
    EXPECT_TRUE(passed.contains("sea.dispersion"));
}

TEST(Verify, ARowPassesWithinItsToleranceAlone) {
    Row row{.expected = 2.0, .measured = 2.1, .tolerance = 0.11};
    EXPECT_EQ(row.verdict(), Verdict::pass);
    row.tolerance = 0.09;
    EXPECT_EQ(row.verdict(), Verdict::fail);
    row.shortfall = "the page says so";
    EXPECT_EQ(row.verdict(), Verdict::shortfall);
    row.shortfall.clear();
    row.measured = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(row.verdict(), Verdict::fail);
    row.not_run = "no GPU";
    EXPECT_EQ(row.verdict(), Verdict::not_run);
}

TEST(Verify, DigitsAreThoseOfTheRelativeError) {
    EXPECT_NEAR((Row{.expected = 2.0, .measured = 2.002}).digits(), 3.0, 1e-9);
    EXPECT_NEAR((Row{.expected = 0.0, .measured = 1e-6}).digits(), 6.0, 1e-9);
    EXPECT_EQ((Row{.expected = 5.0, .measured = 5.0}).digits(), 15.0);
    EXPECT_EQ((Row{.expected = 1.0, .measured = 40.0}).digits(), 0.0);
}

TEST(Verify, GroupsAreRunByTheirNamesAndRowsHaveNamesOfTheirOwn) {
    std::vector<std::string> begun;
    std::set<std::string> ids;
    run({.only = {"spectra"},
         .begin = [&](const Group& group) { begun.emplace_back(group.name); },
         .done = [&](const Row& row) { EXPECT_TRUE(ids.insert(row.id).second) << row.id; }});
    EXPECT_EQ(begun, std::vector<std::string>{"spectra"});
    for (const std::string& id : ids) EXPECT_TRUE(id.starts_with("spectra.")) << id;
    EXPECT_TRUE(run({.only = {"sea"}}).empty()) << "no sea is given";
    EXPECT_THROW(run({.only = {"spctra"}}), Error);
}

}  // namespace
}  // namespace ocean::verify
