// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The chain of one time; see chain.hpp. A result carries the revision of its stage.
#include "chain.hpp"

#include <string>
#include <utility>

#include "ocean/internal/crests.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/surface.hpp"
#include "waves/crests/crest_waves.hpp"
#include "waves/modes/mode_lattice.hpp"

namespace ocean {

void Chain::set_parameters(Parameters parameters, Reuse reuse) {
    const bool first_time = !revisions_.front();
    const auto first = first_time ? Stage::spectrum : first_dirty_stage(parameters_, parameters);
    if (first) dirty(*first);
    parameters_ = std::move(parameters);
    reuse_ = reuse;
}

void Chain::dirty(Stage first) {
    const Revision changed = Revision::begin();
    for (auto stage = static_cast<std::size_t>(first); stage < kStages; ++stage) {
        revisions_[stage] = changed;
    }
}

const DirectionalSpectrum& Chain::spectrum(ThreadPool& pool, StageRuns& runs) {
    if (spectrum_.revision != revision(Stage::spectrum)) {
        spectrum_ = {};
        ++runs.spectrum;
        spectrum_.value = std::make_shared<const DirectionalSpectrum>(
            make_directional_spectrum(parameters_, pool));
        spectrum_.revision = revision(Stage::spectrum);
    }
    return *spectrum_.value;
}

bool Chain::has_modes() const {
    return modes_.get() != nullptr && modes_.get()->revision == revision(Stage::modes);
}

const Modes& Chain::modes(ThreadPool& pool, StageRuns& runs) {
    if (!has_modes()) make_modes(pool, runs);
    return *modes_.get();
}

void Chain::make_modes(ThreadPool& pool, StageRuns& runs) {
    const DirectionalSpectrum& spectrum = this->spectrum(pool, runs);
    ++runs.modes;
    const bool same_lattice = modes_.get() != nullptr && lattice_->is_of(parameters_);
    // Most lattices get modes only once: data that only rebuilds need is kept from the second build
    // on, or if the sea is animated.
    const bool keep = same_lattice || reuse_ == Reuse::animated;
    const Grid& grid = parameters_.grid;
    if (!same_lattice) {
        modes_ = nullptr;
        lattice_.reset();
        require_memory(modes_bytes(grid) + (keep ? ModeLattice::kept_bytes(grid) : 0),
                       "grid.resolution = " + std::to_string(grid.resolution));
    }
    if (!same_lattice || (keep && !lattice_->is_kept())) {
        const auto memory = keep ? ModeLattice::Memory::keep : ModeLattice::Memory::none;
        lattice_ = std::make_shared<const ModeLattice>(parameters_, memory, pool);
    }
    if (!same_lattice) {
        modes_ = std::make_shared<Modes>(lattice_->still_modes(pool));
        modes_.own()->lattice_revision = revision(Stage::modes);
    } else if (modes_.own() == nullptr) {
        modes_ = std::make_shared<Modes>(*modes_.get());
    }
    Modes& modes = *modes_.own();
    modes.revision = {};  // while they are neither the old ones nor the new
    gains_ = make_waves(*lattice_, spectrum, parameters_, pool, modes);
    modes.revision = revision(Stage::modes);
}

const SurfaceSettings& Chain::shown_settings(int resolution, ThreadPool& pool, StageRuns& runs) {
    const Modes& modes = this->modes(pool, runs);
    Cached<SurfaceSettings>& shown = shown_[resolution];
    if (shown.revision != revision(Stage::foam)) {
        ++runs.threshold;
        shown.value = with_threshold(parameters_.surface, modes, resolution);
        shown.revision = revision(Stage::foam);
    }
    return shown.value;
}

const SurfaceSettings& Chain::past_settings(const FoamLattice& lattice, ThreadPool& pool,
                                            StageRuns& runs) {
    if (!lattice.is_spread()) return shown_settings(lattice.resolution, pool, runs);
    const Modes& modes = this->modes(pool, runs);
    Cached<SurfaceSettings>& past = past_[lattice];
    if (past.revision != revision(Stage::foam)) {
        ++runs.threshold;
        past.value = lattice_settings(modes, parameters_, lattice);
        past.revision = revision(Stage::foam);
    }
    return past.value;
}

double Chain::shown_cover_power(const ShownFoam& foam, ThreadPool& pool, StageRuns& runs) {
    Cached<double>& power = cover_powers_[foam];
    if (power.revision != revision(Stage::foam)) {
        const Modes& modes = this->modes(pool, runs);
        const SurfaceSettings& past = past_settings(foam.past, pool, runs);
        const SurfaceSettings& shown =
            foam.is_past_alone() ? past : shown_settings(foam.whitecaps_held_by, pool, runs);
        ++runs.cover_power;
        power.value = cover_power({spectrum(pool, runs), parameters_},
                                  foam_whitecaps(modes, foam, past, shown), pool);
        power.revision = revision(Stage::foam);
    }
    return power.value;
}

void Chain::add_crests(ThreadPool& pool, StageRuns& runs, SeaState& state) {
    if (parameters_.crests.empty()) return;
    const Modes& modes = this->modes(pool, runs);
    ocean::add_crests({spectrum(pool, runs), parameters_, *lattice_, gains_}, modes, pool, state);
}

}  // namespace ocean
