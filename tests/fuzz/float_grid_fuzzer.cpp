// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The header of raw floats, a form feed, and the floats: any bytes give a model that keeps its
// promises, or one printable error. The header's text is a projection, too.
#include <sstream>

#include "elevation/float_grid.hpp"
#include "elevation_checks.hpp"
#include "ocean/internal/elevation_rules.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ocean;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const std::string header(bytes.substr(0, bytes.find('\f')));
    const std::string floats(bytes.substr(std::min(header.size() + 1, size)));
    elevation::is_geographic(header);
    fuzz::require(elevation::metres_per_unit(header) > 0.0);
    fuzz::check_reader(HolePolicy::fill, [&](const ElevationOptions& options) {
        std::istringstream stream(floats);
        return elevation::read_float_grid(elevation::parse_float_header(header, "fuzz.hdr"), stream,
                                          floats.size(), "fuzz.flt", "", options);
    });
    return 0;
}
