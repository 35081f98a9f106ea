// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "live_land.hpp"

#include <utility>

#include "ocean/terrain_table.hpp"
#include "ocean/terrainfile.hpp"

namespace ocean::app {

LiveLand::LiveLand(TerrainModel terrain, int threads,
                   std::function<LandComputing(const TerrainModel&)> computing)
    : threads_(threads),
      choose_(std::move(computing)),
      computing_(choose_(terrain)),
      land_(std::make_unique<Land>(
          std::move(terrain), LandOptions{.threads = threads, .backend = computing_.backend})) {}

preview::DrawnLand LiveLand::show() {
    return maps_.show(*land_, computing_.resolution);
}

void LiveLand::set(const std::string& name, const std::string& value) {
    TerrainModel changed = terrain();
    set_parameter(changed, name, value);
    resolve_files(changed, "");
    change(std::move(changed));
}

void LiveLand::open(TerrainModel terrain) {
    change(std::move(terrain));
}

void LiveLand::compute_anew() {
    change(terrain());
}

void LiveLand::change(TerrainModel terrain) {
    validate(terrain);
    const LandComputing computing = choose_(terrain);
    if (!(computing.backend == computing_.backend)) {
        land_ = std::make_unique<Land>(
            *land_, LandOptions{.threads = threads_, .backend = computing.backend});
    }
    land_->set_terrain(std::move(terrain));
    computing_ = computing;
}

const std::vector<std::string>& LiveLand::warnings() {
    const std::shared_ptr<const LandField> now = land_->field();
    const bool moves = std::exchange(seen_, now) != now;
    if (now == warned_) return warnings_;
    warnings_.clear();
    if (moves) return warnings_;  // statistics take longer than a frame of a drag
    warnings_ = land_->state().warnings;
    warned_ = now;
    return warnings_;
}

}  // namespace ocean::app
