// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The backend `thesis`: each linear field by the transform of [Fluegge 2017]; channels are made of
// them by their formulas. See ocean/gl/backend.hpp.
#include <map>

#include "checks.hpp"
#include "gpu_function.hpp"
#include "ocean/gl/backend.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/page_vector.hpp"
#include "thesis_frame.hpp"
#include "write_quantity.hpp"

namespace ocean::gl {

namespace {

class ThesisMaps {
  public:
    explicit ThesisMaps(const ContextInfo& limits) : limits_(limits) {}

    bool write(const MapRequest& request, ThreadPool& pool) {
        const int resolution = request.modes.resolution;
        auto found = frames_.find(resolution);
        if (found == frames_.end()) {
            found = frames_.emplace(resolution, ThesisFrame(resolution, limits_)).first;
        }
        ThesisFrame& frame = found->second;
        const bool uploaded = frame.load(request, pool);
        texels_.resize(Lattice{resolution, 1.0}.size());
        const LinearSet fields = fields_of(request.outputs);
        for (const Linear field : kLinears) {
            if (!fields.contains(field)) continue;
            frame.transform(field, request);
            glBindTexture(GL_TEXTURE_2D, frame.field().name());
            glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, texels_.data());
            require_no_error("reading a field back");
            write_quantity(request, field, texels_.data(), 1, pool);
        }
        return uploaded;
    }

  private:
    ContextInfo limits_;
    std::map<int, ThesisFrame> frames_;
    PageVector<float> texels_;
};

std::uint64_t thesis_bytes(const Grid&, LinearSet, int resolution) {
    return Lattice{resolution, 1.0}.size() * (20 + 2 * 8 + 4 + 4);
}

/// Returns the fitness of `gl`, but never fast: `thesis` is always slower than `gl`.
BackendFitness thesis_fitness(int resolution) {
    BackendFitness fitness = kBackend.fitness(resolution);
    fitness.fast = false;
    return fitness;
}

}  // namespace

const Backend kThesisBackend = {"thesis",
                                {},
                                [] { return MapFunction(GpuFunction<ThesisMaps>()); },
                                thesis_bytes,
                                thesis_fitness};

}  // namespace ocean::gl
