// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Frames of the GPU against the same frames in double: every size, one cascade and several, early
// and late.
#include <tuple>

#include "ocean/error.hpp"
#include "ocean/gl/backend.hpp"
#include "ocean/internal/fft.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/ocean.hpp"
#include "unit/test_seas.hpp"
#include "waves/surface/map_writer.hpp"
#include "waves/surface/plane_channels.hpp"
#include "waves/synthesis/mode_grid.hpp"

namespace ocean {
namespace {

using test::kAllChannels;
using test::relative_error;
using test::wind_sea;

/// Returns the frame of a request, computed in double.
std::vector<std::vector<float>> judged(MapRequest request, ThreadPool& pool) {
    LinearPlanes<double> planes;
    const Radix2Fft<double> fft(request.modes.resolution);
    pool.for_each_item(kLinearCount, [&](int i, int) {
        const Linear field = kLinears[static_cast<std::size_t>(i)];
        auto grid = coefficient_grid<double>(request.modes, field);
        fft.transform_2d(grid, FftDirection::inverse);
        planes[field].resize(grid.size());
        for (std::size_t k = 0; k < grid.size(); ++k) planes[field][k] = grid[k].real();
    });
    std::vector<std::vector<float>> maps;
    std::vector<MapOutput> outputs(request.outputs.begin(), request.outputs.end());
    for (MapOutput& output : outputs) {
        output.data = maps.emplace_back(Lattice{request.modes.resolution, 1.0}.size()).data();
    }
    request.outputs = outputs;
    write_channels(planes, request, {}, pool);
    return maps;
}

/// A plane for each channel without a past: every linear field is one of them, but for a factor.
struct Planes {
    explicit Planes(int resolution) {
        for (int c = 0; c < kChannelCount; ++c) {
            const auto channel = static_cast<Channel>(c);
            if (kAllChannels.contains(channel)) add(resolution, channel);
        }
    }
    void add(int resolution, Quantity quantity) {
        // NaN marks samples that the frame does not write.
        maps.emplace_back(Lattice{resolution, 1.0}.size(), std::nanf("1"));
        outputs.push_back({maps.back().data(), 1, {{{quantity, 1.0f}}}});
    }

    std::vector<std::vector<float>> maps;
    std::vector<MapOutput> outputs;
};

bool is_linear(Channel channel) {
    const bool velocity =
        channel == Channel::vx || channel == Channel::vy || channel == Channel::vz;
    return channel_info(channel).is_multiple() && !velocity;
}

void expect_exact(const Parameters& parameters, double time, int resolution,
                  const Backend& backend = gl::kBackend) {
    ThreadPool pool;
    Ocean ocean(parameters);
    const Modes& modes = ocean.modes(time);
    const SurfaceSettings settings = with_threshold(parameters.surface, modes, resolution);
    Planes planes(resolution);
    const MapRequest request{map_modes(modes, time, resolution), settings, planes.outputs, {}};
    MapWriter(backend).write(request, pool);
    const auto expected = judged(request, pool);
    double normal_error = 0.0;
    double normal_variance = 0.0;
    for (std::size_t i = 0; i < planes.maps.size(); ++i) {
        const Channel channel = planes.outputs[i].component[0].quantity.channel();
        const double error = relative_error(planes.maps[i], expected[i]);
        const double variance = test::variance(expected[i]);
        // Near 1 a float's last bit is a good part of how nz varies: the float formula alone cannot
        // do it, the shader of `gl` can.
        if (channel_info(channel).name.starts_with('n') && backend.name != "gl") {
            normal_error += error * error * variance;
            normal_variance += variance;
            continue;
        }
        EXPECT_LE(error, is_linear(channel) ? 1e-6 : 2e-6)
            << channel_info(channel).name << " at " << time << " s, resolution " << resolution;
    }
    EXPECT_LE(std::sqrt(normal_error), 2e-6 * std::sqrt(normal_variance)) << "normal";
}

/// Samples 0.8 m apart at every size: where a map holds gentle waves alone, nz is so near 1 that
/// rounding it to a float is an error of more than 2e-6 of how it varies.
Parameters fine_sea(int resolution, int cascades) {
    Parameters parameters = wind_sea(resolution, 0.8 * resolution);
    parameters.grid.cascades = cascades;
    return parameters;
}

class GlFrames : public testing::TestWithParam<std::tuple<int, int, double>> {};

TEST_P(GlFrames, EveryFieldIsThatInDouble) {
    const auto [resolution, cascades, time] = GetParam();
    expect_exact(fine_sea(resolution, cascades), time, resolution);
}

INSTANTIATE_TEST_SUITE_P(Gate, GlFrames,
                         testing::Combine(testing::Values(64, 256, 512), testing::Values(1, 4),
                                          testing::Values(12.0, 1e6)));

/// Minutes on a processor: `scripts/test --full`.
INSTANTIATE_TEST_SUITE_P(DISABLED_Long, GlFrames,
                         testing::Combine(testing::Values(1024, 2048, 4096), testing::Values(1, 4),
                                          testing::Values(1e6)));

TEST(GlFrames, HighWavesOfAWidePatchLeaveTheirGradientsExact) {
    Parameters parameters = wind_sea(256, 4000.0);
    parameters.waves.front().wind_speed = 25.0;
    expect_exact(parameters, 12.0, 256);
    parameters.waves.front().wind_speed = 4.0;
    parameters.grid.patch_size = 20.0;
    expect_exact(parameters, 12.0, 256);
}

TEST(GlFrames, TimesThatNoFloatHoldsAreExactToo) {
    expect_exact(fine_sea(64, 1), 1e6 + 1.0 / 3.0, 64);
    Parameters loop = fine_sea(64, 1);
    loop.time.loop_period = 7.0;
    expect_exact(loop, 1e6 + 1.0 / 3.0, 64);
}

TEST(GlFrames, TheTransformByStagesIsTheSame) {
    for (const int resolution : {32, 256}) {
        expect_exact(fine_sea(resolution, 1), 12.0, resolution, gl::kThesisBackend);
    }
    expect_exact(fine_sea(128, 3), 1e6, 512, gl::kThesisBackend);
}

TEST(GlFrames, MapsThatCutOrPadTheModesAreExactToo) {
    for (const int resolution : {32, 128}) expect_exact(fine_sea(128, 3), 12.0, resolution);
}

TEST(GlFrames, LargeMapsOfFewModesAreExactToo) {
    expect_exact(fine_sea(128, 3), 12.0, 1024);
}

}  // namespace
}  // namespace ocean
