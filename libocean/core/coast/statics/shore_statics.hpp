// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The data of a coast that do not change with time: where its waves come from and when (delays),
// how much of them arrives (energy), the bed. They are made once for a sea; forks and shards share
// them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "coast/bed/bed_grid.hpp"
#include "coast/statics/lee_map.hpp"
#include "coast/statics/shore_bands.hpp"
#include "coast/statics/shore_depths.hpp"
#include "coast/statics/shore_progress.hpp"
#include "field/quad_grid.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

class ThreadPool;

/// The delays of the waves of one band and sector: shift_x, shift_y [m], phase [rad], and the angle
/// by which the waves have turned from the centre of their sector [rad]. Delays depend on the bed,
/// its level, the edges of the band and the sector alone, so that seas share them.
struct BandSectorDelays {
    double low = 0.0;  // edges of the band [rad/m]
    double high = 0.0;
    int sector = 0;
    std::shared_ptr<const QuadGrid> maps;
};

/// The delays of the waves of a coast. They depend on the bed, its level and the division of the
/// sea, not on wave heights.
struct ShoreDelays {
    ShoreBands bands;
    std::vector<BandSectorDelays> waves;  // one for each of bands.waves
    /// Height of the bed [m], depth that waves feel [m], slope of the bed where waves break, and
    /// the influence of the bed by delays: 0 where the waves are the open sea's, 1 at the coast.
    QuadGrid ground;
};

/// The energy that arrives. A change of heights or periods recomputes it cheaply.
struct ShoreEnergy {
    /// Amplitudes relative to the open sea of waves 4 i .. 4 i + 3 of ShoreBands::waves.
    std::vector<QuadGrid> amplitudes;
    /// Hrms of all waves [m], share of them that break, share of the open sea's energy that
    /// arrives unbroken, width of wave groups.
    QuadGrid breaking;
    /// Amplitude of the waves that are in no band, correlation of the coast's surface with the open
    /// sea's, and the influence of the bed by energy, 0 .. 1.
    QuadGrid remainder;
    LeeMap lee;
    ShoreDepths depths;
    double open_height = 0.0;  // significant wave height offshore [m]
    double peak_omega = 0.0;   // [rad/s]
};

struct ShoreStatics {
    std::shared_ptr<const ShoreDelays> delays;
    std::shared_ptr<const ShoreEnergy> energy;

    const ShoreBands& bands() const { return delays->bands; }
    const Domain& domain() const { return delays->ground.domain(); }
    /// Returns the share of the coast's surface at a place [m]: 0 beyond the border of the bed, 1
    /// from the border_margin inwards, and 1 behind land that keeps the open sea off.
    Jet share_of_coast(double x, double y) const;
};

/// Returns the delays over a bed. Needs a spectrum that is not flat. `known`: pairs of other seas
/// over the same bed and water, which are reused; they change no bit of the result. Throws as
/// shore_delays.
std::shared_ptr<const ShoreDelays> make_shore_delays(const BedGrid& bed, const ShoreBands& bands,
                                                     const Water& water, ThreadPool& pool,
                                                     const ShoreProgress& progress = {},
                                                     std::span<const BandSectorDelays> known = {});
/// Returns the energy over the same bed.
std::shared_ptr<const ShoreEnergy> make_shore_energy(const BedGrid& bed, const ShoreDelays& delays,
                                                     const DirectionalSpectrum& spectrum,
                                                     const Water& water, ThreadPool& pool,
                                                     const ShoreProgress& progress = {});

/// Returns an upper bound on the memory of the delays and the energy of `waves` waves, including
/// the work space that builds them [bytes].
std::uint64_t shore_statics_bytes(const Domain& bed, std::size_t waves);

}  // namespace ocean
