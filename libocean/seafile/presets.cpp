// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Seas and terrains by name: the files of presets/, which the build puts into the library.
//
// beaufort  JONSWAP of the mean wind, with the fetch that gives the probable wave height. The
//           winds of forces 1 to 3 raise lower waves, even when the sea is fully developed [Pierson
//           and Moskowitz 1964]: their files state height and period, and a fetch that suffices
//           for full development or is the min of its range.
// douglas   the middle of each degree's heights with the period of a wind sea of steepness 0.036,
//           height over peak wavelength; wind and fetch alone would give about both.
// seed      the programs that this project continues, in corrected physics.
//
// A file has the keys that differ from their defaults, and the keys that users look for first:
// spectrum and resolution; in a terrain resolution, patch_size and beta.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrainfile.hpp"
#include "preset_files.hpp"

namespace ocean {
namespace {

/// Returns the presets of files that begin with "# NAME: DESCRIPTION", as the build checks.
std::vector<Preset> presets_of(std::span<const std::string_view> files) {
    std::vector<Preset> presets;
    for (const std::string_view text : files) {
        const std::size_t name = 2, colon = text.find(": "), description = colon + 2;
        presets.push_back({std::string(text.substr(name, colon - name)),
                           std::string(text.substr(description, text.find('\n') - description)),
                           std::string(text)});
    }
    return presets;
}

/// Returns "beaufort" for "beaufort_12", "" for a name without a number.
std::string_view scale_of(std::string_view name) {
    const std::size_t end = name.find_last_not_of("0123456789");
    return end + 1 < name.size() ? name.substr(0, end) : std::string_view();
}

/// Returns "beaufort_0 .. beaufort_12, seed_lantz".
std::string names_of(std::span<const Preset> presets) {
    std::string names;
    for (std::size_t first = 0, end = 0; first < presets.size(); first = end) {
        const std::string_view scale = scale_of(presets[first].name);
        end = first + 1;
        while (!scale.empty() && end < presets.size() && scale_of(presets[end].name) == scale)
            ++end;
        names += (names.empty() ? "" : ", ") + presets[first].name;
        if (end > first + 1) names += " .. " + presets[end - 1].name;
    }
    return names;
}

/// Returns the preset of that name. `noun` is the word for a preset in messages. Throws Error
/// not_found.
const Preset& find_preset_in(std::span<const Preset> presets, std::string_view name,
                             std::string_view noun) {
    const auto found = std::ranges::find(presets, name, &Preset::name);
    if (found != presets.end()) return *found;
    throw Error(ErrorKind::not_found,
                "no " + std::string(noun) + " is called '" + text::printable(name) + "'" +
                    did_you_mean(name, presets, &Preset::name) + "; allowed: " + names_of(presets));
}

}  // namespace

std::span<const Preset> presets() {
    static const std::vector<Preset> kPresets = presets_of(sea_preset_files());
    return kPresets;
}

const Preset& find_preset(std::string_view name) {
    return find_preset_in(presets(), name, "preset");
}

std::span<const Preset> terrain_presets() {
    static const std::vector<Preset> kPresets = presets_of(terrain_preset_files());
    return kPresets;
}

const Preset& find_terrain_preset(std::string_view name) {
    return find_preset_in(terrain_presets(), name, "terrain preset");
}

}  // namespace ocean
