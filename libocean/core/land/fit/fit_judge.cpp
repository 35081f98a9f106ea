// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Tiles of a law, measured as the elevation model of a fit was; see fit_judge.hpp.
#include "fit_judge.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "land/law/expected_rings.hpp"
#include "ocean/error.hpp"

namespace ocean {
namespace {

constexpr int kFitRingsPerOctave = 4;

TerrainModel tile_for(const ElevationModel& bed) {
    const double cell = std::max(bed.domain.step(0), bed.domain.step(1));
    int samples = FitJudge::kMinSide;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double cells = bed.domain.step(axis) * bed.domain.samples[axis] / cell;
        const auto held = static_cast<unsigned>(std::ceil(cells - 1e-9));
        samples = std::max(samples, static_cast<int>(std::bit_ceil(held)));
    }
    TerrainModel terrain;
    terrain.resolution = std::min(samples, FitJudge::kMaxSide);
    terrain.patch_size = cell * terrain.resolution;
    // The model has no waves that are much longer than itself.
    const double longest = std::max(bed.domain.step(0) * bed.domain.samples[0],
                                    bed.domain.step(1) * bed.domain.samples[1]);
    const double waves = std::round(terrain.patch_size / longest);
    if (waves > 1.0) terrain.longest_wavelength = terrain.patch_size / waves;
    return terrain;
}

/// Returns the part of a tile that has the size of the model, or of its windows.
Domain part_for(const ElevationModel& bed, const TerrainModel& terrain) {
    const double cell = terrain.patch_size / terrain.resolution;
    Domain part{.origin = {}, .size = {}, .samples = {}, .wraps = false};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double cells =
            bed.domain.step(axis) * std::min(bed.domain.samples[axis], FitJudge::kMaxSide) / cell;
        part.samples[axis] = std::clamp(static_cast<int>(std::lround(cells)),
                                        FitJudge::kMinSide / 2, terrain.resolution);
        part.size[axis] = cell * (part.samples[axis] - 1);
    }
    return part;
}

}  // namespace

FitJudge::FitJudge(const ElevationModel& bed, const TerrainFitOptions& options)
    : options_(options),
      land_(tile_for(bed), {.threads = options.threads}),
      domain_(part_for(bed, land_.model())) {
    RingOptions rings{.rings_per_octave = kFitRingsPerOctave, .max_side = kMaxSide};
    rings.limits = ring_limits(bed.domain, rings);
    ring_options_ = rings;
    bed_rings_ = measure_rings(bed.domain, bed.heights, land_.pool(), rings);
}

void FitJudge::measure(
    TerrainModel terrain, std::span<const std::uint32_t> seeds,
    const std::function<void(const std::vector<Ring>&, const std::vector<float>&)>& use) {
    int done = 0;
    for (const std::uint32_t seed : seeds) {
        terrain.seed = seed;
        land_.set_model(terrain);
        const std::vector<float> heights = part();
        const auto rings = measure_rings(domain_, heights, land_.pool(), ring_options_);
        if (rings.size() != bed_rings_.size()) {
            throw Error(ErrorKind::invalid_value,
                        "the model has too few cells for its rings to be compared");
        }
        use(rings, heights);
        if (options_.progress) options_.progress(++done, static_cast<int>(seeds.size()));
    }
}

std::vector<double> FitJudge::expected(const TerrainModel& terrain) {
    return expected_rings(terrain, domain_.samples, ring_options_, land_.pool());
}

std::vector<float> FitJudge::part() {
    const Surface surface = land_.surface({Channel::height});
    const std::span<const float> tile = surface.channel(Channel::height);
    const std::size_t stride = static_cast<std::size_t>(land_.model().resolution);
    const std::size_t columns = static_cast<std::size_t>(domain_.samples[0]);
    std::vector<float> heights;
    heights.reserve(domain_.count());
    for (int j = 0; j < domain_.samples[1]; ++j) {
        const std::span<const float> row =
            tile.subspan(static_cast<std::size_t>(j) * stride, columns);
        heights.insert(heights.end(), row.begin(), row.end());
    }
    return heights;
}

}  // namespace ocean
