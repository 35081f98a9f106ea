// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A land that is changed while it is shown.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ocean/internal/preview/land_maps.hpp"
#include "ocean/terrain.hpp"

namespace ocean::app {

/// How a land is computed.
struct LandComputing {
    Backend backend = Backend::cpu;
    int resolution = 0;  // of its map

    bool operator==(const LandComputing&) const = default;
};

/// The OpenGL context of the constructor must be current in every call, also in the destructor. A
/// function that throws Error has changed nothing.
class LiveLand {
  public:
    /// computing: returns how to compute a terrain; throws Error if it cannot be computed.
    LiveLand(TerrainModel model, int threads,
             std::function<LandComputing(const TerrainModel&)> computing);

    /// Returns the land with all changes. Redoes only the stages that they dirty. Throws Error.
    preview::DrawnLand show();

    /// Sets a parameter; a file that it names is read, relative to the working directory. Throws
    /// Error.
    void set(const std::string& name, const std::string& value);
    /// Shows another terrain. Throws Error.
    void open(TerrainModel model);
    /// Computes the land anew if `computing` has another answer. Throws Error.
    void compute_anew();

    const TerrainModel& model() const { return terrain_->model(); }
    Terrain& terrain() { return *terrain_; }
    const LandComputing& computing() const { return computing_; }
    /// Returns warnings about the land, a sentence each, or none while it changes.
    const std::vector<std::string>& warnings();

  private:
    void change(TerrainModel model);

    int threads_;
    std::function<LandComputing(const TerrainModel&)> choose_;
    LandComputing computing_;
    std::unique_ptr<Terrain> terrain_;
    preview::LandMaps maps_;
    std::vector<std::string> warnings_;
    std::shared_ptr<const LandFunction> warned_, seen_;  // of the warnings, and of the call before
};

}  // namespace ocean::app
