// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The `cpu` backend; see cpu_backend.hpp.
#include "waves/kernel/cpu_backend.hpp"

#include <array>
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
        : level_(other.level_), packed_(other.packed_), from_(other.from_) {}

    bool write(const MapRequest& request, ThreadPool& pool) {
        const MapModes& modes = request.modes;
        const bool passes = !modes.toward.empty();
        // The next step of a glide begins where the last ended, or ends where it began.
        const bool turns = packed_[1 - from_].revision == modes.revision ||
                           (passes && packed_[from_].revision == modes.toward_revision);
        if (turns) from_ = 1 - from_;
        Packed& from = packed_[from_];
        Packed& to = packed_[1 - from_];
        bool packs = pack(modes, from, pool);
        if (kernel_ && (packs || turns)) kernel_->use(from.modes.share());
        if (passes) {
            MapModes end = modes;
            end.cascades = modes.toward;
            end.revision = modes.toward_revision;
            packs = pack(end, to, pool) || packs;
        }
        if (!kernel_) kernel_.emplace(from.modes.share());
        kernel_->interpolate(passes ? to.modes.share() : nullptr, modes.share);
        kernel_->run({modes.tau, request.settings, request.outputs, request.foam}, pool);
        return packs;
    }

  private:
    struct Packed {
        SharedValue<PackedModes> modes;
        Revision revision;
    };

    /// Packs modes unless they are. Returns true if they were not.
    bool pack(const MapModes& modes, Packed& packed, ThreadPool& pool) const {
        if (packed.revision == modes.revision) return false;
        packed.revision = {};
        PackedModes* const own = packed.modes.own();
        if (own == nullptr || !own->refill(modes, pool)) {
            packed.modes = std::make_shared<PackedModes>(modes, pool, level_());
        }
        packed.revision = modes.revision;
        return true;
    }

    SimdLevel (*level_)();
    std::array<Packed, 2> packed_;  // both ends of a passage
    std::size_t from_ = 0;
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
                           .keeps_foam = true,
                           .interpolates = true});
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
