// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How floating bodies lie on waves that are known.
#include "ocean/internal/float_pose.hpp"

#include "ocean/internal/surface_query.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

constexpr double kPeriod = 256.0;
constexpr double kDegrees = 180.0 / kPi;

/// h = cos(k x) at time 0, not displaced, on samples 1 m apart.
class FloatOnOneWave : public testing::Test {
  protected:
    explicit FloatOnOneWave(int waves = 2)
        : parameters_(test::wind_sea(256, kPeriod)),
          k_(kTwoPi * waves / kPeriod),
          query_(make_query(parameters_, waves, pool_)) {}

    static SurfaceQuery make_query(Parameters& parameters, int waves, ThreadPool& pool) {
        parameters.surface.choppiness = 0.0;
        return SurfaceQuery(test::single_wave(parameters, waves, 0), parameters.surface,
                            parameters.water, 0.0, {}, pool);
    }
    FloatPose pose(double x, double heading, double length, double width) {
        return float_pose(query_, {x, 5.0, heading, length, width}, pool_);
    }
    double slope(double x) const { return -k_ * std::sin(k_ * x); }

    Parameters parameters_;
    ThreadPool pool_{1};
    double k_;
    SurfaceQuery query_;
};

TEST_F(FloatOnOneWave, ABoatTiltsAsTheWaveAndLiesOnIt) {
    for (double x = 3.0; x < kPeriod; x += 10.0) {
        const FloatPose east = pose(x, 0.0, 6.0, 2.0);
        EXPECT_NEAR(east.position[0], x, 0.0);
        EXPECT_NEAR(east.position[1], 5.0, 0.0);
        EXPECT_NEAR(east.position[2], std::cos(k_ * x), 4e-3);
        EXPECT_NEAR(east.pitch, std::atan(slope(x)) * kDegrees, 0.02);
        EXPECT_NEAR(east.roll, 0.0, 1e-3);
        EXPECT_NEAR(-east.up[0] / east.up[2], slope(x), 3e-4);
        EXPECT_NEAR(east.forward[2] / east.forward[0], slope(x), 3e-4);
        // To the north, the rising east side is starboard.
        const FloatPose north = pose(x, 90.0, 6.0, 2.0);
        EXPECT_NEAR(north.pitch, 0.0, 1e-3);
        EXPECT_NEAR(north.roll, -std::atan(slope(x)) * kDegrees, 0.02);
        EXPECT_NEAR(north.up[0], east.up[0], 3e-4);
        const FloatPose west = pose(x, 180.0, 6.0, 2.0);
        EXPECT_NEAR(west.pitch, -east.pitch, 1e-3);
    }
}

TEST_F(FloatOnOneWave, ASmallBodyTakesTheNormalOfTheSurface) {
    for (const double size : {0.9, 0.01, 0.0}) {
        const FloatPose pose = this->pose(20.0, 33.0, size, 0.5 * size);
        const QuerySample sample = query_.sample({20.0, 5.0});
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(pose.up[c], sample.normal[c], 1e-6);
        EXPECT_NEAR(pose.position[2], sample.height, 1e-6);
    }
}

TEST_F(FloatOnOneWave, UpAndForwardAreUnitVectorsAtRightAngles) {
    for (double heading = -400.0; heading < 800.0; heading += 37.0) {
        const FloatPose p = pose(20.0, heading, 12.0, 4.0);
        const auto dot = [](const double* a, const double* b) {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        };
        EXPECT_NEAR(dot(p.up, p.up), 1.0, 1e-12);
        EXPECT_NEAR(dot(p.forward, p.forward), 1.0, 1e-12);
        EXPECT_NEAR(dot(p.up, p.forward), 0.0, 1e-12);
        EXPECT_NEAR(std::atan2(p.forward[1], p.forward[0]),
                    std::remainder(heading, 360.0) / kDegrees, 1e-12);
    }
}

class FloatOnShortWaves : public FloatOnOneWave {
  protected:
    FloatOnShortWaves() : FloatOnOneWave(16) {}
};

TEST_F(FloatOnShortWaves, ABodyMuchLongerThanTheWavesStaysNearlyLevel) {
    double steepest = 0.0;
    for (double x = 0.0; x < 16.0; x += 0.5) {
        const FloatPose ship = pose(x, 0.0, 120.0, 15.0);
        steepest = std::max(steepest, std::abs(ship.pitch));
        EXPECT_LT(std::abs(ship.position[2]), 0.1);
    }
    // A line fitted to a cosine over a length l >> wave slopes by 12 / (k l^2) at most.
    EXPECT_LT(steepest, std::atan(12.5 / (k_ * 120.0 * 120.0)) * kDegrees);
    EXPECT_GT(std::atan(k_) * kDegrees, 20.0);  // slope of the waves themselves
}

TEST_F(FloatOnOneWave, RefusesABodyThatIsNone) {
    const double nan = std::nan("");
    EXPECT_THROW(pose(nan, 0.0, 1.0, 1.0), Error);
    EXPECT_THROW(pose(0.0, nan, 1.0, 1.0), Error);
    EXPECT_THROW(pose(0.0, 0.0, -1.0, 1.0), Error);
    EXPECT_THROW(pose(0.0, 0.0, 1.0, nan), Error);
    EXPECT_EQ(test::message_of([&] { pose(0.0, 0.0, 1.0, 2e5); }),
              "width = 200000; allowed: 0 .. 100000 m");
}

}  // namespace
}  // namespace ocean
