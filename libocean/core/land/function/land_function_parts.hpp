// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts whose sum is a LandFunction.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "field/mask_grid.hpp"
#include "field/spline_grid.hpp"
#include "land/function/fine_waves.hpp"
#include "land/function/shore_ground.hpp"
#include "ocean/internal/gullies.hpp"
#include "ocean/land_mask.hpp"

namespace ocean {

struct LandFunctionParts {
    Domain domain;        // see LandFunction::domain()
    double offset = 0.0;  // added to all heights [m]
    std::shared_ptr<const SplinePyramid> base;
    std::shared_ptr<const SplinePyramid> fine = nullptr;  // waves finer than gullies
    std::optional<GullyFilter> gullies = {};
    /// Replaces base, gullies and finer waves where a shore reaches; empty: no shore.
    std::shared_ptr<const ShoreGround> shore = nullptr;
    std::shared_ptr<const FineWaves> detail = nullptr;
    /// Share of the detail, lower on beaches and in water; empty: 1.
    std::shared_ptr<const MaskGrid> detail_share = nullptr;
    /// Masks of the domain; masks of gullies are computed instead.
    std::vector<std::pair<LandMask, std::shared_ptr<const MaskGrid>>> masks = {};
};

}  // namespace ocean
