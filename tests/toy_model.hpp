// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A model that is no sea, with a table of its own: a kiln with a list of trays, and a lid inside.
// It shows that the loops over a table know nothing of seas, and that booleans and keys that came
// later pass through each of them.
#pragma once

#include <vector>

#include "ocean/table.hpp"

namespace ocean::test {

enum class Glaze { matt, glossy };

struct Tray {
    int bowls = 4;
    Glaze glaze = Glaze::glossy;
};

struct Kiln {
    double heat = 1200.0;
    int bricks = 256;
    bool vented = false;
    double lid_angle = 0.0;
    std::vector<Tray> trays;
};

inline constexpr TableSection kKiln{"kiln"};
inline constexpr TableSection kTray{"kiln.tray", "tray", 3};
inline constexpr TableSection kLid{"kiln.lid"};
inline constexpr TableSection kKilnSections[] = {kKiln, kTray, kLid};

inline constexpr TableRow<Kiln> kKilnRows[] = {
    {kKiln, "heat", "K", "Heat", "Temperature of the fire.", member<&Kiln::heat>(), 300.0, 1600.0,
     900.0, 1500.0, ParameterClass::live, StagesOf<Kiln>::type::all},
    {kKiln, "bricks", "", "Bricks", "Bricks of the wall.", member<&Kiln::bricks>(), 16, 4096, 16,
     1024, ParameterClass::rebuild, StagesOf<Kiln>::type::all,
     OptionalColumns{.rule = NumberRule::power_of_two}},
    {kKiln, "vented", "", "Vented", "Whether smoke leaves by a flue.", member<&Kiln::vented>(), 0,
     0, 0, 0, ParameterClass::live, StagesOf<Kiln>::type::all, OptionalColumns{.neutral = "false"}},
    {kTray, "bowls", "", "Bowls", "Bowls on the tray.", member<&Kiln::trays, &Tray::bowls>(), 0, 64,
     0, 16, ParameterClass::rebuild, StagesOf<Kiln>::type::all,
     OptionalColumns{.rule = NumberRule::even}},
    {kTray, "glaze", "", "Glaze", "Glaze of the bowls.", member<&Kiln::trays, &Tray::glaze>(), 0, 0,
     0, 0, ParameterClass::rebuild, StagesOf<Kiln>::type::all},
    {kLid, "lid_angle", "deg", "Lid angle", "How far the lid stands open.",
     member<&Kiln::lid_angle>(), 0.0, 90.0, 0.0, 90.0, ParameterClass::live,
     StagesOf<Kiln>::type::all},
};
inline constexpr Table<Kiln> kKilnTable{"kiln", kKilnSections, kKilnRows};
static_assert(is_consistent(kKilnTable));

}  // namespace ocean::test
