// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What sea water does to light: Jerlov's ten optical types, from the clearest ocean to murky
// coasts. Renderers take their materials from here; nothing of the waves depends on it.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace ocean {

/// Red, green and blue of linear Rec. 709.
using Rgb = std::array<double, 3>;

/// Wavelengths that stand for the three, nm: the primaries' dominant ones (611, 549, 464) rounded.
inline constexpr Rgb kRgbWavelengths = {610.0, 550.0, 465.0};
/// Of sea water, in the visible.
inline constexpr double kWaterIor = 1.333;
/// Part of the light that hydrosols scatter backwards, and the mean cosine of the angle by which
/// they scatter: the average particle of Petzold's measurements [Mobley 1994] ch. 3.
inline constexpr double kParticleBackscatter = 0.0183;
inline constexpr double kScatteringAnisotropy = 0.924;
/// Reflectance of a fresh, thick layer of foam in the visible [Whitlock 1982]; [Koepke 1984] takes
/// it for new whitecaps and 0.22 for the mean over their life, in which they thin out.
inline constexpr double kFoamAlbedo = 0.55;

struct WaterType {
    std::string_view name;  // "jerlov_ii"
    std::string_view label;
    std::string_view help;
    Rgb absorption;  // a, 1/m
    Rgb scattering;  // b, 1/m, that of the water itself included

    /// b_b, 1/m: half of what the water itself scatters and kParticleBackscatter of the rest. The
    /// water's own is b_w = 0.005826 (400 nm / lambda)^4.322 [Haltrin 1999] eq. 5.
    Rgb backscattering() const;
    /// Upward over downward irradiance just below the surface of deep water: R = 0.33 b_b / a
    /// [Gordon 1975], [Morel and Prieur 1977], for b_b << a. At most 0.08 here.
    Rgb irradiance_reflectance() const;
    /// Albedo of the water body below its surface: a viewer above gets this times 1 - F, F
    /// Fresnel's reflectance of his direction. 0.55 R / (1 - 0.48 R): 0.55 = (1 - 0.021) / n^2 is
    /// what enters the water, spread by refraction as it leaves [Mobley 1999]; 0.48 of the diffuse
    /// light from below is thrown back down [Gordon 1988].
    Rgb water_leaving_albedo() const;
    /// Of the sun's light behind a crest, what comes through it, where wave/crest_light.glsl is 1:
    /// 0.55 (1 - exp(-(b + 0.15) l)) exp(-a l), scattered and absorbed on a way of l = 8 m, with
    /// bubbles that scatter 0.15 / m. These three numbers are chosen by eye, for Jerlov's II.
    Rgb crest_colour() const;
};

/// Clearest first: neither absorption nor scattering falls from one to the next.
std::span<const WaterType> water_types();
/// Of that name. Throws Error invalid_value.
const WaterType& water_type(std::string_view name);

/// The table as JSON, an array of objects: name, label, help, ior, absorption, scattering,
/// anisotropy (the mean cosine), albedo (of the water body), crest (colour of crests with the sun
/// behind them), foam_albedo.
std::string water_types_json();

}  // namespace ocean
