// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The small map of one cascade; see cascade_map.hpp.
#include "ocean/internal/cascade_map.hpp"
#include "ocean/internal/map_request.hpp"

#include <array>

namespace ocean {

CascadeMap::CascadeMap(std::size_t cascade, int resolution, const Backend& backend)
    : cascade_(cascade), resolution_(resolution), maps_(backend.start()) {
    if (resolution != 0) require_resolution(resolution);
}

const LinearPlanes<float>& CascadeMap::planes(const Modes& modes, double time, LinearSet fields,
                                              ThreadPool& pool) {
    require_time(time);
    const int own = modes.cascades[cascade_].lattice.resolution;
    const Lattice map{resolution_ != 0 ? resolution_ : own, 1.0};
    std::array<MapOutput, kLinearCount> outputs;
    std::size_t count = 0;
    for (const Linear field : kLinears) {
        if (!fields.contains(field)) continue;
        planes_[field].resize(map.size());
        outputs[count++] = {planes_[field].data(), 1, {{{field, 1.0f}}}};
    }
    const MapModes small = cascade_modes(modes, cascade_, time, map.resolution);
    maps_({small, {}, std::span(outputs).first(count), {}}, pool);
    return planes_;
}

}  // namespace ocean
