// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Terrains by name: the two surfaces of the program that this project continues, and landscapes
// whose laws were measured. A preset is a few numbers; its file is written from them.
#include <vector>

#include "ocean/terrain_table.hpp"
#include "ocean/terrainfile.hpp"
#include "preset_text.hpp"

namespace ocean {
namespace {

/// Returns whether a preset has the line of a key: one that differs from its default, or that a
/// reader looks for first, the resolution, the size and beta.
bool is_shown(const RefOf<Terrain>& ref, const std::string& line) {
    static const Terrain kDefaults;
    return ref.info->holds<&Terrain::resolution>() || ref.info->holds<&Terrain::patch_size>() ||
           ref.info->holds<&Terrain::beta>() || ref.info->in_list() ||
           line != parameter_line(kDefaults, ref);
}

/// Makes a preset. `notes` are lines that follow the description as comments.
Preset make_preset(const std::string& name, const std::string& description, std::string_view notes,
                   const Terrain& terrain) {
    return described_preset(name, description, notes,
                            preset_keys(terrain_table(), terrain, is_shown));
}

Preset seed_fbm(const std::string& name, double beta, const std::string& words) {
    Terrain terrain;
    terrain.resolution = 256;
    terrain.patch_size = 256.0;
    terrain.beta = beta;
    terrain.rms = 16.0;
    return make_preset(
        name, "fractional Brownian terrain with beta = " + to_text(beta) + ", " + words,
        "The classic way: white noise, its Fourier transform, a filter 1 / f^beta, and back. Here\n"
        "the mean is 0, the rms height is what the file says at any resolution, and the noise of "
        "a\n"
        "wave depends on its index alone. `ocean terrain --stage` shows each step.",
        terrain);
}

Preset gabilan_mesa() {
    Terrain terrain;
    terrain.resolution = 1024;
    terrain.patch_size = 4096.0;
    terrain.rms = 29.0;
    terrain.mean = 311.0;
    terrain.beta = 1.3;
    terrain.breaks = {{174.0, 2.7}};
    terrain.ridge_wavelength = 174.0;
    terrain.ridge_gain = 9.0;
    terrain.ridge_width = 0.25;
    terrain.ridge_direction = 47.0;
    terrain.ridge_spread = 2.0;
    return make_preset(
        "gabilan_mesa", "evenly spaced ridges and valleys, 174 m apart, of low hills",
        "After the Gabilan Mesa in California [Perron 2008]: valleys 174 +- 13 m apart, crossed\n"
        "towards 47 degrees, an rms height of about 29 m around 311 m, and hillslopes that are\n"
        "smooth at shorter wavelengths. The exponents are those of a broken law by eye.",
        terrain);
}

Preset earth() {
    Terrain terrain;
    terrain.resolution = 1024;
    terrain.patch_size = 100000.0;
    terrain.rms = 150.0;
    terrain.mean = 400.0;
    terrain.beta = 1.5;
    terrain.outer_scale = 50000.0;
    return make_preset(
        "earth", "land as its long transects have it: power falls as the square of the wavenumber",
        "Transects of the continents have densities that fall as k^-2 over wavelengths of metres\n"
        "to thousands of kilometres [Sayles and Thomas 1978], [Turcotte 1997]: as k^-3 over the\n"
        "plane, beta = 1.5, H = 0.5, D = 2.5. The patch is 100 km, with an outer scale of 50 km.",
        terrain);
}

Preset tujunga() {
    Terrain terrain;
    terrain.resolution = 1024;
    terrain.patch_size = 16384.0;
    terrain.rms = 185.0;
    terrain.mean = 1200.0;
    terrain.beta = 1.67;
    terrain.breaks = {{440.0, 2.65}};
    terrain.outer_scale = 12000.0;
    return make_preset(
        "tujunga", "steep mountains: slopes of 22 degrees in the middle, 42 at the steepest",
        "The broken law fitted to an elevation model of the Big Tujunga in California, cells of\n"
        "30 m: exponents 1.67 and 2.65, break at 440 m, within 0.11 of log10 of the density. The\n"
        "rms height gives the model's median slope of 22 degrees. Real slopes have a threshold\n"
        "near 41 degrees; a Gaussian surface exceeds it in places.",
        terrain);
}

Preset jacksboro() {
    Terrain terrain;
    terrain.resolution = 512;
    terrain.patch_size = 32768.0;
    terrain.rms = 136.0;
    terrain.mean = 500.0;
    terrain.beta = 1.33;
    terrain.breaks = {{1130.0, 2.59}};
    terrain.outer_scale = 24000.0;
    return make_preset(
        "jacksboro", "wooded hills: slopes of 13 degrees in the middle, 28 at the steepest",
        "The broken law fitted to an elevation model of the Jacksboro fault in Tennessee, cells "
        "of\n"
        "3 seconds of arc: exponents 1.33 and 2.59, break at 1130 m, within 0.06 of log10 of the\n"
        "density. The rms height gives the model's median slope of 13 degrees.",
        terrain);
}

Preset big_tujunga() {
    Terrain terrain;
    terrain.resolution = 1024;
    terrain.patch_size = 16384.0;
    terrain.rms = 300.0;
    terrain.mean = 1200.0;
    terrain.beta = 1.67;
    terrain.breaks = {{440.0, 2.65}};
    terrain.outer_scale = 12000.0;
    terrain.gullies.depth = 0.05;
    terrain.gullies.longest = 700.0;
    return make_preset(
        "big_tujunga", "steep mountains cut by gullies: slopes of 22 degrees, 42 at the steepest",
        "The law of `tujunga`, whose waves below 1.6 km gave way to gullies along the fall line.\n"
        "The slopes that 50, 90 and 99 % of the land do not exceed are within 3 degrees of those\n"
        "of the elevation model, 22.1, 33.4 and 41.5 degrees at cells of 30 m.",
        terrain);
}

Preset bay_island() {
    Terrain terrain;
    terrain.kind = TerrainKind::placed;
    terrain.resolution = 1024;
    terrain.patch_size = 16384.0;
    terrain.seed = 8;
    terrain.rms = 200.0;
    terrain.mean = 620.0;
    terrain.island = 1000.0;
    terrain.beta = 1.9;
    terrain.breaks = {{1500.0, 2.5}};
    terrain.outer_scale = 9000.0;
    terrain.detail_wavelength = 1.0;
    terrain.stream.slope = StreamSettings{}.slope;
    terrain.coast.beach_slope = 0.0333;
    return make_preset(
        "bay_island", "an island with valleys, beaches in its bays and cliffs at its capes",
        "A land that exists once: streams cut it until they carry away what rises, the shore has\n"
        "beaches of 1 in 30 where it is sheltered, and waves down to 1 m are added below the cell\n"
        "of 16 m. Heights are over the water.",
        terrain);
}

std::vector<Preset> make_presets() {
    return {gabilan_mesa(),
            earth(),
            tujunga(),
            jacksboro(),
            big_tujunga(),
            bay_island(),
            seed_fbm("seed_smooth", 2.4, "smooth"),
            seed_fbm("seed_rough", 2.0, "rougher")};
}

}  // namespace

std::span<const Preset> terrain_presets() {
    static const std::vector<Preset> kPresets = make_presets();
    return kPresets;
}

const Preset& find_terrain_preset(std::string_view name) {
    std::string allowed;
    for (const Preset& preset : terrain_presets()) {
        allowed += (allowed.empty() ? "" : ", ") + preset.name;
    }
    return find_preset_in(terrain_presets(), name, "terrain preset", allowed);
}

}  // namespace ocean
