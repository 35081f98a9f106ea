// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Frames of our own kernel, of any outputs.
#pragma once

#include <memory>
#include <vector>

#include "ocean/internal/platform.hpp"
#include "ocean/thread_pool.hpp"
#include "subject.hpp"
#include "waves/kernel/map_kernel.hpp"

namespace ocean::bench {

class OurFrame {
  public:
    /// `sea` must outlive this. The modes are packed for the fields that outputs may need.
    OurFrame(const Sea& sea, int threads, SimdLevel level,
             const CacheSizes& caches = cache_sizes());

    void show(std::vector<MapOutput> outputs, const SurfaceSettings& settings,
              const FoamLayer& foam = {});
    void run(double time);

  private:
    const Modes* modes_;
    std::unique_ptr<ThreadPool> pool_;
    MapKernel kernel_;
    std::vector<MapOutput> outputs_;
    KernelFrame frame_;
};

}  // namespace ocean::bench
