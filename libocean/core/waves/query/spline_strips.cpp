// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spline maps strip by strip; see spline_strips.hpp.
#include "waves/query/spline_strips.hpp"

#include "ocean/backend.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

SplineStrips::SplineStrips(const Modes& modes, int resolution, const ModeFactor& factor,
                           ThreadPool& pool)
    : packed_(std::make_shared<PackedModes>(map_modes(modes, 0.0, resolution), pool, simd_level(),
                                            factor)),
      kernel_(packed_),
      width_(kernel_.strip_width()),
      ready_(resolution / width_) {}

bool SplineStrips::repack(const Modes& modes, const ModeFactor& factor, ThreadPool& pool) {
    if (!packed_->refill(map_modes(modes, 0.0, packed_->size()), pool, factor)) return false;
    kernel_.use(packed_);
    return true;
}

void SplineStrips::begin(const Modes& modes, double time, std::span<const MapOutput> outputs,
                         ThreadPool& pool) {
    ready_.clear();
    SurfaceSettings plain;
    plain.choppiness = 1.0;
    kernel_.begin({modes.tau(time), plain, outputs, {}}, pool);
}

void SplineStrips::make(std::span<const int> strips, ThreadPool* pool) const {
    const std::lock_guard lock(making_);
    const auto threads = pool != nullptr ? static_cast<std::size_t>(pool->size()) : 1;
    if (scratch_.size() < threads) scratch_.resize(threads);
    ready_.make(strips, pool, [this](int strip, int thread) {
        PageVector<float>& scratch = scratch_[static_cast<std::size_t>(thread)];
        if (scratch.size() < kernel_.scratch_floats()) {
            scratch = PageVector<float>(kernel_.scratch_floats());
        }
        kernel_.write_strip(strip, scratch.data());
    });
}

}  // namespace ocean
