// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The modes of a sea as crests condition them: each with its variance P = E|h0|^2, in two parts.
// Long waves carry the crests, and short ones, which ride on them, are level there. Both parts are
// independent, so that each is conditioned alone, and a finer grid keeps the long waves' bits.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "ocean/internal/modes.hpp"

namespace ocean {

class ModeLattice;

/// The lattice and the spectrum from which a sea's modes were drawn.
struct CrestSource {
    const DirectionalSpectrum& spectrum;
    const Parameters& parameters;
    const ModeLattice& lattice;
    std::span<const double> gains;  // of the energy of each cascade, as set_waves returns them
};

/// One mode.
struct CrestWave {
    double kx = 0.0;         // [rad/m]
    double ky = 0.0;         // [rad/m]
    double rate_high = 0.0;  // as in CascadeModes
    double rate_low = 0.0;
    double omega = 0.0;         // [rad/s]
    double displacement = 0.0;  // coth(k d) / k [m]
    double variance = 0.0;      // P = E|h0|^2 [m^2]
    std::size_t cascade = 0;
    std::size_t index = 0;  // of its h0
};

enum class CrestPart { long_waves, short_waves };

/// The number of shares into which the modes are cut for any number of threads, so that sums over
/// the shares have the same bits.
inline constexpr int kCrestShares = 16;

/// Returns the largest wavenumber of the long waves [rad/m]: a twelfth of the peak wavelength, or
/// shorter where these waves hold less than 99 % of the energy.
double long_wave_limit(const CrestSource& source);

/// One part of the waves of a sea: the long waves, kept in memory, as crests go through them often,
/// or the short ones, whose variances are read anew.
class CrestWaves {
  public:
    using Visit = std::function<void(std::size_t share, const CrestWave&)>;

    /// Keeps references. limit: the largest wavenumber of the long waves [rad/m]. Long waves are
    /// those of the first cascade: the waves of other cascades repeat within the patch, and a crest
    /// must not.
    CrestWaves(const CrestSource& source, const Modes& modes, CrestPart part, double limit,
               ThreadPool& pool);

    /// Calls visit(share, wave) for each mode that has energy; the calls of one share come from one
    /// thread, in order.
    void for_each(const Visit& visit) const;

    const Parameters& parameters() const { return source_.parameters; }
    const DirectionalSpectrum& spectrum() const { return source_.spectrum; }
    const Modes& modes() const { return modes_; }

  private:
    void read(const Visit& visit) const;

    const CrestSource& source_;
    const Modes& modes_;
    CrestPart part_;
    double limit_;
    ThreadPool& pool_;
    std::vector<std::vector<CrestWave>> kept_;  // of each share
};

}  // namespace ocean
