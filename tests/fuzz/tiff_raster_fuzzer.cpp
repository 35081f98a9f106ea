// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A GeoTIFF from any bytes, in this process: our own part of it, which the tags and sizes of the
// file reach. The program reads in a child process, since libtiff itself is not ours to mend.
#include <sstream>

#include "raster_checks.hpp"
#include "tiff_raster.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ocean;
    std::istringstream stream(std::string(reinterpret_cast<const char*>(data), size));
    fuzz::check_raster(
        [&](const elevation::RasterReceiver& receiver) { elevation::read_tiff(stream, receiver); });
    return 0;
}
