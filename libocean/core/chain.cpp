// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The chain of one time; see chain.hpp. A result carries the revision of its stage.
#include "chain.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "ocean/internal/crests.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/surface.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/crests/crest_waves.hpp"
#include "waves/modes/mode_lattice.hpp"

namespace ocean {

namespace {

/// Returns true if the waves of both are the same.
bool have_same_waves(const Parameters& a, const Parameters& b) {
    const auto first = first_dirty_stage(a, b);
    return !first || *first > Stage::modes;
}

/// Sets the amplitudes of modes to from + share (to - from).
void interpolate(const Chain::ModesBetween& between, ThreadPool& pool, Modes& modes) {
    const float share = between.share;
    for (std::size_t c = 0; c < modes.cascades.size(); ++c) {
        CascadeModes& cascade = modes.cascades[c];
        pool.for_each_range(cascade.lattice.resolution, [&](int first, int last) {
            const auto width = static_cast<std::size_t>(cascade.lattice.resolution);
            const std::size_t end = static_cast<std::size_t>(last) * width;
            for (std::size_t i = static_cast<std::size_t>(first) * width; i < end; ++i) {
                const std::complex<float> a = between.from.cascades[c].h0[i];
                const std::complex<float> b = between.to.cascades[c].h0[i];
                cascade.h0[i] = a + share * (b - a);
            }
        });
    }
}

GradientCovariance interpolated(const GradientCovariance& from, const GradientCovariance& to,
                                double share) {
    GradientCovariance rest = from, sum = to;
    rest *= 1.0 - share;
    sum *= share;
    return sum += rest;
}

}  // namespace

void Chain::set_parameters(Parameters parameters, std::optional<Passage> passage, Reuse reuse) {
    const bool first_time = !revisions_.front();
    auto first = first_time ? Stage::spectrum : first_dirty_stage(parameters_, parameters);
    // Equal numbers are a passage at one time, and fast or at rest at another.
    if (passage.has_value() != passage_.has_value()) {
        first = first ? std::min(*first, Stage::modes) : Stage::modes;
    }
    if (first) dirty(*first);
    parameters_ = std::move(parameters);
    passage_ = std::move(passage);
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
    if (has_modes()) return *modes_.get();
    if (!passage_) {
        const DirectionalSpectrum& spectrum = this->spectrum(pool, runs);
        gains_ = make_modes(parameters_, spectrum, modes_, pool, runs);
    } else {
        statistics(pool, runs);
        const ModesBetween between = *modes_between(pool, runs);
        // A copy of the chain may have shared them since.
        if (modes_.own() == nullptr) modes_ = std::make_shared<Modes>(*modes_.get());
        interpolate(between, pool, *modes_.own());
    }
    modes_.own()->revision = revision(Stage::modes);
    return *modes_.get();
}

std::vector<double> Chain::make_modes(const Parameters& parameters,
                                      const DirectionalSpectrum& spectrum,
                                      SharedValue<Modes>& modes, ThreadPool& pool,
                                      StageRuns& runs) {
    ++runs.modes;
    const bool same_lattice = lattice_ != nullptr && lattice_->is_of(parameters);
    const bool same_arrays = same_lattice && modes.get() != nullptr &&
                             modes.get()->lattice_revision == lattice_revision_;
    // Most lattices get modes only once: data that only rebuilds need is kept from the second build
    // on, or if the sea is animated.
    const bool keep = same_lattice || reuse_ == Reuse::animated;
    const Grid& grid = parameters.grid;
    if (!same_arrays) {
        modes = nullptr;
        if (!same_lattice) lattice_.reset();
        require_memory(
            modes_bytes(grid) + (keep && !same_lattice ? ModeLattice::kept_bytes(grid) : 0),
            "grid.resolution = " + std::to_string(grid.resolution));
    }
    if (!same_lattice || (keep && !lattice_->is_kept())) {
        const auto memory = keep ? ModeLattice::Memory::keep : ModeLattice::Memory::none;
        lattice_ = std::make_shared<const ModeLattice>(parameters, memory, pool);
        if (!same_lattice) lattice_revision_ = Revision::begin();
    }
    if (!same_arrays) {
        modes = std::make_shared<Modes>(lattice_->still_modes(pool));
        modes.own()->lattice_revision = lattice_revision_;
    } else if (modes.own() == nullptr) {
        modes = std::make_shared<Modes>(*modes.get());
    }
    modes.own()->revision = {};  // while they are neither the old ones nor the new
    return make_waves(*lattice_, spectrum, parameters, pool, *modes.own());
}

std::optional<Chain::ModesBetween> Chain::modes_between(ThreadPool& pool, StageRuns& runs) {
    if (!passage_) return std::nullopt;
    constexpr std::size_t kNone = std::tuple_size_v<decltype(states_)>;
    const auto find = [&](const Parameters& parameters) {
        std::size_t i = 0;
        while (i < kNone &&
               !(states_[i].is_made() && have_same_waves(states_[i].parameters, parameters))) {
            ++i;
        }
        return i;
    };
    std::size_t from = find(passage_->from);
    std::size_t to = find(passage_->to);
    if (from == kNone) {
        from = to == 0 ? 1 : 0;
        make_state(passage_->from, states_[from], pool, runs);
    }
    if (to == kNone) {
        to = 1 - from;
        make_state(passage_->to, states_[to], pool, runs);
    }
    return ModesBetween{*states_[from].modes.get(), *states_[to].modes.get(),
                        static_cast<float>(passage_->share)};
}

void Chain::make_state(const Parameters& parameters, State& state, ThreadPool& pool,
                       StageRuns& runs) {
    ++runs.spectrum;
    make_modes(parameters, make_directional_spectrum(parameters, pool), state.modes, pool, runs);
    state.parameters = parameters;
    state.modes.own()->revision = Revision::begin();
}

const Modes& Chain::statistics(ThreadPool& pool, StageRuns& runs) {
    if (!passage_) return modes(pool, runs);
    if (statistics_revision_ == revision(Stage::modes)) return *modes_.get();
    const ModesBetween between = *modes_between(pool, runs);
    if (modes_.own() == nullptr || modes_.get()->lattice_revision != lattice_revision_) {
        modes_ = nullptr;
        modes_ = std::make_shared<Modes>(between.from);
    }
    Modes& modes = *modes_.own();
    modes.revision = {};
    modes.wind_speed = strongest_wind(parameters_).value_or(0.0);
    for (std::size_t c = 0; c < modes.cascades.size(); ++c) {
        auto& shells = modes.cascades[c].shell_covariance;
        for (std::size_t s = 0; s < shells.size(); ++s) {
            shells[s] = interpolated(between.from.cascades[c].shell_covariance[s],
                                     between.to.cascades[c].shell_covariance[s], passage_->share);
        }
    }
    statistics_revision_ = revision(Stage::modes);
    return modes;
}

const SurfaceSettings& Chain::shown_settings(int resolution, ThreadPool& pool, StageRuns& runs) {
    const Modes& modes = statistics(pool, runs);
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
    const Modes& modes = statistics(pool, runs);
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
        const Modes& modes = statistics(pool, runs);
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
