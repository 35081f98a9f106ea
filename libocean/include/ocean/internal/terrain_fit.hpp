// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits a terrain to an elevation model: finds the law whose land has the model's density in every
// ring of wavenumbers, and reports what the law does and does not reproduce.
//
// Model and terrain are judged alike. A terrain is made with several seeds, a part of the model's
// size is cut out of each, and its rings are measured as the model's are, so that window and edges
// are the same in both. No seed corrects a law: the mean over all seeds is computed.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "ocean/internal/elevation.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean {

enum class FitLaw {
    table,   // the rings themselves
    broken,  // one exponent for long and one for short waves, and the wavelength between them
    one,     // one exponent
};

struct TerrainFitOptions {
    FitLaw law = FitLaw::table;
    bool ridge = false;  // with FitLaw::broken: a raised band, too
    int seeds = 16;      // seeds that judge the fit, kMinFitSeeds .. kMaxFitSeeds
    int threads = 0;     // 0 = the cores this process may use
    /// Called after each of the `of` terrains. If it throws, the fit ends.
    std::function<void(int done, int of)> progress = {};
};
inline constexpr int kMinFitSeeds = 4;
inline constexpr int kMaxFitSeeds = 256;

/// A ring of wavenumbers.
struct FittedRing {
    double wavenumber = 0.0;  // [rad/m]
    double density = 0.0;     // of the elevation model [m^4]
    double count = 0.0;       // independent waves
    double model = 0.0;       // mean of the terrain's seeds [m^4]
    double scatter = 0.0;     // standard deviation of log10 of the density between seeds

    /// Returns log10(model / density).
    double residual() const;
};

/// The rings of an octave.
struct FittedOctave {
    double longest_wave = 0.0;  // [m]; the shortest is half of it
    double error = 0.0;         // root mean square of the rings' residuals, weighted by count
    double scatter = 0.0;       // the same mean of the rings' scatters
};

struct FittedParameter {
    std::string name;
    double value = 0.0;
    bool is_at_bound = false;  // the best value may lie beyond
};

/// Shares of the land whose slopes Relief::slopes bounds.
inline constexpr std::array<double, 3> kReliefShares = {0.5, 0.9, 0.99};

struct Relief {
    double rms = 0.0;                // about the least-squares plane [m]
    double rms_about_mean = 0.0;     // [m]
    double skewness = 0.0;           // of the heights about the plane; 0 for Gaussian land
    std::array<double, 3> slopes{};  // [degrees]
    double anisotropy = 1.0;         // ratio of the rms slopes along the steepest and flattest axis
    double direction = 0.0;          // of the steepest axis [degrees counter-clockwise from +x]
};

struct TerrainFit {
    TerrainModel terrain;
    double cell = 0.0;  // of the terrain [m]
    std::vector<FittedRing> rings;
    std::vector<FittedOctave> octaves;  // from the longest waves
    std::vector<FittedParameter> parameters;
    Relief bed;
    Relief model;           // means of the seeds that judge
    double kept_rms = 0.0;  // rms that the terrain should have [m]: see fit_terrain
    double rms = 0.0;       // of the terrain's tile with its seed, about the mean [m]
    std::vector<std::string> warnings;

    /// Returns the largest error of an octave but the first, which has few waves.
    double error_above_lowest() const;
};

/// Fits a tile with square cells, as wide as the coarser side of the model's cells, and with the
/// smallest power of two of samples, at most 2048 along a side, that holds the model; a larger
/// model is judged by squares that overlap. The tile has the variance of the model about its mean,
/// or about its plane if the plane is steeper than the waves of a tile make one. Its seed is the
/// one of 512 whose longest waves have that variance while the others have the density of the
/// rings; the next best seeds judge the fit. Waves longer than the model are left out. A table law
/// has the exponent of its land as beta. Throws Error invalid_value for fewer than 32 cells along a
/// side, for holes, and for a flat model; out_of_memory.
TerrainFit fit_terrain(const ElevationModel& model, const TerrainFitOptions& options = {});

}  // namespace ocean
