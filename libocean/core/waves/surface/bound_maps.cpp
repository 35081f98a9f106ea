// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "waves/surface/bound_maps.hpp"

#include <vector>

#include "ocean/thread_pool.hpp"

namespace ocean {

void BoundMaps::make(const MapRequest& request, LinearSet fields, ThreadPool& pool) {
    const bool rates = fields.contains(Linear::height_rate);
    const Modes& bound = waves_.at(request.modes, request.settings.choppiness, rates, pool);
    MapModes modes = map_modes(bound, 0.0, request.modes.resolution);
    modes.held_by = request.modes.held_by;
    std::vector<MapOutput> outputs;
    for (const Linear field : kLinears) {
        if (!fields.contains(field)) continue;
        planes_[field].resize(Lattice{modes.resolution, 1.0}.size());
        outputs.push_back({planes_[field].data(), 1, {{{field, 1.0f}}}});
    }
    maps_({modes, request.settings, outputs, {}}, pool);
    if (!fields.contains(Linear::height)) return;
    const auto mean = static_cast<float>(waves_.mean());
    for (float& height : planes_[Linear::height]) height += mean;
}

}  // namespace ocean
