// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The cover's power on maps that are finer than the foam lattice.
#pragma once

#include "foam/gradient_process.hpp"
#include "ocean/foam.hpp"

namespace ocean {

/// Returns cover_power of a sea that squeezes and keeps foam, where the map holds waves that the
/// foam lattice does not.
double layered_cover_power(const CoverPowerInput& sea, const FoamWaves& waves,
                           const Stretch& stretch, ThreadPool& pool);

}  // namespace ocean
