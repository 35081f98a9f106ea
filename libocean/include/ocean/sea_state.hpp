// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The statistics of a sea, in the quantities of oceanography: as the spectrum requests them, and as
// a grid resolves them.
//
//     const SeaState state = Ocean(sea).state();
//     std::printf("Hs = %.2f m of %.2f m\n", state.significant_wave_height.resolved,
//                 state.significant_wave_height.asked);
//     for (const std::string& warning : state.warnings) std::puts(warning.c_str());
//     std::puts(sea_state_json(state).c_str());
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ocean/sea_bed.hpp"

namespace ocean {

class DirectionalSpectrum;
class ThreadPool;
struct Modes;

/// A statistic twice: `asked` is the integral of the spectrum, in double; `resolved` is the sum
/// over the modes of the grid. Neither contains a random draw.
struct AskedResolved {
    double asked = 0.0;
    double resolved = 0.0;
};

/// The error of the wave speed at one wavelength that closing the loop causes.
struct LoopError {
    double wavelength = 0.0;   // [m]
    double speed_error = 0.0;  // (speed in the loop - speed) / speed; 1 = twice as fast
};

/// The contents of one cascade, whose waves repeat after a shorter period than the sea.
struct CascadeShare {
    double period = 0.0;         // [m]
    double shortest_wave = 0.0;  // shortest wave of this cascade [m]; 0 = it holds none
    double longest_wave = 0.0;   // [m]
    double height = 0.0;  // share of the variance of heights that repeats at this period, 0 .. 1
    double slope = 0.0;   // share of the variance of slopes
};

/// The mean square slope that a map of one resolution shows. A host that draws a coarse map far
/// away turns the rest of the sea's mean square slope into roughness.
struct MapSlope {
    int resolution = 0;
    double mean_square_slope = 0.0;
};

/// A crest of [[crests]], or a trough, and how likely the sea makes it by itself.
struct CrestSummary {
    double time = 0.0;             // [s]
    double x = 0.0;                // [m]
    double y = 0.0;                // [m]
    double height = 0.0;           // over still water [m]; below 0: a trough
    double relative_height = 0.0;  // in units of the significant wave height
    /// One crest in this many is as high, by Rayleigh's distribution of linear waves and by
    /// [Forristall 2000], second order.
    double one_in_rayleigh = 0.0;
    double one_in_forristall = 0.0;
    double steepness =
        0.0;  // height times m2 / (m0 g); the Jacobian at the crest is about 1 less it
};

/// A hull of [[hulls]] and its waves at its highest speed.
struct HullSummary {
    double begin = 0.0, end = 0.0;  // of its track [s]
    double speed = 0.0;             // the highest between two rows [m/s]
    double froude_number = 0.0;     // speed / sqrt(g length)
    double volume = 0.0;            // of the water that it displaces [m^3]
    double wavelength = 0.0;        // of the waves behind it in deep water [m]
    double wave_height = 0.0;       // from trough to crest, one length beside it [m]
    double steepness = 0.0;         // wave_height over the length of the waves there
    double wake_size = 0.0;         // side of the square that shows its wake [m]
    double wake_cell = 0.0;         // distance of the samples of that square [m]
};

/// Second order of a sea. The skewness is <h^3> / <h^2>^1.5 of the heights over places; a linear
/// sea has none.
struct SecondOrderSummary {
    double skewness = 0.0;               // of this sea's surface
    double skewness_of_theory = 0.0;     // of its spectrum [Sharma and Dean 1981]
    double shortest_binding_wave = 0.0;  // shorter waves are linear [m]
    double steepness = 0.0;              // peak wavenumber times half the significant wave height
};

struct SeaState {
    AskedResolved significant_wave_height;  // [m]
    AskedResolved peak_period;              // [s]; 0 = flat
    AskedResolved energy_period;            // Te = m-1 / m0 [s]; 0 = flat
    AskedResolved mean_period;              // Tm01 = m0 / m1 [s]; 0 = flat
    AskedResolved peak_wavelength;          // [m]
    AskedResolved mean_square_slope;
    AskedResolved mean_direction;      // travelling to, counter-clockwise from +x [degrees]
    AskedResolved directional_spread;  // circular standard deviation [degrees]
    double energy_resolved = 1.0;      // resolved m0 / asked m0; 1 for a flat sea
    double shortest_wave = 0.0;        // within the limits, along an axis of the grid [m]
    double longest_wave = 0.0;         // [m]
    double period = 0.0;               // [m]
    int map_resolution = 0;            // default_map_resolution
    double map_shortest_wave = 0.0;    // shortest wave of a map of map_resolution [m]
    std::vector<MapSlope> map_slopes;  // of maps of 1, 2, 4 .. 8192 samples along a side
    /// One for each cascade, ordered from the longest period.
    std::vector<CascadeShare> cascades;
    /// Bytes of modes, spectrum table and a frame of displacement, normals and foam.
    std::uint64_t memory_bytes = 0;
    double foam_preroll_seconds = 0.0;
    /// `asked`: the share of the sea that this wind makes white. `resolved`: the mean whitecap of a
    /// map of map_resolution.
    AskedResolved whitecap_coverage;
    double foam_threshold = 0.0;  // Jacobian below which whitecaps begin; 1 = undisturbed
    double folded_share = 0.0;    // share of the area, by label, that has folded over
    /// Errors in octaves from the longest wave held to the shortest; empty for a sea without a
    /// loop.
    std::vector<LoopError> loop_errors;
    std::optional<SeaBedSummary> bed;  // absent in an open sea
    double loop_error = 0.0;           // rms over the modes, weighted by energy
    std::vector<CrestSummary> crests;  // those of the sea file
    /// Expected variance of the patch's heights with its crests, over that without them.
    double crest_variance = 1.0;
    std::vector<HullSummary> hulls;                  // those of the sea file
    std::optional<SecondOrderSummary> second_order;  // absent in a linear sea
    std::vector<std::string> warnings;               // full sentences, for people
};

/// Returns the statistics without the whitecaps, for which add_whitecaps needs the modes. Needs
/// validated parameters.
SeaState sea_state(const DirectionalSpectrum& spectrum, const Parameters& parameters,
                   ThreadPool& pool);
/// Adds whitecap_coverage, foam_threshold and folded_share to a state of the same sea, and a
/// warning if crests fold.
void add_whitecaps(const Modes& modes, const SurfaceSettings& settings, SeaState& state);
/// Returns a sentence for each JONSWAP or TMA system whose fetch makes higher or longer waves than
/// a fully developed sea has [Pierson and Moskowitz 1964], with both heights, or both periods where
/// the height is given, and the fetch of full development. A system whose height and period are
/// both given has no warning. Reads the wave systems and the water; sea_state() includes these
/// warnings.
std::vector<std::string> full_development_warnings(const Parameters& parameters);
/// Returns the JSON object of `ocean info --json`.
std::string sea_state_json(const SeaState& state);

}  // namespace ocean
