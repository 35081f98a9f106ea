// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The spectral law of a terrain: its density over the wavenumber plane.
//
//   S(kx, ky) = P(k') (1 + g q(k') cos^2s(theta - r)),   k' = |(u / sqrt(a), v sqrt(a))|
//
//   P  = k^-2beta [Mandelbrot 1983], with each break at kb, from b1 to b2, multiplied by
//        (1 + (k / kb)^4)^(-(b2 - b1) / 2), and (k^2 + ko^2)^-beta with an outer scale 2 pi / ko
//        [von Karman 1948]; or a table of measured rings, straight lines over log k and log S
//   u, v  components of k [rad/m] along and across `direction`, a the anisotropy
//   q  = exp(-log2(k / kr)^2 / (2 w^2)), the band of the ridges: gain g, width w [octaves],
//        direction r, spread s; without a direction the cosine is 1
//
// S is 0 beyond the limits of wavelength. It is a density: variance = integral S dkx dky. Tests:
// terrain_law_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ocean/terrain_model.hpp"

namespace ocean {

/// The waves of a land with gullies in two parts, because gullies replace the waves in between:
/// `smooth` has the longer waves, which steer the gullies, `fine` the waves shorter than the
/// smallest gully. With k1 = 2 pi / (7/3 longest), k2 = 2 pi / smallest:
///
///   S_smooth = S (1 + (k / k1)^4)^-0.9,   S_fine = S / (1 + (k2 / k)^8)
///
/// Without gullies `smooth` is the whole and `fine` is nothing.
enum class LawPart { whole, smooth, fine };

class TerrainLaw {
  public:
    /// Needs a validated terrain.
    explicit TerrainLaw(const TerrainModel& terrain, LawPart part = LawPart::whole);

    /// Returns S at (kx, ky) [rad/m]; 0 at k = 0.
    double density(double kx, double ky) const;
    /// Returns true if S is in [m^4]; else it is relative, and rms or range scale the terrain.
    bool is_absolute() const { return absolute_; }

    /// Returns the local exponent of amplitude, -1/2 d log S / d log k, of the mean over all
    /// directions at a wavenumber k [rad/m], by a difference over half an octave.
    double exponent(double k) const;

  private:
    friend class TerrainAmplitudes;

    double radial(double k) const;                     // P, with ridges that have no direction
    double ridge(double k) const;                      // g q(k)
    double turning(double theta) const;                // cos^2s
    double scaled_square(double kx, double ky) const;  // k'^2
    bool has_wave(double k) const;
    double measured(double log_k) const;  // log S
    double log_part(double log_k) const;  // log of the part's share of S

    double exponent_;
    double outer_square_ = 0.0;  // ko^2 [rad^2/m^2]
    struct Break {
        double log_k;
        double change;  // of the exponent
    };
    std::vector<Break> breaks_;
    double ridge_log_k_ = 0.0;
    double ridge_gain_ = 0.0;
    double ridge_width_ = 1.0;  // [ln of k]
    bool ridge_turns_ = false;
    double ridge_direction_ = 0.0;
    double ridge_spread_ = 0.0;
    double min_k_, max_k_;  // of the limits of wavelength
    double anisotropy_, cosine_, sine_;
    bool absolute_ = false;
    LawPart part_;
    double log_part_k_ = 0.0;            // of k1 or k2
    std::vector<double> log_k_, log_s_;  // of measured rings
    double first_slope_ = 0.0, last_slope_ = 0.0;
};

/// Cells of k^2, 1024 to an octave, with straight lines between them: the grid of a table over the
/// wavenumber, which is read without a logarithm.
struct WavenumberCells {
    static constexpr int kOctaveBits = 10;

    /// The cell of a k^2 [rad^2/m^2], and the position within the cell, 0 .. 1.
    struct Place {
        std::int64_t cell;
        double part;
    };
    static Place place_of(double square);
    /// Returns the k^2 at which a cell begins.
    static double begin_of(std::int64_t cell);
};

/// sqrt(S) of a law, fast: P from a table over WavenumberCells, which differs from a power law by
/// 3e-7; the limits of wavelength are exact. A value depends on the law and on k alone, so that
/// every grid gets the same bits.
class TerrainAmplitudes {
  public:
    /// Makes the table for wavenumbers min_k .. max_k [rad/m], 0 < min_k <= max_k.
    TerrainAmplitudes(const TerrainLaw& law, double min_k, double max_k);

    /// Returns sqrt(S(kx, ky)) with k within the range of the table.
    double operator()(double kx, double ky) const;
    /// Writes row[n] = sqrt(S(n dk, ky)).
    void row(double dk, double ky, std::span<double> row) const;

    /// Returns true if S depends on the direction of k.
    bool turns() const { return turns_; }
    /// Returns true if waves of the lattice lie beyond the limits of wavelength.
    bool has_limits() const;
    /// Returns the value at the beginning of a cell.
    double at_cell(std::int64_t cell) const {
        return table_[static_cast<std::size_t>(cell - first_)];
    }

  private:
    TerrainLaw law_;
    bool turns_;
    double min_k_, max_k_;
    std::int64_t first_;
    std::vector<double> table_;
};

}  // namespace ocean
