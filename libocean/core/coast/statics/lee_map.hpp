// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Water that is still, or calm behind walls that the maps of energy are too coarse for, at each
// sample of the bed: a cubic through cells of 16 m carries waves over a wall that is narrower.
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
    Jet height{1.0f};  // by which waves are lower than the maps of energy have them, 0 .. 1
    Jet inside{0.0f};  // the least share of the coast's surface, where land keeps off the open sea
};

class LeeMap {
  public:
    LeeMap() = default;
    LeeMap(const Domain& bed, std::vector<std::array<float, 2>> samples)
        : domain_(bed), samples_(std::move(samples)) {}

    /// An empty map has {1, 0} everywhere, as places beyond the bed have.
    bool is_empty() const { return samples_.empty(); }
    std::size_t bytes() const { return samples_.size() * sizeof(samples_[0]); }
    /// Returns the numbers of a place [m], smooth between the samples and within theirs.
    LeeSample at(double x, double y) const;

  private:
    Domain domain_;
    std::vector<std::array<float, 2>> samples_;  // height, inside
};

/// Returns the map of a bed, empty where the maps of energy are right everywhere. `maps` are those
/// that were continued onto the land, and `heights` has their rms_height as its first field.
/// margin: the width of the strip along the border where the open sea fades in [m].
LeeMap make_lee_map(const BedGrid& bed_height, const EnergyMaps& maps, const QuadGrid& heights,
                    double margin);

}  // namespace ocean
