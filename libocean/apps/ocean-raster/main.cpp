// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// ocean-raster: reads one raster of heights by GDAL for `ocean terrain import`, which executes it
// with limits. It is no command for people.
#include "ocean/internal/send_raster.hpp"

int main(int count, char** arguments) {
    return ocean::send_raster({arguments + 1, static_cast<std::size_t>(count > 0 ? count - 1 : 0)});
}
