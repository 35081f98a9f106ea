// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The tiles of the detail at work: what a band keeps from time to time, as the chain does of the
// sea. Last stage of the pipeline, behind Ocean::detail.
#pragma once

#include <span>
#include <vector>

#include "detail/detail_plan.hpp"
#include "ocean/map_output.hpp"
#include "surface/map_writer.hpp"

namespace ocean {

class DetailMaps {
  public:
    DetailMaps(const DetailSettings& settings, const Backend& backend)
        : settings_(settings), backend_(backend) {}

    /// From now on for these parameters and their spectrum, of which `revision` is. What neither
    /// has changed stays.
    void stand_for(const Parameters& parameters, const DirectionalSpectrum& spectrum,
                   const Revision& revision, ThreadPool& pool);
    const DetailBudget& budget() const { return budget_; }

    /// Of a time: outputs[i] of band i, multiples of its slopes. The spectrum is that of
    /// stand_for.
    void write(double time, const DirectionalSpectrum& spectrum, std::span<const MapOutput> outputs,
               ThreadPool& pool);

  private:
    struct Tile {
        CascadeBand ring;
        ModeLattice lattice;
        Modes modes;        // without a revision: their waves are not made
        double gain = 1.0;  // of the modes' slopes, so that their sum is the band's integral
        MapWriter maps;
    };

    DetailSettings settings_;
    Backend backend_;
    Revision revision_;  // of the spectrum that the budget is of
    DetailBudget budget_;
    std::vector<Tile> tiles_;
};

}  // namespace ocean
