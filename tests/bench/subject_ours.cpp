// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Our kernel as a subject: packed modes, and outputs in the caller's memory.
#include "subject_ours.hpp"

#include <utility>

#include "frame_maps.hpp"
#include "ocean/internal/map_request.hpp"

namespace ocean::bench {

OurFrame::OurFrame(const Sea& sea, int threads, SimdLevel level, const CacheSizes& caches)
    : modes_(&sea.modes),
      pool_(std::make_unique<ThreadPool>(threads)),
      kernel_(pack_modes(map_modes(sea.modes, 0.0, sea.modes.lattice.resolution), *pool_, level),
              caches) {
    frame_.settings = VertexMaps::settings();
}

void OurFrame::show(std::vector<MapOutput> outputs, const SurfaceSettings& settings,
                    const FoamLayer& foam) {
    outputs_ = std::move(outputs);
    frame_.settings = settings;
    frame_.foam = foam;
    frame_.outputs = outputs_;
}

void OurFrame::run(double time) {
    frame_.tau = modes_->tau(time);
    kernel_.run(frame_, *pool_);
}

Subject make_ours(const Cell& cell) {
    struct State {
        OurFrame frame;
        std::unique_ptr<VertexMaps> vertices;
        std::unique_ptr<PlanarMaps> planes;
    };
    const int n = cell.resolution();
    const std::vector<Linear> fields = fields_of(cell.kind);
    const auto state = std::make_shared<State>(
        State{OurFrame(*cell.sea, cell.threads, cell.level), nullptr, nullptr});
    if (cell.kind == FrameKind::vertices) {
        state->vertices = std::make_unique<VertexMaps>(n);
        const auto outputs = state->vertices->outputs();
        state->frame.show({outputs.begin(), outputs.end()}, VertexMaps::settings());
    } else {
        state->planes = std::make_unique<PlanarMaps>(n, fields);
        state->frame.show(state->planes->outputs(), VertexMaps::settings());
    }
    Subject result;
    result.library = "ours";
    result.variant = simd_name(cell.level);
    result.frame = [state](double time) { state->frame.run(time); };
    result.field = [state](Linear field) {
        return state->vertices ? state->vertices->field(field) : state->planes->field(field);
    };
    result.normal = [state](Channel channel) { return state->vertices->normal(channel); };
    return result;
}

}  // namespace ocean::bench
