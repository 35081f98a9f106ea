// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// An ESRI ASCII grid from any bytes gives a model that keeps its promises, or one printable error.
#include <sstream>

#include "elevation_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ocean;
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (const HolePolicy holes : {HolePolicy::keep, HolePolicy::fill}) {
        fuzz::check_reader(holes, [&](const ElevationOptions& options) {
            std::istringstream stream(text);
            return parse_ascii_grid(stream, size, "fuzz.asc", "", options);
        });
    }
    return 0;
}
