// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: parameters of any table are declared in POV-Ray's spelling.
#include "ocean/internal/io/povray_declarations.hpp"

#include <gtest/gtest.h>

#include "ocean/parameter_table.hpp"
#include "toy_model.hpp"

namespace ocean::io {
namespace {

TEST(PovrayDeclarations, EveryTypeOfATableIsDeclared) {
    const auto line = [](std::string_view name, const ParameterValue& value) {
        const auto ref = find_parameter(test::kKilnTable, name);
        return povray_parameter_declaration(*ref.info, ref.item, value);
    };
    EXPECT_EQ(line("heat", 1200.5), "#declare Ocean_Kiln_Heat = 1200.5;  // K\n");
    EXPECT_EQ(line("vented", true), "#declare Ocean_Kiln_Vented = true;\n");
    EXPECT_EQ(line("vented", false), "#declare Ocean_Kiln_Vented = false;\n");
    EXPECT_EQ(line("kiln.tray.2.bowls", std::int64_t{8}),
              "#declare Ocean_Kiln_Tray_2_Bowls = 8;\n");
    EXPECT_EQ(line("glaze", std::string("matt")), "#declare Ocean_Kiln_Tray_0_Glaze = \"matt\";\n");
    EXPECT_EQ(povray_parameter_declaration(*find_parameter("peak_period").info, 0, std::string()),
              "#declare Ocean_Waves_0_Peak_Period = 0; #undef Ocean_Waves_0_Peak_Period\n");
}

}  // namespace
}  // namespace ocean::io
