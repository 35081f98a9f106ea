// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What lies between the modes and a map, as pictures: the stages of the backend `thesis`.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/backend.hpp"

namespace ocean {
class ThreadPool;
}

namespace ocean::gl {

/// "h0", "spectrum", "butterfly", "horizontal-1" .. "horizontal-9", "vertical-1" .. for N = 512.
std::vector<std::string> stage_names(int resolution);

struct StageImage {
    int width = 0;
    int height = 0;
    std::vector<std::string> channels;
    std::vector<float> texels;  // interleaved, the bottom row first
};

/// One stage of the height's transform after another, over the map's wavenumbers with k = 0 in the
/// middle, kx to the right and ky up:
///   h0            re and im of h0(k), then of conj h0(-k) [m]
///   spectrum      re and im of h(k, t) [m]
///   butterfly     log2 N wide: of each stage and output the root (re, im) and both inputs
///   horizontal-K  after K stages along x, vertical-K: and all along x before K along y
/// In the context that is current at the first that needs one, else in one of its own; both, and
/// what was compiled in it, are kept. One call at a time. The destructor needs the host's context
/// to be current, where it is the host's.
class StageMaker {
  public:
    StageMaker();
    ~StageMaker();
    StageMaker(const StageMaker&) = delete;
    StageMaker& operator=(const StageMaker&) = delete;

    /// Throws Error invalid_value for another name than those of stage_names(), which it lists, and
    /// no_gpu.
    StageImage make(const MapModes& modes, std::string_view stage, ThreadPool& pool);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace ocean::gl
