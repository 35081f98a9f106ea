// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Every preset, queried at random points: the bounds of query.hpp.

#include "ocean/internal/surface_query.hpp"
#include "ocean/internal/wave_sum.hpp"
#include "ocean/ocean.hpp"
#include "ocean/query.hpp"
#include "ocean/seafile.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

constexpr double kTime = 12.0;
constexpr double kMillimetre = 1e-3;

class PresetQuery : public testing::TestWithParam<std::string> {};

struct Distances {
    double shown = 0.0;  // from the point to where the query's own surface shows its label
    double exact = 0.0;  // to where the sum over all modes shows it
};

Distances distances(const SurfaceQuery& query, const WaveSum& sum, double choppiness,
                    const std::vector<WorldPoint>& points,
                    const std::vector<QuerySample>& samples) {
    Distances largest;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const WorldPoint label{samples[i].label[0], samples[i].label[1]};
        const WorldPoint shown = query.shown(label);
        const DisplacementSample exact = sum.displacement_at(label.x, label.y);
        const auto grow = [&](double& distance, double x, double y) {
            distance = std::max(distance, std::hypot(x - points[i].x, y - points[i].y));
        };
        grow(largest.shown, shown.x, shown.y);
        grow(largest.exact, label.x - choppiness * exact.displacement_x,
             label.y - choppiness * exact.displacement_y);
    }
    return largest;
}

TEST_P(PresetQuery, KeepsTheStatedBounds) {
    const Parameters parameters = parse_sea(find_preset(GetParam()).toml, "preset", "").parameters;
    ThreadPool pool;
    const Modes modes = make_modes(make_directional_spectrum(parameters), parameters, pool);
    WaveSum sum(modes, parameters.water);
    sum.set_time(kTime);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> coordinate(0.0, parameters.grid.patch_size);
    std::vector<WorldPoint> points;
    for (int i = 0; i < 60; ++i) {
        const double x = coordinate(random);
        points.push_back({x, coordinate(random)});
    }
    const auto ask = [&](const QueryOptions& options, Distances& largest) {
        const SurfaceQuery query(modes, parameters.surface, parameters.water, kTime, options, pool);
        std::vector<QuerySample> samples(points.size());
        query.sample(points, samples, pool);
        largest = distances(query, sum, parameters.surface.choppiness, points, samples);
        return samples;
    };
    Distances plain, refined, exactly;
    const std::vector<QuerySample> samples = ask({}, plain);
    const std::vector<QuerySample> fine = ask({.refine = 2}, refined);
    const std::vector<QuerySample> exact = ask({.exact = true}, exactly);
    EXPECT_LT(plain.shown, kMillimetre);
    EXPECT_LT(refined.exact, kMillimetre);
    EXPECT_LT(exactly.exact, 1e-6 * kMillimetre);
    const auto rms = [&](const auto& value) {
        double sum_of_squares = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) sum_of_squares += std::pow(value(i), 2);
        return std::sqrt(sum_of_squares / static_cast<double>(points.size()));
    };
    const double height = rms([&](std::size_t i) { return exact[i].height; });
    EXPECT_LE(rms([&](std::size_t i) { return samples[i].height - exact[i].height; }),
              2e-3 * height);
    EXPECT_LE(rms([&](std::size_t i) { return fine[i].height - exact[i].height; }), 1e-4 * height);
    for (const QuerySample& sample : samples) EXPECT_FALSE(sample.folded);  // J > 0
}

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (const Preset& preset : presets()) names.push_back(preset.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, PresetQuery, testing::ValuesIn(preset_names()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace ocean
