// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Seas by name: the Beaufort and Douglas scales, and the two programs that this project continues.
// A preset is a few numbers; its sea file is written from them, with the same loop as any other.
#include <array>
#include <vector>

#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "preset_text.hpp"

namespace ocean {
namespace {

/// WMO Manual on Codes, table 1100. The wind is the mean of the force; with this fetch JONSWAP
/// gives the probable wave height of the open sea. Forces 1 to 3 raise less, even fully developed
/// [Pierson and Moskowitz 1964]: the height and period of their open sea are given, and the fetch
/// is that of full development or the min of its range. The patch is about 8 peak wavelengths.
struct Beaufort {
    std::string_view name;
    double wind_speed;         // m/s
    double wave_height;        // m
    double fetch;              // m
    double patch_size;         // m
    double peak_period = 0.0;  // s; 0 where height and period follow from wind and fetch
};
constexpr std::array<Beaufort, 13> kBeaufort = {{
    {"calm", 0.0, 0.0, 300e3, 100.0},
    {"light air", 0.8, 0.1, 1e3, 35.0, 1.66},
    {"light breeze", 2.4, 0.2, 7e3, 52.0, 2.03},
    {"gentle breeze", 4.3, 0.6, 22e3, 150.0, 3.46},
    {"moderate breeze", 6.7, 1.0, 54e3, 230.0},
    {"fresh breeze", 9.3, 2.0, 110e3, 460.0},
    {"strong breeze", 12.3, 3.0, 150e3, 690.0},
    {"near gale", 15.5, 4.0, 170e3, 870.0},
    {"gale", 18.9, 5.5, 220e3, 1200.0},
    {"strong gale", 22.6, 7.0, 250e3, 1500.0},
    {"storm", 26.4, 9.0, 310e3, 1900.0},
    {"violent storm", 30.5, 11.5, 380e3, 2400.0},
    {"hurricane", 34.8, 14.0, 440e3, 2800.0},
}};

/// WMO Manual on Codes, table 3700: the state of the sea by its significant wave height, here the
/// middle of each degree. Peak periods are those of a wind sea of steepness 0.036 (height over peak
/// wavelength), wind and fetch those with which JONSWAP has this height and period by itself.
struct Douglas {
    std::string_view name;
    double wave_height;  // m
    double peak_period;  // s
    double wind_speed;   // m/s
    double fetch;        // m
    double patch_size;   // m
};
constexpr std::array<Douglas, 10> kDouglas = {{
    {"calm (glassy)", 0.0, 0.0, 0.0, 300e3, 100.0},
    {"calm (rippled)", 0.05, 0.94, 1.7, 2300.0, 11.0},
    {"smooth (wavelets)", 0.3, 2.3, 4.1, 14e3, 65.0},
    {"slight", 0.875, 3.9, 6.9, 40e3, 190.0},
    {"moderate", 1.875, 5.8, 10.0, 86e3, 420.0},
    {"rough", 3.25, 7.6, 13.5, 150e3, 720.0},
    {"very rough", 5.0, 9.4, 16.5, 230e3, 1100.0},
    {"high", 7.5, 11.6, 20.5, 340e3, 1700.0},
    {"very high", 11.5, 14.3, 25.0, 530e3, 2600.0},
    {"phenomenal", 16.0, 16.9, 29.5, 730e3, 3600.0},
}};

/// Returns "3.25" for 3.25, "11" for 11.0.
std::string plain(double value) {
    return to_text(ParameterValue(value));
}

/// Returns whether a preset has the line of a key: one that differs from its default, or that a
/// reader looks for first, the spectrum and the resolution.
bool is_shown(const ParameterRef& ref, const std::string& line) {
    static const Parameters kDefaults;
    return ref.info->holds<&WaveSystem::spectrum>() || ref.info->holds<&Grid::resolution>() ||
           line != parameter_line(kDefaults, {ref.info, 0});
}

/// Makes a preset. `notes` are lines that follow the description as comments.
Preset make_preset(const std::string& name, const std::string& description, std::string_view notes,
                   const Parameters& parameters) {
    return described_preset(name, description, notes,
                            preset_keys(sea_table(), parameters, is_shown));
}

Parameters wind_sea(double wind_speed, double fetch, double patch_size) {
    Parameters parameters;
    parameters.grid.patch_size = patch_size;
    WaveSystem& waves = parameters.waves.front();
    waves.spectrum = SpectrumKind::jonswap;
    waves.wind_speed = wind_speed;
    waves.fetch = fetch;
    waves.spreading = SpreadingKind::hasselmann;
    waves.opposing = 0.0;
    return parameters;
}

void set_waves(Parameters& parameters, double height, double period) {
    parameters.waves.front().significant_wave_height = height;
    parameters.waves.front().peak_period = period;
}

Preset beaufort(std::size_t force) {
    const Beaufort& row = kBeaufort[force];
    const std::string wind = " (" + plain(row.wind_speed) + " m/s), waves of ";
    const std::string description = "Beaufort force " + std::to_string(force) + ", " +
                                    std::string(row.name) + wind + plain(row.wave_height) + " m";
    constexpr std::string_view kNotes =
        "Mean wind of the force at 10 m and probable wave height of the open sea: WMO code table\n"
        "1100. The height is not set: it follows from wind and fetch by JONSWAP, and the fetch is\n"
        "the one that gives it. The patch holds about 8 of the most energetic waves.";
    constexpr std::string_view kSetNotes =
        "Mean wind of the force at 10 m and probable wave height of the open sea: WMO code table\n"
        "1100. Height and period are set: a fully developed sea of so little wind is lower, and\n"
        "the open sea has waves of other winds too. The fetch is about that of full development.\n"
        "The patch holds about 8 of the most energetic waves.";
    Parameters parameters = wind_sea(row.wind_speed, row.fetch, row.patch_size);
    const bool is_set = row.peak_period > 0.0;
    if (is_set) set_waves(parameters, row.wave_height, row.peak_period);
    return make_preset("beaufort_" + std::to_string(force), description,
                       is_set ? kSetNotes : kNotes, parameters);
}

Preset douglas(std::size_t degree) {
    const Douglas& row = kDouglas[degree];
    const std::string description = "Douglas sea state " + std::to_string(degree) + ", " +
                                    std::string(row.name) + ", significant wave height " +
                                    plain(row.wave_height) + " m";
    constexpr std::string_view kNotes =
        "The middle of the degree's range of heights: WMO code table 3700. The period is that of "
        "a\n"
        "wind sea of steepness 0.036, and wind and fetch give about this height and period by\n"
        "themselves. The patch holds about 8 of the most energetic waves.";
    Parameters parameters = wind_sea(row.wind_speed, row.fetch, row.patch_size);
    if (row.wave_height > 0.0) set_waves(parameters, row.wave_height, row.peak_period);
    return make_preset("douglas_" + std::to_string(degree), description, kNotes, parameters);
}

constexpr std::string_view kLantzNotes =
    R"(N = L = 32, loop of 200 s, wind (0, 32), damping 0.001: the parameters of the classic post,
in physics that is corrected where its program went astray:
- h0(-k) is the mirrored entry of the one h0 array. The program asked for -n and -m of a centred
  index, far beyond the Nyquist line, and drew again: a quarter of the variance was left.
- Every mode carries the energy of its cell of the spectrum, dkx dky. Without it heights grow with
  the patch; the program's A = 0.0005 made up for that and has no meaning here. amplitude = 1 is the
  constant that Phillips measured.
- Frequencies are rounded to the loop, not down: long waves keep their speed (they were up to 11 %
  slow), and none stands still.
- Waves travel where the wind blows. With exp(+i w t) they ran against it.
- choppiness = 1 sharpens crests: the program's lambda = -1, with a sign that says what it does.
- Normals are those of the displaced surface; the Nyquist row is zero.
The damping of 0.001 stands for a length, l = 0.001 V^2/g = 0.104 m in exp(-k^2 l^2). Our cut-off is
the wavelength where the energy is down to 1/e, 2 pi l = 0.656 m.
A patch of 32 m holds a small part of what a wind of 32 m/s raises, as `ocean info` warns; for the
whole storm take beaufort_11.)";

constexpr std::string_view kThesisNotes =
    R"(N = 256, L = 1000 m, wind (1, 1) at 40 m/s, A = 4, cut-off 0.5 m: parameters of the thesis,
in physics that is corrected where its program went astray:
- h0(-k) is the mirrored entry of the one h0 array. The program drew both apart: half of the
  variance ended in an imaginary part that nobody saw.
- Every mode carries the energy of its cell of the spectrum, dkx dky, and the inverse transform has
  no factor 1/N^2: heights depend neither on the patch nor on the resolution. A is in units of
  Phillips' constant here; the program's had none.
- Waves travel where the wind blows. With exp(+i w t) they ran against it.
- Short waves are damped at a wavelength that is a length of the water. The program took l = L/2000,
  half a metre of this patch and more of a larger one, in exp(-k^2 l^2). Our cut-off is the
  wavelength where the energy is down to 1/e: cutoff_wavelength = 3.14 (2 pi l) is the same filter.
- Amplitudes are not clamped, noise has no 8-bit steps, the Nyquist row is zero.
The directional factor is the 6th power of the cosine, waves against the wind included.)";

