// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What each part of a frame costs.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/gl/sea_textures.hpp"

namespace ocean::app {

/// Milliseconds of each stage, the GPU's work included: it is waited for after each, so that their
/// sum is more than a frame that is not measured.
class FrameBudget {
  public:
    /// For the options of who does the work.
    gl::AfterStage after_stage();
    /// Something begins that is no stage of before.
    void begin();
    void end_frame() { ++frames_; }
    /// "stage,median,worst" and a line for each, in the order of the work, then for all of a frame.
    std::string table() const;

  private:
    void add(std::string_view stage, double milliseconds);

    double before_ = 0.0;  // ms, of a steady clock
    std::size_t frames_ = 0;
    std::vector<std::string> order_;
    std::map<std::string, std::vector<double>, std::less<>> stages_;  // a number a frame
};

}  // namespace ocean::app
