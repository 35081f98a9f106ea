// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "live_land.hpp"

#include <utility>

#include "ocean/terrain_table.hpp"
#include "ocean/terrainfile.hpp"

namespace ocean::app {

LiveLand::LiveLand(TerrainModel model, int threads,
                   std::function<LandComputing(const TerrainModel&)> computing)
    : threads_(threads),
      choose_(std::move(computing)),
      computing_(choose_(model)),
      terrain_(std::make_unique<Terrain>(
          std::move(model), TerrainOptions{.threads = threads, .backend = computing_.backend})) {}

preview::DrawnLand LiveLand::show() {
    return maps_.show(*terrain_, computing_.resolution);
}

void LiveLand::set(const std::string& name, const std::string& value) {
    TerrainModel changed = model();
    set_parameter(changed, name, value);
    resolve_files(changed, "");
    change(std::move(changed));
}

void LiveLand::open(TerrainModel model) {
    change(std::move(model));
}

void LiveLand::compute_anew() {
    change(model());
}

void LiveLand::change(TerrainModel model) {
    validate(model);
    const LandComputing computing = choose_(model);
    if (!(computing.backend == computing_.backend)) {
        terrain_ = std::make_unique<Terrain>(
            *terrain_, TerrainOptions{.threads = threads_, .backend = computing.backend});
    }
    terrain_->set_model(std::move(model));
    computing_ = computing;
}

const std::vector<std::string>& LiveLand::warnings() {
    const std::shared_ptr<const LandFunction> now = terrain_->function();
    const bool moves = std::exchange(seen_, now) != now;
    if (now == warned_) return warnings_;
    warnings_.clear();
    if (moves) return warnings_;  // statistics take longer than a frame of a drag
    warnings_ = terrain_->state().warnings;
    warned_ = now;
    return warnings_;
}

}  // namespace ocean::app
