// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How often each stage of the chain ran, for those who want to know what a change costs.
#pragma once

namespace ocean {

struct StageRuns {
    int spectrum = 0;
    int modes = 0;
    int packing = 0;    // of the modes for one resolution of maps
    int threshold = 0;  // of the whitecaps
    int cover_power = 0;
    int surface = 0;      // maps that were asked for
    int foam_ticks = 0;   // whitecap maps of the foam's clock
    int spray_ticks = 0;  // maps of the spray's lattice

    bool operator==(const StageRuns&) const = default;
};

}  // namespace ocean
