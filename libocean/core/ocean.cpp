// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade: parameters -> spectrum -> modes -> surface, each kept until something dirties it.
#include "ocean/ocean.hpp"

namespace ocean {

Ocean::Ocean(Parameters parameters, OceanOptions options)
    : parameters_(std::move(parameters)), options_(options), pool_(options.threads) {
    validate(parameters_);
}

void Ocean::set(std::string_view name, std::string_view value) {
    set_parameter(parameters_, name, value);
    dirty(find_parameter(name).info->dirties);
}

void Ocean::dirty(Stage stage) {
    if (stage == Stage::spectrum) spectrum_.reset();
    if (stage == Stage::spectrum || stage == Stage::modes) modes_.reset();
}

const DirectionalSpectrum& Ocean::spectrum() {
    if (!spectrum_) spectrum_ = make_directional_spectrum(parameters_);
    return *spectrum_;
}

const Modes& Ocean::modes() {
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
