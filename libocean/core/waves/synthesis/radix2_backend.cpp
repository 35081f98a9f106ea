// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The `radix2` backend: one full complex transform per field, as in the textbook.
#include "ocean/internal/fft.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/synthesis/mode_grid.hpp"

namespace ocean {

LinearPlanes<float> synthesize_radix2(const MapModes& modes, LinearSet fields, ThreadPool& pool) {
    LinearPlanes<float> planes;
    const Radix2Fft<float> fft(modes.resolution);
    // Each field is a work item: the planes are independent of each other.
    pool.for_each_item(kLinearCount, [&](int item, int) {
        const Linear field = kLinears[static_cast<std::size_t>(item)];
        if (!fields.contains(field)) return;
        auto grid = coefficient_grid<float>(modes, field);
        fft.transform_2d(grid, FftDirection::inverse);
        planes[field].resize(grid.size());
        for (std::size_t i = 0; i < grid.size(); ++i) planes[field][i] = grid[i].real();
    });
    return planes;
}

}  // namespace ocean
