// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See terrain_fit_text.hpp.
#include "terrain_fit_text.hpp"

#include "ocean/internal/json.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

std::string law_text(const TerrainFit& fit) {
    if (fit.parameters.empty()) {
        return "the table of " + std::to_string(fit.rings.size()) + " rings";
    }
    return joined(fit.parameters, ", ", [](const FittedParameter& parameter) {
        return parameter.name + " " + significant<4>(parameter.value) +
               (parameter.is_at_bound ? " (at its bound)" : "");
    });
}

std::string octaves_text(const TerrainFit& fit) {
    std::string text =
        "\nwavelengths             error  scatter of a seed, in log10 of the density\n";
    for (const FittedOctave& octave : fit.octaves) {
        const std::string band =
            length_text(octave.longest_wave) + " .. " + length_text(0.5 * octave.longest_wave);
        text += format_text("%-22s  %5.3f  %5.3f\n", band.c_str(), octave.error, octave.scatter);
    }
    return text +
           "largest error above the first octave: " + fixed_text(fit.error_above_lowest(), 3) +
           "\n";
}

std::string relief_row(const char* name, double bed, double terrain, const char* unit) {
    return format_text("%-12s %10.4g %10.4g  %s\n", name, bed, terrain, unit);
}

JsonObject relief_json(const Relief& relief) {
    return JsonObject()
        .add("rms", relief.rms)
        .add("rms_about_mean", relief.rms_about_mean)
        .add("skewness", relief.skewness)
        .add("slopes", json_array(relief.slopes));
}

}  // namespace

std::string law_name(const TerrainFit& fit) {
    if (fit.terrain.rings != nullptr) return "table";
    return fit.terrain.breaks.empty() ? "one" : "broken";
}

std::string fit_text(const ElevationModel& bed, const TerrainFit& fit) {
    const Domain& domain = bed.domain;
    std::string text = "model    " + std::to_string(domain.samples[0]) + " x " +
                       std::to_string(domain.samples[1]) + " cells, " +
                       length_text(domain.step(0) * domain.samples[0]) + " x " +
                       length_text(domain.step(1) * domain.samples[1]) + "\nterrain  " +
                       std::to_string(fit.terrain.resolution) + " x " +
                       std::to_string(fit.terrain.resolution) + " samples, " +
                       length_text(fit.terrain.patch_size) + ", cell " + length_text(fit.cell) +
                       "\nlaw      " + law_text(fit) + "\n" + octaves_text(fit) +
                       "\n                   model    terrain\n";
    text += relief_row("rms", fit.bed.rms_about_mean, fit.rms, "m, about the mean");
    text += relief_row("rms of parts", fit.bed.rms, fit.model.rms, "m, about the plane");
    for (std::size_t i = 0; i < kReliefShares.size(); ++i) {
        const std::string name = "slope " + significant<3>(100.0 * kReliefShares[i]) + " %";
        text += relief_row(name.c_str(), fit.bed.slopes[i], fit.model.slopes[i],
                           "degrees, of this share of the land at most");
    }
    text += relief_row("skewness", fit.bed.skewness, fit.model.skewness, "of the heights");
    return text + relief_row("anisotropy", fit.bed.anisotropy, fit.model.anisotropy,
                             ("of slopes, steepest along " + significant<3>(fit.bed.direction) +
                              " degrees")
                                 .c_str());
}

std::string fit_json(const ElevationModel& bed, const TerrainFit& fit) {
    JsonArray rings, octaves, parameters;
    for (const FittedRing& ring : fit.rings) {
        rings.add(JsonObject()
                      .add("wavenumber", ring.wavenumber)
                      .add("density", ring.density)
                      .add("count", ring.count)
                      .add("model", ring.model)
                      .add("scatter", ring.scatter)
                      .add("residual", ring.residual()));
    }
    for (const FittedOctave& octave : fit.octaves) {
        octaves.add(JsonObject()
                        .add("longest_wave", octave.longest_wave)
                        .add("error", octave.error)
                        .add("scatter", octave.scatter));
    }
    for (const FittedParameter& parameter : fit.parameters) {
        parameters.add(JsonObject()
                           .add("name", parameter.name)
                           .add("value", parameter.value)
                           .add("at_bound", parameter.is_at_bound));
    }
    JsonObject json{JsonLines{2}};
    json.add("samples", json_array(bed.domain.samples))
        .add("cell", fit.cell)
        .add("law", law_name(fit))
        .add("parameters", parameters)
        .add("error_above_lowest", fit.error_above_lowest())
        .add("octaves", octaves)
        .add("rings", rings)
        .add("model", relief_json(fit.bed)
                          .add("anisotropy", fit.bed.anisotropy)
                          .add("direction", fit.bed.direction))
        .add("terrain", relief_json(fit.model).add("tile_rms", fit.rms))
        .add("warnings", json_array(fit.warnings));
    return json.text() + "\n";
}

std::string rings_csv(const TerrainFit& fit) {
    std::string text = kRingsHeader;
    for (const FittedRing& ring : fit.rings) {
        for (const double value :
             {ring.wavenumber, ring.density, ring.count, ring.model, ring.scatter}) {
            text += shortest_text(value) + ",";
        }
        text += shortest_text(ring.residual()) + "\n";
    }
    return text;
}

}  // namespace ocean::app
