// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Optical properties of sea water: Jerlov's ten types, from the clearest ocean to murky coasts.
// Renderers derive their materials from them; the waves do not depend on them.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace ocean {

/// Red, green and blue of linear Rec. 709.
using Rgb = std::array<double, 3>;

/// The wavelengths of red, green and blue [nm]: their dominant ones (611, 549, 464) rounded.
inline constexpr Rgb kRgbWavelengths = {610.0, 550.0, 465.0};
/// Index of refraction of sea water, in visible light.
inline constexpr double kWaterIor = 1.333;
/// Share of the light that hydrosols scatter backwards, and the mean cosine of their scattering
/// angle: the average particle of Petzold's measurements [Mobley 1994] ch. 3.
inline constexpr double kParticleBackscatter = 0.0183;
inline constexpr double kScatteringAnisotropy = 0.924;
/// Reflectance of a fresh, thick layer of foam in visible light [Whitlock 1982]; [Koepke 1984] uses
/// it for new whitecaps, and 0.22 for the mean over their life, during which they thin out.
inline constexpr double kFoamAlbedo = 0.55;

struct WaterType {
    std::string_view name;  // "jerlov_ii"
    std::string_view label;
    std::string_view help;
    Rgb absorption;  // a [1/m]
    Rgb scattering;  // b [1/m], the water's own included

    /// Returns b_b [1/m]: half the scattering of the water itself plus kParticleBackscatter of the
    /// rest. The water's own scattering is b_w = 0.005826 (400 nm / lambda)^4.322 [Haltrin 1999]
    /// eq. 5.
    Rgb backscattering() const;
    /// Returns the upward over the downward irradiance just below the surface of deep water: R =
    /// 0.33 b_b / a [Gordon 1975], [Morel and Prieur 1977], for b_b << a. At most 0.08 here.
    Rgb irradiance_reflectance() const;
    /// Returns the albedo of the water body below its surface: a viewer above receives it times 1 -
    /// F, with Fresnel's reflectance F of the viewing direction. 0.55 R / (1 - 0.48 R): 0.55 = (1 -
    /// 0.021) / n^2 is the share that enters the water, spread by refraction as it leaves [Mobley
    /// 1999]; 0.48 of the diffuse light from below is reflected down again [Gordon 1988].
    Rgb water_leaving_albedo() const;
    /// Returns the share of sunlight that a crest transmits towards a viewer on its lit-from-behind
    /// side, where wave/crest_light.glsl is 1: 0.55 (1 - exp(-(b + 0.15) l)) exp(-a l), scattered
    /// and absorbed on a path of l = 8 m with bubbles that scatter 0.15 / m. These three numbers
    /// are chosen by eye, for Jerlov's II.
    Rgb crest_colour() const;
};

/// Returns all types, clearest first: neither absorption nor scattering falls from one to the next.
std::span<const WaterType> water_types();
/// Returns the type of that name. Throws Error invalid_value for an unknown name.
const WaterType& water_type(std::string_view name);

/// Returns the table as a JSON array of objects: name, label, help, ior, absorption, scattering,
/// anisotropy (the mean cosine), albedo (of the water body), crest (colour of crests with the sun
/// behind them), foam_albedo.
std::string water_types_json();

}  // namespace ocean
