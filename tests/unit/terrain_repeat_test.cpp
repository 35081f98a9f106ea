// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Repeats of tiles and their layers, seen by the autocorrelation.
#include "ocean/terrain_repeat.hpp"

#include "ocean/terrain.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

TerrainModel tile() {
    TerrainModel terrain;
    terrain.resolution = 512;
    terrain.patch_size = 8192.0;
    terrain.beta = 1.8;
    terrain.outer_scale = 1500.0;
    return terrain;
}

TEST(TerrainRepeat, ALayerShowsAtItsPeriodWithItsShareOfTheEnergy) {
    TerrainModel terrain = tile();
    Terrain plain(terrain);
    EXPECT_LT(find_repeat(plain.modes()).slope.correlation, 0.1);
    EXPECT_LT(find_repeat(plain.modes()).height.correlation, 0.35);  // few long waves
    terrain.layers = {{.period = 2048.0, .gain = 1.0, .seed = 5}};
    Terrain layered(terrain);
    const TerrainRepeat repeat = find_repeat(layered.modes());
    // Half of the energy is the layer's.
    EXPECT_NEAR(repeat.slope.correlation, 0.5, 0.06);
    const double multiples = repeat.slope.distance / 2048.0;
    const double square = multiples * multiples;  // of a lag of whole periods along both axes
    EXPECT_NEAR(square, std::round(square), 0.02);
    EXPECT_GE(square, 1.0);
}

TEST(TerrainRepeat, AFlatTerrainHasNone) {
    TerrainModel terrain = tile();
    terrain.rms = 0.0;
    Terrain land(terrain);
    EXPECT_EQ(find_repeat(land.modes()).height.correlation, 0.0);
    EXPECT_EQ(find_repeat(land.modes()).slope.distance, 0.0);
}

}  // namespace
}  // namespace ocean
