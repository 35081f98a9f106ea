// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The linear fields of bound waves on a map, by the map's own backend.
#pragma once

#include "ocean/backend.hpp"
#include "ocean/internal/make_surface.hpp"
#include "waves/bound/bound_waves.hpp"

namespace ocean {

/// The linear fields that bound waves change.
inline constexpr LinearSet kBoundFields = {Linear::height, Linear::slope_x, Linear::slope_y,
                                           Linear::height_rate};

class BoundMaps {
  public:
    explicit BoundMaps(const Backend& backend) : maps_(backend.start()) {}

    /// Makes planes of some of kBoundFields for the map of a request, whose binding_limit is not 0.
    void make(const MapRequest& request, LinearSet fields, ThreadPool& pool);
    /// Returns the planes that make() made last.
    const LinearPlanes<float>& planes() const { return planes_; }

  private:
    BoundWaves waves_;
    MapFunction maps_;
    LinearPlanes<float> planes_;
};

}  // namespace ocean
