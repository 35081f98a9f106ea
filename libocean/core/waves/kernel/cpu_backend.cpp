// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The `cpu` backend; see cpu_backend.hpp.
#include "waves/kernel/cpu_backend.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "base/shared_value.hpp"
#include "ocean/internal/kernel_backends.hpp"
#include "ocean/internal/map_request.hpp"
#include "packed_modes.hpp"

namespace ocean {

namespace {

/// The packed modes and the kernel for maps of one resolution. A map half as large needs a quarter
/// of the memory, so all resolutions are kept.
class CpuMap {
  public:
    explicit CpuMap(SimdLevel (*level)()) : level_(level) {}
    /// Shares the packed modes; the arrays of the transform are not shared.
    CpuMap(const CpuMap& other)
        : level_(other.level_), packed_(other.packed_), revision_(other.revision_) {}

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
            packed_ = std::make_shared<PackedModes>(modes, pool, level_());
        }
        if (kernel_) kernel_->use(packed_.share());
        revision_ = modes.revision;
    }

    SimdLevel (*level_)();
    SharedValue<PackedModes> packed_;
    Revision revision_;  // of the packed modes
    std::optional<MapKernel> kernel_;
};

MapFunction start_kernel(SimdLevel (*level)()) {
    return [level, maps = std::map<int, CpuMap>()](const MapRequest& request,
                                                   ThreadPool& pool) mutable {
        return maps.try_emplace(request.modes.resolution, level).first->second.write(request, pool);
    };
}

template <SimdLevel kLevel>
MapFunction start_kernel_of() {
    return start_kernel([] { return kLevel; });
}

}  // namespace

MapFunction start_cpu() {
    return start_kernel(simd_level);
}

std::span<const Backend> kernel_backends() {
    using enum SimdLevel;
    static const std::vector<Backend> backends = [] {
        std::vector<Backend> all;
        const auto add = [&](SimdLevel level, MapFunction (*start)()) {
            if (level > simd_level() || !simd_available(level)) return;
            all.push_back({.name = simd_name(level),
                           .makes = kCpuChannels,
                           .start = start,
                           .work_bytes = kernel_bytes,
                           .keeps_foam = true});
        };
        add(avx512, start_kernel_of<avx512>);
        add(avx2, start_kernel_of<avx2>);
        add(sse4, start_kernel_of<sse4>);
        add(portable, start_kernel_of<portable>);
        return all;
    }();
    return backends;
}

}  // namespace ocean
