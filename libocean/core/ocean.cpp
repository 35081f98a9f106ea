// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade: parameters -> spectrum -> modes -> surface -> foam, each kept until something dirties
// it.
#include "ocean/ocean.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace ocean {

Ocean::Ocean(Sea sea, OceanOptions options)
    : sea_(std::move(sea)),
      now_(sea_.parameters),
      options_(std::move(options)),
      pool_(options_.threads) {
    require_valid();
}

Ocean::Ocean(Parameters parameters, OceanOptions options)
    : Ocean(Sea{std::move(parameters), {}}, std::move(options)) {}

Ocean::Ocean(const Ocean& built, OceanOptions options)
    : sea_(built.sea_),
      now_(built.now_),
      validated_(built.validated_),
      options_(std::move(options)),
      pool_(options_.threads),
      spectrum_(built.spectrum_),
      modes_(built.modes_) {}

void Ocean::set(std::string_view name, std::string_view value) {
    Sea changed = sea_;
    set_parameter(changed.parameters, name, value);
    change(std::move(changed), find_parameter(name).info->dirties);
}

void Ocean::change(Sea sea, Stage first_stage) {
    sea_ = std::move(sea);
    now_ = sea_.parameters;
    validated_ = false;
    // A take's past may have changed anything.
    dirty(sea_.take.empty() ? first_stage : Stage::spectrum);
    if (first_stage != Stage::clock || !sea_.take.empty()) foam_.reset();
    surface_query_.reset();
    water_velocity_.reset();
}

void Ocean::dirty(Stage first_stage) {
    switch (first_stage) {
        case Stage::spectrum:
            spectrum_.reset();
            [[fallthrough]];
        case Stage::modes:
            modes_.reset();
            [[fallthrough]];
        case Stage::surface:
        case Stage::foam:
            shown_.reset();
            [[fallthrough]];
        case Stage::clock:
            break;
    }
}

void Ocean::require_valid() {
    if (!validated_) validate(sea_);
    validated_ = true;
}

void Ocean::go_to(double time) {
    require_valid();
    if (sea_.take.empty()) return;
    Parameters then = sea_.at(time);
    if (const auto stage = first_dirty_stage(now_, then)) dirty(*stage);
    now_ = std::move(then);
}

const DirectionalSpectrum& Ocean::spectrum(double time) {
    go_to(time);
    return current_spectrum();
}

const Modes& Ocean::modes(double time) {
    go_to(time);
    return current_modes();
}

const DirectionalSpectrum& Ocean::current_spectrum() {
    if (!spectrum_) {
        ++runs_.spectrum;
        spectrum_ = std::make_shared<const DirectionalSpectrum>(make_directional_spectrum(now_));
    }
    return *spectrum_;
}

const Modes& Ocean::current_modes() {
    if (!modes_) {
        require_memory(modes_bytes(now_.grid),
                       "grid.resolution = " + std::to_string(now_.grid.resolution));
        const DirectionalSpectrum& spectrum = current_spectrum();
        ++runs_.modes;
        modes_ = std::make_shared<const Modes>(make_modes(spectrum, now_, pool_));
    }
    return *modes_;
}

SeaState Ocean::state() {
    const DirectionalSpectrum& spectrum = this->spectrum();
    SeaState state = sea_state(spectrum, now_, pool_);
    add_whitecaps(current_modes(), now_.surface, state);
    return state;
}

