// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The stages between the modes and a map, as pictures, made by the backend `thesis`.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/backend.hpp"
#include "ocean/internal/map_request.hpp"

namespace ocean {
class ThreadPool;
}

namespace ocean::gl {

/// Returns "h0", "spectrum", "butterfly", "horizontal-1" .. "horizontal-9", "vertical-1" .. for a
/// resolution of 512.
std::vector<std::string> stage_names(int resolution);

struct StageImage {
    int width = 0;
    int height = 0;
    std::vector<std::string> channels;
    std::vector<float> texels;  // interleaved, the bottom row first
};

/// Makes the stages of the height's transform, over the map's wavenumbers with k = 0 in the middle,
/// kx to the right and ky up:
///   h0            re and im of h0(k), then of conj h0(-k) [m]
///   spectrum      re and im of h(k, t) [m]
///   butterfly     log2 N wide: for each stage and output the root (re, im) and both inputs
///   horizontal-K  after K stages along x
///   vertical-K    after all stages along x and K stages along y
/// Uses the context that is current when the first stage needs one, else a context of its own;
/// keeps context and compiled programs. One call at a time. If the context is the host's, it must
/// be current in the destructor.
class StageMaker {
  public:
    StageMaker();
    ~StageMaker();
    StageMaker(const StageMaker&) = delete;
    StageMaker& operator=(const StageMaker&) = delete;

    /// Returns one stage. Throws Error invalid_value, with a list of stage_names(), for an unknown
    /// name, and no_gpu.
    StageImage make(const MapModes& modes, std::string_view stage, ThreadPool& pool);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::gl
