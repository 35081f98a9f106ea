// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The elevation model of a terrain; see base_file.hpp.
#include "base_file.hpp"

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
    ThreadPool pool;
    TerrainBase base;
    for (const Ring& ring : measure_rings(model.domain, model.heights, pool)) {
        base.rings.wavenumber.push_back(ring.wavenumber);
        base.rings.density.push_back(ring.density);
    }
    base.hash = height_hash(model.domain, model.heights);
    base.model = std::move(model);
    return std::make_shared<const TerrainBase>(std::move(base));
}

}  // namespace

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
