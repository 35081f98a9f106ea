// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Names of directional quantities: see bin_names.hpp.
#include "bin_names.hpp"

#include <array>
#include <string_view>

#include "names.hpp"

namespace ocean::netcdf {
namespace {

/// The plain names of each quantity, separated by blanks.
constexpr std::array<std::string_view, kBinQuantities> kNames = {{
    " a1 wavea1 wavea1value a1value ",
    " b1 waveb1 waveb1value b1value ",
    " a2 wavea2 wavea2value a2value ",
    " b2 waveb2 waveb2value b2value ",
    " meanwavedir meanwavedirection alpha1 wavealpha1 swdir swdir1 wavemeandirection meandirection "
    "meandir th1m th1 theta1 theta1d dir1 mwd dm mdir vmdr direction dir wavedirection wavedir ",
    " principalwavedir principalwavedirection alpha2 wavealpha2 swdir2 waveprincipaldirection "
    "principaldirection principaldir th2m th2 theta2 dir2 ",
    " wavespectrumr1 r1 waver1 swr1 ",
    " wavespectrumr2 r2 waver2 swr2 ",
    " sth1m sth1 stheta1 spread1 spread1d spread wavespread directionalspread "
    "directionalspreading dirspread meandirectionalspread wavespreading dspr sprd ",
    " sth2m sth2 stheta2 spread2 principaldirectionalspread ",
}};

bool lists(std::string_view names, const std::string& name) {
    return names.find(" " + name + " ") != std::string_view::npos;
}

}  // namespace

int bin_rank(BinQuantity quantity, const std::string& name, const std::string& standard_name) {
    if (lists(kNames[quantity], plain_name(name))) return 2;
    for (const std::string_view names : kNames) {
        if (lists(names, plain_name(name))) return 0;
    }
    const bool standard =
        (quantity == kMean && among(standard_name, {"sea_surface_wave_from_direction",
                                                    "sea_surface_wave_to_direction"})) ||
        (quantity == kSpread && standard_name == "sea_surface_wave_directional_spread");
    return standard ? 1 : 0;
}

bool is_known_to_come_from(const std::string& name) {
    return lists(
        " meanwavedir alpha1 wavealpha1 swdir swdir1 wavemeandirection th1m theta1 mwd vmdr "
        "principalwavedir alpha2 wavealpha2 swdir2 th2m theta2 ",
        plain_name(name));
}

}  // namespace ocean::netcdf
