// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Still water, and calm water behind walls too narrow for the maps of energy, at each sample of the
// bed: a cubic through cells of 16 m carries waves over a narrower wall.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "coast/bed/bed_grid.hpp"
#include "energy_march.hpp"
#include "field/jet.hpp"
#include "field/quad_grid.hpp"
#include "ocean/domain.hpp"

namespace ocean {

/// The numbers of a place.
struct LeeSample {
    Jet height{1.0f};  // factor on the waves of the maps of energy, 0 .. 1
    Jet inside{0.0f};  // min share of the coast's surface behind land
};

class LeeMap {
  public:
    LeeMap() = default;
    LeeMap(const Domain& bed, std::vector<std::array<float, 2>> samples)
        : domain_(bed), samples_(std::move(samples)) {}

    /// An empty map returns {1, 0} everywhere, as every map does beyond the bed.
    bool is_empty() const { return samples_.empty(); }
    std::size_t bytes() const { return samples_.size() * sizeof(samples_[0]); }
    /// Returns the numbers of a place [m], smooth between the samples and within their range.
    LeeSample at(double x, double y) const;

  private:
    Domain domain_;
    std::vector<std::array<float, 2>> samples_;  // height, inside
};

/// Returns the map of a bed, empty if the maps of energy are right everywhere. `maps` must have
/// been continued onto the land, and `heights` has their rms_height as its first field. margin: the
/// width of the strip along the border where the open sea fades in [m].
LeeMap make_lee_map(const BedGrid& bed_height, const EnergyMaps& maps, const QuadGrid& heights,
                    double margin);

}  // namespace ocean
