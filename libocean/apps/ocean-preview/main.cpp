// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "preview_program.hpp"

int main(int argc, char** argv) {
    return ocean::app::run_preview(argc, argv);
}
