// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea's parameters by name, and the first stage that a change dirties.
#include <algorithm>

#include "ocean/parameter_table.hpp"

namespace ocean {

namespace {

bool same_systems(const Parameters& a, const Parameters& b) {
    return std::equal(a.waves.begin(), a.waves.end(), b.waves.begin(), b.waves.end(),
                      [](const WaveSystem& x, const WaveSystem& y) {
                          return x.measured == y.measured && x.energy_share == y.energy_share &&
                                 x.wind_onset == y.wind_onset;
                      });
}

bool names_record(const ParameterInfo& info) {
    return info.holds<&WaveSystem::file>() || info.holds<&WaveSystem::record>() ||
           info.holds<&WaveSystem::place>();
}

}  // namespace

ParameterRef find_parameter(std::string_view name) {
    return find_parameter(sea_table(), name);
}

std::optional<Stage> first_dirty_stage(const Parameters& before, const Parameters& after) {
    if (!same_systems(before, after)) return Stage::spectrum;
    std::optional<Stage> first;
    for (const ParameterInfo& info : parameter_table()) {
        if (first && *first <= info.dirties) continue;
        for (std::size_t item = 0; item < info.member.items(before); ++item) {
            if (info.member.get(before, item) != info.member.get(after, item)) first = info.dirties;
        }
    }
    return first;
}

void set_parameter(Parameters& parameters, std::string_view name, std::string_view text) {
    const ParameterRef ref = find_parameter(name);
    Parameters changed = parameters;
    assign(changed, ref, parse_value(*ref.info, ref.item, text));
    if (names_record(*ref.info) && value_of(changed, ref) != value_of(parameters, ref)) {
        changed.waves[ref.item].measured = nullptr;  // it belongs to the previous name
    }
    parameters = std::move(changed);
}

std::string get_parameter(const Parameters& parameters, std::string_view name) {
    return to_text(value_of(parameters, find_parameter(name)));
}

std::string live_parameter_names() {
    std::string names;
    for (const ParameterInfo& info : parameter_table()) {
        if (info.change != ParameterClass::live) continue;
        names += (names.empty() ? "" : ", ") + std::string(info.key);
    }
    return names;
}

std::string parameters_markdown() {
    return parameters_markdown(listed(sea_table()));
}

std::string parameters_json() {
    return parameters_json(listed(sea_table()));
}

}  // namespace ocean
