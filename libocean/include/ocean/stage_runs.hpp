// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Counters of how often each stage of the chain ran: the cost of a change, for tests and tools.
#pragma once

namespace ocean {

struct StageRuns {
    int spectrum = 0;
    int modes = 0;
    int packing = 0;    // packings of the modes for a resolution of maps
    int threshold = 0;  // of the whitecaps
    int cover_power = 0;
    int surface = 0;      // requested maps
    int foam_ticks = 0;   // whitecap maps of the foam's clock
    int spray_ticks = 0;  // maps of the spray's lattice

    bool operator==(const StageRuns&) const = default;
};

}  // namespace ocean
