// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The pattern of the foam of a sea: direction, length and windrows of its cells.
#pragma once

#include <optional>

#include "ocean/parameters.hpp"

namespace ocean {
class ThreadPool;
}

namespace ocean::preview {

struct CoverPattern {
    double direction = 0.0;  // [rad] counter-clockwise from +x, along the cells
    double stretch = 1.5;    // length/width of the cells
    double streaks = 0.0;    // share of windrows, 0 .. 1
};

/// Keeps the pattern of the last sea.
class CoverPatterns {
  public:
    /// Returns the pattern of a sea: gales have streaks and long cells, as in POV-Ray's
    /// Ocean_Material.
    const CoverPattern& of(const Parameters& parameters, ThreadPool& pool);

  private:
    CoverPattern pattern_;
    std::optional<Parameters> made_of_;
};

}  // namespace ocean::preview
