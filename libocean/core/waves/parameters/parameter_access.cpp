// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea's parameters by name, and the first stage that a change dirties.
#include <algorithm>

#include "ocean/parameter_table.hpp"
#include "ocean/sea_bed.hpp"

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

/// Returns true for a key whose change makes a reader read another bed from its file.
bool names_bed(const ParameterInfo& info) {
    return info.holds<&Water::seabed>() || info.holds<&Water::seabed_unit>();
}

/// Returns the bed of the changed water: the present one, moved, or none if its file must be read
/// anew.
std::shared_ptr<const SeaBed> bed_after(const ParameterInfo& changed, const Water& water) {
    if (water.bed == nullptr) return nullptr;
    const bool has_file = !water.seabed.empty() || changed.holds<&Water::seabed>();
    if (names_bed(changed) && has_file) return nullptr;
    return placed_bed(water.bed, water);
}

}  // namespace

ParameterRef find_parameter(std::string_view name) {
    return find_parameter(sea_table(), name);
}

std::optional<Stage> first_dirty_stage(const Parameters& before, const Parameters& after) {
    if (!same_systems(before, after)) return Stage::spectrum;
    std::optional<Stage> first;
    if (!same_bed(before.water, after.water)) first = Stage::surface;
    for (const ParameterInfo& info : parameter_table()) {
        if (first && *first <= info.dirties) continue;
        const std::size_t items = info.member.items(before);
        bool same = items == info.member.items(after);
        for (std::size_t item = 0; same && item < items; ++item) {
            same = info.member.get(before, item) == info.member.get(after, item);
        }
        if (!same) first = info.dirties;
    }
    if (!first && before.hulls != after.hulls) first = Stage::clock;  // another track
    return first;
}

void set_parameter(Parameters& parameters, std::string_view name, std::string_view text) {
    const ParameterRef ref = find_parameter(name);
    Parameters changed = parameters;
    assign(changed, ref, parse_value(*ref.info, ref.item, text));
    if (names_record(*ref.info) && value_of(changed, ref) != value_of(parameters, ref)) {
        changed.waves[ref.item].measured = nullptr;  // it belongs to the previous name
    }
    const bool is_of_file = ref.info->holds<&Hull::track_file>() ||
                            ref.info->holds<&Hull::origin>() ||
                            ref.info->holds<&Hull::origin_time>();
    if (is_of_file && value_of(changed, ref) != value_of(parameters, ref)) {
        Hull& hull = changed.hulls[ref.item];
        if (ref.info->holds<&Hull::track_file>() || !hull.track_file.empty()) hull.track = nullptr;
    }
    if (value_of(changed, ref) != value_of(parameters, ref)) {
        changed.water.bed = bed_after(*ref.info, changed.water);
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
