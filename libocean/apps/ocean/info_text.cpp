// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See info_text.hpp.
#include "info_text.hpp"

#include <array>
#include <cmath>

#include "any_spectra.hpp"
#include "console.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/crests.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/terrain_base.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

std::string row(const char* label, const std::string& value) {
    return format_text("%-24s%s\n", label, value.c_str());
}

std::string land_values(const std::string& label, const AskedResolved& value, const char* unit,
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

std::string asked_resolved(const char* label, const AskedResolved& value, const char* unit,
                           const char* number = "%.4g") {
    const auto cell = [&](double x) {
        // A direction of -1e-15 is 0, not -0.0.
        return format_text(number, std::abs(x) < 1e-9 ? 0.0 : x) + unit;
    };
    return format_text("%-24s%-16s%s\n", label, cell(value.asked).c_str(),
                       cell(value.resolved).c_str());
}

std::string waves_text(const Parameters& parameters) {
    std::string text;
    for (std::size_t i = 0; i < parameters.waves.size(); ++i) {
        const WaveSystem& waves = parameters.waves[i];
        const std::string prefix = "waves." + std::to_string(i) + ".";
        std::string line = get_parameter(parameters, prefix + "spectrum");
        if (waves.measured) {
            line += ": " + origin_text(*waves.measured);
        } else {
            if (const auto wind = waves.wind_above()) line += format_text(", wind %g m/s", *wind);
            line += format_text(" towards %g deg", waves.direction_degrees());
        }
        text += row(i == 0 ? "Waves" : "", line);
    }
    return text;
}

std::string state_text(const SeaState& state) {
    std::string text = format_text("\n%-24s%-16s%s\n", "", "asked", "resolved by the grid");
    text += asked_resolved("Significant height", state.significant_wave_height, " m");
    if (state.significant_wave_height.asked > 0.0) {
        text += asked_resolved("Peak period", state.peak_period, " s");
        text += asked_resolved("Energy period, Te", state.energy_period, " s");
        text += asked_resolved("Mean period, Tm01", state.mean_period, " s");
        text += asked_resolved("Peak wavelength", state.peak_wavelength, " m");
        text += asked_resolved("Mean square slope", state.mean_square_slope, "");
        text += asked_resolved("Mean direction, to", state.mean_direction, " deg", "%.1f");
        const AskedResolved from{coming_from(state.mean_direction.asked),
                                 coming_from(state.mean_direction.resolved)};
        text += asked_resolved("  nautical, from", from, " deg", "%.1f");
        text += asked_resolved("Directional spread", state.directional_spread, " deg", "%.1f");
    } else {
        text += row("", "flat: no waves");
    }
    return text + row("Energy resolved", format_text("%.2f %%", 100.0 * state.energy_resolved));
}

/// Returns the speed errors of a loop; waves whose speed it hardly changes get no line.
std::string loop_text(const SeaState& state, double period) {
    constexpr double kNotWorthALine = 0.001;
    std::string text = row("Loop", format_text("%g s; waves are %.2f %% off their speed, rms",
                                               period, 100.0 * state.loop_error));
    for (const LoopError& error : state.loop_errors) {
        if (std::abs(error.speed_error) < kNotWorthALine) continue;
        text += row(
            "", format_text("%8.4g m long: %+.1f %%", error.wavelength, 100.0 * error.speed_error));
    }
    return text;
}

std::string cascades_text(const SeaState& state) {
    std::string text = format_text("%-24s%-16s%-24s%s\n", "Cascades repeat every", "",
                                   "share of the height", "of the slope");
    for (const CascadeShare& share : state.cascades) {
        text += format_text("%-24s%-16s%-24s%s\n", "", format_text("%.4g m", share.period).c_str(),
                            format_text("%.1f %%", 100.0 * share.height).c_str(),
                            format_text("%.1f %%", 100.0 * share.slope).c_str());
    }
    return text;
}

std::string foam_text(const SeaState& state, const SurfaceSettings& surface,
                      const FrameCost& cost) {
    std::string text = "\n";
    if (state.whitecap_coverage.resolved > 0.0) {
        text += row("Whitecaps",
                    format_text("%.2f %% of the sea, where its area shrinks below %.3f",
                                100.0 * state.whitecap_coverage.resolved, state.foam_threshold));
    } else {
        text += row("Whitecaps", "none");
    }
    if (surface.foam_coverage == FoamCoverage::monahan && state.whitecap_coverage.asked > 0.0) {
        text += row("", format_text("this wind makes %.2f %% white",
                                    100.0 * state.whitecap_coverage.asked));
    }
    text += row("Folded over", format_text("%.2f %% of the surface", 100.0 * state.folded_share));
    text += row("Foam", format_text("lives %g s; is followed for %g s before a frame alone",
                                    surface.foam_lifetime, state.foam_preroll_seconds));
    if (cost.alone == 0.0) return text;
    return text + row("A frame with foam",
                      format_text("takes about %.2g s alone, %.2g s after the one before it",
                                  cost.alone, cost.in_sequence));
}

std::string bed_text(const SeaBedSummary& bed, const Water& water) {
    const auto [x, y] = water.bed_origin();
    std::string text = row("Sea bed", format_text("%d x %d samples %.4g m apart, from (%g, %g) m",
                                                  bed.samples[0], bed.samples[1], bed.cell, x, y));
    text += row("", format_text("%.4g to %.4g m over still water", bed.lowest, bed.highest));
    text += row("", format_text("%.1f %% is wet, %.1f %% shallower than the sea", 100.0 * bed.wet,
                                100.0 * bed.shallow));
    return text + row("", "SHA-256 " + bed.sha256);
}

std::string grid_text(const SeaState& state, const Parameters& parameters) {
    const Grid& grid = parameters.grid;
    std::string text = "\n";
    text += row("Period",
                format_text("%g m, %d x %d samples %.4g m apart", state.period, grid.resolution,
                            grid.resolution, state.period / grid.resolution));
    text += row("Waves held",
                format_text("%.4g .. %.4g m long", state.shortest_wave, state.longest_wave));
    if (state.cascades.size() > 1) text += cascades_text(state);
    text += row("Map", format_text("%d x %d samples hold waves of %.4g m", state.map_resolution,
                                   state.map_resolution, state.map_shortest_wave));
    text += row("Depth", std::isinf(parameters.water.depth)
                             ? std::string("deep")
                             : format_text("%g m", parameters.water.depth));
    if (state.bed) text += bed_text(*state.bed, parameters.water);
    const Timing& time = parameters.time;
    text += row("Time", format_text("%g s at frame %d, %g frames per second", time.start,
                                    time.first_frame, time.fps));
    if (time.loop_period > 0.0) text += loop_text(state, time.loop_period);
    text += row("Memory", bytes_text(state.memory_bytes));
    return text;
}

std::string second_order_text(const SecondOrderSummary& summary) {
    std::string text = row("Skewness", format_text("%.3f; %.3f by theory, 0 without second_order",
                                                   summary.skewness, summary.skewness_of_theory));
    return text + row("", format_text("waves longer than %.4g m bind others; k_p Hs / 2 is %.3f",
                                      summary.shortest_binding_wave, summary.steepness));
}

std::string crests_text(const SeaState& state) {
    std::string text;
    for (const CrestSummary& crest : state.crests) {
        text += row(crest.height > 0.0 ? "Crest" : "Trough",
                    format_text("%.4g m, %.3g Hs, at (%g, %g) m and %g s", std::abs(crest.height),
                                std::abs(crest.relative_height), crest.x, crest.y, crest.time));
        std::string rarity = format_text("one in %.2g (Rayleigh)", crest.one_in_rayleigh);
        if (crest.height > 0.0) {
            rarity =
                format_text("one crest in %.2g (Forristall), ", crest.one_in_forristall) + rarity;
        }
        text += row("", rarity + format_text("; steepness %.2f", crest.steepness));
    }
    if (state.crests.empty()) return text;
    return text + row("", format_text("the patch's variance is %.3f of that without crests",
                                      state.crest_variance));
}

std::string hulls_text(const SeaState& state, const Parameters& parameters) {
    std::string text;
    for (std::size_t i = 0; i < state.hulls.size(); ++i) {
        const Hull& hull = parameters.hulls[i];
        const HullSummary& of = state.hulls[i];
        text += row("Hull", format_text("%g x %g x %g m, %.4g m3, up to %.3g m/s (Froude number "
                                        "%.2f), from %g to %g s",
                                        hull.length, hull.beam, hull.draught, of.volume, of.speed,
                                        of.froude_number, of.begin, of.end));
        text += row("", format_text("waves of %.3g m, %.2f m high one length beside it; wake in "
                                    "%.4g m, samples %.3g m apart",
                                    of.wavelength, of.wave_height, of.wake_size, of.wake_cell));
    }
    return text;
}

std::string take_text(const Sea& sea) {
    if (sea.take.empty()) return "";
    const std::vector<TakeEvent>& events = sea.take.events;
    return row("Take",
               format_text("%zu change%s from %g to %g s, each gliding for %g s", events.size(),
                           events.size() == 1 ? "" : "s", events.front().seconds,
                           events.back().seconds, sea.parameters.time.glide)) +
           row("", "numbers here are those of the start");
}

struct Rarity {
    double relative_height = 0.0;  // in units of Hs
    double one_in = 0.0;           // one crest in so many is as high
};

Rarity rarity_of(double height, const SeaState& state) {
    const double hs = state.significant_wave_height.asked;
    return {height / hs, 1.0 / rayleigh_exceedance(height, hs)};
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
    text += land_values("RMS height", state.rms, " m");
    text += land_values("RMS slope", state.rms_slope, "");
    constexpr const char* kShares[] = {"Slopes, 50 % up to", "        90 %", "        99 %"};
    for (std::size_t i = 0; i < state.slope_angles.size(); ++i) {
        text += land_values(kShares[i], state.slope_angles[i], " deg", "%.1f");
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

std::string info_text(const Sea& sea, const std::string& source, const SeaState& state,
                      const FrameCost& cost) {
    return row("Sea", source) + waves_text(sea.parameters) + state_text(state) +
           grid_text(state, sea.parameters) + take_text(sea) + crests_text(state) +
           hulls_text(state, sea.parameters) +
           (state.second_order ? second_order_text(*state.second_order) : "") +
           foam_text(state, sea.parameters.surface, cost);
}

std::string found_crest_text(const FoundCrestText& found) {
    const auto& [crest, frame, window, state] = found;
    const Rarity rarity = rarity_of(crest.height, state);
    std::string text =
        row("Highest crest", format_text("%.4g m, %.3g Hs, at (%.1f, %.1f) m", crest.height,
                                         rarity.relative_height, crest.x, crest.y));
    text += row("", format_text("at %.2f s, frame %.1f", crest.time, frame));
    text += row("", format_text("one crest in %.2g (Rayleigh)", rarity.one_in));
    const std::array<double, 4> all = {0.0, 0.0, state.period, state.period};
    const auto [west, south, east, north] = window.place.value_or(all);
    return text + row("Searched", format_text("%g to %g s, from (%g, %g) to (%g, %g) m",
                                              window.from, window.to, west, south, east, north));
}

std::string found_crest_json(const FoundCrestText& found) {
    const Rarity rarity = rarity_of(found.crest.height, found.state);
    JsonObject json;
    json.add("time", found.crest.time).add("frame", found.frame);
    json.add("x", found.crest.x).add("y", found.crest.y).add("height", found.crest.height);
    json.add("relative_height", rarity.relative_height).add("one_in_rayleigh", rarity.one_in);
    return json.text() + "\n";
}

}  // namespace ocean::app
