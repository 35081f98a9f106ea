// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Queries at world points against the sum over all modes, and on folded seas.
#include "ocean/query.hpp"

#include <thread>

#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/internal/wave_sum.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"
#include "wave/wave.hpp"

namespace ocean {
namespace {

constexpr double kTime = 12.0;

std::vector<WorldPoint> random_points(std::size_t count, double from, double to) {
    std::mt19937 random(7);
    const auto coordinate = [&] {
        return from + (to - from) * std::uniform_real_distribution<double>(0.0, 1.0)(random);
    };
    std::vector<WorldPoint> points(count);
    for (auto& [x, y] : points) x = coordinate(), y = coordinate();
    return points;
}

/// Returns a wind sea of that choppiness.
Parameters choppy_sea(double choppiness, int resolution, double patch) {
    return test::wind_sea(resolution, patch, {.choppiness = choppiness});
}

/// A sea, its modes and the threads that query it.
struct TestSea {
    Parameters parameters;
    ThreadPool pool{2};
    Modes modes;

    explicit TestSea(const Parameters& p) : TestSea(p, test::modes_of(p)) {}
    TestSea(const Parameters& p, Modes m) : parameters(p), modes(std::move(m)) {}

    SurfaceQuery query(const QueryOptions& options = {}, double time = kTime, FoamMap foam = {}) {
        return SurfaceQuery(modes, parameters.surface, parameters.water, time, options, pool,
                            std::move(foam));
    }
    OrbitalMotion water(double z, const QueryOptions& options = {}) {
        return OrbitalMotion(modes, parameters.water, kTime, z, options, pool);
    }
    std::vector<QuerySample> samples(const SurfaceQuery& query,
                                     const std::vector<WorldPoint>& points) {
        std::vector<QuerySample> result(points.size());
        query.sample(points, result, pool);
        return result;
    }
};

/// Displays a point by the double-precision sum: Newton's method from the point itself, sharing
/// only the equation with the query.
struct ExactSample {
    double height;
    wave::double_precision::SurfaceNormal normal;
    double velocity[3];
};
ExactSample exact_sample(const WaveSum& sum, double choppiness, WorldPoint place) {
    double x = place.x, y = place.y;
    for (int step = 0; step < 30; ++step) {
        const LinearSample at = sum.at_label(x, y);
        const double fx = x - choppiness * at.displacement_x - place.x;
        const double fy = y - choppiness * at.displacement_y - place.y;
        const double xx = 1.0 - choppiness * at.gradient_xx;
        const double yy = 1.0 - choppiness * at.gradient_yy;
        const double xy = choppiness * at.gradient_xy;
        const double j = xx * yy - xy * xy;
        x -= (yy * fx + xy * fy) / j;
        y -= (xy * fx + xx * fy) / j;
    }
    const LinearSample at = sum.at_label(x, y);
    EXPECT_NEAR(x - choppiness * at.displacement_x, place.x, 1e-9);
    EXPECT_NEAR(y - choppiness * at.displacement_y, place.y, 1e-9);
    return {at.height,
            wave::double_precision::surface_normal(choppiness, at.gradient_xx, at.gradient_yy,
                                                   at.gradient_xy, at.slope_x, at.slope_y),
            {-choppiness * at.displacement_x_rate, -choppiness * at.displacement_y_rate,
             at.height_rate}};
}

/// rms errors relative to the rms of the quantity: of the height, of the velocity vector, and of
/// the normal relative to the rms of its tilt.
struct Errors {
    double height, velocity, normal;
};
Errors errors_of(const std::vector<QuerySample>& samples, const std::vector<ExactSample>& exact) {
    double height[2] = {}, velocity[2] = {}, normal[2] = {};
    const auto add = [](double(&sum)[2], double is, double should, double still) {
        sum[0] += (is - should) * (is - should);
        sum[1] += (should - still) * (should - still);
    };
    for (std::size_t i = 0; i < samples.size(); ++i) {
        add(height, samples[i].height, exact[i].height, 0.0);
        for (int c = 0; c < 3; ++c)
            add(velocity, samples[i].velocity[c], exact[i].velocity[c], 0.0);
        add(normal, samples[i].normal[0], exact[i].normal.x, 0.0);
        add(normal, samples[i].normal[1], exact[i].normal.y, 0.0);
        add(normal, samples[i].normal[2], exact[i].normal.z, 1.0);
    }
    const auto relative = [](const double(&sum)[2]) { return std::sqrt(sum[0] / sum[1]); };
    return {relative(height), relative(velocity), relative(normal)};
}

Parameters shallow_sea() {
    Parameters parameters = choppy_sea(0.8, 64, 200.0);
    parameters.water.depth = 6.0;
    parameters.waves.front().spectrum = SpectrumKind::tma;
    return parameters;
}
Parameters looping_sea() {
    Parameters parameters = choppy_sea(0.5, 64, 300.0);
    parameters.time.loop_period = 10.0;
    return parameters;
}

class QueryAccuracy : public testing::TestWithParam<Parameters> {};

TEST_P(QueryAccuracy, IsThatOfTheSumOverAllModesToTheStatedBounds) {
    TestSea sea(GetParam());
    WaveSum sum(sea.modes, sea.parameters.water);
    sum.set_time(kTime);
    const auto points = random_points(400, -50.0, 500.0);
    std::vector<ExactSample> exact;
    for (const WorldPoint& point : points) {
        exact.push_back(exact_sample(sum, sea.parameters.surface.choppiness, point));
    }
    const auto expect = [&](const QueryOptions& options, double of_waves, double of_normals) {
        const Errors errors = errors_of(sea.samples(sea.query(options), points), exact);
        EXPECT_LT(errors.height, of_waves) << options.refine;
        EXPECT_LT(errors.velocity, of_waves) << options.refine;
        EXPECT_LT(errors.normal, of_normals) << options.refine;
    };
    expect({}, 2e-3, 2e-2);
    expect({.refine = 2}, 1e-4, 2e-3);
    expect({.exact = true}, 1e-9, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Seas, QueryAccuracy,
                         testing::Values(test::wind_sea(128, 400.0), shallow_sea(), looping_sea()));

TEST(Query, AWaveIsOffByItsAliasesAloneInHeightAndSlope) {
    constexpr int kWaves = 13;  // on 64 samples of the spline
    const Parameters parameters = choppy_sea(0.0, 32, 64.0);
    TestSea sea(parameters, test::single_wave(parameters, kWaves, 0));
    const SurfaceQuery query = sea.query({}, 0.0);
    const double k = kTwoPi * kWaves / 64.0;
    double height_error = 0.0, slope_error = 0.0;
    constexpr int kPoints = 6400;
    for (int i = 0; i < kPoints; ++i) {
        const double x = 64.0 * i / kPoints;
        const QuerySample sample = query.sample({x, 20.0});
        height_error += std::pow(sample.height - std::cos(k * x), 2);
        slope_error += std::pow(-sample.normal[0] / sample.normal[2] + k * std::sin(k * x), 2);
    }
    const double near = 13.0 / (64.0 - 13.0), far = 13.0 / (64.0 + 13.0);
    const double height = std::hypot(std::pow(near, 4), std::pow(far, 4));
    const double slope = std::hypot(std::pow(near, 3), std::pow(far, 3));
    EXPECT_NEAR(std::sqrt(height_error / kPoints * 2.0), height, 0.02 * height);
    EXPECT_NEAR(std::sqrt(slope_error / kPoints * 2.0) / k, slope, 0.02 * slope);
}

TEST(Query, RepeatsWithThePeriodHoweverFarAway) {
    TestSea sea(test::wind_sea(64, 200.0));
    const SurfaceQuery query = sea.query();
    for (const WorldPoint& near : random_points(50, 0.0, 200.0)) {
        const QuerySample here = query.sample(near);
        for (const WorldPoint shift : {WorldPoint{-200.0, 400.0}, WorldPoint{1e7, -1e7}}) {
            const WorldPoint far{near.x + shift.x, near.y + shift.y};
            const QuerySample there = query.sample(far);
            EXPECT_NEAR(there.height, here.height, 1e-6);
            EXPECT_NEAR(there.normal[0], here.normal[0], 1e-6);
            EXPECT_NEAR(there.velocity[1], here.velocity[1], 1e-6);
            EXPECT_NEAR(there.label[0] - far.x, here.label[0] - near.x, 1e-5);
            EXPECT_NEAR(there.label[1] - far.y, here.label[1] - near.y, 1e-5);
        }
    }
    const QuerySample edge = query.sample({-1e-300, std::nextafter(200.0, 0.0)});
    EXPECT_NEAR(edge.height, query.sample({0.0, 0.0}).height, 1e-5);
    EXPECT_TRUE(std::isfinite(query.sample({1e300, -1e300}).height));
}

TEST(Query, SaysTheErrorOfItsHeights) {
    TestSea sea(choppy_sea(0.0, 128, 200.0));  // so that labels are places
    WaveSum sum(sea.modes, sea.parameters.water);
    const auto points = random_points(300, 0.0, 200.0);
    for (const QueryOptions& options :
         {QueryOptions{}, QueryOptions{.refine = 2}, QueryOptions{.resolution = 32},
          QueryOptions{.exact = true, .resolution = 64}}) {
        double error = 0.0, said = 0.0;
        // Over times far apart: the error is one of the sea.
        for (const double time : {0.0, 100.0, 200.0, 300.0, 400.0}) {
            const SurfaceQuery query = sea.query(options, time);
            sum.set_time(time);
            said = query.height_error();
            for (const WorldPoint& point : points) {
                const double exact = sum.at_label(point.x, point.y).height;
                error += std::pow(query.sample(point).height - exact, 2);
            }
        }
        error = std::sqrt(error / 5.0 / static_cast<double>(points.size()));
        EXPECT_NEAR(error, said, 0.2 * said) << options.refine << ", " << options.resolution;
    }
    EXPECT_EQ(sea.query({.exact = true}).height_error(), 0.0);
}

/// All that a sample says.
void expect_same(const QuerySample& a, const QuerySample& b) {
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(0, std::memcmp(a.normal, b.normal, sizeof(a.normal)));
    EXPECT_EQ(0, std::memcmp(a.velocity, b.velocity, sizeof(a.velocity)));
    EXPECT_EQ(0, std::memcmp(a.label, b.label, sizeof(a.label)));
    EXPECT_EQ(a.foam, b.foam);
    EXPECT_EQ(a.folded, b.folded);
    EXPECT_EQ(a.undecided, b.undecided);
}

TEST(Query, HasTheSameBitsForAnyNumberOfThreadsOnePointAloneAndSeveralThreadsAtOnce) {
    const Parameters parameters = choppy_sea(3.0, 64, 60.0);
    TestSea sea(parameters);
    const auto points = random_points(3000, -100.0, 100.0);
    const SurfaceQuery query = sea.query();
    const auto expected = sea.samples(query, points);
    for (const int threads : {1, 3, 5}) {
        ThreadPool pool(threads);
        const SurfaceQuery other(sea.modes, parameters.surface, parameters.water, kTime, {}, pool);
        std::vector<QuerySample> samples(points.size());
        other.sample(points, samples, pool);
        for (std::size_t i = 0; i < points.size(); ++i) {
            expect_same(samples[i], expected[i]);
            if (i % 100 == 0) expect_same(other.sample(points[i]), expected[i]);
        }
    }
    std::vector<QuerySample> samples(400);
    std::vector<std::thread> threads;
    for (std::size_t thread = 0; thread < 4; ++thread) {
        threads.emplace_back([&, thread] {
            for (std::size_t i = thread; i < 400; i += 4) samples[i] = query.sample(points[i]);
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < 400; ++i) expect_same(samples[i], expected[i]);
}

TEST(Query, OfOnePointMakesAFewColumnsToTheSameBits) {
    for (const double choppiness : {0.0, 1.0, 3.0}) {
        TestSea sea(choppy_sea(choppiness, 128, 400.0));
        const auto points = random_points(40, -500.0, 500.0);
        const auto together = sea.samples(sea.query(), points);
        // The first sample at kTime finds that the strips of another place are needed too, the next
        // ones need others.
        SurfaceQuery one_by_one = sea.query({}, 0.0);
        one_by_one.sample(points.back());
        one_by_one.move_to(sea.modes, sea.parameters.surface, sea.parameters.water, kTime,
                           sea.pool);
        for (std::size_t i = 0; i < points.size(); ++i) {
            expect_same(sea.query().sample(points[i]), together[i]);
            expect_same(one_by_one.sample(points[i]), together[i]);
        }
    }
}

TEST(Query, MovesToOtherTimesAndModesToTheBitsOfANewOne) {
    TestSea sea(test::wind_sea(64, 200.0));
    sea.modes.revision = Revision::begin();
    TestSea other(test::wind_sea(64, 300.0));
    TestSea larger(test::wind_sea(128, 200.0));
    larger.modes.revision = Revision::begin();
    const auto points = random_points(200, 0.0, 200.0);
    SurfaceQuery query = sea.query({.refine = 2}, 0.0);
    const auto expect_move_to = [&](TestSea& to, double time) {
        query.move_to(to.modes, to.parameters.surface, to.parameters.water, time, to.pool);
        const auto moved = to.samples(query, points);
        const auto made = to.samples(to.query({.refine = 2}, time), points);
        for (std::size_t i = 0; i < points.size(); ++i) expect_same(moved[i], made[i]);
    };
    expect_move_to(sea, 3.0);
    sea.parameters.surface.choppiness = 2.5;
    expect_move_to(sea, 3.0);
    Parameters storm = test::wind_sea(64, 200.0, {.wind = 20.0});
    TestSea stormy(storm);
    stormy.modes.revision = Revision::begin();
    expect_move_to(stormy, 5.0);
    expect_move_to(other, 5.0);
    expect_move_to(larger, 7.0);
    expect_move_to(sea, 1e6);
}

/// A copy of a sea begins where that is, and each changes for itself.
TEST(Query, CopiesOfASeaHaveItsRevisionUntilOneChanges) {
    Ocean first(test::wind_sea(32, 200.0));
    const Revision before = first.modes().revision;
    Ocean second(first, {});
    EXPECT_TRUE(second.modes().revision == before);
    first.set("wind_speed", "12");
    second.set("wind_speed", "18");
    EXPECT_FALSE(first.modes().revision == before);
    EXPECT_FALSE(second.modes().revision == before);
    EXPECT_FALSE(first.modes().revision == second.modes().revision);
    EXPECT_TRUE(first.modes().lattice_revision == second.modes().lattice_revision);
    EXPECT_FALSE(Revision() == Revision());
    // Oceans that were built alike have counted as many changes.
    EXPECT_FALSE(Ocean(test::wind_sea(32, 200.0)).modes().revision == before);
}

class FoldedWave : public testing::TestWithParam<int> {};

TEST_P(FoldedWave, ShowsTheTopOfItsLoop) {
    // h = cos(k a) is shown at a - C D with D = sin(k a): folded where C k cos(k a) > 1.
    constexpr double kPeriod = 64.0;
    const double k = kTwoPi * 2.0 / kPeriod, c = 3.0 / k;
    const Parameters parameters = choppy_sea(c, GetParam(), kPeriod);
    TestSea sea(parameters, test::single_wave(parameters, 2, 0));
    const SurfaceQuery query = sea.query({}, 0.0);
    int folded = 0;
    for (int i = 0; i < 500; ++i) {
        const double x = kPeriod * (i + 0.5) / 500;
        // All labels: where a - C sin(k a) - x changes its sign between neighbours of a fine list.
        double top = -2.0;
        int labels = 0;
        const auto off = [&](double a) { return a - c * std::sin(k * a) - x; };
        constexpr double kStep = 0.02;
        for (double a = -kPeriod; a < 2.0 * kPeriod; a += kStep) {
            const double left = off(a), right = off(a + kStep);
            if ((left < 0.0) == (right < 0.0)) continue;
            ++labels;
            top = std::max(top, std::cos(k * (a + kStep * left / (left - right))));
        }
        const QuerySample sample = query.sample({x, 11.0});
        EXPECT_NEAR(sample.height, top, 2e-3) << "at x = " << x;
        EXPECT_EQ(sample.folded, labels > 1) << "at x = " << x;
        EXPECT_GE(sample.normal[2], 0.0);
        folded += labels > 1 ? 1 : 0;
    }
    EXPECT_GT(folded, 100);
    EXPECT_LT(folded, 500);
}

// On the finer map a block of points is small compared with the displacement of labels.
INSTANTIATE_TEST_SUITE_P(Maps, FoldedWave, testing::Values(64, 256));

/// Returns the Jacobian of the displayed surface, by differences.
double jacobian_at(const SurfaceQuery& query, WorldPoint label) {
    constexpr double kStep = 0.01;
    const WorldPoint a = query.shown(label);
    const WorldPoint b = query.shown({label.x + kStep, label.y});
    const WorldPoint c = query.shown({label.x, label.y + kStep});
    return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / (kStep * kStep);
}

TEST(Query, OfAFoldedSeaHasNothingShownAboveIt) {
    TestSea sea(choppy_sea(4.0, 128, 100.0));
    const SurfaceQuery query = sea.query();
    Parameters calm = sea.parameters;
    calm.surface.choppiness = 0.0;
    TestSea by_label(calm, sea.modes);
    const SurfaceQuery heights = by_label.query();
    int hidden = 0, inside_out = 0;
    for (const WorldPoint& label : random_points(50000, 0.0, 100.0)) {
        const double jacobian = jacobian_at(query, label);
        // The very edge of a fold is left out: its labels are shown within a millimetre of places
        // where they are not.
        if (std::abs(jacobian) < 0.1) continue;
        const double height = heights.sample(label).height;
        const QuerySample top = query.sample(query.shown(label));
        EXPECT_GT(top.height, height - 1e-3);
        hidden += top.height > height + 0.01 ? 1 : 0;
        inside_out += jacobian < 0.0 ? 1 : 0;
        EXPECT_TRUE(top.folded || jacobian > 0.0);
    }
    EXPECT_GT(hidden, 50);
    EXPECT_GT(inside_out, 50);
}

class FoldedQuery : public testing::TestWithParam<double> {};

TEST_P(FoldedQuery, FindsALabelThatIsShownAtThePointEverywhere) {
    Parameters parameters = choppy_sea(4.0, 128, 100.0);
    parameters.waves.front().significant_wave_height = GetParam();
    TestSea sea(parameters);
    const SurfaceQuery query = sea.query();
    for (const WorldPoint& point : random_points(20000, -1000.0, 1000.0)) {
        const QuerySample sample = query.sample(point);
        const WorldPoint shown = query.shown({sample.label[0], sample.label[1]});
        EXPECT_LT(std::hypot(shown.x - point.x, shown.y - point.y), 2.1e-6 * query.reach());
        const double* n = sample.normal;
        EXPECT_NEAR(std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), 1.0, 1e-9);
        EXPECT_TRUE(std::isfinite(sample.velocity[0] + sample.velocity[1] + sample.velocity[2]));
    }
}

INSTANTIATE_TEST_SUITE_P(Heights, FoldedQuery, testing::Values(2.0, 15.0));

TEST(Query, OfASeaBeyondAllSenseEndsAndIsFinite) {
    Parameters parameters = choppy_sea(4.0, 64, 10.0);
    parameters.waves.front().significant_wave_height = 100.0;
    TestSea sea(parameters);
    for (const QuerySample& sample : sea.samples(sea.query(), random_points(300, 0.0, 10.0))) {
        EXPECT_TRUE(std::isfinite(sample.height + sample.label[0] + sample.velocity[0]));
        EXPECT_TRUE(std::isfinite(sample.normal[0] + sample.normal[1] + sample.normal[2]));
        EXPECT_TRUE(sample.undecided);  // the lists of labels there would exceed the map
    }
    sea.parameters.surface.choppiness = 0.2;
    int folded = 0;
    for (const QuerySample& sample : sea.samples(sea.query(), random_points(300, 0.0, 10.0))) {
        EXPECT_FALSE(sample.undecided);
        folded += sample.folded ? 1 : 0;
    }
    EXPECT_GT(folded, 20);
}

TEST(Query, OfAFlatSeaIsFlat) {
    Parameters parameters = test::wind_sea(32, 64.0, {.wind = 0.0});
    TestSea sea(parameters);
    const QuerySample sample = sea.query().sample({3.0, -7.0});
    EXPECT_EQ(sample.height, 0.0);
    EXPECT_EQ(sample.normal[2], 1.0);
    EXPECT_EQ(sample.label[0], 3.0);
    EXPECT_EQ(sample.label[1], -7.0);
    EXPECT_FALSE(sample.folded);
}

TEST(Query, ShowsOnlyTheWavesOfTheMapThatIsShown) {
    TestSea sea(choppy_sea(0.0, 128, 200.0));
    WaveSum coarse(sea.modes, sea.parameters.water, 32);
    WaveSum fine(sea.modes, sea.parameters.water);
    coarse.set_time(kTime);
    fine.set_time(kTime);
    const SurfaceQuery query = sea.query({.refine = 4, .resolution = 32});
    const SurfaceQuery exact = sea.query({.exact = true, .resolution = 32});
    EXPECT_EQ(query.spacing(), 200.0 / 32);
    double difference = 0.0;
    for (const WorldPoint& point : random_points(50, 0.0, 200.0)) {
        const double height = coarse.at_label(point.x, point.y).height;
        EXPECT_NEAR(query.sample(point).height, height, 1e-4);
        EXPECT_NEAR(exact.sample(point).height, height, 1e-12);
        const double whole = fine.at_label(point.x, point.y).height;
        difference = std::max(difference, std::abs(height - whole));
    }
    EXPECT_GT(difference, 0.05);
}

TEST(Query, FoamIsInterpolatedAtTheLabelAndRepeats) {
    TestSea sea(choppy_sea(0.0, 32, 64.0));
    FoamMap foam{std::vector<float>(32 * 32, 0.0f), 32};
    foam.values[5 * 32 + 31] = 1.0f;  // at (62, 10); its neighbour to the east is at x = 0
    const SurfaceQuery query = sea.query({}, kTime, foam);
    EXPECT_EQ(query.sample({62.0, 10.0}).foam, 1.0);
    EXPECT_EQ(query.sample({63.0, 10.0}).foam, 0.5);
    EXPECT_EQ(query.sample({-1.0, 11.0 + 640.0}).foam, 0.25);
    EXPECT_EQ(query.sample({0.0, 10.0}).foam, 0.0);
    EXPECT_EQ(sea.query().sample({62.0, 10.0}).foam, 0.0);
    EXPECT_EQ(sea.query({.foam = false}, kTime, foam).sample({62.0, 10.0}).foam, 0.0);

    sea.parameters.surface.choppiness = 1.0;
    for (const auto [i, j, at] : test::cells(32, 32)) {
        foam.values[at] = static_cast<float>(0.5 + 0.5 * std::cos(kTwoPi * i / 32.0));
    }
    const SurfaceQuery choppy = sea.query({}, kTime, foam);
    for (const WorldPoint& point : random_points(50, 0.0, 64.0)) {
        const QuerySample sample = choppy.sample(point);
        EXPECT_NEAR(sample.foam, 0.5 + 0.5 * std::cos(kTwoPi * sample.label[0] / 64.0), 3e-3);
    }
}

TEST(Query, RefusesWhatItCannotAnswerAndWritesNothing) {
    TestSea sea(test::wind_sea(32, 64.0));
    const auto message = [&](const QueryOptions& options) {
        const test::Refusal refusal = test::refusal_of([&] { sea.query(options); });
        EXPECT_EQ(refusal.kind, ErrorKind::invalid_value);
        return refusal.message;
    };
    EXPECT_EQ(message({.refine = 3}),
              "refine = 3; allowed for a map of 32 x 32 samples: a power of two, 1 .. 128");
    for (const int refine : {0, -2, 256}) EXPECT_NE(message({.refine = refine}), "") << refine;
    EXPECT_NE(message({.refine = 2, .resolution = 4096}), "");
    EXPECT_EQ(message({.resolution = 33}), "resolution = 33; allowed: a power of two, 32 .. 8192");
    EXPECT_THROW(sea.query({}, std::nan("")), Error);
    EXPECT_THROW(sea.query({.exact = true}, std::nan("")), Error);
    EXPECT_THROW(sea.water(std::numeric_limits<double>::infinity()), Error);
    EXPECT_THROW(OrbitalMotion(sea.modes, sea.parameters.water, std::nan(""), 0.0, {.exact = true},
                               sea.pool),
                 Error);

    const SurfaceQuery query = sea.query();
    std::vector<WorldPoint> points = {{1.0, 2.0}, {3.0, std::nan("")}};
    std::vector<QuerySample> samples(2);
    samples[0].height = 77.0;
    EXPECT_EQ(test::message_of([&] { query.sample(points, samples, sea.pool); }),
              "point 1 = (3, nan); allowed: finite coordinates in metres");
    EXPECT_EQ(samples[0].height, 77.0);
    query.sample({}, {}, sea.pool);
}

/// Returns the rms of the difference, relative to that of the second.
double relative_difference(const std::vector<WaterMotion>& a, const std::vector<WaterMotion>& b,
                           double WaterMotion::*component) {
    std::vector<double> error, size;
    for (std::size_t i = 0; i < a.size(); ++i) {
        error.push_back(a[i].*component - b[i].*component);
        size.push_back(b[i].*component);
    }
    return test::rms(error) / test::rms(size);
}

constexpr double WaterMotion::*kMotion[] = {&WaterMotion::velocity_x, &WaterMotion::velocity_y,
                                            &WaterMotion::velocity_z, &WaterMotion::pressure};

TEST(OrbitalMotion, OfASeaIsThatOfTheSumOverAllModes) {
    for (const double depth : {12.0, std::numeric_limits<double>::infinity()}) {
        for (const double loop_period : {0.0, 20.0}) {
            Parameters parameters =
                test::wind_sea(128, 400.0, {.depth = depth, .loop = loop_period});
            TestSea sea(parameters);
            WaveSum sum(sea.modes, parameters.water);
            sum.set_time(kTime);
            for (const double z : {-10.0, -2.0, 0.0, 1.5}) {
                const auto points = random_points(100, 0.0, 400.0);
                std::vector<WaterMotion> motions(points.size()), summed(points.size()), expected;
                for (const auto& [x, y] : points) expected.push_back(sum.water_motion(x, y, z));
                sea.water(z).sample(points, motions, sea.pool);
                sea.water(z, {.exact = true}).sample(points, summed, sea.pool);
                for (const auto component : kMotion) {
                    EXPECT_LT(relative_difference(motions, expected, component), 2e-3)
                        << "at z = " << z;
                    EXPECT_LT(relative_difference(summed, expected, component), 1e-12);
                }
            }
        }
    }
}

TEST(OrbitalMotion, MovedToAnotherTimeDepthOrSeaIsAsMadeAnew) {
    Parameters parameters = test::wind_sea(64, 200.0, {.depth = 30.0});
    TestSea sea(parameters);
    parameters.waves.front().wind_speed = 14.0;
    TestSea windier(parameters);
    parameters.water.depth = 40.0;
    TestSea deeper(parameters);
    const auto points = random_points(50, 0.0, 200.0);
    for (const bool exact : {false, true}) {
        const QueryOptions options{.exact = exact};
        OrbitalMotion moved = sea.water(-3.0, options);
        const auto expect_as_anew = [&](TestSea& other, double time, double z) {
            const OrbitalMotion anew(other.modes, other.parameters.water, time, z, options,
                                     other.pool);
            moved.move_to(other.modes, other.parameters.water, time, z, other.pool);
            for (const WorldPoint& p : points) EXPECT_EQ(moved.sample(p), anew.sample(p)) << z;
        };
        expect_as_anew(sea, kTime, -3.0);
        expect_as_anew(sea, kTime + 1.0, -3.0);
        expect_as_anew(sea, kTime, -1.0);
        expect_as_anew(windier, kTime, -1.0);
        expect_as_anew(windier, kTime, -31.0);  // below the bottom
        expect_as_anew(windier, kTime, -29.0);
        expect_as_anew(deeper, kTime, -29.0);
    }
}

TEST(OceanQuery, AnswersPointsOfAnyDepthsInTheirOrder) {
    Parameters parameters = test::wind_sea(64, 200.0, {.depth = 20.0});
    Ocean ocean(parameters, {.threads = 1});
    const double depths[] = {-4.0, 1.0, 0.0, -25.0, -4.0};
    std::vector<WaterPoint> points;
    for (const WorldPoint& p : random_points(40, -300.0, 300.0)) {
        points.push_back({p.x, p.y, depths[points.size() % 5]});
    }
    std::vector<WaterMotion> motions(points.size());
    ocean.water_motion(kTime, points, motions);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const OrbitalMotion alone(ocean.modes(), parameters.water, kTime, points[i].z, {},
                                  *std::make_unique<ThreadPool>(1));
        EXPECT_EQ(motions[i], alone.sample({points[i].x, points[i].y}));
    }
    const std::vector<WaterMotion> before = motions;
    for (const WaterPoint& bad :
         {WaterPoint{std::nan(""), 0.0, 0.0}, WaterPoint{0.0, 0.0, std::nan("")},
          WaterPoint{0.0, std::numeric_limits<double>::infinity(), 0.0}}) {
        points[7] = bad;
        EXPECT_THROW(ocean.water_motion(kTime, points, motions), Error);
        EXPECT_EQ(motions, before);
    }
}

}  // namespace
}  // namespace ocean