FrameCost Ocean::measure_frame_cost() {
    constexpr int kLargest = 512;
    const double start = sea_.parameters.time.start;
    const int map = default_map_resolution(sea_.parameters.grid);
    const int measured = std::min(map, kLargest);
    const auto seconds = [&](ChannelSet channels) {
        const auto begin = std::chrono::steady_clock::now();
        evaluate(start, channels, measured);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    const ChannelSet tick_channels = {Channel::whitecap};
    const ChannelSet frame_channels = {Channel::dx, Channel::dy, Channel::height,  Channel::nx,
                                       Channel::ny, Channel::nz, Channel::whitecap};
    seconds(tick_channels);  // builds what is not there yet
    // An inverse transform of N x N samples is N^2 log N work.
    const double scale = std::pow(static_cast<double>(map) / measured, 2.0) *
                         std::log(static_cast<double>(map)) /
                         std::log(static_cast<double>(measured));
    const double tick = scale * seconds(tick_channels);
    const double frame = scale * seconds(frame_channels);
    const FoamClock clock = foam_clock(now_.surface, now_.time.loop_period);
    const double lifetime = now_.surface.foam_lifetime;
    const auto preroll =
        static_cast<double>(preroll_ticks(clock, 0, [lifetime](double) { return lifetime; }));
    // Without a lifetime there are no ticks to follow.
    const double ticks = preroll > 0.0 ? 1.0 / (now_.time.fps * clock.step) : 0.0;
    return {frame + preroll * tick, frame + std::min(ticks, preroll) * tick};
}

const SurfaceSettings& Ocean::shown_settings(int resolution) {
    if (!shown_ || shown_resolution_ != resolution) {
        ++runs_.threshold;
        shown_ = with_threshold(now_.surface, current_modes(), resolution);
        shown_resolution_ = resolution;
    }
    return *shown_;
}

Surface Ocean::current_surface(double time, ChannelSet channels, int resolution) {
    const SurfaceSettings& settings =
        channels.contains(Channel::whitecap) ? shown_settings(resolution) : now_.surface;
    return make_surface(current_modes(), settings, time, channels, options_.backend, pool_,
                        resolution);
}

Surface Ocean::evaluate(double time, ChannelSet channels, int resolution) {
    go_to(time);
    const int n = resolution > 0 ? resolution : default_map_resolution(now_.grid);
    const bool foam = channels.contains(Channel::foam);
    require_memory((modes_ ? 0 : modes_bytes(now_.grid)) +
                       surface_bytes(n, channels.size() + (foam ? kFoamMaps : 0)),
                   "a map of " + std::to_string(n) + " x " + std::to_string(n) + " samples");
    ChannelSet moment = channels.without(Channel::foam);
    if (foam) moment = moment | ChannelSet{Channel::whitecap};
    ++runs_.surface;
    Surface surface = current_surface(time, moment, n);
    if (foam) {
        surface.add(Channel::foam);
        add_foam(surface);
        if (!channels.contains(Channel::whitecap)) surface.drop(Channel::whitecap);
    }
    return surface;
}

void Ocean::add_foam(Surface& surface) {
    if (!foam_ || foam_resolution_ != surface.resolution()) {
        foam_.emplace(foam_clock(sea_.parameters.surface, sea_.parameters.time.loop_period),
                      options_.foam_start);
        foam_resolution_ = surface.resolution();
    }
    const FoamSource source{[this](double time) { return sea_.foam_lifetime(time); },
                            [this](double time) {
                                go_to(time);
                                ++runs_.foam_ticks;
                                tick_ =
                                    current_surface(time, {Channel::whitecap}, foam_resolution_);
                                return std::as_const(tick_).channel(Channel::whitecap);
                            },
                            options_.foam_progress};
    foam_->evaluate(surface.time(), std::as_const(surface).channel(Channel::whitecap), source,
                    surface.channel(Channel::foam), pool_);
}

namespace {

void require_query_memory(std::uint64_t bytes) {
    require_memory(bytes, "a query of this sea");
}

}  // namespace

QueryOptions Ocean::shown(QueryOptions options) const {
    if (options.resolution == 0) {
        options.resolution = default_map_resolution(sea_.parameters.grid);
    }
    return options;
}

const SurfaceQuery& Ocean::surface_query(double time, const QueryOptions& asked) {
    const QueryOptions options = shown(asked);
    const auto& kept = surface_query_;
    if (!kept || kept->time != time || kept->options != options) {
        surface_query_.reset();
        require_query_memory(SurfaceQuery::bytes(modes(time), options));
        FoamMap foam;
        if (options.foam) {
            const Surface map = evaluate(time, {Channel::foam}, options.resolution);
            const std::span<const float> values = map.channel(Channel::foam);
            foam = {{values.begin(), values.end()}, map.resolution()};
        }
        const Modes& modes = this->modes(time);  // foam has been in the past
        surface_query_ = {
            time, 0.0, options,
            SurfaceQuery(modes, now_.surface, now_.water, time, options, pool_, std::move(foam))};
    }
    return surface_query_->query;
}

const OrbitalVelocity& Ocean::water_velocity(double time, double z, const QueryOptions& asked) {
    const QueryOptions options = shown(asked);
    const auto& kept = water_velocity_;
    if (!kept || kept->time != time || kept->z != z || kept->options != options) {
        water_velocity_.reset();
        const Modes& modes = this->modes(time);
        require_query_memory(OrbitalVelocity::bytes(modes, options));
        water_velocity_ = {time, z, options,
                           OrbitalVelocity(modes, now_.water, time, z, options, pool_)};
    }
    return water_velocity_->query;
}

void Ocean::query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
                  const QueryOptions& options) {
    surface_query(time, options).sample(points, samples, pool_);
}

void Ocean::orbital_velocity(double time, double z, std::span<const WorldPoint> points,
                             std::span<std::array<double, 3>> velocities,
                             const QueryOptions& options) {
    water_velocity(time, z, options).sample(points, velocities, pool_);
}

void Ocean::float_poses(double time, std::span<const FloatBody> bodies,
                        std::span<FloatPose> poses) {
    // A pose needs no foam, but the query that is kept may have some.
    QueryOptions options = shown({});
    const auto& kept = surface_query_;
    options.foam = kept && kept->time == time && kept->options == options;
    const SurfaceQuery& query = surface_query(time, options);
    std::vector<FloatPose> found;
    for (const FloatBody& body : bodies) found.push_back(float_pose(query, body, pool_));
    std::copy(found.begin(), found.end(), poses.begin());
}

}  // namespace ocean
