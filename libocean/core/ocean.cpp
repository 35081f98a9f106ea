// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade: parameters -> spectrum -> modes -> surface, each kept until something dirties it.
#include "ocean/ocean.hpp"

namespace ocean {

Ocean::Ocean(Parameters parameters, OceanOptions options)
    : parameters_(std::move(parameters)), options_(options), pool_(options.threads) {
    require_valid();
}

void Ocean::set(std::string_view name, std::string_view value) {
    Parameters changed = parameters_;
    set_parameter(changed, name, value);
    change(std::move(changed), find_parameter(name).info->dirties);
}

void Ocean::change(Parameters parameters, Stage first_stage) {
    parameters_ = std::move(parameters);
    validated_ = false;
    if (first_stage == Stage::spectrum) spectrum_.reset();
    if (first_stage == Stage::spectrum || first_stage == Stage::modes) modes_.reset();
}

void Ocean::require_valid() {
    if (!validated_) validate(parameters_);
    validated_ = true;
}

const DirectionalSpectrum& Ocean::spectrum() {
    require_valid();
    if (!spectrum_) spectrum_ = make_directional_spectrum(parameters_);
    return *spectrum_;
}

const Modes& Ocean::modes() {
    require_valid();
    if (!modes_) {
        const int n = parameters_.grid.resolution;
        require_memory(modes_bytes(n), "grid.resolution = " + std::to_string(n));
        modes_ = make_modes(spectrum(), parameters_, pool_);
    }
    return *modes_;
}

SeaState Ocean::state() {
    return sea_state(spectrum(), parameters_, pool_);
}

Surface Ocean::evaluate(double time, ChannelSet channels, int resolution) {
    const int n = resolution > 0 ? resolution : parameters_.grid.resolution;
    const std::uint64_t modes_left = modes_ ? 0 : modes_bytes(parameters_.grid.resolution);
    require_memory(modes_left + surface_bytes(n, channels.size()),
                   "a map of " + std::to_string(n) + " x " + std::to_string(n) + " samples");
    return make_surface(modes(), parameters_.surface, time, channels, options_.backend, pool_,
                        resolution);
}

}  // namespace ocean
