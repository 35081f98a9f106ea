// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See terrain_info_text.hpp.
#include "terrain_info_text.hpp"

#include <cmath>

#include "console.hpp"
#include "ocean/internal/measured_rings.hpp"
#include "ocean/internal/terrain_base.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

std::string row(const char* label, const std::string& value) {
    return format_text("%-24s%s\n", label, value.c_str());
}

std::string asked_resolved(const std::string& label, const AskedResolved& value, const char* unit,
                           const char* number = "%.4g") {
    const auto cell = [&](double x) {
        return std::isnan(x) ? std::string("-") : format_text(number, x) + unit;
    };
    return format_text("%-24s%-16s%s\n", label.c_str(), cell(value.asked).c_str(),
                       cell(value.resolved).c_str());
}

std::string law_text(const TerrainModel& terrain) {
    if (terrain.rings != nullptr) {
        return row("Law", format_text("measured, %zu rings: %s", terrain.rings->wavenumber.size(),
                                      terrain.measured.c_str()));
    }
    std::string text =
        row("Beta", format_text("%g (of amplitude; density k^-%g, H = %g, D = %g)", terrain.beta,
                                2.0 * terrain.beta, terrain.beta - 1.0, 4.0 - terrain.beta));
    for (const auto& [wavelength, exponent] : terrain.breaks) {
        text += row("", format_text("%g below %g m", exponent, wavelength));
    }
    return text;
}

/// Returns the lines about the place of a land, its base and what shapes it.
std::string shape_text(const TerrainModel& terrain, const TerrainState& state) {
    std::string text;
    if (terrain.is_placed()) {
        text += row("Placed land", format_text("%.6g x %.6g m, a cell of %.4g m", state.size[0],
                                               state.size[1], state.cell));
    } else {
        text += row("Tile", format_text("%g m, %d samples, a cell of %.4g m", state.period,
                                        terrain.resolution, state.cell));
    }
    if (terrain.base_model != nullptr) {
        const Domain& domain = terrain.base_model->model.domain;
        text += row("Base", format_text("%s, %d x %d samples", terrain.base.c_str(),
                                        domain.samples[0], domain.samples[1]));
    }
    if (terrain.has_gullies()) {
        text += row("Gullies", format_text("%d sizes from %g m", terrain.gullies.octaves,
                                           terrain.gullies.longest));
    }
    if (terrain.has_streams()) {
        text += row("Streams", format_text("slope %g at %g m2, falling with area^%g, age %g",
                                           terrain.stream.slope, terrain.stream.hillslope_area,
                                           terrain.stream.exponent, terrain.stream.age));
    }
    if (terrain.has_coast()) {
        text += row("Shore", format_text("water at %g m, beaches 1 in %.3g",
                                         terrain.coast_level.value_or(0.0),
                                         1.0 / terrain.coast.beach_slope));
    }
    return text;
}

std::string octaves_text(const TerrainState& state) {
    std::string text = format_text("\n%-24s%-16s%-16s%-16s%s\n", "Octave, longest wave",
                                   "rms asked", "resolved", "beta asked", "resolved");
    for (const TerrainOctave& octave : state.octaves) {
        const std::string exponent = std::isnan(octave.exponent.resolved)
                                         ? "-"
                                         : format_text("%.2f", octave.exponent.resolved);
        text += format_text("%-24s%-16s%-16s%-16s%s\n",
                            format_text("%.4g m", octave.longest_wave).c_str(),
                            format_text("%.4g m", octave.rms.asked).c_str(),
                            format_text("%.4g m", octave.rms.resolved).c_str(),
                            format_text("%.2f", octave.exponent.asked).c_str(), exponent.c_str());
    }
    return text;
}

}  // namespace

std::string terrain_info_text(const TerrainModel& terrain, const std::string& name,
                              const TerrainState& state) {
    std::string text = row("Terrain", name);
    text += shape_text(terrain, state);
    for (const TerrainLayer& layer : terrain.layers) {
        text += row("Layer", format_text("repeats every %g m, gain %g", layer.period, layer.gain));
    }
    if (terrain.base_model == nullptr) text += law_text(terrain);
    text += row("Waves", format_text("%.4g to %.4g m", state.shortest_wave, state.longest_wave));
    text += row("Mean height", format_text("%.4g m", state.mean));
    if (state.lowest < state.highest) {
        text += row("Heights", format_text("%.6g to %.6g m", state.lowest, state.highest));
    }
    const std::string measured = state.measured_cell > state.cell
                                     ? format_text("of the land, every %.4g m", state.measured_cell)
                                     : "of the land";
    text += terrain.is_shaped()
                ? format_text("\n%-24s%-16s%s\n", "", "of its waves", measured.c_str())
                : format_text("\n%-24s%-16s%s\n", "", "asked", "in this tile");
    text += asked_resolved("RMS height", state.rms, " m");
    text += asked_resolved("RMS slope", state.rms_slope, "");
    constexpr const char* kShares[] = {"Slopes, 50 % up to", "        90 %", "        99 %"};
    for (std::size_t i = 0; i < state.slope_angles.size(); ++i) {
        text += asked_resolved(kShares[i], state.slope_angles[i], " deg", "%.1f");
    }
    if (state.repeat) {
        const auto peak = [](const RepeatPeak& at) {
            return at.correlation > 0.0 ? format_text("%.2f at %.4g m", at.correlation, at.distance)
                                        : std::string("none");
        };
        text +=
            row("Repeats", format_text("after %g m; highest correlation before that: height %s, "
                                       "slope %s",
                                       terrain.patch_size, peak(state.repeat->height).c_str(),
                                       peak(state.repeat->slope).c_str()));
    }
    if (!state.octaves.empty()) text += octaves_text(state);
    return text + "\n" + row("Memory", bytes_text(state.memory_bytes));
}

}  // namespace ocean::app
