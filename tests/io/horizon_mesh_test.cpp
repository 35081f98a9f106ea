// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: the horizon mesh shows the surface near the eye, still water beyond the true horizon, and
// in between only waves that its vertices resolve; the others tilt the normals to the eye by the
// mean of the visible slopes.

#include "ocean/internal/io/horizon_mesh.hpp"
#include "mesh/map_pyramid.hpp"
#include "ocean/internal/io/visible_slope.hpp"
#include "refusal.hpp"
#include "sample_surface.hpp"

namespace ocean {
namespace {

constexpr double kPeriod = 64.0;
constexpr double kEarth = 6371000.0;

// E[u max(0, t + u)] / E[max(0, t + u)] by drawing facets.
double monte_carlo(double slope_rms, double elevation, std::mt19937_64& random) {
    std::normal_distribution<double> lean(0.0, slope_rms);
    double weights = 0.0, sum = 0.0;
    for (int draw = 0; draw < 500'000; ++draw) {
        const double u = lean(random);
        const double seen = std::max(0.0, elevation + u);
        weights += seen;
        sum += seen * u;
    }
    return sum / weights;
}

TEST(VisibleSlope, EqualsMonteCarlo) {
    std::mt19937_64 random(5);
    for (const double rms : {0.05, 0.2}) {
        for (const double elevation : {-0.2, -0.05, 0.0, 0.02, 0.1, 0.5, 2.0}) {
            const double expected = monte_carlo(rms, elevation, random);
            // Five standard errors; few facets are left to draw on a side turned away by four
            // sigma.
            const double tolerance = elevation < -3.0 * rms ? 0.2 : 7e-3;
            EXPECT_NEAR(io::mean_visible_slope(rms, elevation), expected, tolerance * rms)
                << rms << " " << elevation;
        }
    }
}

TEST(VisibleSlope, LimitsAndContinuity) {
    EXPECT_EQ(io::mean_visible_slope(0.0, 0.1), 0.0);
    EXPECT_NEAR(io::mean_visible_slope(0.2, 0.0), 0.2 * std::sqrt(kPi / 2), 1e-12);
    EXPECT_NEAR(io::mean_visible_slope(0.1, 5.0), 0.01 / 5.0, 1e-12);
    EXPECT_NEAR(io::mean_visible_slope(0.01, -10.0), 10.0, 1e-4);
    // Where the series takes over.
    const double before = io::mean_visible_slope(1.0, -11.9999);
    const double after = io::mean_visible_slope(1.0, -12.0001);
    EXPECT_NEAR(before, after, 4e-4);  // of which 2e-4 is the step in the argument
}

// h = a sin(k x), no displacement: present in the levels that can hold `waves` per period.
Surface wave_level(int n, int waves, double amplitude) {
    using enum Channel;
    Surface surface(Lattice{n, kPeriod}, 0.0, {dx, dy, height, nx, ny, nz, slope_x, slope_y});
    for (const Channel zero : {dx, dy, ny, slope_y}) {
        std::ranges::fill(surface.channel(zero), 0.0f);
    }
    const double k = kTwoPi * waves / kPeriod;
    const double a = waves < n / 2 ? amplitude : 0.0;
    for (const auto [i, j, at] : test::cells(n, n)) {
        const double phase = k * i * kPeriod / n;
        const double slope = a * k * std::cos(phase), length = std::hypot(slope, 1.0);
        surface.channel(height)[at] = static_cast<float>(a * std::sin(phase));
        surface.channel(slope_x)[at] = static_cast<float>(slope);
        surface.channel(nx)[at] = static_cast<float>(-slope / length);
        surface.channel(nz)[at] = static_cast<float>(1.0 / length);
    }
    return surface;
}

std::vector<Surface> levels_of(int waves, double amplitude) {
    std::vector<Surface> levels;
    for (int n = 256; n >= 32; n /= 2) levels.push_back(wave_level(n, waves, amplitude));
    return levels;
}

io::View small_view() {
    io::View view;
    view.columns = 64;
    view.rows = 400;
    return view;
}

double radius(const io::Mesh& mesh, std::size_t v) {
    return std::hypot(mesh.positions[3 * v], mesh.positions[3 * v + 1]);
}

TEST(HorizonMesh, StillWaterIsARoundEarthBeyondItsHorizon) {
    const auto levels = levels_of(4, 0.0);
    const io::View view = small_view();
    const io::Mesh mesh = io::make_horizon_mesh(levels, view);
    ASSERT_EQ(mesh.positions.size(), 3u * 64 * 400);
    ASSERT_EQ(mesh.triangles.size(), 6u * 63 * 399);
    double steepest = -1.0, steepest_at = 0.0;
    for (std::size_t v = 0; v < mesh.positions.size() / 3; ++v) {
        const double r = radius(mesh, v);
        EXPECT_NEAR(mesh.positions[3 * v + 2], -r * r / (2.0 * kEarth), 0.0051);
        const double elevation = (mesh.positions[3 * v + 2] - view.height) / r;
        if (elevation > steepest) steepest = elevation, steepest_at = r;
    }
    EXPECT_NEAR(io::horizon_distance(6.0), 8743.0, 1.0);
    EXPECT_NEAR(steepest_at, 8743.0, 400.0);  // the highest line is the horizon, not the edge
    EXPECT_NEAR(radius(mesh, 0), 3.6, 1e-3);
    EXPECT_GT(radius(mesh, mesh.positions.size() / 3 - 1), 9000.0);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        const auto p = [&](std::size_t c) {
            return &mesh.positions[3 * static_cast<std::size_t>(mesh.triangles[t + c])];
        };
        EXPECT_GT((p(1)[0] - p(0)[0]) * (p(2)[1] - p(0)[1]),
                  (p(2)[0] - p(0)[0]) * (p(1)[1] - p(0)[1]));
    }
}

TEST(HorizonMesh, ExtendsBeyondTheSidesOfTheView) {
    const auto levels = levels_of(4, 0.0);
    for (const double angle : {20.0, 60.0, 100.0}) {
        io::View view = small_view();
        view.heading = 70.0;
        view.field_of_view = angle;
        const io::Mesh mesh = io::make_horizon_mesh(levels, view);
        for (const std::size_t v : {std::size_t{0}, std::size_t{63}}) {
            const double bearing =
                std::atan2(mesh.positions[3 * v + 1], mesh.positions[3 * v]) * 180.0 / kPi;
            const double side = v == 0 ? -1.0 : 1.0;  // from right to left
            EXPECT_GE(side * (bearing - 70.0), 0.5 * angle + 5.0);
            EXPECT_LE(side * (bearing - 70.0), 0.5 * angle + 20.0);
        }
    }
}

TEST(HorizonMesh, NearVerticesLieOnTheSurface) {
    const int waves = 8;
    const auto levels = levels_of(waves, 0.3);
    io::View view = small_view();
    view.x = 5.0;
    view.y = -3.0;
    view.heading = 30.0;
    const io::Mesh mesh = io::make_horizon_mesh(levels, view);
    const double k = kTwoPi * waves / kPeriod;
    std::size_t near = 0;
    for (std::size_t v = 0; v < mesh.positions.size() / 3; ++v) {
        const float* p = &mesh.positions[3 * v];
        const double r = std::hypot(p[0] - view.x, p[1] - view.y);
        if (r > 8.0) continue;  // finer spacing than the finest map's
        ++near;
        EXPECT_NEAR(p[2], 0.3 * std::sin(k * p[0]), 1e-3);
        const double slope = 0.3 * k * std::cos(k * p[0]);
        EXPECT_NEAR(mesh.normals[3 * v] / mesh.normals[3 * v + 2], -slope, 2e-3);
    }
    EXPECT_GT(near, 1000u);
}

TEST(HorizonMesh, FiltersWavesThatWouldAliasAndTiltsNormalsInstead) {
    const int waves = 64;  // 1 m long: only the finest level holds it
    const double amplitude = 0.02;
    const auto levels = levels_of(waves, amplitude);
    const io::View view = small_view();
    const io::Mesh mesh = io::make_horizon_mesh(levels, view);
    const double k = kTwoPi * waves / kPeriod;
    const double variance = 0.5 * amplitude * amplitude * k * k;  // all of it along x
    std::size_t checked = 0;
    for (std::size_t v = 0; v < mesh.positions.size() / 3; ++v) {
        const float* p = &mesh.positions[3 * v];
        const double r = radius(mesh, v);
        if (r < 100.0) continue;  // spacing there: 2 m and more
        ++checked;
        EXPECT_NEAR(p[2], -r * r / (2.0 * kEarth), 0.0051);
        // V e m / s^2 with V = diag(variance, 0) lies along x only.
        const double ex = -p[0] / r, ey = -p[1] / r;
        const double s = std::sqrt(variance) * std::abs(ex);
        const double elevation = (view.height - p[2]) / r - r / kEarth;
        const double lean = io::mean_visible_slope(s, elevation) * variance * ex / (s * s);
        EXPECT_NEAR(mesh.normals[3 * v] / mesh.normals[3 * v + 2], lean - ex * r / kEarth, 2e-3);
        EXPECT_NEAR(mesh.normals[3 * v + 1] / mesh.normals[3 * v + 2], -ey * r / kEarth, 1e-4);
    }
    EXPECT_GT(checked, 1000u);
}

// At the samples, where interpolation adds nothing of its own.
TEST(MapPyramid, ResolvedAndFilteredSlopesAddUpAtAnySpacing) {
    const auto levels = levels_of(64, 0.002);
    const io::MapPyramid maps(levels);
    const double whole = 0.5 * std::pow(0.002 * kTwoPi * 64 / kPeriod, 2);
    for (const double spacing : {0.1, 0.25, 0.3, 0.35, 0.42, 0.5, 3.0, 1000.0}) {
        double shown = 0.0, left_out = 0.0;
        for (int i = 0; i < 256; ++i) {
            const io::PyramidSample sample = maps.sample(i * kPeriod / 256, 3.0, spacing);
            shown += std::pow(sample.normal_x / sample.normal_z, 2) / 256;
            left_out = sample.left_out.xx;
        }
        EXPECT_NEAR(shown + left_out, whole, 1e-3 * whole) << spacing;
        EXPECT_GE(left_out, -1e-6 * whole);
    }
}

TEST(HorizonMesh, ChangesContinuouslyBetweenLevels) {
    const auto levels = levels_of(16, 0.2);
    io::View view = small_view();
    view.rows = 2000;
    view.heading = 90.0;  // along the crests: only the level changes from row to row
    const io::Mesh mesh = io::make_horizon_mesh(levels, view);
    const std::size_t middle = 31;
    double worst = 0.0, range = 0.0;
    for (std::size_t row = 1; row < 2000; ++row) {
        const auto level_height = [&](std::size_t at) {
            const float* p = &mesh.positions[3 * (at * 64 + middle)];
            const double r = std::hypot(p[0], p[1]);
            const double shown = p[2] + r * r / (2.0 * kEarth);
            const double full = 0.2 * std::sin(kTwoPi * 16 / kPeriod * p[0]);
            return std::abs(full) < 0.1 ? -1.0 : shown / full;  // share of the wave that is shown
        };
        const double a = level_height(row - 1), b = level_height(row);
        if (a < 0.0 || b < 0.0 || radius(mesh, row * 64) > 500.0) continue;
        worst = std::max(worst, std::abs(a - b));
        range = std::max(range, 1.0 - b);
    }
    EXPECT_GT(range, 0.9);   // it does fade out
    EXPECT_LT(worst, 0.05);  // and in small steps
}

TEST(HorizonMesh, RefusesInvalidViews) {
    auto levels = levels_of(4, 0.1);
    const auto refusal = [&levels](auto member, auto value) {
        io::View view = small_view();
        view.*member = value;
        return test::message_of([&] { io::make_horizon_mesh(levels, view); });
    };
    EXPECT_NE(refusal(&io::View::height, 0.0), "");
    EXPECT_NE(refusal(&io::View::field_of_view, std::nan("")), "");
    EXPECT_NE(refusal(&io::View::rows, 2'000'000'000), "");
    EXPECT_NE(refusal(&io::View::horizon, 1.0), "");
    EXPECT_EQ(refusal(&io::View::heading, 0.0), "");
    EXPECT_THROW(io::make_horizon_mesh({}, small_view()), Error);
    levels.erase(levels.begin() + 1);
    EXPECT_NE(refusal(&io::View::heading, 0.0), "");
    Domain place = levels[0].domain();
    place.wraps = false;
    levels = {Surface(place, 0.0, levels[0].channels())};
    EXPECT_TRUE(test::says(refusal(&io::View::heading, 0.0), "maps that repeat"));
}

}  // namespace
}  // namespace ocean
