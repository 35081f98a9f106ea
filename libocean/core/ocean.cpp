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

#include "kernel/map_kernel.hpp"
#include "kernel/packed_modes.hpp"
#include "modes/mode_lattice.hpp"

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
      lattice_(built.lattice_),
      modes_(built.modes_),
      modes_right_(built.modes_right_),
      modes_lent_(true) {
    built.modes_lent_ = true;
    for (const auto& [resolution, theirs] : built.kernels_) {
        if (!theirs.right) continue;
        KernelOfMap& ours = kernels_[resolution];
        ours.packed = theirs.packed;
        ours.right = true;
        ours.lent = true;
        theirs.lent = true;
    }
}

Ocean::~Ocean() = default;

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
            modes_right_ = false;
            for (auto& [resolution, kept] : kernels_) kept.right = false;
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
        spectrum_ =
            std::make_shared<const DirectionalSpectrum>(make_directional_spectrum(now_, pool_));
    }
    return *spectrum_;
}

const Modes& Ocean::current_modes() {
    if (modes_right_) return *modes_;
    const DirectionalSpectrum& spectrum = current_spectrum();
    ++runs_.modes;
    const bool same_lattice = modes_ && lattice_->is_of(now_);
    // The first modes of a lattice are mostly the last: what only rebuilds need is kept from the
    // second on, or where a take will ask for them.
    const bool keep = same_lattice || !sea_.take.empty();
    if (!same_lattice) {
        modes_.reset();
        lattice_.reset();
        require_memory(modes_bytes(now_.grid) + (keep ? ModeLattice::kept_bytes(now_.grid) : 0),
                       "grid.resolution = " + std::to_string(now_.grid.resolution));
    }
    if (!same_lattice || (keep && !lattice_->is_kept())) {
        const auto memory = keep ? ModeLattice::Memory::keep : ModeLattice::Memory::none;
        lattice_ = std::make_shared<const ModeLattice>(now_, memory, pool_);
    }
    if (!same_lattice) {
        modes_ = std::make_shared<Modes>(lattice_->still_modes(pool_));
    } else if (modes_lent_) {
        modes_ = std::make_shared<Modes>(*modes_);
    }
    modes_lent_ = false;
    lattice_->set_waves(spectrum, strongest_wind(now_), pool_, *modes_);
    modes_right_ = true;
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

MapKernel& Ocean::kernel(int resolution) {
    const Modes& modes = current_modes();
    KernelOfMap& kept = kernels_[resolution];
    if (!kept.right) {
        ++runs_.packing;
        const SynthesisRequest request = synthesis_request(modes, 0.0, resolution, {});
        // Packed again in place, unless another sea has it too.
        if (!kept.packed || kept.lent || !kept.packed->refill(request, pool_)) {
            kept.packed = std::make_shared<PackedModes>(request, pool_, simd_level());
            kept.lent = false;
        }
        if (kept.kernel) kept.kernel->use(kept.packed);
        kept.right = true;
    }
    if (!kept.kernel) kept.kernel = std::make_unique<MapKernel>(kept.packed);
    return *kept.kernel;
}

namespace {

ChannelSet channels_of(std::span<const MapOutput> outputs) {
    ChannelSet channels;
    for (const MapOutput& output : outputs) channels = channels | output.channels();
    return channels;
}

/// The backends that are written to be read make planes first.
void copy_maps(const Surface& surface, std::span<const MapOutput> outputs, const FoamLayer& foam) {
    const auto value = [&](Channel channel, std::size_t i) {
        return channel == Channel::foam ? foam.over(surface.channel(Channel::whitecap)[i], i)
                                        : surface.channel(channel)[i];
    };
    const auto samples = Lattice{surface.resolution(), 1.0}.size();
    for (const MapOutput& output : outputs) {
        const auto stride = static_cast<std::size_t>(output.components);
        for (std::size_t c = 0; c < stride; ++c) {
            const auto [quantity, factor] = output.component[c];
            if (quantity == Quantity{}) continue;
            const auto channel = static_cast<Channel>(quantity.id);
            for (std::size_t i = 0; i < samples; ++i) {
                output.data[i * stride + c] = factor * value(channel, i);
            }
        }
    }
}

}  // namespace

void Ocean::write_maps(double time, std::span<const MapOutput> outputs, int resolution,
                       const FoamLayer& foam) {
    ChannelSet channels = channels_of(outputs);
    if (channels.contains(Channel::foam)) channels = channels | ChannelSet{Channel::whitecap};
    const SurfaceSettings& settings =
        channels.contains(Channel::whitecap) ? shown_settings(resolution) : now_.surface;
    if (options_.backend == Backend::cpu) {
        const double tau = current_modes().tau(time);
        kernel(resolution).run({tau, settings, outputs, foam}, pool_);
        return;
    }
    const Surface surface =
        make_surface(current_modes(), settings, time, channels.without(Channel::foam),
                     options_.backend, pool_, resolution);
    copy_maps(surface, outputs, foam);
}

Surface Ocean::evaluate(double time, ChannelSet channels, int resolution) {
    resolution = map_resolution(resolution);
    go_to(time);
    require_map_memory(resolution, channels.size(), channels);
    Surface surface({resolution, now_.grid.patch_size}, time, channels);
    evaluate_into(time, outputs_of(surface), resolution);
    return surface;
}

void Ocean::evaluate_into(double time, std::span<const MapOutput> outputs, int resolution) {
    require_finite_time(time);
    resolution = map_resolution(resolution);
    go_to(time);
    const ChannelSet channels = channels_of(outputs);
    require_map_memory(resolution, 0, channels);
    ++runs_.surface;
    FoamLayer foam;
    if (channels.contains(Channel::foam)) {
        foam = foam_layer(time, resolution);
        go_to(time);  // foam has been in the past
    }
    write_maps(time, outputs, resolution, foam);
}

int Ocean::map_resolution(int asked) const {
    if (asked == 0) return default_map_resolution(sea_.parameters.grid);
    require_resolution(asked);
    return asked;
}

void Ocean::require_map_memory(int resolution, int maps, ChannelSet channels) const {
    const int foam = channels.contains(Channel::foam) ? kFoamMaps : 0;
    const auto kept = kernels_.find(resolution);
    const bool there = kept != kernels_.end() && kept->second.kernel;
    require_memory(
        (modes_right_ ? 0 : modes_bytes(now_.grid)) +
            (there ? 0 : kernel_bytes(resolution, channels.size())) +
            surface_bytes(resolution, maps + foam),
        "a map of " + std::to_string(resolution) + " x " + std::to_string(resolution) + " samples");
}

FoamLayer Ocean::foam_layer(double time, int resolution) {
    if (!foam_ || foam_resolution_ != resolution) {
        foam_.emplace(foam_clock(sea_.parameters.surface, sea_.parameters.time.loop_period),
                      Lattice{resolution, 1.0}.size(), options_.foam_start);
        foam_resolution_ = resolution;
    }
    const FoamSource source{
        [this](double t) { return sea_.foam_lifetime(t); },
        [this, resolution](double t, const FoamLayer& before, std::span<float> foam) {
            go_to(t);
            ++runs_.foam_ticks;
            const MapOutput output{foam.data(), 1, {{{Channel::foam, 1.0f}}}};
            write_maps(t, {&output, 1}, resolution, before);
        },
        options_.foam_progress};
    return foam_->layer(time, source);
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
