// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// An SRTM tile from any bytes: the first one chooses the size that the file claims, the others are
// its heights, repeated or cut off. They are a name, too.
#include <sstream>

#include "ocean/internal/elevation_import.hpp"
#include "raster_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ocean;
    if (size == 0) return 0;
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    if (const auto corner = corner_of_name(bytes)) {
        fuzz::require(std::abs((*corner)[0]) <= 180.0 && std::abs((*corner)[1]) <= 90.0);
    }
    constexpr std::size_t kTile = std::size_t{2} * 1201 * 1201;
    const std::size_t claims[] = {kTile, size - 1, 0, std::size_t{2} * 3601 * 3601};
    std::string content;
    if (data[0] % 8 == 0 && !bytes.empty()) {
        while (content.size() < kTile) content += bytes;
    } else {
        content = bytes;
    }
    std::istringstream stream(content);
    fuzz::check_raster([&](const elevation::RasterReceiver& receiver) {
        elevation::read_hgt(stream, claims[data[0] / 8 % 4], {0.0, 0.0}, receiver);
    });
    return 0;
}
