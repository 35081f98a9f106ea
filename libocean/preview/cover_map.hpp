// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The water that foam hides: its power, its pattern, and its map foam^power with mipmaps: see
// DrawnCover.
#pragma once

#include <memory>
#include <optional>

#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/gl/shader_program.hpp"
#include "ocean/internal/open_sea.hpp"
#include "ocean/internal/preview/sea_maps.hpp"
#include "ocean/parameters.hpp"

namespace ocean {
class ThreadPool;
}

namespace ocean::preview {

/// Solves the power of the foam's cover in a thread of its own.
class CoverPower {
  public:
    CoverPower();
    /// Stops a solution that is in work.
    ~CoverPower();
    CoverPower(const CoverPower&) = delete;
    CoverPower& operator=(const CoverPower&) = delete;

    /// Returns OpenSea::cover_power of a sea at a time [s], or the previous value until it is
    /// solved. A call while a solution is in work returns that value too; the first call after it
    /// begins the next solution. Throws Error.
    double of(OpenSea& sea, double time, const ShownFoam& foam);
    /// Returns whether a solution is in work, or ready for the next call of of().
    Pending pending() const;

  private:
    struct Job;

    Revision revision_;  // of the modes of the last request
    SurfaceSettings settings_;
    ShownFoam foam_{};
    double power_ = 3.0;  // about that of a fresh breeze
    std::unique_ptr<Job> job_;
};

/// The pattern of the water that foam hides: its cells and their direction.
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

class CoverMap {
  public:
    CoverMap();

    /// Makes the map from a texture of foam of `resolution` texels along a side, each multiplied by
    /// `fade`.
    void make(unsigned foam, int resolution, float fade, double power);

    unsigned texture() const { return map_.name(); }
    int resolution() const { return resolution_; }

  private:
    gl::ShaderProgram program_;
    gl::VertexArray no_vertices_;
    gl::Framebuffer framebuffer_;
    gl::Texture map_;
    int resolution_ = 0;
};

}  // namespace ocean::preview
