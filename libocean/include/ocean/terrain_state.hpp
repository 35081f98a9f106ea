// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The statistics of a terrain, as its law requests them and as its tile holds them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ocean/sea_state.hpp"
#include "ocean/terrain_model.hpp"
#include "ocean/terrain_repeat.hpp"

namespace ocean {

class Surface;
struct Modes;
struct TerrainScale;

/// The waves of one octave of wavelength.
struct TerrainOctave {
    double longest_wave = 0.0;  // [m]; the shortest is half of it
    AskedResolved rms;          // of the heights of these waves [m]
    /// Exponent beta: `asked` is the law's exponent in the middle of the octave, `resolved` the
    /// slope of a line through the densities of eight rings of this tile, NaN if the octave has
    /// fewer than 100 waves.
    AskedResolved exponent;
};

/// `asked` is the mean of all seeds, a sum over the modes of the lattice without their noise;
/// `resolved` is this very tile. A land with erosion, a shore or a place of its own is measured on
/// a map instead: `resolved` describes that map, `asked` its waves before they were shaped; NaN for
/// an elevation model.
struct TerrainState {
    AskedResolved rms;        // [m]
    AskedResolved rms_slope;  // root of the mean square slope
    /// Slope angles [degrees] that 50, 90 and 99 % of the land do not exceed, computed from the
    /// mean square slope as for a Gaussian surface without direction.
    std::vector<AskedResolved> slope_angles;
    double mean = 0.0;             // [m]
    double shortest_wave = 0.0;    // within the limits, along an axis of the grid [m]
    double longest_wave = 0.0;     // [m]
    double period = 0.0;           // [m]; 0 for a land that exists once
    std::array<double, 2> size{};  // of a land that exists once, or of the tile [m]
    double lowest = 0.0;           // lowest height of the measured map [m]; 0 if none
    double highest = 0.0;
    double cell = 0.0;                   // distance of samples [m]
    double measured_cell = 0.0;          // cell of the map whose slopes are stated; shaped land
    std::vector<TerrainOctave> octaves;  // from the longest wave
    /// The highest peaks within the period, without gullies, which add to both. Unset for a land
    /// that exists once.
    std::optional<TerrainRepeat> repeat;
    std::uint64_t memory_bytes = 0;     // for noise, modes and a map of height and slopes
    std::vector<std::string> warnings;  // full sentences, for people
};

/// Returns the statistics of a terrain with these modes; `offset` is the height added to the modes.
TerrainState terrain_state(const TerrainModel& terrain, const Modes& modes,
                           const TerrainScale& scale, double offset);
/// Replaces the statistics that shaping changes by the statistics of `map`, which has heights and
/// slopes.
void measure_shaped(const Surface& map, TerrainState& state);
/// Returns the JSON object of `ocean info --json`.
std::string terrain_state_json(const TerrainState& state);

}  // namespace ocean
