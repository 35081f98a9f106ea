// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Presets keep their names: the scales' heights by libocean's own spectra, on grids that hold them.

#include <cstddef>

#include "helpers.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/ocean.hpp"
#include "ocean/terrain_table.hpp"
#include "ocean/terrainfile.hpp"

namespace ocean::test {
namespace {

SeaState state_of(const std::string& preset) {
    const Sea sea = parse_sea(find_preset(preset).toml, preset, "");
    return Ocean(sea.parameters).state();
}

TEST(Presets, AreTwoScalesAndTwoSeeds) {
    EXPECT_EQ(presets().size(), 25u);
    for (const Preset& preset : presets()) {
        EXPECT_EQ(&find_preset(preset.name), &preset);
        EXPECT_FALSE(preset.description.empty());
        EXPECT_EQ(preset.toml.find("# " + preset.name + ": " + preset.description), 0u);
    }
}

/// Checks that each key of a preset is commented by unit and label, and stands where the table has
/// it: the files are written by hand.
template <typename Model>
void expect_comments_of_table(const Table<Model>& table, const Preset& preset) {
    std::istringstream lines(preset.toml);
    std::string section;
    std::ptrdiff_t before = -1;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('[')) section = line.substr(line.rfind('[') + 1);
        if (line.starts_with('#') || line.starts_with("libocean") || line.find(" = ") == line.npos)
            continue;
        const auto row = std::ranges::find_if(table.rows, [&](const TableRow<Model>& one) {
            return section.starts_with(std::string(one.section) + "]") &&
                   line.starts_with(std::string(one.key) + " = ");
        });
        ASSERT_NE(row, table.rows.end()) << preset.name << ": " << line;
        EXPECT_GT(row - table.rows.begin(), before) << preset.name << ": " << line;
        before = row - table.rows.begin();
        const std::string unit = row->unit.empty() ? "" : std::string(row->unit) + ": ";
        EXPECT_TRUE(line.ends_with("  # " + unit + std::string(row->label)))
            << preset.name << ": " << line;
    }
    EXPECT_GE(before, 0) << preset.name;
}

TEST(Presets, CommentTheirKeysByUnitAndLabelInTheOrderOfTheTable) {
    for (const Preset& preset : presets()) expect_comments_of_table(sea_table(), preset);
    for (const Preset& preset : terrain_presets()) {
        expect_comments_of_table(terrain_table(), preset);
    }
}

TEST(Presets, BeaufortForcesHaveTheWindAndWavesOfTheWmoTable) {
    const double wind[] = {0, 0.8, 2.4, 4.3, 6.7, 9.3, 12.3, 15.5, 18.9, 22.6, 26.4, 30.5, 34.8};
    const double height[] = {0, 0.1, 0.2, 0.6, 1, 2, 3, 4, 5.5, 7, 9, 11.5, 14};
    for (int force = 0; force <= 12; ++force) {
        const std::string name = "beaufort_" + std::to_string(force);
        const Sea sea = parse_sea(find_preset(name).toml, name, "");
        EXPECT_EQ(sea.parameters.waves[0].wind_speed, wind[force]);
        const bool is_set = force >= 1 && force <= 3;
        EXPECT_EQ(sea.parameters.waves[0].significant_wave_height.has_value(), is_set) << force;
        EXPECT_EQ(sea.parameters.waves[0].peak_period.has_value(), is_set) << force;
        EXPECT_NEAR(state_of(name).significant_wave_height.asked, height[force],
                    0.03 * height[force]);
    }
}

TEST(Presets, DouglasDegreesHaveTheMiddleOfTheirHeights) {
    const double height[] = {0, 0.05, 0.3, 0.875, 1.875, 3.25, 5, 7.5, 11.5, 16};
    for (int degree = 0; degree <= 9; ++degree) {
        const std::string name = "douglas_" + std::to_string(degree);
        const SeaState state = state_of(name);
        EXPECT_NEAR(state.significant_wave_height.asked, height[degree], 1e-3 * height[degree]);
        Sea unset = parse_sea(find_preset(name).toml, name, "");
        unset.parameters.waves[0].significant_wave_height.reset();
        unset.parameters.waves[0].peak_period.reset();
        const SeaState own = Ocean(unset.parameters).state();
        EXPECT_NEAR(own.significant_wave_height.asked, height[degree], 0.05 * height[degree])
            << "wind and fetch give the height by themselves";
        EXPECT_NEAR(own.peak_period.asked, state.peak_period.asked, 0.03 * state.peak_period.asked);
    }
}

