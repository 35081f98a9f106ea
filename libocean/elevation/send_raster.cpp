// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The work of ocean-raster: see ocean/internal/send_raster.hpp.
#include "ocean/internal/send_raster.hpp"

#include <charconv>
#include <cstdio>
#include <string_view>

#include "gdal_raster.hpp"
#include "raster_wire.hpp"

namespace ocean {
namespace {

using namespace elevation;

GridWindow window_of(std::span<const char* const> words) {
    std::int64_t numbers[4] = {};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::string_view word = words[i];
        const char* const end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), end, numbers[i]);
        if (error != std::errc() || stop != end) throw RasterFault("is asked for no window");
    }
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

}  // namespace

int send_raster(std::span<const char* const> arguments) {
    if (arguments.size() != 1 && arguments.size() != 2 && arguments.size() != 5) {
        std::fputs("ocean-raster is a part of `ocean terrain import`\n", stderr);
        return 2;
    }
    bool is_whole = true;
    const auto sink = [&](const void* bytes, std::size_t size) {
        is_whole = std::fwrite(bytes, 1, size, stdout) == size && is_whole;
    };
    elevation::encode(
        [&](const RasterReceiver& receiver) {
            RasterRequest request{.facts_alone = arguments.size() == 2};
            if (arguments.size() == 5) request.window = window_of(arguments.subspan(1));
            start_gdal();
            read_gdal(arguments[0], request, receiver);
        },
        sink);
    return std::fflush(stdout) == 0 && is_whole ? 0 : 1;
}

}  // namespace ocean