Preset seed_lantz() {
    Parameters parameters;
    parameters.grid.resolution = 32;
    parameters.grid.patch_size = 32.0;
    parameters.time.loop_period = 200.0;
    WaveSystem& waves = parameters.waves.front();
    waves.spectrum = SpectrumKind::phillips;
    waves.wind_speed = 32.0;
    waves.wind_direction = 90.0;
    waves.alignment = 2;
    waves.cutoff_wavelength = 0.656;
    return make_preset("seed_lantz", "the sea of K. Lantz's cOcean, 32 x 32, in corrected physics",
                       kLantzNotes, parameters);
}

Preset seed_thesis() {
    Parameters parameters;
    parameters.grid.resolution = 256;
    parameters.grid.patch_size = 1000.0;
    WaveSystem& waves = parameters.waves.front();
    waves.spectrum = SpectrumKind::phillips;
    waves.wind_speed = 40.0;
    waves.wind_direction = 45.0;
    waves.amplitude = 4.0;
    waves.alignment = 6;
    waves.cutoff_wavelength = 0.5;
    return make_preset("seed_thesis",
                       "the sea of F. Fluegge's thesis of 2017, 256 x 256, in corrected physics",
                       kThesisNotes, parameters);
}

std::vector<Preset> make_presets() {
    std::vector<Preset> presets;
    for (std::size_t force = 0; force < kBeaufort.size(); ++force)
        presets.push_back(beaufort(force));
    for (std::size_t degree = 0; degree < kDouglas.size(); ++degree) {
        presets.push_back(douglas(degree));
    }
    presets.push_back(seed_lantz());
    presets.push_back(seed_thesis());
    return presets;
}

}  // namespace

std::span<const Preset> presets() {
    static const std::vector<Preset> kPresets = make_presets();
    return kPresets;
}

const Preset& find_preset(std::string_view name) {
    return find_preset_in(
        presets(), name, "preset",
        "beaufort_0 .. beaufort_12, douglas_0 .. douglas_9, seed_lantz, seed_thesis");
}

}  // namespace ocean