TEST(Presets, HaveNoMoreFetchThanAFullyDevelopedSea) {
    for (const Preset& preset : presets()) {
        const Sea sea = parse_sea(preset.toml, preset.name, "");
        EXPECT_TRUE(full_development_warnings(sea.parameters).empty()) << preset.name;
    }
}

// Forces 1 to 3 with the fetch that made their height by itself: 27, 16 and 44 km.
TEST(Presets, LightBeaufortForcesLookAsTheyDidWithAnImpossibleFetch) {
    const double height[] = {0.1009, 0.2034, 0.5996};
    const double period[] = {1.663, 2.033, 3.461};
    const double slope[] = {0.007497, 0.013655, 0.014146};
    for (int i = 0; i < 3; ++i) {
        const SeaState state = state_of("beaufort_" + std::to_string(i + 1));
        EXPECT_NEAR(state.significant_wave_height.asked, height[i], 0.02 * height[i]);
        EXPECT_NEAR(state.peak_period.asked, period[i], 0.002 * period[i]);
        EXPECT_NEAR(state.mean_square_slope.resolved, slope[i], 0.03 * slope[i]);
    }
}

TEST(Presets, OfTheScalesAreHeldByTheirGrids) {
    for (const Preset& preset : presets()) {
        if (preset.name.starts_with("seed_")) continue;
        const SeaState state = state_of(preset.name);
        EXPECT_GE(state.energy_resolved, 0.97) << preset.name;
        EXPECT_LE(state.energy_resolved, 1.03) << preset.name;
        if (state.significant_wave_height.asked == 0.0) continue;
        EXPECT_NEAR(state.period / state.peak_wavelength.asked, 8.0, 0.3) << preset.name;
    }
}

TEST(Presets, SeedsHaveTheParametersOfTheirPrograms) {
    const Parameters lantz = parse_sea(find_preset("seed_lantz").toml, "p", "").parameters;
    EXPECT_EQ(lantz.grid.resolution, 32);
    EXPECT_EQ(lantz.grid.patch_size, 32.0);
    EXPECT_EQ(lantz.time.loop_period, 200.0);
    EXPECT_EQ(lantz.waves[0].wind_speed, 32.0);
    EXPECT_EQ(lantz.waves[0].wind_direction, 90.0);
    // l = 0.001 V^2/g in exp(-k^2 l^2); ours is the wavelength 2 pi l.
    EXPECT_NEAR(lantz.waves[0].cutoff_wavelength, kTwoPi * 0.001 * 32.0 * 32.0 / 9.81, 1e-3);
    const Parameters thesis = parse_sea(find_preset("seed_thesis").toml, "p", "").parameters;
    EXPECT_EQ(thesis.grid.resolution, 256);
    EXPECT_EQ(thesis.grid.patch_size, 1000.0);
    EXPECT_EQ(thesis.waves[0].wind_speed, 40.0);
    EXPECT_EQ(thesis.waves[0].wind_direction, 45.0);
    EXPECT_EQ(thesis.waves[0].amplitude, 4.0);
    EXPECT_EQ(thesis.waves[0].cutoff_wavelength, 0.5);
    EXPECT_EQ(thesis.waves[0].spectrum, SpectrumKind::phillips);
}

TEST(Presets, UnknownNameIsNotFoundAndTheNearestNamed) {
    const Refusal refusal = refusal_of([] { find_preset("beaufort_13"); });
    EXPECT_EQ(refusal.kind, ErrorKind::not_found);
    EXPECT_TRUE(refusal.says(
        "'beaufort_13'", "did you mean beaufort_1",
        "allowed: beaufort_0 .. beaufort_12, douglas_0 .. douglas_9, seed_lantz, seed_thesis"));
}

}  // namespace
}  // namespace ocean::test
