// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a terrain file: either a terrain that survives a round trip, or one Error whose
// message is safe to print. Small terrains are also made. Anything else is a finding.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrainfile.hpp"
#include "require.hpp"

using ocean::fuzz::check_message;
using ocean::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    ocean::TerrainModel terrain;
    try {
        terrain = ocean::parse_terrain(text, "fuzz.toml", "/nonexistent");
    } catch (const ocean::Error& error) {
        check_message(error.what());
        return 0;
    }
    const std::string written = ocean::write_terrain(terrain);
    const ocean::TerrainModel again = ocean::parse_terrain(written, "written.toml", "/nonexistent");
    require(ocean::write_terrain(again) == written);
    if (terrain.resolution > 64) return 0;
    ocean::Terrain land(terrain, {.threads = 1});
    const ocean::Surface map = land.surface({ocean::Channel::height});
    for (const float height : map.channel(ocean::Channel::height)) require(std::isfinite(height));
    land.state();
    return 0;
}
