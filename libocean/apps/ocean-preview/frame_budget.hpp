// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The cost of each stage of a frame.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/gl/sea_textures.hpp"

namespace ocean::app {

/// Milliseconds of each stage, the GPU's work included. It waits for the GPU after each stage, so
/// that the sum is more than the time of a frame that is not measured.
class FrameBudget {
  public:
    /// Returns the callback for the options of SeaMaps and Renderer.
    gl::AfterStage after_stage();
    /// Begins a stage now: the time before belongs to none.
    void begin();
    void end_frame() { ++frames_; }
    /// Returns "stage,median,worst" and a line for each stage [ms] in the order of the work, then
    /// one for the whole frame.
    std::string table() const;

  private:
    void add(std::string_view stage, double milliseconds);

    double before_ = 0.0;  // [ms] of a steady clock
    std::size_t frames_ = 0;
    std::vector<std::string> order_;
    std::map<std::string, std::vector<double>, std::less<>> stages_;  // [ms] of each frame
};

}  // namespace ocean::app
