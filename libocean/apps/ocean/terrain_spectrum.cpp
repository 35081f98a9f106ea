// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See terrain_spectrum.hpp.
#include "terrain_spectrum.hpp"

#include "ocean/internal/grid.hpp"
#include "text.hpp"

namespace ocean::app {

std::string terrain_rings_csv(std::span<const TerrainRing> rings) {
    std::string csv =
        "wavenumber,wavelength_m,count,density,asked_m4,seeds_mean_m4,seeds_scatter_log10\n";
    for (const TerrainRing& ring : rings) {
        csv += format_text("%.9g,%.6g,%.0f,%.6g,%.6g,%.6g,%.4f\n", ring.wavenumber,
                           kTwoPi / ring.wavenumber, ring.count, ring.tile, ring.asked, ring.mean,
                           ring.scatter);
    }
    return csv;
}

}  // namespace ocean::app
