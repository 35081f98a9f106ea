// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "bridge_program.hpp"

int main(int argc, char** argv) {
    return ocean::app::run_bridge(argc, argv);
}
