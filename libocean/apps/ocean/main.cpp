// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The `ocean` command; see ocean_program.hpp.
#include "ocean_program.hpp"

int main(int argc, char** argv) {
    return ocean::app::run_ocean(argc, argv, ocean::app::ocean_catalogue());
}
