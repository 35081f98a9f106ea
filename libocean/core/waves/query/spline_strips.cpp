// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spline maps strip by strip; see spline_strips.hpp.
#include "waves/query/spline_strips.hpp"

#include <algorithm>

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
      swept_(static_cast<std::size_t>(resolution / width_)),
      next_sweep_(swept_.size()),
      ready_(resolution / width_) {}

bool SplineStrips::repack(const Modes& modes, const ModeFactor& factor, ThreadPool& pool) {
    if (!packed_->refill(map_modes(modes, 0.0, packed_->size()), pool, factor)) return false;
    kernel_.use(packed_);
    return true;
}

void SplineStrips::begin(const Modes& modes, double time, std::span<const MapOutput> outputs,
                         ThreadPool& pool) {
    std::ranges::fill(swept_, 0);
    for (int strip = 0; strip < count(); ++strip) {
        next_sweep_[static_cast<std::size_t>(strip)] = has(strip) ? 1 : 0;
    }
    ready_.clear();
    SurfaceSettings plain;
    plain.choppiness = 1.0;
    kernel_.begin({modes.tau(time), plain, outputs, {}}, pool);
}

void SplineStrips::sweep_all(ThreadPool& pool) {
    kernel_.sweep({}, &pool);
    std::ranges::fill(swept_, 1);
}

void SplineStrips::sweep_for(std::span<const int> strips, ThreadPool* pool) const {
    const auto is_swept = [this](int strip) {
        return swept_[static_cast<std::size_t>(strip)] != 0;
    };
    if (std::ranges::all_of(strips, is_swept)) return;
    for (const int strip : strips) next_sweep_[static_cast<std::size_t>(strip)] = 1;
    kernel_.sweep(next_sweep_, pool);
    for (std::size_t strip = 0; strip < swept_.size(); ++strip) {
        swept_[strip] |= next_sweep_[strip];
        next_sweep_[strip] = swept_[strip] != 0 ? 0 : 1;
    }
}

void SplineStrips::make(std::span<const int> strips, ThreadPool* pool) const {
    const std::lock_guard lock(making_);
    sweep_for(strips, pool);
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
