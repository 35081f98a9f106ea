// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: the text of `ocean params` is a loop over any table.
#include "parameters_text.hpp"

#include <gtest/gtest.h>

#include "toy_model.hpp"

namespace ocean::app {
namespace {

TEST(ParametersText, ListsTheTableOfAnyModel) {
    const std::string text = parameters_text(listed(test::kKilnTable));
    EXPECT_EQ(text.substr(0, text.find("[kiln.lid]")),
              "[kiln]\n"
              "  heat = 1200                             300 .. 1600 K\n"
              "      Temperature of the fire.\n"
              "  bricks = 256                            a power of two, 16 .. 4096\n"
              "      Bricks of the wall.\n"
              "  vented = false                          true or false\n"
              "      Whether smoke leaves by a flue.\n"
              "\n[[kiln.tray]]  (one table per tray)\n"
              "  bowls = 4                               an even number, 0 .. 64\n"
              "      Bowls on the tray.\n"
              "  glaze = glossy                          one of matt, glossy\n"
              "      Glaze of the bowls.\n\n");
}

}  // namespace
}  // namespace ocean::app
