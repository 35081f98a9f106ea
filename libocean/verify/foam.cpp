// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How much of the sea is white.
#include <string>

#include "bench.hpp"
#include "literature.hpp"
#include "map_statistics.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::verify {
namespace {

double monahan(double wind) {
    return 3.84e-6 * std::pow(wind, 3.41);
}

void cover_row(Bench& bench) {
    constexpr double kWind = 12.3;
    Parameters parameters = wind_sea(kWind, 30e3, 128, 20.0 * kWind);
    double cover = 0.0, whitecap = 0.0;
    for (parameters.seed = 1; parameters.seed <= 12; ++parameters.seed) {
        Ocean sea(parameters, bench.options());
        for (int i = 0; i < 60; ++i) {
            const Surface map = sea.evaluate(0.5 * i, {Channel::cover, Channel::whitecap});
            cover += mean_of(map.channel(Channel::cover));
            whitecap += mean_of(map.channel(Channel::whitecap));
        }
    }
    bench.add({.id = "foam.cover",
               .claim = "Foam covers as much as whitecaps do",
               .reference = "mean of cover over the mean of whitecap",
               .method = "12 seeds, 60 times each, U = 12.3 m/s, N = 128, L = 246 m",
               .expected = 1.0,
               .measured = cover / whitecap,
               .tolerance = 0.02,
               .bound = "2 %"});
}

}  // namespace

Row whitecap_row(Bench& bench, const Parameters& parameters, int seeds, Row row) {
    Ocean sea(parameters, bench.options());
    const double wind = parameters.waves.front().wind();
    SampleMean whitecap;
    for (int seed = 1; seed <= seeds; ++seed) {
        sea.set("seed", std::to_string(seed));
        const Surface map = sea.evaluate(3.0, {Channel::whitecap});
        whitecap.add(mean_of(map.channel(Channel::whitecap)));
    }
    row.kind = Kind::physics;
    row.reference = "[Monahan and O'Muircheartaigh 1980]: W = 3.84e-6 U^3.41";
    row.method = "mean whitecap of " + std::to_string(seeds) + " seeds" + row.method;
    row.expected = monahan(wind);
    row.measured = whitecap.mean();
    row.tolerance = std::max(0.05 * row.expected, 3.0 * whitecap.error());
    row.bound = "5 %, or 3 standard errors";
    row.plot.measured = {{wind, whitecap.mean(), 2.0 * whitecap.error()}};
    return row;
}

void verify_foam(Bench& bench) {
    Plot plot{.title = "Mean whitecap of 24 seas, and Monahan's",
              .x_label = "wind at 10 m [m/s]",
              .y_label = "share of the sea",
              .logarithmic = true};
    for (double wind = 7.0; wind < 22.0; wind += 0.5) plot.curve.push_back({wind, monahan(wind)});
    std::vector<Row> rows;
    for (const double wind : {8.0, 12.0, 16.0, 20.0}) {
        Row row = whitecap_row(bench, wind_sea(wind, 300e3, 128, 150.0), 24,
                               {.id = "foam.whitecaps_" + plain_text(wind),
                                .claim = "Whitecaps in a wind of " + plain_text(wind) + " m/s",
                                .method = ", N = 128, L = 150 m"});
        plot.measured.push_back(row.plot.measured.front());
        row.plot = {};
        rows.push_back(std::move(row));
    }
    rows.back().plot = std::move(plot);
    for (Row& row : rows) bench.add(std::move(row));
    cover_row(bench);
}

}  // namespace ocean::verify
