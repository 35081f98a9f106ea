// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The tiles of the detail, with the data that each band keeps between times, as the chain does for
// the sea. This is the last stage of the pipeline, behind Ocean::detail.
#pragma once

#include <span>
#include <vector>

#include "ocean/surface.hpp"
#include "waves/detail/detail_plan.hpp"
#include "waves/surface/map_writer.hpp"

namespace ocean {

class DetailMaps {
  public:
    DetailMaps(const DetailSettings& settings, const Backend& backend)
        : settings_(settings), backend_(backend) {}

    /// Sets the parameters and their spectrum, whose revision is `revision`. Keeps all results that
    /// neither change affects.
    void set_parameters(const Parameters& parameters, const DirectionalSpectrum& spectrum,
                        const Revision& revision, ThreadPool& pool);
    const DetailBudget& budget() const { return budget_; }

    /// Writes the slopes of one time: outputs[i] receives multiples of the slopes of band i.
    /// `spectrum` must be the spectrum passed to set_parameters.
    void write(double time, const DirectionalSpectrum& spectrum, std::span<const MapOutput> outputs,
               ThreadPool& pool);

  private:
    struct Tile {
        CascadeBand ring;
        ModeLattice lattice;
        Modes modes;        // without a revision, because their waves are not made
        double gain = 1.0;  // of the modes' slopes: scales their sum to the band's integral
        MapWriter maps;
    };

    DetailSettings settings_;
    Backend backend_;
    Revision revision_;  // revision of the spectrum of the budget
    DetailBudget budget_;
    std::vector<Tile> tiles_;
};

}  // namespace ocean
