// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a sea is, in the numbers wave people use: asked for by the spectrum, and resolved by a grid.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ocean/modes.hpp"

namespace ocean {

/// asked: integral of the spectrum, in double. resolved: sum over the modes of the grid. Neither
/// holds a random draw.
struct AskedResolved {
    double asked = 0.0;
    double resolved = 0.0;
};

/// What closing the loop does to the speed of the waves of one length.
struct LoopError {
    double wavelength = 0.0;   // m
    double speed_error = 0.0;  // (speed in the loop - speed) / speed, 1 = twice as fast
};

/// One cascade: its waves repeat more often than the sea does.
struct CascadeShare {
    double period = 0.0;         // m
    double shortest_wave = 0.0;  // m, of the waves that this cascade holds; 0 = it holds none
    double longest_wave = 0.0;
    double height = 0.0;  // share of the variance that repeats at this period, 0 .. 1
    double slope = 0.0;
};

/// The slopes that a map shows. Far away a host draws a coarse map; what that lacks of the sea's
/// mean square slope becomes roughness.
struct MapSlope {
    int resolution = 0;
    double mean_square_slope = 0.0;
};

struct SeaState {
    AskedResolved significant_wave_height;  // m
    AskedResolved peak_period;              // s; 0 = flat
    AskedResolved energy_period;            // s, Te = m-1 / m0; 0 = flat
    AskedResolved mean_period;              // s, Tm01 = m0 / m1; 0 = flat
    AskedResolved peak_wavelength;          // m
    AskedResolved mean_square_slope;
    AskedResolved mean_direction;      // degrees counter-clockwise from +x, travelling to
    AskedResolved directional_spread;  // degrees, circular standard deviation
    double energy_resolved = 1.0;      // resolved m0 / asked m0; 1 for a flat sea
    double shortest_wave = 0.0;        // m, within the limits, along an axis of the grid
    double longest_wave = 0.0;
    double period = 0.0;               // m
    int map_resolution = 0;            // of a map when nobody says
    double map_shortest_wave = 0.0;    // m, that such a map holds
    std::vector<MapSlope> map_slopes;  // of 1, 2, 4 .. 8192 samples a side
    /// One for each cascade, longest period first.
    std::vector<CascadeShare> cascades;
    /// Modes, spectrum table and a frame of displacement, normals and foam.
    std::uint64_t memory_bytes = 0;
    double foam_preroll_seconds = 0.0;
    /// Asked: what this wind makes white. Resolved: the mean whitecap of a map of map_resolution.
    AskedResolved whitecap_coverage;
    double foam_threshold = 0.0;  // Jacobian where whitecaps begin there; 1 is undisturbed
    double folded_share = 0.0;    // of that map's area, by label, where crests have folded over
    /// From the longest wave held in octaves to the shortest; empty for a sea without a loop.
    std::vector<LoopError> loop_errors;
    double loop_error = 0.0;            // of the modes, rms weighted by energy
    std::vector<std::string> warnings;  // full sentences, for people
};

/// Needs validated parameters. Leaves out the whitecaps, which are the modes': see add_whitecaps.
SeaState sea_state(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                   ThreadPool& pool);
/// whitecap_coverage, foam_threshold and folded_share of a state of the same sea, and the warning
/// of folds.
void add_whitecaps(const Modes& modes, const SurfaceSettings& settings, SeaState& state);
/// Returns a sentence for each JONSWAP or TMA system whose fetch makes waves beyond those of a
/// fully developed sea [Pierson and Moskowitz 1964], with both heights, or both periods where the
/// height is given, and the fetch of full development. A system whose height and period are both
/// given has none. Reads the wave systems and the water; sea_state() has these warnings too.
std::vector<std::string> full_development_warnings(const Parameters& parameters);
/// The object of `ocean info --json`.
std::string sea_state_json(const SeaState& state);

}  // namespace ocean
