// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade's coast, for those of its files that need it.
#pragma once

#include "chain.hpp"
#include "coast/surface/coast.hpp"
#include "ocean/ocean.hpp"

namespace ocean {

template <typename Body>
decltype(auto) Ocean::with_coast_sea(double time, const Body& body) {
    require_time(time);
    go_to(time);
    const DirectionalSpectrum& spectrum = chain_->spectrum(pool_, runs_);
    const Modes& modes = current_modes();
    return body(CoastSea{now(), spectrum, chain_->spectrum_revision(), modes,
                         default_map_resolution(now().grid)});
}

}  // namespace ocean
