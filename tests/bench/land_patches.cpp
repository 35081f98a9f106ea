// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The quadtree of land: a frame's selection, inside a frustum and all round, and a mesh of it.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "ocean/internal/land_mesh.hpp"
#include "ocean/internal/land_quadtree.hpp"

namespace ocean::bench {
namespace {

constexpr double kHalfWidth = 0.57735, kHalfHeight = 0.32476;  // 60 degrees across, 16:9

/// Returns the planes of a camera 100 m up that looks along +x and a little down.
std::array<std::array<double, 4>, 5> frustum(const std::array<double, 3>& eye, double pitch) {
    const double c = std::cos(pitch), s = std::sin(pitch);
    const auto plane = [&](double forward, double right, double up) {
        const std::array<double, 3> n = {forward * c - up * s, -right, forward * s + up * c};
        return std::array<double, 4>{n[0], n[1], n[2],
                                     -n[0] * eye[0] - n[1] * eye[1] - n[2] * eye[2]};
    };
    return {plane(1.0, 0.0, 0.0), plane(kHalfWidth, 1.0, 0.0), plane(kHalfWidth, -1.0, 0.0),
            plane(kHalfHeight, 0.0, 1.0), plane(kHalfHeight, 0.0, -1.0)};
}

/// Selects for eyes along a way; argument 0: inside a frustum, 1: all round.
void land_selection(benchmark::State& state) {
    const QuadtreeSettings settings;
    const HeightBounds bounds = [](double, double, double) { return std::pair{-50.0f, 900.0f}; };
    std::vector<LandPatch> patches;
    double way = 0.0;
    for ([[maybe_unused]] const auto iteration : state) {
        LandView view{{way += 1.25, 0.3 * way, 100.0}, 20.0};
        const auto planes = frustum(view.eye, -0.1);
        if (state.range(0) == 0) view.planes = planes;
        select(settings, view, bounds, patches);
        benchmark::DoNotOptimize(patches.data());
    }
    state.counters["patches"] = static_cast<double>(patches.size());
    state.counters["triangles"] = static_cast<double>(triangles_of(settings, patches));
}
BENCHMARK(land_selection)->Name("land/select")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

/// Makes the mesh of a view all round, over land that costs nothing.
void land_meshing(benchmark::State& state) {
    const QuadtreeSettings settings;
    const LandView view{{10.0, 20.0, 100.0}, 20.0};
    const auto patches = select(settings, view, {});
    const HeightSampler flat = [](std::span<const WorldPoint>, double, std::span<float> heights) {
        std::fill(heights.begin(), heights.end(), 0.0f);
    };
    for ([[maybe_unused]] const auto iteration : state) {
        benchmark::DoNotOptimize(make_land_mesh(settings, patches, view, flat));
    }
    state.counters["triangles"] = static_cast<double>(triangles_of(settings, patches));
}
BENCHMARK(land_meshing)->Name("land/mesh")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ocean::bench
