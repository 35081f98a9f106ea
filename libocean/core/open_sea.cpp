// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The open sea: parameters -> spectrum -> modes -> surface -> foam, each kept until something
// dirties it.
#include "ocean/internal/open_sea.hpp"

#include <utility>

#include "chain.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/second_order.hpp"
#include "waves/bound/bound_waves.hpp"
#include "waves/detail/detail_maps.hpp"
#include "waves/spray/spray_follower.hpp"
#include "waves/state/performer.hpp"
#include "waves/surface/map_writer.hpp"

namespace ocean {
namespace {

std::unique_ptr<MapWriter> writer_like(const MapWriter& other, const OceanOptions& options) {
    if (other.backend() == options.backend) {
        return std::make_unique<MapWriter>(other, options.channels);
    }
    return std::make_unique<MapWriter>(options.backend, options.channels);
}

bool same_events(const Take& a, const Take& b) {
    return std::ranges::equal(a.events, b.events, [](const TakeEvent& x, const TakeEvent& y) {
        return x.seconds == y.seconds && x.parameter.same_as(y.parameter) && x.value == y.value;
    });
}

/// Returns true if what was followed over time in one sea holds in the other.
bool have_same_past(const Sea& a, const Sea& b) {
    const auto first = first_dirty_stage(a.parameters, b.parameters);
    if (a.take.empty() && b.take.empty()) return !first || *first == Stage::clock;
    // A take's past may have changed anything, unless hulls are all that changes.
    if (!same_events(a.take, b.take)) return false;
    Parameters with_hulls = a.parameters;
    with_hulls.hulls = b.parameters.hulls;
    return !first_dirty_stage(with_hulls, b.parameters);
}

}  // namespace

OpenSea::OpenSea(Sea sea, OceanOptions options)
    : sea_(std::move(sea)),
      options_(std::move(options)),
      pool_(options_.threads, options_.run_jobs),
      chain_(std::make_unique<Chain>()),
      maps_(std::make_unique<MapWriter>(options_.backend, options_.channels)) {
    pool_.set_interrupt(options_.interrupt);
    go_to(sea_.parameters.time.start);
    if (!sea_.parameters.crests.empty()) current_modes();  // which refuse impossible crests
}

OpenSea::OpenSea(const OpenSea& built, OceanOptions options)
    : sea_(built.sea_),
      revision_(built.revision_),
      checked_(built.checked_),
      options_(std::move(options)),
      pool_(options_.threads, options_.run_jobs),
      chain_(std::make_unique<Chain>(*built.chain_)),
      maps_(writer_like(*built.maps_, options_)) {
    pool_.set_interrupt(options_.interrupt);
}

OpenSea::~OpenSea() = default;

OpenSea::Ended OpenSea::change(Sea sea) {
    const Ended ended{.past = !have_same_past(sea_, sea),
                      .grid = sea_.parameters.grid != sea.parameters.grid};
    if (ended.past) {
        foam_.clear();
        spray_.reset();
    }
    if (ended.grid) {
        surface_query_.reset();
        orbital_motion_.reset();
        detail_.clear();
    }
    sea_ = std::move(sea);
    ++revision_;
    performer_.reset();
    return ended;
}

void OpenSea::take_foam(OpenSea& before) {
    if (have_same_past(before.sea_, sea_)) foam_ = std::move(before.foam_);
}

void OpenSea::perform(double time, std::string_view name, std::string_view value) {
    const bool checked = checked_ == revision_;
    if (!checked) validate(sea_);
    require_takes(sea_.parameters);
    if (!performer_) performer_ = std::make_unique<Performer>(sea_);
    const double from = performer_->perform(sea_, time, name, value);
    if (from > kLatestTime) return;
    ++revision_;
    // The performer has checked the event, so a long take need not be checked as a whole each time.
    if (checked) checked_ = revision_;
    for (auto& [resolution, foam] : foam_) foam.forget_from(from);
    if (spray_) spray_->forget_from(from);
}

void OpenSea::go_to(double time) {
    const bool changed = checked_ != revision_;
    if (!changed && sea_.take.empty()) return;
    if (changed) validate(sea_);
    chain_->set_parameters(sea_.at(time), sea_.passage(time),
                           sea_.take.empty() ? Chain::Reuse::static_sea : Chain::Reuse::animated);
    checked_ = revision_;
}

const Parameters& OpenSea::now() const {
    return chain_->parameters();
}

const Parameters& OpenSea::parameters_at(double time) {
    require_time(time);
    go_to(time);
    return now();
}

const DirectionalSpectrum& OpenSea::spectrum(double time) {
    parameters_at(time);
    return chain_->spectrum(pool_, runs_);
}

const Revision& OpenSea::spectrum_revision() const {
    return chain_->spectrum_revision();
}

const SurfaceSettings& OpenSea::shown_settings(double time, int resolution) {
    parameters_at(time);
    return chain_->shown_settings(resolution, pool_, runs_);
}

const Modes& OpenSea::modes(double time) {
    parameters_at(time);
    return current_modes();
}

const Modes& OpenSea::current_modes() {
    return chain_->modes(pool_, runs_);
}

SeaState OpenSea::state() {
    const DirectionalSpectrum& spectrum = this->spectrum(sea_.parameters.time.start);
    SeaState state = sea_state(spectrum, now(), pool_);
    add_whitecaps(current_modes(), now().surface, state);
    chain_->add_crests(pool_, runs_, state);
    add_second_order(chain_->spectrum(pool_, runs_), now(), state);
    return state;
}

MapModes OpenSea::modes_of_map(double time, int resolution) {
    if (options_.backend.interpolates) {
        if (const auto between = chain_->modes_between(pool_, runs_)) {
            return map_modes(between->from, between->to, between->share, time, resolution);
        }
    }
    return map_modes(current_modes(), time, resolution);
}

void OpenSea::write_maps(double time, std::span<const MapOutput> outputs, int resolution,
                         const FoamLayer& foam) {
    const FoamUse use = foam_use(channels_of(outputs), options_.channels);
    const SurfaceSettings& settings =
        use == FoamUse::none ? now().surface : chain_->shown_settings(resolution, pool_, runs_);
    FoamLayer layer = foam;
    if (use == FoamUse::cover) {
        const ShownFoam map = foam_of_map(sea_.parameters, resolution);
        layer.cover_power = static_cast<float>(chain_->shown_cover_power(map, pool_, runs_));
    }
    const MapModes modes = modes_of_map(time, resolution);
    if (maps_->write({modes, settings, outputs, layer}, pool_)) ++runs_.packing;
    ChannelSet& allocated = allocated_[resolution];
    allocated = allocated | channels_of(outputs);
}

Surface OpenSea::evaluate(double time, ChannelSet channels, int resolution) {
    require_time(time);
    resolution = map_resolution(resolution);
    go_to(time);
    require_map_memory(resolution, channels.size(), channels);
    Surface surface(Lattice{resolution, now().grid.patch_size}, time, channels);
    evaluate_into(time, outputs_of(surface), resolution);
    return surface;
}

void OpenSea::evaluate_into(double time, std::span<const MapOutput> outputs, int resolution) {
    require_time(time);
    resolution = map_resolution(resolution);
    go_to(time);
    const ChannelSet channels = channels_of(outputs);
    require_map_memory(resolution, 0, channels);
    ++runs_.surface;
    if (!has_foam(channels)) {
        write_maps(time, outputs, resolution, {});
        return;
    }
    const FoamLattice lattice = foam_lattice(sea_.parameters, resolution);
    FoamLayer foam = foam_layer(time, lattice);
    go_to(time);  // foam has been in the past
    if (lattice.is_spread()) foam = spread_layer(time, foam, lattice, resolution);
    write_maps(time, outputs, resolution, foam);
    keep_foam(foam, lattice);
}

void OpenSea::evaluate_cascade_into(std::size_t cascade, double time,
                                    std::span<const MapOutput> outputs, int resolution) {
    const Modes& modes = this->modes(time);
    if (cascade >= modes.cascades.size()) {
        throw Error(ErrorKind::invalid_value,
                    "cascade " + std::to_string(cascade) + ": the sea has " +
                        std::to_string(modes.cascades.size()) + ", numbered from 0");
    }
    for (const MapOutput& output : outputs) {
        for (const auto& [quantity, factor] : output.used()) {
            if (!quantity.is_channel()) continue;
            const ChannelInfo& info = channel_info(quantity.channel(), options_.channels);
            if (info.is_multiple()) continue;
            throw Error(
                ErrorKind::invalid_value,
                std::string(info.name) +
                    ": is not a sum over the cascades; allowed: displacement, height, slopes, "
                    "velocity and derivatives");
        }
    }
    if (resolution == 0) resolution = modes.cascades[cascade].lattice.resolution;
    require_resolution(resolution);
    if (cascade_maps_.size() <= cascade) cascade_maps_.resize(cascade + 1);
    std::unique_ptr<MapWriter>& maps = cascade_maps_[cascade];
    if (!maps) {
        require_memory(work_bytes(now().grid, options_.backend, channels_of(outputs), resolution),
                       "a map of a cascade");
        maps = std::make_unique<MapWriter>(options_.backend, options_.channels);
    }
    const MapModes part = cascade_modes(modes, cascade, time, resolution);
    if (maps->write({part, now().surface, outputs, {}}, pool_)) ++runs_.packing;
}

DetailMaps& OpenSea::detail_at(double time, const DetailSettings& settings) {
    require_time(time);
    go_to(time);
    DetailSettings shown = settings;
    shown.resolution = map_resolution(settings.resolution);
    std::unique_ptr<DetailMaps>& maps = detail_[shown];
    if (!maps) {
        require_memory(detail_bytes(now(), shown, options_.backend), "slope tiles");
        maps = std::make_unique<DetailMaps>(shown, options_.backend);
    }
    const DirectionalSpectrum& spectrum = chain_->spectrum(pool_, runs_);
    maps->set_parameters(now(), spectrum, chain_->spectrum_revision(), pool_);
    return *maps;
}

DetailBudget OpenSea::detail_budget(double time, const DetailSettings& settings) {
    return detail_at(time, settings).budget();
}

Detail OpenSea::detail(double time, const DetailSettings& settings) {
    Detail detail(time, settings.samples, detail_budget(time, settings));
    std::vector<MapOutput> outputs;
    for (std::size_t i = 0; i < detail.bands().size(); ++i) {
        outputs.push_back(
            {detail.slopes(i).data(), 2, {{{Channel::slope_x, 1.0f}, {Channel::slope_y, 1.0f}}}});
    }
    detail_into(time, outputs, settings);
    return detail;
}

void OpenSea::detail_into(double time, std::span<const MapOutput> outputs,
                          const DetailSettings& settings) {
    constexpr ChannelSet kSlopes = {Channel::slope_x, Channel::slope_y};
    if (!fields_of(outputs).empty() || !kSlopes.contains(channels_of(outputs))) {
        throw Error(ErrorKind::invalid_value,
                    "detail: a tile has slopes only; allowed: slope_x and slope_y");
    }
    DetailMaps& maps = detail_at(time, settings);
    if (outputs.size() > maps.budget().bands.size()) {
        throw Error(ErrorKind::invalid_value,
                    "detail: " + std::to_string(outputs.size()) + " maps requested; the sea has " +
                        std::to_string(maps.budget().bands.size()) + " bands beyond this map");
    }
    maps.write(time, chain_->spectrum(pool_, runs_), outputs, pool_);
}

int OpenSea::map_resolution(int requested) const {
    if (requested == 0) return default_map_resolution(sea_.parameters.grid);
    require_resolution(requested);
    return requested;
}

void OpenSea::require_map_memory(int resolution, int maps, ChannelSet channels) const {
    const FoamLattice lattice = foam_lattice(sea_.parameters, resolution);
    const bool follows = has_foam(channels) && !foam_.contains(lattice);
    const bool spreads = has_foam(channels) && lattice.is_spread();
    const auto allocated = allocated_.find(resolution);
    const bool has_work_space =
        allocated != allocated_.end() && channels.without(allocated->second).empty();
    const std::uint64_t work = has_work_space ? 0
                                              : work_bytes(now().grid, options_.backend, channels,
                                                           resolution, options_.channels);
    // Bound waves have up to four planes of the map too.
    const std::uint64_t bound =
        has_work_space || !now().surface.second_order
            ? 0
            : BoundWaves::bytes(now().grid.resolution) + maps_bytes(resolution, 4);
    require_memory(
        bound + (chain_->has_modes() ? 0 : modes_bytes(now().grid)) + work +
            maps_bytes(resolution, maps + (spreads ? 1 : 0)) +
            maps_bytes(lattice.resolution, follows ? kFoamMaps : 0),
        "a map of " + std::to_string(resolution) + " x " + std::to_string(resolution) + " samples");
}

bool OpenSea::has_foam(ChannelSet channels) const {
    return has_past(foam_use(channels, options_.channels));
}

const SprayFollower& OpenSea::spray(double time, const SpraySettings& settings) {
    const Lattice lattice = spray_lattice(sea_.parameters.grid);
    const auto require_room = [&] {
        require_map_memory(lattice.resolution, kSprayChannels.size(), kSprayChannels);
    };
    return spray(
        time, settings, Domain::tile(lattice.period, lattice.resolution), require_room,
        [&](double t, Surface& map) { write_maps(t, outputs_of(map), map.resolution(), {}); });
}

const SprayFollower& OpenSea::spray(double time, const SpraySettings& settings,
                                    const Domain& domain, const std::function<void()>& require_room,
                                    const SprayMap& fill) {
    require_time(time);
    validate(settings);
    go_to(time);
    if (!spray_ || spray_->settings() != settings || spray_->domain() != domain) {
        spray_.reset();
        require_room();
        spray_ = std::make_unique<SprayFollower>(
            settings, foam_clock(sea_.parameters.surface, sea_.parameters.time.loop_period), domain,
            sea_.parameters.seed);
    }
    spray_->go_to(time, {[&](double t, Surface& map) {
                      go_to(t);
                      ++runs_.spray_ticks;
                      fill(t, map);
                      return spray_air(now());
                  }});
    return *spray_;
}

}  // namespace ocean
