// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The main function of every GoogleTest program.
#include <gtest/gtest.h>

#include "paths.hpp"

std::string ocean::test::source_dir() {
    return OCEAN_SOURCE_DIR;
}

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
