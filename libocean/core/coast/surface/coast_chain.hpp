// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The chain of a coast: statics -> surface -> sums. Each stage is computed when it is first needed
// and kept until a change of the sea dirties it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "coast/statics/shore_statics.hpp"
#include "coast/surface/shore_surface.hpp"
#include "ocean/backend.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/internal/revision.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

class ThreadPool;

/// Is called with what is being made and the share of it that is done, 0 .. 1; may throw to stop.
using BuildProgress = std::function<void(std::string_view work, double share)>;

/// The sea at one time, as a coast needs it.
struct CoastSea {
    const Parameters& parameters;  // with a bed
    const DirectionalSpectrum& spectrum;
    const Revision& spectrum_revision;
    const Modes& modes;
    int shown;  // samples of the map whose waves count
};

class CoastChain {
  public:
    CoastChain() = default;
    /// Makes the coast of another thread, which shares the statics.
    CoastChain(const CoastChain& built)
        : statics_(built.statics_),
          made_of_(built.made_of_),
          known_(built.known_),
          known_over_(built.known_over_) {}
    CoastChain& operator=(const CoastChain&) = delete;

    /// Max bytes of kept delays: those of the last sea and of seas before it.
    static constexpr std::uint64_t kKnownBytes = std::uint64_t{256} << 20;

    /// Returns the statics. When the bed or its water has changed it makes them; when the sea has,
    /// their energy and the delays of those pairs of a band and a sector that no sea before had, or
    /// had so long ago that kKnownBytes did not hold them. Throws Error invalid_value for a sea
    /// without waves, and out_of_memory.
    const ShoreStatics& statics(const CoastSea& sea, ThreadPool& pool,
                                const BuildProgress& progress);
    /// Returns the surface at a time [s]. Valid until the next call. cells: see
    /// ShoreSurface::move_to.
    ShoreSurface& surface(const CoastSea& sea, double time, ShoreSurface::Rates rates,
                          ThreadPool& pool, const BuildProgress& progress,
                          const SignalCells* cells = nullptr);
    /// A surface with rates, for reads by its sums: its own time may be another.
    struct Exact {
        ShoreSurface& surface;
        const ShoreSums& sums;
    };
    /// Returns the sums over the modes at a time [s]. Valid until the next call.
    Exact exact(const CoastSea& sea, double time, ThreadPool& pool, const BuildProgress& progress);

    /// Returns the function by which a backend sums the waves; empty: it leaves them to the
    /// processor.
    const CoastFunction& summed_by(const Backend& backend) {
        if (!sum_waves_ && backend.start_coast != nullptr) sum_waves_ = backend.start_coast();
        return sum_waves_;
    }

  private:
    ShoreSurface& current_surface(const CoastSea& sea, ShoreSurface::Rates rates, ThreadPool& pool,
                                  const BuildProgress& progress);
    /// The input of the statics, compared with that of the next call.
    struct Source {
        Water water;
        // The bands end at its limits of wavelength and at the finest cascade's Nyquist line.
        Grid grid;
        double shortest_wavelength = 0.0;
        double longest_wavelength = 0.0;
        Revision spectrum;
        bool operator==(const Source&) const = default;
    };
    void keep(const std::vector<BandSectorDelays>& pairs);

    ShoreStatics statics_;
    Source made_of_;
    std::vector<BandSectorDelays> known_;  // the last used ones first
    Water known_over_;                     // without what delays do not depend on
    std::optional<ShoreSurface> surface_;
    std::optional<ShoreSums> sums_;  // of surface_
    Revision surface_modes_;
    double surface_choppiness_ = 0.0;
    int surface_shown_ = 0;
    bool moved_ = false;
    CoastFunction sum_waves_;
};

}  // namespace ocean
