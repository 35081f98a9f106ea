// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The `cpu` backend; see cpu_backend.hpp.
#include "waves/kernel/cpu_backend.hpp"

#include <map>
#include <memory>
#include <optional>

#include "base/shared_value.hpp"
#include "ocean/internal/map_request.hpp"
#include "packed_modes.hpp"

namespace ocean {

namespace {

/// The packed modes and the kernel for maps of one resolution. A map half as large needs a quarter
/// of the memory, so all resolutions are kept.
class CpuMap {
  public:
    CpuMap() = default;
    /// Shares the packed modes; the arrays of the transform are not shared.
    CpuMap(const CpuMap& other) : packed_(other.packed_), revision_(other.revision_) {}

    bool write(const MapRequest& request, ThreadPool& pool) {
        const bool packs = revision_ != request.modes.revision;
        if (packs) pack(request.modes, pool);
        if (!kernel_) kernel_.emplace(packed_.share());
        kernel_->run({request.modes.tau, request.settings, request.outputs, request.foam}, pool);
        return packs;
    }

  private:
    void pack(const MapModes& modes, ThreadPool& pool) {
        revision_ = {};
        PackedModes* const own = packed_.own();
        if (own == nullptr || !own->refill(modes, pool)) {
            packed_ = std::make_shared<PackedModes>(modes, pool, simd_level());
        }
        if (kernel_) kernel_->use(packed_.share());
        revision_ = modes.revision;
    }

    SharedValue<PackedModes> packed_;
    Revision revision_;  // of the packed modes
    std::optional<MapKernel> kernel_;
};

}  // namespace

MapFunction start_cpu() {
    return [maps = std::map<int, CpuMap>()](const MapRequest& request, ThreadPool& pool) mutable {
        return maps[request.modes.resolution].write(request, pool);
    };
}

}  // namespace ocean
