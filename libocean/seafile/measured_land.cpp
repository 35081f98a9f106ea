// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See measured_land.hpp.
#include "measured_land.hpp"

#include <cmath>
#include <utility>

#include "height_grid_text.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/elevation.hpp"
#include "ocean/internal/elevation_file.hpp"
#include "ocean/internal/ring_spectrum.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

constexpr int kMinBaseSide = 16;  // min side for a spectrum

MeasuredRings rings_of(const ElevationModel& model) {
    ThreadPool pool;
    MeasuredRings rings;
    for (const Ring& ring : measure_rings(model.domain, model.heights, pool)) {
        rings.wavenumber.push_back(ring.wavenumber);
        rings.density.push_back(ring.density);
    }
    return rings;
}

/// Returns the base of a model without holes.
std::shared_ptr<const TerrainBase> base_of(ElevationModel model) {
    for (const int side : model.domain.samples) {
        if (side >= kMinBaseSide) continue;
        throw Error(ErrorKind::invalid_value,
                    "a base needs at least 16 samples along each side, for its spectrum; this one "
                    "has " +
                        std::to_string(side));
    }
    const double ratio = model.domain.step(0) / model.domain.step(1);
    if (std::abs(ratio - 1.0) > 0.5) {
        throw Error(ErrorKind::invalid_value,
                    "the cells of a base are at most 1.5 times as long as they are wide; these "
                    "are " +
                        shortest_text(model.domain.step(0)) + " m x " +
                        shortest_text(model.domain.step(1)) + " m");
    }
    TerrainBase base;
    base.rings = rings_of(model);
    base.hash = height_hash(model.domain, model.heights);
    base.model = std::move(model);
    return std::make_shared<const TerrainBase>(std::move(base));
}

}  // namespace

void validate_rings(const MeasuredRings& rings, const std::string& parameter) {
    const std::size_t count = rings.wavenumber.size();
    bool good = count >= kMinRings && count <= kMaxRings && rings.density.size() == count;
    for (std::size_t i = 0; good && i < count; ++i) {
        const double below = i > 0 ? rings.wavenumber[i - 1] : 0.0;
        good = rings.wavenumber[i] > below && std::isfinite(rings.wavenumber[i]) &&
               rings.density[i] >= 0.0 && std::isfinite(rings.density[i]);
    }
    if (good) return;
    throw Error(
        ErrorKind::invalid_value,
        {.what = "needs 2 .. 4096 ascending wavenumbers above 0 with a density of 0 or more "
                 "each",
         .parameter = parameter});
}

MeasuredRings read_measured_rings(const std::string& path) {
    if (path.ends_with(".csv")) return read_rings(path);
    return rings_of(read_elevation(path, {.holes = HolePolicy::fill}));
}

std::shared_ptr<const TerrainBase> read_base(const std::string& path) {
    return base_of(read_elevation(path));
}

std::string base_text(const TerrainBase& base) {
    return "\n[terrain." + std::string(kBaseTable) + "]\n" +
           height_grid_text({base.model.domain, base.hash, base.model.heights});
}

BaseHeights read_base_table(const toml::table& table) {
    const std::string name = "terrain." + std::string(kBaseTable);
    HeightGridText read = read_height_grid(table, name, kMaxElevationSide);
    BaseHeights found;
    found.hash = std::move(read.hash);
    if (read.heights.empty()) return found;
    ElevationModel model;
    model.domain = read.grid;
    model.heights = std::move(read.heights);
    found.model = base_of(std::move(model));
    std::shared_ptr<const TerrainBase> stated = base_with_hash(found.model, found.hash);
    if (stated == nullptr) require_stated_hash(found.model->hash, found.hash, name);
    found.model = std::move(stated);
    found.hash = found.model->hash;
    return found;
}

std::shared_ptr<const TerrainBase> base_with_hash(const std::shared_ptr<const TerrainBase>& base,
                                                  const std::string& stated) {
    if (base->hash == stated) return base;
    if (!is_comma_hash(stated, base->model.domain, base->model.heights)) return nullptr;
    auto noted = std::make_shared<TerrainBase>(*base);
    noted->model.notes.emplace_back(kCommaHashNote);
    return noted;
}

}  // namespace ocean
