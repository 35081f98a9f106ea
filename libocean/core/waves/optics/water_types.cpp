// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The table of Jerlov's water types, and the properties derived from its two coefficients.
//
// Jerlov classified waters by the attenuation of daylight, K_d. Absorption and scattering of the
// types are later work:
// - IB to 5C: measured, [Williamson and Hollins 2022], their table at 1 nm, read at 610, 550, 465.
// - I, IA, 7C and 9C, which they lack: from K_d by a bio-optical model, [Solonenko and Mobley 2015]
//   tables 4 to 8, a value each 25 nm. b is interpolated linearly; a likewise after subtracting
//   that of pure water [Pope and Fry 1997], which is far from linear near 600 nm, and then added
//   again.
// Both tables as transcribed, their defects marked, by github.com/tishibashi-cpu/jerlov.
// Rejected: [Solonenko and Mobley 2015] for the other types. Their b of II and III is 2.5 and 4
// times the measured one, which would make those seas far too bright, and their rows of 5C from 600
// nm on repeat those from 300 nm: a renderer with a red absorption of 4.6 1/m probably uses these.
//
// Checked by WaterTypes.AttenuateDaylightAsJerlovMeasured against K_d of [Jerlov 1976].
#include "ocean/internal/water_types.hpp"

#include <algorithm>
#include <cmath>

#include "ocean/error.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/nearest_name.hpp"

namespace ocean {

namespace {

constexpr WaterType kTypes[] = {
    {"jerlov_i",
     "Jerlov I",
     "The clearest ocean: deep blue.",
     {0.272, 0.0620, 0.0182},
     {0.00115, 0.00170, 0.00336}},
    {"jerlov_ia",
     "Jerlov IA",
     "Very clear ocean.",
     {0.272, 0.0622, 0.0214},
     {0.00272, 0.00354, 0.00574}},
    {"jerlov_ib",
     "Jerlov IB",
     "Clear ocean, of warm seas.",
     {0.273, 0.0655, 0.0383},
     {0.117, 0.122, 0.132}},
    {"jerlov_ii",
     "Jerlov II",
     "Ocean with some plankton: blue.",
     {0.277, 0.0724, 0.0572},
     {0.168, 0.177, 0.192}},
    {"jerlov_iii",
     "Jerlov III",
     "Ocean rich in plankton: blue-green.",
     {0.287, 0.0878, 0.101},
     {0.277, 0.287, 0.305}},
    {"jerlov_1c",
     "Jerlov 1C",
     "Clear coastal water: green-blue.",
     {0.294, 0.0988, 0.131},
     {0.413, 0.427, 0.451}},
    {"jerlov_3c",
     "Jerlov 3C",
     "Coastal water: green.",
     {0.314, 0.128, 0.180},
     {0.624, 0.644, 0.679}},
    {"jerlov_5c",
     "Jerlov 5C",
     "Turbid coastal water: green.",
     {0.333, 0.159, 0.270},
     {1.16, 1.19, 1.26}},
    {"jerlov_7c",
     "Jerlov 7C",
     "Very turbid coastal water: yellow-green.",
     {0.345, 0.195, 0.449},
     {1.97, 2.35, 3.13}},
    {"jerlov_9c",
     "Jerlov 9C",
     "Harbours and estuaries: olive.",
     {0.426, 0.348, 0.802},
     {2.62, 3.12, 4.16}},
};

template <typename Function>
Rgb each_channel(const Function& function) {
    return {function(std::size_t{0}), function(std::size_t{1}), function(std::size_t{2})};
}

}  // namespace

std::span<const WaterType> water_types() {
    return kTypes;
}

const WaterType& water_type(std::string_view name) {
    const auto found = std::ranges::find(kTypes, name, &WaterType::name);
    if (found != std::ranges::end(kTypes)) return *found;
    throw Error(ErrorKind::invalid_value, "unknown type of water '" + std::string(name) + "'" +
                                              did_you_mean(name, kTypes, &WaterType::name));
}

Rgb WaterType::backscattering() const {
    return each_channel([this](std::size_t c) {
        const double of_water = 0.005826 * std::pow(400.0 / kRgbWavelengths[c], 4.322);
        return 0.5 * of_water + kParticleBackscatter * std::max(0.0, scattering[c] - of_water);
    });
}

Rgb WaterType::irradiance_reflectance() const {
    const Rgb back = backscattering();
    return each_channel([&](std::size_t c) { return 0.33 * back[c] / absorption[c]; });
}

Rgb WaterType::water_leaving_albedo() const {
    const Rgb below = irradiance_reflectance();
    return each_channel([&](std::size_t c) { return 0.55 * below[c] / (1.0 - 0.48 * below[c]); });
}

Rgb WaterType::crest_colour() const {
    constexpr double kWay = 8.0;       // m
    constexpr double kBubbles = 0.15;  // 1/m
    return each_channel([&](std::size_t c) {
        const double scattered = 1.0 - std::exp(-kWay * (scattering[c] + kBubbles));
        return 0.55 * scattered * std::exp(-kWay * absorption[c]);
    });
}

std::string water_types_json() {
    const auto number = [](double value) { return Json(value, plain_text); };
    const auto rgb = [&](const Rgb& value) { return json_array(value, number); };
    JsonArray table(JsonLines{2});
    for (const WaterType& type : kTypes) {
        JsonObject row;
        row.add("name", type.name).add("label", type.label).add("help", type.help);
        row.add("absorption", rgb(type.absorption)).add("scattering", rgb(type.scattering));
        row.add("albedo", rgb(type.water_leaving_albedo()));
        row.add("crest", rgb(type.crest_colour()));
        row.add("ior", number(kWaterIor)).add("anisotropy", number(kScatteringAnisotropy));
        table.add(row.add("foam_albedo", number(kFoamAlbedo)));
    }
    return table.text() + "\n";
}

}  // namespace ocean
