// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The user's sea: its open water at its start, without bed, take, crests and second order, and each
// of its hulls alone in deep water.
#include <algorithm>
#include <string>

#include "bench.hpp"
#include "literature.hpp"
#include "map_statistics.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::verify {
namespace {

Parameters open_water(const Sea& sea) {
    Parameters parameters = sea.at(sea.parameters.time.start);
    parameters.water.bed = nullptr;
    parameters.water.seabed.clear();
    parameters.hulls.clear();
    parameters.crests.clear();
    parameters.surface.second_order = false;
    return parameters;
}

void propagation_rows(Bench& bench, const Parameters& parameters) {
    Row dispersion{.id = "sea.dispersion", .claim = "Frequencies of its waves"};
    Row direction{.id = "sea.direction",
                  .claim = "Its waves travel the way of its spectrum",
                  .reference = "mean direction of the modes that the grid resolves",
                  .method = "mean over 8 seeds of the mean direction of the energy along +k",
                  .unit = "degrees",
                  .bound = "3 standard errors, at most 3 degrees"};
    const auto leave_out = [&](const char* reason) {
        for (Row* row : {&dispersion, &direction}) {
            row->not_run = reason;
            bench.add(*row);
        }
    };
    if (parameters.water.gravity != kG || parameters.water.surface_tension != 0.074 ||
        parameters.water.density != 1000.0) {
        return leave_out("its water is not that of the suite's equations");
    }
    Ocean sea(parameters, bench.options());
    const double shortest =
        2.0 * parameters.grid.patch_size / samples_of_propagation(parameters.grid);
    const double step =
        0.7 * kPi /
        angular_frequency(std::sqrt(2.0) * 2.0 * kPi / shortest, parameters.water.depth);
    bench.add(dispersion_row(sea, step, dispersion));
    SampleMean turn;
    const SeaState state = sea.state();
    if (state.directional_spread.resolved > 65.0) {  // 81 where all directions are equal
        direction.not_run = "its waves travel all ways, as those of Phillips do both ways";
        return bench.add(direction);
    }
    for (int seed = 1; seed <= 8; ++seed) {
        sea.set("seed", std::to_string(seed));
        const double found = measure_propagation(sea, 6, step).direction;
        turn.add(std::remainder(found - state.mean_direction.resolved, 360.0));
    }
    direction.measured = turn.mean();
    direction.tolerance = std::min(3.0 * turn.error(), 3.0);
    bench.add(direction);
}

void whitecaps(Bench& bench, Parameters parameters, int seeds) {
    const double wind = Ocean(parameters, bench.options()).modes().wind_speed;
    Row row{.id = "sea.whitecaps", .claim = "Its whitecaps", .method = ", its own grid"};
    if (parameters.surface.foam_coverage != FoamCoverage::monahan) {
        row.not_run = "a threshold is given";
    } else if (!(wind > 4.0) || parameters.surface.choppiness < 0.5) {
        row.not_run = "its wind or its choppiness makes hardly any";
    } else if (parameters.waves.front().wind() != wind) {
        row.not_run = "its wind is that of another wave system";
    }
    if (row.not_run.empty()) row = whitecap_row(bench, parameters, seeds, std::move(row));
    row.plot = {};
    bench.add(std::move(row));
}

void hulls(Bench& bench, const Sea& sea) {
    const SeaState state = Ocean(sea, bench.options()).state();
    for (std::size_t i = 0; i < state.hulls.size(); ++i) {
        const HullSummary& summary = state.hulls[i];
        Row row{.id = "sea.hull_" + std::to_string(i),
                .claim = "Energy of the wake of hull " + std::to_string(i),
                .method = ", the hull alone, straight on at its highest speed"};
        if (summary.froude_number < 0.25 || summary.froude_number > 1.2) {
            row.not_run = "its Froude number, " + significant_text(summary.froude_number, 2) +
                          ", is beyond 0.25 .. 1.2";
            bench.add(row);
            continue;
        }
        bench.add(michell_row(bench, sea.parameters.hulls[i], summary.speed, row));
    }
}

}  // namespace

void verify_sea(Bench& bench) {
    const Sea& given = *bench.request.sea;
    const Parameters parameters = open_water(given);
    const double samples = std::pow(parameters.grid.resolution, 2.0);
    const int seeds = static_cast<int>(std::clamp(16777216.0 / samples, 8.0, 64.0));
    const SeaState state = Ocean(parameters, bench.options()).state();
    if (!(state.significant_wave_height.resolved > 0.0)) {
        bench.add({.id = "sea.variance", .claim = "Variance of its maps", .not_run = "it is flat"});
        return hulls(bench, given);
    }
    bench.add({.id = "sea.energy_of_grid",
               .claim = "Its grid holds the energy of its spectrum",
               .reference = "sum over the modes over the integral of the spectrum",
               .method = "share of the variance",
               .expected = 1.0,
               .measured = state.energy_resolved,
               .tolerance = 0.05,
               .bound = "`ocean info` warns of less"});
    bench.add(variance_row(bench, parameters, seeds,
                           {.id = "sea.variance", .claim = "Variance of its maps"}));
    propagation_rows(bench, parameters);
    whitecaps(bench, parameters, std::min(seeds, 24));
    std::vector<Backend> backends = {Backend::cpu};
    backends.insert(backends.end(), bench.request.backends.begin(), bench.request.backends.end());
    for (const Backend& backend : backends) {
        bench.add(precision_row(bench, parameters, backend,
                                {.id = "sea.precision_" + std::string(backend.name),
                                 .claim = "Its linear fields by " + std::string(backend.name)}));
    }
    hulls(bench, given);
}

}  // namespace ocean::verify
