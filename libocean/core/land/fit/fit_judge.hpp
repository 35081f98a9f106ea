// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Makes tiles of a law and measures them as the elevation model of a fit was measured.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ocean/domain.hpp"
#include "ocean/internal/elevation.hpp"
#include "ocean/internal/ring_spectrum.hpp"
#include "ocean/internal/terrain_fit.hpp"
#include "ocean/terrain.hpp"

namespace ocean {

class FitJudge {
  public:
    static constexpr int kMaxSide = 2048;  // of tiles and windows: a seed takes less than a second
    static constexpr int kMinSide = 32;

    /// Measures the rings of the elevation model. `options` must outlive the judge.
    FitJudge(const ElevationModel& bed, const TerrainFitOptions& options);

    /// Returns the tile for the model, with the default law.
    const TerrainModel& tile() const { return land_.model(); }
    const std::vector<Ring>& bed_rings() const { return bed_rings_; }
    /// Returns the part of a tile that is measured.
    const Domain& domain() const { return domain_; }
    ThreadPool& pool() { return land_.pool(); }

    /// Measures the terrain with each of the seeds. `use` gets the rings of each, and the heights
    /// of the part. Throws Error invalid_value if the rings are not those of the model.
    void measure(TerrainModel terrain, std::span<const std::uint32_t> seeds,
                 const std::function<void(const std::vector<Ring>& rings,
                                          const std::vector<float>& heights)>& use);
    /// Returns the mean of all seeds in each ring: see expected_rings.
    std::vector<double> expected(const TerrainModel& terrain);

  private:
    std::vector<float> part();

    const TerrainFitOptions& options_;
    Terrain land_;
    Domain domain_;
    RingOptions ring_options_;
    std::vector<Ring> bed_rings_;
};

}  // namespace ocean
