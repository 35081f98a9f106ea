// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade: an open sea, the coast that it has over a bed, and its hulls.
#include "ocean/ocean.hpp"

#include <string>
#include <utility>

#include "coast.hpp"
#include "hull_sea.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/open_sea.hpp"
#include "waves/spray/spray_follower.hpp"

namespace ocean {

Ocean::Ocean(Sea sea, OceanOptions options)
    : open_(std::make_unique<OpenSea>(std::move(sea), std::move(options))),
      coast_(std::make_unique<Coast>(*open_)),
      hulls_(std::make_unique<HullSea>(*open_)) {}

Ocean::Ocean(Parameters parameters, OceanOptions options)
    : Ocean(Sea{std::move(parameters), {}}, std::move(options)) {}

Ocean::Ocean(const Ocean& built, OceanOptions options)
    : open_(std::make_unique<OpenSea>(*built.open_, std::move(options))),
      coast_(std::make_unique<Coast>(*built.coast_, *open_)),
      hulls_(std::make_unique<HullSea>(*open_)) {}

Ocean::~Ocean() = default;

const Sea& Ocean::sea() const {
    return open_->sea();
}

const Parameters& Ocean::parameters() const {
    return open_->parameters();
}

std::uint64_t Ocean::revision() const {
    return open_->revision();
}

void Ocean::set(std::string_view name, std::string_view value) {
    Sea changed = sea();
    set_parameter(changed.parameters, name, value);
    change(std::move(changed));
}

void Ocean::perform(double time, std::string_view name, std::string_view value) {
    open_->perform(time, name, value);
}

void Ocean::change(Sea sea) {
    const OpenSea::Ended ended = open_->change(std::move(sea));
    coast_->drop(ended);
    hulls_->drop(ended);
}

bool Ocean::has_bed() const {
    return parameters().water.bed != nullptr;
}

OpenSea& Ocean::without_bed(std::string_view what) {
    if (!has_bed()) return *open_;
    throw Error(ErrorKind::unsupported,
                std::string(what) +
                    " repeats or knows no depth, and this sea has a bed (water.seabed), over which "
                    "it does not repeat; request a region");
}

PlacedSea* Ocean::placed() const {
    if (has_bed()) return coast_.get();
    return parameters().hulls.empty() ? nullptr : hulls_.get();
}

PlacedSea& Ocean::region_sea() const {
    if (PlacedSea* const sea = placed()) return *sea;
    throw Error(ErrorKind::unsupported,
                "this sea has no bed (water.seabed): it repeats, and its maps are those of one "
                "period");
}

bool Ocean::repeats() const {
    return placed() == nullptr;
}

const DirectionalSpectrum& Ocean::spectrum(double time) {
    return open_->spectrum(time);
}

const Modes& Ocean::modes(double time) {
    return open_->modes(time);
}

SeaState Ocean::state() {
    SeaState state = open_->state();
    if (PlacedSea* const sea = placed()) sea->describe(state);
    return state;
}

Surface Ocean::evaluate(double time, ChannelSet channels, int resolution) {
    return without_bed("a map of one period").evaluate(time, channels, resolution);
}

void Ocean::evaluate_into(double time, std::span<const MapOutput> outputs, int resolution) {
    without_bed("a map of one period").evaluate_into(time, outputs, resolution);
}

void Ocean::evaluate_cascade_into(std::size_t cascade, double time,
                                  std::span<const MapOutput> outputs, int resolution) {
    without_bed("a map of a cascade").evaluate_cascade_into(cascade, time, outputs, resolution);
}

Surface Ocean::region(double time, const Domain& domain, ChannelSet channels) {
    return region_sea().region(time, domain, channels);
}

void Ocean::region_into(double time, const Domain& domain, std::span<const MapOutput> outputs) {
    region_sea().region_into(time, domain, outputs);
}

void Ocean::require_hull(std::size_t hull) const {
    const std::size_t count = parameters().hulls.size();
    if (hull < count) return;
    throw Error(ErrorKind::invalid_value,
                {.parameter = "hull",
                 .value = std::to_string(hull),
                 .allowed = count == 0 ? "none: this sea has no hulls"
                                       : "0 .. " + std::to_string(count - 1)});
}

Domain Ocean::wake_domain(std::size_t hull, double time) const {
    require_hull(hull);
    return hulls_->wake_domain(hull, time);
}

void Ocean::wake_into(std::size_t hull, double time, const Domain& domain,
                      std::span<const MapOutput> outputs) {
    require_hull(hull);
    hulls_->wake_into(hull, time, domain, outputs, false);
}

void Ocean::add_wake(std::size_t hull, double time, const Domain& domain,
                     std::span<const MapOutput> outputs) {
    require_hull(hull);
    hulls_->wake_into(hull, time, domain, outputs, true);
}

void Ocean::prepare_coast() {
    region_sea().prepare();
}

double Ocean::cover_power(double time, int resolution) {
    return open_->cover_power(time, resolution);
}

DetailBudget Ocean::detail_budget(double time, const DetailSettings& settings) {
    return without_bed("a slope tile").detail_budget(time, settings);
}

Detail Ocean::detail(double time, const DetailSettings& settings) {
    return without_bed("a slope tile").detail(time, settings);
}

void Ocean::detail_into(double time, std::span<const MapOutput> outputs,
                        const DetailSettings& settings) {
    without_bed("a slope tile").detail_into(time, outputs, settings);
}

std::vector<SprayParticle> Ocean::spray(double time, const SpraySettings& settings,
                                        const std::optional<Domain>& region) {
    return spray_at(time, settings, region).particles();
}

std::vector<MistPuff> Ocean::mist(double time, const SpraySettings& settings,
                                  const std::optional<Domain>& region) {
    return spray_at(time, settings, region).mist();
}

const SprayFollower& Ocean::spray_at(double time, const SpraySettings& settings,
                                     const std::optional<Domain>& region) {
    PlacedSea* const sea = region ? &region_sea() : placed();
    return sea != nullptr ? sea->spray(time, settings, region) : open_->spray(time, settings);
}

std::int64_t Ocean::foam_settling_ticks() const {
    return open_->foam_settling_ticks();
}

FrameCost Ocean::measure_frame_cost() {
    return without_bed("a map of one period").measure_frame_cost();
}

const StageRuns& Ocean::stage_runs() const {
    return open_->stage_runs();
}

ThreadPool& Ocean::pool() {
    return open_->pool();
}

void Ocean::query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
                  const QueryOptions& options) {
    if (PlacedSea* const sea = placed()) return sea->query(time, points, samples, options);
    open_->query(time, points, samples, options);
}

double Ocean::query_height_error(double time, const QueryOptions& options) {
    PlacedSea* const sea = placed();
    return sea != nullptr ? sea->query_height_error(time, options)
                          : open_->query_height_error(time, options);
}

void Ocean::water_motion(double time, std::span<const WaterPoint> points,
                         std::span<WaterMotion> motions, const QueryOptions& options) {
    if (PlacedSea* const sea = placed()) return sea->water_motion(time, points, motions, options);
    open_->water_motion(time, points, motions, options);
}

void Ocean::float_poses(double time, std::span<const FloatBody> bodies,
                        std::span<FloatPose> poses) {
    if (PlacedSea* const sea = placed()) return sea->float_poses(time, bodies, poses);
    open_->float_poses(time, bodies, poses);
}

}  // namespace ocean
