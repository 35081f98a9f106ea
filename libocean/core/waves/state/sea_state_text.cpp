// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The state of a sea as sentences and as JSON.
#include "waves/state/sea_state_text.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/spreading.hpp"
#include "waves/modes/mode_lattice.hpp"

namespace ocean {

namespace {

Json asked_resolved(const AskedResolved& value) {
    return JsonObject().add("asked", value.asked).add("resolved", value.resolved);
}

Json slope_json(const MapSlope& map) {
    return JsonObject()
        .add("resolution", map.resolution)
        .add("mean_square_slope", map.mean_square_slope);
}

Json cascade_json(const CascadeShare& share) {
    return JsonObject()
        .add("period", share.period)
        .add("shortest_wave", share.shortest_wave)
        .add("longest_wave", share.longest_wave)
        .add("height_share", share.height)
        .add("slope_share", share.slope);
}

Json loop_error_json(const LoopError& error) {
    return JsonObject().add("wavelength", error.wavelength).add("speed_error", error.speed_error);
}

Json crest_json(const CrestSummary& crest) {
    JsonObject object;
    object.add("time", crest.time).add("x", crest.x).add("y", crest.y);
    object.add("height", crest.height).add("relative_height", crest.relative_height);
    object.add("one_in_rayleigh", crest.one_in_rayleigh);
    if (crest.height > 0.0) object.add("one_in_forristall", crest.one_in_forristall);
    return object.add("steepness", crest.steepness);
}

Json hull_json(const HullSummary& hull) {
    return JsonObject()
        .add("begin", hull.begin)
        .add("end", hull.end)
        .add("speed", hull.speed)
        .add("froude_number", hull.froude_number)
        .add("volume", hull.volume)
        .add("wavelength", hull.wavelength)
        .add("wave_height", hull.wave_height)
        .add("steepness", hull.steepness)
        .add("wake_size", hull.wake_size)
        .add("wake_cell", hull.wake_cell);
}

Json bed_json(const SeaBedSummary& bed) {
    return JsonObject()
        .add("samples", json_array(bed.samples))
        .add("cell", bed.cell)
        .add("lowest", bed.lowest)
        .add("highest", bed.highest)
        .add("mean", bed.mean)
        .add("wet_share", bed.wet)
        .add("shallow_share", bed.shallow)
        .add("sha256", bed.sha256);
}

Json second_order_json(const SecondOrderSummary& summary) {
    return JsonObject()
        .add("skewness", summary.skewness)
        .add("skewness_of_theory", summary.skewness_of_theory)
        .add("shortest_binding_wave", summary.shortest_binding_wave)
        .add("steepness", summary.steepness);
}

/// Hs over depth of a surf zone that breaks all the way: Hrms = 0.42 d [Thornton and Guza 1982],
/// Hs = sqrt(2) Hrms.
constexpr double kSaturated = 0.6;
/// Folded share above which a warning is due: the share that whitecaps cover in a wind of 10 m/s.
/// Presets up to Beaufort 12 fold 3e-11 of their surface with a choppiness of 1.5, the end of its
/// soft range, 2e-5 with 2 and three cascades, and 1.4 % with 4, the end of the hard range.
constexpr double kMuchFolded = 0.01;

/// A warning is due from this many degrees of spread on.
constexpr double kNarrowed = 0.5;

/// Returns the circular spread of a record's moments [degrees], weighted by energy: as measured,
/// and in the record's sea, whose distributions are limited by kLargestExponent and kLargestMoment.
AskedResolved spread_of_moments(const SpectrumRecord& record) {
    std::complex<double> asked = 0.0;
    std::complex<double> held = 0.0;
    double energy = 0.0;
    for (std::size_t i = 0; i < record.a1.size(); ++i) {
        const std::complex<double> c1(record.a1[i], record.b1[i]);
        const std::size_t below = i > 0 ? i - 1 : i;
        const std::size_t above = std::min(i + 1, record.a1.size() - 1);
        const double weight =
            record.density[i] * (record.frequency[above] - record.frequency[below]);
        if (std::isnan(c1.real()) || !(weight > 0.0)) continue;
        const double most =
            std::isnan(record.a2[i]) ? kLargestExponent / (1.0 + kLargestExponent) : kLargestMoment;
        energy += weight;
        asked += weight * c1;
        held += weight * c1 * std::min(1.0, most / std::max(std::abs(c1), most));
    }
    if (!(energy > 0.0)) return {};
    constexpr double kDegrees = 180.0 / kPi;
    return {circular_spread(std::abs(asked) / energy) * kDegrees,
            circular_spread(std::abs(held) / energy) * kDegrees};
}

/// Adds a warning for keys of a measured spectrum in a system of another spectrum.
void warn_of_unread(const WaveSystem& system, const std::string& name, SeaState& state) {
    const auto warn = [&](const char* key, const std::string& value) {
        if (value.empty()) return;
        state.warnings.push_back(name + key +
                                 " has no effect: spectrum = \"measured\" alone reads it");
    };
    warn(".file", system.file);
    warn(".record", system.record);
    warn(".place", system.place);
}

/// Adds the assumptions of the readers of the sea's measured records, and the data missing in them.
void add_record_warnings(const Parameters& parameters, SeaState& state) {
    for (std::size_t i = 0; i < parameters.waves.size(); ++i) {
        const WaveSystem& system = parameters.waves[i];
        const std::string name = "waves." + std::to_string(i);
        if (system.spectrum != SpectrumKind::measured) {
            warn_of_unread(system, name, state);
            continue;
        }
        if (system.measured == nullptr) continue;
        for (const std::string& warning : system.measured->warnings) {
            state.warnings.push_back(name + ".file: " + warning);
        }
        const AskedResolved spread = spread_of_moments(*system.measured);
        if (spread.resolved - spread.asked > kNarrowed) {
            state.warnings.push_back(
                name + ".file has a directional spread of " + fixed_text(spread.asked, 1) +
                " degrees, narrower than any sea: " + fixed_text(spread.resolved, 1) + " is used");
        }
        if (system.measured->has_directions() || system.wind_direction) continue;
        state.warnings.push_back(name + ".file has no directions: the waves travel to " + name +
                                 ".wind_direction = " + fixed_text(system.direction_degrees(), 0) +
                                 ", to the east, spread as " + name + ".spreading says");
    }
}

}  // namespace

void add_warnings(const Parameters& parameters, bool flat, SeaState& state) {
    const auto warn = [&state](std::string text) { state.warnings.push_back(std::move(text)); };
    add_record_warnings(parameters, state);
    for (std::string& text : hull_warnings(parameters)) warn(std::move(text));
    if (parameters.water.bed != nullptr) {
        for (std::string& text : bed_warnings(*parameters.water.bed, parameters.water)) {
            warn(std::move(text));
        }
    }
    if (flat) {
        warn("the sea is flat: no wave system has any energy (wind_speed = 0?)");
        return;
    }
    if (parameters.water.bed != nullptr) {
        for (std::string& text :
             coast_warnings(*parameters.water.bed, incoming_waves(parameters))) {
            warn(std::move(text));
        }
    }
    if (state.energy_resolved < 0.95) {
        warn("this grid holds " + fixed_text(100.0 * state.energy_resolved, 1) +
             " % of the energy asked for; its waves are " + fixed_text(state.shortest_wave, 2) +
             " to " + fixed_text(state.longest_wave, 0) +
             " m long, the peak of the spectrum is at " +
             fixed_text(state.peak_wavelength.asked, 1) +
             " m: change grid.patch_size or grid.resolution");
    }
    if (state.energy_resolved > 1.02) {
        warn("the spectrum is narrower than the grid's modes lie apart: heights are " +
             fixed_text(100.0 * state.energy_resolved, 1) +
             " % of the energy asked for; make grid.patch_size larger");
    }
    const double height = state.significant_wave_height.asked;
    if (height > kSaturated * parameters.water.depth) {
        warn("waves of " + fixed_text(height, 2) +
             " m in water.depth = " + fixed_text(parameters.water.depth, 2) +
             " m: a real sea has broken before its significant height is 0.6 of the depth; allow "
             "more depth, less height, or take spectrum = \"tma\"");
    }
    for (std::string& text : full_development_warnings(parameters)) warn(std::move(text));
    if (state.loop_error > 0.05) {
        warn("time.loop_period = " + fixed_text(parameters.time.loop_period, 1) +
             " s moves the waves " + fixed_text(100.0 * state.loop_error, 1) +
             " % off their speed; a longer loop does less");
    }
    for (std::size_t c = 1; c < state.cascades.size(); ++c) {
        const CascadeShare& share = state.cascades[c];
        if (std::max(share.height, share.slope) <= 0.5) continue;
        warn(fixed_text(100.0 * share.height, 0) + " % of the variance of the height and " +
             fixed_text(100.0 * share.slope, 0) + " % of that of the slope repeat every " +
             fixed_text(share.period, 1) +
             " m, not only at grid.patch_size: choose smaller grid.cascade_divisors, fewer "
             "cascades or more grid.resolution");
    }
    if (parameters.surface.foam_coverage == FoamCoverage::monahan && !strongest_wind(parameters)) {
        warn(
            "the wind is unknown: heights and periods are measured or given, but no wind_speed. "
            "The sea has no whitecaps; set wind_speed of a wave system to have them");
    }
    if (parameters.grid.patch_size < 3.0 * state.peak_wavelength.asked) {
        warn("fewer than three of the dominant waves (" +
             fixed_text(state.peak_wavelength.asked, 1) + " m) fit into grid.patch_size = " +
             fixed_text(parameters.grid.patch_size, 1) + " m: the repetition will show");
    }
}

void add_folding_warning(const SurfaceSettings& surface, SeaState& state) {
    if (state.folded_share <= kMuchFolded) return;
    state.warnings.push_back(
        "crests have folded over on " + fixed_text(100.0 * state.folded_share, 1) +
        " % of the surface, where it passes through itself: make surface.choppiness = " +
        fixed_text(surface.choppiness, 2) + " smaller, the waves lower or the water deeper");
}

std::string sea_state_json(const SeaState& state) {
    JsonObject json(JsonLines{2});
    json.add("significant_wave_height", asked_resolved(state.significant_wave_height));
    json.add("peak_period", asked_resolved(state.peak_period));
    json.add("energy_period", asked_resolved(state.energy_period));
    json.add("mean_period", asked_resolved(state.mean_period));
    json.add("peak_wavelength", asked_resolved(state.peak_wavelength));
    json.add("mean_square_slope", asked_resolved(state.mean_square_slope));
    json.add("mean_direction", asked_resolved(state.mean_direction));
    json.add("directional_spread", asked_resolved(state.directional_spread));
    json.add("energy_resolved", state.energy_resolved);
    json.add("shortest_wave", state.shortest_wave);
    json.add("longest_wave", state.longest_wave);
    json.add("period", state.period);
    json.add("map_resolution", state.map_resolution);
    json.add("map_shortest_wave", state.map_shortest_wave);
    json.add("map_slopes", json_array(state.map_slopes, slope_json));
    json.add("cascades", json_array(state.cascades, cascade_json));
    json.add("memory_bytes", state.memory_bytes);
    json.add("foam_preroll_seconds", state.foam_preroll_seconds);
    json.add("whitecap_coverage", asked_resolved(state.whitecap_coverage));
    json.add("foam_threshold", state.foam_threshold);
    json.add("folded_share", state.folded_share);
    json.add("loop_error", state.loop_error);
    json.add("loop_errors", json_array(state.loop_errors, loop_error_json));
    if (state.bed) json.add("bed", bed_json(*state.bed));
    if (!state.crests.empty()) {
        json.add("crests", json_array(state.crests, crest_json));
        json.add("crest_variance", state.crest_variance);
    }
    if (!state.hulls.empty()) json.add("hulls", json_array(state.hulls, hull_json));
    if (state.second_order) json.add("second_order", second_order_json(*state.second_order));
    json.add("warnings", json_array(state.warnings));
    return json.text() + "\n";
}

}  // namespace ocean
