// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Wave systems that a user adds and removes, and the numbers by which a take refers to the others.
#include <iterator>
#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/sea.hpp"

namespace ocean {

namespace {

constexpr std::string_view kPrefix = "waves.";

/// Returns the number of "waves.1". Throws Error invalid_value.
std::size_t system_number(std::string_view name, std::size_t last) {
    if (!name.starts_with(kPrefix)) {
        throw Error(ErrorKind::invalid_value, "unknown wave system '" + std::string(name) +
                                                  "'; allowed: waves.0 .. waves." +
                                                  std::to_string(last));
    }
    return static_cast<std::size_t>(parse_whole_number(
        name.substr(kPrefix.size()), "number of a wave system", 0, static_cast<int>(last)));
}

bool is_of(const TakeEvent& event, std::size_t system) {
    return event.parameter.info->in_list() && event.parameter.item == system;
}

/// Renumbers the systems from `first` on in the take.
void renumber(Take& take, std::size_t first, std::ptrdiff_t by) {
    for (TakeEvent& event : take.events) {
        std::size_t& wave = event.parameter.item;
        if (!event.parameter.info->in_list() || wave < first) continue;
        wave = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(wave) + by);
    }
}

}  // namespace

void add_wave_system(Sea& sea, std::string_view name) {
    std::vector<WaveSystem>& waves = sea.parameters.waves;
    const std::size_t number = system_number(name, waves.size());
    if (waves.size() >= kMaxWaveSystems) {
        throw Error(
            ErrorKind::invalid_value,
            "the sea already has " + std::to_string(waves.size()) + " wave systems, the max");
    }
    waves.insert(waves.begin() + static_cast<std::ptrdiff_t>(number), WaveSystem{});
    renumber(sea.take, number, 1);
}

void remove_wave_system(Sea& sea, std::string_view name) {
    std::vector<WaveSystem>& waves = sea.parameters.waves;
    const std::size_t number = system_number(name, waves.size() - 1);
    if (waves.size() == 1) {
        throw Error(ErrorKind::invalid_value,
                    "the last wave system cannot be removed; allowed: 1 .. " +
                        std::to_string(kMaxWaveSystems) + " systems");
    }
    waves.erase(waves.begin() + static_cast<std::ptrdiff_t>(number));
    std::erase_if(sea.take.events, [=](const TakeEvent& event) { return is_of(event, number); });
    renumber(sea.take, number + 1, -1);
}

}  // namespace ocean
