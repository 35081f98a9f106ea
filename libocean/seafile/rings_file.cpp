// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The measured spectrum of a terrain; see rings_file.hpp.
#include "rings_file.hpp"

#include <cmath>
#include <cstddef>

#include "ocean/error.hpp"
#include "ocean/internal/elevation_file.hpp"
#include "ocean/internal/ring_spectrum.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

void validate_rings(const MeasuredRings& rings, const std::string& parameter) {
    constexpr std::size_t kMaxRings = 4096;
    const std::size_t count = rings.wavenumber.size();
    bool good = count >= 2 && count <= kMaxRings && rings.density.size() == count;
    for (std::size_t i = 0; good && i < count; ++i) {
        const double below = i > 0 ? rings.wavenumber[i - 1] : 0.0;
        good = rings.wavenumber[i] > below && std::isfinite(rings.wavenumber[i]) &&
               rings.density[i] >= 0.0 && std::isfinite(rings.density[i]);
    }
    if (good) return;
    throw Error(
        ErrorKind::invalid_value,
        {.what = "needs 2 .. 4096 ascending wavenumbers above 0 with a density of 0 or more "
                 "each",
         .parameter = parameter});
}

MeasuredRings read_measured_rings(const std::string& path) {
    if (path.ends_with(".csv")) return read_rings(path);
    const ElevationModel model = read_elevation(path, {.holes = HolePolicy::fill});
    ThreadPool pool;
    MeasuredRings rings;
    for (const Ring& ring : measure_rings(model.domain, model.heights, pool)) {
        rings.wavenumber.push_back(ring.wavenumber);
        rings.density.push_back(ring.density);
    }
    return rings;
}

}  // namespace ocean
