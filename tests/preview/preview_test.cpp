// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: the renderer draws the sea: its heights, its slopes and the roughness that they leave to
// the light, from every place and at every distance.
#include <chrono>
#include <thread>

#include "gl/leftovers.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/preview/probe.hpp"
#include "ocean/internal/water_types.hpp"
#include "preview/shown_maps.hpp"
#include "preview_fixture.hpp"
#include "sky.hpp"
#include "wave/wave.hpp"

namespace ocean::preview {
namespace {

int largest_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

/// Straight down on a square of twice its height a side.
Camera above(double x, double y, double height) {
    return {.eye = {x, y, height}, .heading = 0.0, .pitch = -90.0, .field_of_view = 90.0};
}

TEST_F(PreviewTest, TheDrawnHeightIsTheQuerys) {
    Ocean sea(two_cascades());
    const SeaState state = sea.state();
    const double time = 31.7;
    const auto every_mode = static_cast<int>(complete_map_resolution(sea.parameters().grid));
    struct Case {
        bool compute;
        int cascade_resolution;
    };
    for (const auto& [compute, resolution] : {Case{false, 128}, {true, 128}, {false, 512}}) {
        SeaMaps maps({.compute = compute, .cascade_resolution = resolution});
        Renderer renderer({.cells = 64});
        const DrawnSea shown = maps.show(sea, time);
        const Camera camera{.eye = {123.4, -56.7, 6.0}};
        const double rms_slope = std::sqrt(state.mean_square_slope.resolved);
        double half_texel_slope = 0.0;  // of each cascade, added up
        for (std::size_t c = 0; c < shown.cascades.size(); ++c) {
            half_texel_slope += 0.5 * shown.cascades[c].period / shown.cascades[c].maps.resolution *
                                rms_slope * std::sqrt(state.cascades[c].slope);
        }
        const double texel = shown.cascades.back().period / shown.cascades.back().maps.resolution;
        const double least = 1e-3 * shown.significant_wave_height;

        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        double farthest = 0.0;
        double squares = 0.0;
        int near = 0;
        for (int i = 0; i < 200; ++i) {
            const double distance = 0.5 * std::pow(kPeriod * 0.97 / 0.5, unit(random));
            const double angle = kTwoPi * unit(random);
            const WorldPoint place{camera.eye[0] + distance * std::cos(angle),
                                   camera.eye[1] + distance * std::sin(angle)};
            QuerySample expected;
            sea.query(time, {&place, 1}, {&expected, 1}, {.foam = false, .resolution = every_mode});
            const auto found = probe(renderer, shown, camera, {place.x, place.y});
            ASSERT_TRUE(found) << distance;
            const double slope = std::sqrt(1.0 / (expected.normal[2] * expected.normal[2]) - 1.0);
            const double steep = std::max(1.0, slope / rms_slope);
            // A cell of the mesh is seen under 1/32 to 1/64: within it labels are interpolated, and
            // waves that it cannot hold are left to the light.
            const double cell = std::max(texel, distance / 32.0);
            const double bound = least + steep * (half_texel_slope + 0.5 * cell * rms_slope);
            EXPECT_NEAR(found->map_height, expected.height, bound) << distance;
            EXPECT_NEAR(found->mesh_height, expected.height, bound) << distance;
            farthest = std::max(farthest, distance);
            if (distance < 5.0) {
                const double difference = found->map_height - expected.height;
                squares += difference * difference;
                ++near;
            }
        }
        EXPECT_GT(farthest, 0.8 * kPeriod);
        EXPECT_GT(near, 40);
        // Finer maps are the query's surface.
        if (resolution == 512) {
            EXPECT_LT(std::sqrt(squares / near), 2.0 * least);
        }
    }
}

TEST_F(PreviewTest, ShownAndHandedOnSlopesAreTheSeasWithDetailAndWithout) {
    Parameters parameters = two_cascades();
    parameters.surface.choppiness = 0.0;
    Ocean sea(parameters);
    SeaMaps maps({.compute = false, .detail = true});
    Renderer renderer({.cells = 8});  // pixels read slopes, whatever the mesh
    const DrawnSea shown = maps.show(sea, 12.0);
    ASSERT_GE(shown.tiles.size(), 2u);
    DrawnSea bare = shown;
    bare.tiles.clear();
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(0.0, kPeriod);
    struct Sum {
        double shown = 0.0, handed_on = 0.0;
    };
    for (const double height : {1.0, 10.0, 100.0, 1000.0, 3000.0, 10000.0}) {
        // All of a period; of so many pictures as there are from 1 m, places in it.
        const int beside = std::max(1, static_cast<int>(kPeriod / (2.0 * height)));
        const int pictures = std::min(beside * beside, 400);
        Sum with, without;
        std::size_t pixels = 0;
        for (int i = 0; i < pictures; ++i) {
            const double step = kPeriod / beside;
            const bool some = pictures < beside * beside;
            const double x = some ? unit(random) : (i % beside + 0.5) * step;
            const double y = some ? unit(random) : (i / beside + 0.5) * step;
            for (const bool detailed : {true, false}) {
                Sum& sum = detailed ? with : without;
                const auto values =
                    numbers(renderer, detailed ? shown : bare, above(x, y, height), 48);
                for (std::size_t p = 0; p < values.size(); p += 4) {
                    sum.shown += values[p + 2];
                    sum.handed_on += values[p + 3];
                    pixels += detailed ? 1 : 0;
                }
            }
        }
        const double asked = shown.mean_square_slope * static_cast<double>(pixels);
        const double all = with.shown + with.handed_on;
        const double all_without = without.shown + without.handed_on;
        EXPECT_NEAR((all - all_without) / asked, 0.0, 0.01) << height;
        if (height > 1.0) {
            EXPECT_NEAR(all / asked, 1.0, 0.01) << height;
        }
        if (height == 1.0) {  // pixels of 4 cm
            EXPECT_LT(with.handed_on, 0.9 * without.handed_on);
        }
        if (height == 10.0) {
            const double handed_on =
                (shown.mean_square_slope - test::map_slope(shown)) * static_cast<double>(pixels);
            EXPECT_GT(without.shown, 0.6 * (all_without - handed_on));
        }
        if (height >= 1000.0) {
            EXPECT_EQ(with.shown, without.shown);
        }
        if (height >= 3000.0) {
            EXPECT_LT(without.shown, 0.05 * all_without);
        }
    }
}

TEST_F(PreviewTest, TheDetailOfALabelIsThatOfTheTilesEverywhere) {
    Ocean sea(two_cascades());
    SeaMaps maps({.compute = false, .detail = true});
    Renderer renderer({.cells = 32});
    DrawnSea shown = maps.show(sea, 12.0);
    for (DrawnCascade& cascade : shown.cascades) cascade.weight = 0.0;  // nothing else has slopes
    shown.tiles.resize(1);
    const DrawnTile& tile = shown.tiles[0];
    const auto side = static_cast<std::size_t>(tile.samples);
    const std::vector<float> slopes = test::layer_texels(tile.texture, tile.layer, 0, GL_RG, 2);
    const auto slope_at = [&](double u, double v, std::size_t component) {
        const double x = (u - std::floor(u)) * tile.samples, y = (v - std::floor(v)) * tile.samples;
        const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
        const double a = x - static_cast<double>(i), b = y - static_cast<double>(j);
        const auto texel = [&](std::size_t p, std::size_t q) {
            return static_cast<double>(slopes[2 * ((q % side) * side + p % side) + component]);
        };
        return (1.0 - b) * ((1.0 - a) * texel(i, j) + a * texel(i + 1, j)) +
               b * ((1.0 - a) * texel(i, j + 1) + a * texel(i + 1, j + 1));
    };
    for (const double far : {0.0, 3e6}) {
        const double first = std::floor(far / tile.tile);
        double squares = 0.0, differences = 0.0;
        for (int n = 0; n < 40; ++n) {
            const double u = first + 0.37 * n, v = 0.61 * n - first;
            double expected[2] = {};
            for (int corner = 0; corner < 3; ++corner) {
                const auto read = wave::double_precision::slope_tile_read(u, v, corner);
                for (const std::size_t c : {0, 1}) {
                    expected[c] += read.weight * slope_at(read.x, read.y, c);
                }
            }
            const auto found =
                numbers(renderer, shown, above(u * tile.tile, v * tile.tile, 0.02), 3);
            const double size = std::hypot(expected[0], expected[1]);
            squares += size * size;
            differences += std::pow(std::sqrt(static_cast<double>(found[4 * 4 + 2])) - size, 2);
        }
        EXPECT_LT(std::sqrt(differences / squares), 0.02) << far;
    }
}

TEST_F(PreviewTest, NearWaterIsNoSilk) {
    Parameters parameters = test::wind_sea(512, 230.0);
    parameters.waves.front().wind_speed = 6.7;
    Ocean sea(parameters, {.foam_start = FoamStart::empty});
    SeaMaps maps({.compute = false, .cascade_resolution = 512, .detail = true});
    Renderer renderer({.cells = 64});
    const Camera camera{.eye = {0.0, 0.0, 1.6}, .heading = 30.0, .pitch = -4.0};
    const Look look{.foam_amount = 0.0};
    constexpr int kWidth = 640, kHeight = 360;
    const auto fine_contrast = [&](const DrawnSea& shown) {
        const auto rgb = picture(renderer, shown, camera, look, kWidth, kHeight);
        double squares = 0.0;
        int count = 0;
        for (int y = 4; y < kHeight / 2 - 4; ++y) {  // the bottom row comes first
            for (int x = 4; x + 4 < kWidth; ++x) {
                const auto at = [&](int i, int j) {
                    return static_cast<double>(
                        rgb[3 * static_cast<std::size_t>(j * kWidth + i) + 1]);
                };
                double mean = 0.0;
                for (int j = -4; j <= 4; ++j) {
                    for (int i = -4; i <= 4; ++i) mean += at(x + i, y + j) / 81.0;
                }
                squares += std::pow(at(x, y) - mean, 2);
                ++count;
            }
        }
        return std::sqrt(squares / count);
    };
    const DrawnSea shown = maps.show(sea, 4.0);
    DrawnSea bare = shown;
    bare.tiles.clear();
    const double with = fine_contrast(shown), without = fine_contrast(bare);
    RecordProperty("with", std::to_string(with));
    RecordProperty("without", std::to_string(without));
    EXPECT_GT(with, 3.0 * without) << with << " and " << without;
}

/// Returns the mean cover by the last level of the mipmaps.
double mean_cover(const DrawnSea& shown) {
    float mean = 0.0f;
    glBindTexture(GL_TEXTURE_2D, shown.covers[0].texture);
    const int last = static_cast<int>(std::lround(std::log2(shown.covers[0].resolution)));
    glGetTexImage(GL_TEXTURE_2D, last, GL_RED, GL_FLOAT, &mean);
    return static_cast<double>(mean);
}

double mean_cover(Ocean& sea, double time, int resolution) {
    const Surface map = sea.evaluate(time, {Channel::cover}, resolution);
    double sum = 0.0;
    for (const float cover : map.channel(Channel::cover)) sum += static_cast<double>(cover);
    return sum / (static_cast<double>(resolution) * resolution);
}

TEST_F(PreviewTest, AsMuchIsCoveredAsTheSeaSaysFromAnyDistance) {
    constexpr int kResolution = 128;
    Parameters parameters = two_cascades();
    parameters.waves.front().wind_speed = 17.0;
    Ocean sea(parameters);
    for (const bool compute : {false, true}) {
        // Shaders show the foam of the clock's last tick: between ticks it lacks the newest.
        const double time = compute ? 70.0 * parameters.surface.foam_step : 7.3;
        const double expected = mean_cover(sea, time, kResolution);
        EXPECT_GT(expected, 0.01);
        SeaMaps maps(
            {.compute = compute, .foam_resolution = kResolution, .foam_start = FoamStart::settled});
        const DrawnSea shown = maps.show(sea, time);
        ASSERT_EQ(shown.covers.size(), 1u);
        glBindTexture(GL_TEXTURE_2D, shown.covers[0].texture);
        for (int level = 0; kResolution >> level > 0; ++level) {
            const auto side = static_cast<std::size_t>(kResolution >> level);
            std::vector<float> texels(side * side);
            glGetTexImage(GL_TEXTURE_2D, level, GL_RED, GL_FLOAT, texels.data());
            double mean = 0.0;
            for (const float texel : texels) mean += static_cast<double>(texel);
            mean /= static_cast<double>(texels.size());
            EXPECT_NEAR(mean / expected, 1.0, 0.02) << compute << ", level " << level;
        }
    }
}

TEST_F(PreviewTest, ALivePictureDoesNotWaitForItsCover) {
    Ocean sea(two_cascades());
    SeaMaps maps({.compute = false, .foam_resolution = 128, .live = true});
    for (const char* wind : {"20", "14", "24"}) {
        sea.set("wind_speed", wind);
        Ocean same(sea, {});
        const double expected = mean_cover(same, 6.0, 128);
        maps.show(sea, 6.0);
        // A solution that is in work belongs to the wind before: the next picture requests this
        // one.
        for (Pending pending; (pending = maps.pending()) != Pending::nothing;) {
            if (pending == Pending::ready) maps.show(sea, 6.0);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        const double found = mean_cover(maps.show(sea, 6.0));
        EXPECT_EQ(sea.stage_runs().cover_power, 0);
        EXPECT_NEAR(found / expected, 1.0, 0.02) << wind;
    }
}

TEST_F(PreviewTest, ThePictureHasNoHole) {
    Ocean sea(two_cascades());
    SeaMaps maps({.compute = false});
    Renderer renderer({.cells = 32});
    const DrawnSea shown = maps.show(sea, 5.0);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> place(-1000.0, 1000.0);
    for (const double height : {6.0, 40.0, 700.0, 20000.0}) {
        for (int i = 0; i < 6; ++i) {
            // So wide that it sees where levels of the mesh meet.
            Camera camera = above(place(random), place(random), height);
            camera.field_of_view = 145.0;
            const auto values = numbers(renderer, shown, camera, 201);
            int holes = 0;
            for (std::size_t p = 3; p < values.size(); p += 4) holes += values[p] <= 0.0f ? 1 : 0;
            EXPECT_EQ(holes, 0) << height << " m over " << camera.eye[0] << ", " << camera.eye[1];
        }
    }
}

TEST_F(PreviewTest, WaterStandsStillWhileTheEyeMoves) {
    Ocean sea(two_cascades());
    SeaMaps maps({.compute = false});
    Renderer renderer({.cells = 64});
    const DrawnSea shown = maps.show(sea, 5.0);
    const double bound = 1e-3 * shown.significant_wave_height;
    const auto height_from = [&](double x, double y) {
        return probe(renderer, shown, {.eye = {x, y, 4.0}}, {10.0, 20.0})->mesh_height;
    };
    // Within the finest level nothing is morphed: 3/4 of 64 cells of .39 m or more.
    const double first = height_from(10.0, 20.0);
    for (const auto& [x, y] : {std::pair{13.37, 20.0}, {4.1, 27.9}, {21.0, 11.0}, {10.1, 31.7}}) {
        EXPECT_NEAR(height_from(x, y), first, bound) << x << ", " << y;
    }
    // Away from it, through several levels: it changes, but never at once.
    double before = first;
    double change = 0.0;
    double largest = 0.0;
    for (double distance = 1.0; distance < 300.0; distance *= 1.01) {
        const double now = height_from(10.0 + distance, 20.0);
        largest = std::max(largest, std::abs(now - before));
        change = std::max(change, std::abs(now - first));
        before = now;
    }
    EXPECT_GT(change, 10.0 * bound);
    EXPECT_LT(largest, 10.0 * bound);
}

TEST_F(PreviewTest, WholePeriodsAndLoopsLaterThePictureIsTheSame) {
    Parameters parameters = two_cascades();
    parameters.time.loop_period = 20.0;
    Ocean sea(parameters);
    SeaMaps maps({.compute = false});
    Renderer renderer({.cells = 32});
    Camera camera{.eye = {17.3, -40.2, 12.0}, .heading = 70.0, .pitch = -25.0};
    const Look look{.foam_amount = 0.0};  // its pattern has another period
    const auto shown = [&](double time) {
        return picture(renderer, maps.show(sea, time), camera, look);
    };
    const auto here = shown(3.0);
    camera.eye[0] += 2500.0 * kPeriod;
    camera.eye[1] -= 2500.0 * kPeriod;
    EXPECT_LE(largest_difference(shown(3.0), here), 1);
    EXPECT_LE(largest_difference(shown(1000003.0), here), 1);
    EXPECT_GT(largest_difference(shown(4.0), here), 20);
}

/// Returns the correlation of heights one period apart, both more than two periods from the eye.
double correlation_at_a_period(const std::vector<float>& values, int side, int pixels_a_period) {
    double product = 0.0;
    double square = 0.0;
    const double middle = 0.5 * (side - 1);
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i + pixels_a_period < side; ++i) {
            const auto far = [&](int x) {
                return std::hypot(x - middle, j - middle) > 2.0 * pixels_a_period;
            };
            if (!far(i) || !far(i + pixels_a_period)) continue;
            const auto at = [&](int x) {
                return static_cast<double>(values[4 * static_cast<std::size_t>(j * side + x) + 1]);
            };
            product += at(i) * at(i + pixels_a_period);
            square += 0.5 * (at(i) * at(i) + at(i + pixels_a_period) * at(i + pixels_a_period));
        }
    }
    return product / square;
}

TEST_F(PreviewTest, TheFarSeaDoesNotRepeat) {
    Parameters parameters = two_cascades();
    parameters.surface.choppiness = 0.0;
    Ocean sea(parameters);
    SeaMaps maps({.compute = false});
    Renderer renderer({.cells = 64});
    const DrawnSea shown = maps.show(sea, 5.0);
    constexpr int kPixels = 40;  // a period
    constexpr int kSide = 8 * kPixels;
    const Camera camera = above(50.0, 60.0, 4.0 * kPeriod);
    const auto mixed = numbers(renderer, shown, camera, kSide);
    EXPECT_LT(std::abs(correlation_at_a_period(mixed, kSide, kPixels)), 0.1);
    const auto repeated = numbers(renderer, shown, camera, kSide, {.repeats = true});
    EXPECT_GT(correlation_at_a_period(repeated, kSide, kPixels), 0.9);
    // The mixture has the variance of the sea.
    double mixed_square = 0.0;
    double repeated_square = 0.0;
    for (std::size_t p = 1; p < mixed.size(); p += 4) {
        mixed_square += mixed[p] * mixed[p];
        repeated_square += repeated[p] * repeated[p];
    }
    EXPECT_NEAR(mixed_square / repeated_square, 1.0, 0.15);
}

TEST_F(PreviewTest, HeightsOfACrossFadeAreTheBlendOfBothSeas) {
    Parameters parameters = test::wind_sea(64, kPeriod);
    parameters.surface.choppiness = 0.0;
    SeaMaps from_maps({.compute = false, .foam_resolution = 64});
    SeaMaps to_maps({.compute = false, .foam_resolution = 64});
    Renderer renderer({.cells = 32});
    constexpr std::array kAtShares = {0.0, 0.25, 0.5, 0.75, 1.0};
    std::array<double, kAtShares.size()> found{}, expected{};
    for (int seed = 0; seed < 16; ++seed) {
        Parameters stronger = parameters;
        stronger.waves.front().wind_speed = 14.0;
        parameters.seed = static_cast<std::uint32_t>(seed);
        stronger.seed = static_cast<std::uint32_t>(100 + seed);
        Ocean from_sea(parameters, {.foam_start = FoamStart::empty});
        Ocean to_sea(stronger, {.foam_start = FoamStart::empty});
        const DrawnSea from = from_maps.show(from_sea, 3.0);
        const DrawnSea to = to_maps.show(to_sea, 3.0);
        const double before = height(renderer, from), after = height(renderer, to);
        for (std::size_t i = 0; i < kAtShares.size(); ++i) {
            const double weight = std::pow(std::sin(0.25 * kTwoPi * kAtShares[i]), 2);  // of energy
            const double faded = height(renderer, cross_fade(from, to, kAtShares[i]));
            found[i] += faded;
            expected[i] += std::sqrt((1.0 - weight) * before * before + weight * after * after);
            if (kAtShares[i] == 0.0) {
                EXPECT_NEAR(faded, before, 1e-5);
            }
            if (kAtShares[i] == 1.0) {
                EXPECT_NEAR(faded, after, 1e-5);
            }
        }
    }
    for (std::size_t i = 0; i < kAtShares.size(); ++i) {
        EXPECT_NEAR(found[i] / expected[i], 1.0, 0.05) << kAtShares[i];
    }
}

TEST_F(PreviewTest, WavesThatBothSeasHaveDoNotGrowInTheMiddleOfACrossFade) {
    Parameters parameters = test::wind_sea(64, kPeriod);
    parameters.surface.choppiness = 0.0;
    Parameters stronger = parameters;
    stronger.waves.front().wind_speed = 17.0;
    Ocean from_sea(parameters, {.foam_start = FoamStart::empty});
    Ocean to_sea(stronger, {.foam_start = FoamStart::empty});
    SeaMaps from_maps({.compute = false, .foam_resolution = 64});
    SeaMaps to_maps({.compute = false, .foam_resolution = 64});
    Renderer renderer({.cells = 32});
    const DrawnSea from = from_maps.show(from_sea, 3.0);
    const DrawnSea to = to_maps.show(to_sea, 3.0);
    const double correlation = height_correlation(from_sea.modes(3.0), 3.0, to_sea.modes(3.0), 3.0);
    EXPECT_GT(correlation, 0.8);
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        const double before = height(renderer, from), after = height(renderer, to);
        const double weight = std::pow(std::sin(0.25 * kTwoPi * share), 2);
        const double expected =
            std::sqrt((1.0 - weight) * before * before + weight * after * after);
        EXPECT_NEAR(height(renderer, cross_fade(from, to, share, correlation)) / expected, 1.0,
                    0.05);
        // Without it the sea would be half as high again.
        if (share == 0.5) {
            EXPECT_GT(height(renderer, cross_fade(from, to, share)) / expected, 1.3);
        }
    }
}

TEST_F(PreviewTest, LinearLightHasNoLimit) {
    Ocean sea(two_cascades(), {.foam_start = FoamStart::empty});
    SeaMaps maps({.compute = false});
    Renderer renderer({.cells = 32});
    const DrawnSea shown = maps.show(sea, 5.0);
    const Camera at_the_sun{.eye = {0.0, 0.0, 5.0}, .heading = 0.0, .pitch = 0.0};
    const auto exposed = [&](double exposure) {
        Look look{.sun_altitude = 8.0, .sun_bearing = 0.0};
        look.exposure = exposure;
        return light(renderer, shown, at_the_sun, look, 160, 90);
    };
    const auto once = exposed(1.0), twice = exposed(2.0);
    EXPECT_GT(*std::ranges::max_element(once), 20.0f);
    for (std::size_t i = 0; i < once.size(); ++i) {
        if (i % 4 == 3) continue;
        EXPECT_NEAR(twice[i], 2.0f * once[i], 1e-5f * twice[i]);
    }
}

TEST_F(PreviewTest, CrestsGlowBeforeTheSunAlone) {
    Ocean sea(two_cascades(), {.foam_start = FoamStart::empty});
    SeaMaps maps({.compute = false});
    Renderer renderer({.cells = 64});
    const DrawnSea shown = maps.show(sea, 5.0);
    // The light that crests add to each pixel, with the sun so many degrees beside the sight.
    const auto added = [&](double aside, double amount) {
        const Camera camera{.eye = {0.0, 0.0, 3.0}, .heading = 20.0, .pitch = -6.0};
        Look look{.sun_altitude = 15.0, .sun_bearing = camera.heading + aside};
        look.foam_amount = look.visibility = 0.0;
        look.crest_light = 0.0;
        auto without = light(renderer, shown, camera, look, 160, 90);
        look.crest_light = amount;
        const auto with = light(renderer, shown, camera, look, 160, 90);
        for (std::size_t i = 0; i < with.size(); ++i) without[i] = with[i] - without[i];
        return without;
    };
    const auto sum = [](const std::vector<float>& pixels, std::size_t channel) {
        double all = 0.0;
        for (std::size_t i = channel; i < pixels.size(); i += 4) all += pixels[i];
        return all;
    };
    const auto once = added(0.0, 1.0), twice = added(0.0, 2.0), behind = added(180.0, 1.0);
    const double green = sum(once, 1);
    EXPECT_GT(*std::ranges::max_element(once), 0.005f);
    EXPECT_NEAR(sum(twice, 1) / green, 2.0, 0.01);
    EXPECT_EQ(sum(behind, 1), 0.0);
    // Its colour is the water's in the light of the sun.
    const Sky sky = make_sky({.sun_altitude = 15.0});
    const Rgb crest = water_type("jerlov_ii").crest_colour();
    EXPECT_NEAR(sum(once, 0) / green, crest[0] / crest[1] * sky.sun_colour.r / sky.sun_colour.g,
                0.01);
    // None is in the sky, nor below the eye, where the sight has no way towards the sun.
    const std::size_t half = once.size() / 2;
    EXPECT_EQ(
        *std::max_element(once.begin() + static_cast<std::ptrdiff_t>(half + half / 2), once.end()),
        0.0f);
    EXPECT_GE(*std::ranges::min_element(once), -1e-4f);
}

TEST_F(PreviewTest, CascadesShownAloneAddUpToTheSea) {
    Parameters parameters = two_cascades();
    parameters.surface.choppiness = 0.0;
    Ocean sea(parameters);
    SeaMaps maps({.compute = false});
    Renderer renderer({.cells = 64});
    const DrawnSea shown = maps.show(sea, 12.0);
    constexpr int kSide = 64;
    const auto period = [&](const DrawnSea& of, int cascade) {
        const Canvas canvas(kSide, kSide, GL_RGBA32F);
        DrawOptions options;
        options.width = options.height = kSide;
        options.view = View::numbers;
        options.cascade = cascade;
        renderer.draw_from_above(of, {}, 0.0, 0.0, kPeriod, options);
        return canvas.rgba();
    };
    // Heights add up at each place, slopes on the mean.
    const auto all = period(shown, -1), first = period(shown, 0), second = period(shown, 1);
    const double bound = 1e-5 * shown.significant_wave_height;
    const double pixels = kSide * kSide;
    double squares[2] = {}, slopes[3] = {};
    for (std::size_t p = 0; p < all.size(); p += 4) {
        EXPECT_NEAR(first[p] + second[p], all[p], bound);              // the mesh
        EXPECT_NEAR(first[p + 1] + second[p + 1], all[p + 1], bound);  // the maps
        squares[0] += first[p + 1] * first[p + 1] / pixels;
        squares[1] += second[p + 1] * second[p + 1] / pixels;
        slopes[0] += (first[p + 2] + first[p + 3]) / pixels;
        slopes[1] += (second[p + 2] + second[p + 3]) / pixels;
        slopes[2] += (all[p + 2] + all[p + 3]) / pixels;
    }
    EXPECT_GT(squares[0], 1e-3);
    EXPECT_GT(squares[1], 1e-6);
    EXPECT_GT(slopes[1], slopes[0]);
    const double unresolved = shown.mean_square_slope - test::map_slope(shown);
    EXPECT_GT(unresolved, 0.0);
    EXPECT_NEAR((slopes[0] + slopes[1] + unresolved) / slopes[2], 1.0, 0.02);
    // In a cross-fade the shown cascade is that of both seas.
    const auto faded = period(cross_fade(shown, shown, 0.5), 1);
    for (std::size_t p = 1; p < all.size(); p += 4) {
        EXPECT_NEAR(faded[p], std::sqrt(2.0) * second[p], bound);
    }
    const auto probed = probe(renderer, shown, {.eye = {10.0, 0.0, 5.0}}, {12.0, 3.0}, 1);
    const auto whole = probe(renderer, shown, {.eye = {10.0, 0.0, 5.0}}, {12.0, 3.0});
    ASSERT_TRUE(probed && whole);
    EXPECT_GT(std::abs(whole->map_height - probed->map_height), 100.0 * bound);
}

TEST_F(PreviewTest, TwoThousandFramesLeaveNothingBehind) {
    Ocean sea(test::wind_sea(32, 200.0), {.foam_start = FoamStart::empty});
    SeaMaps maps({.compute = false, .foam_resolution = 32});
    Renderer renderer({.cells = 8});
    const Canvas canvas(64, 36, GL_RGBA8);
    const auto frame = [&](int number) {
        if (number % 100 == 50) sea.set("wind_speed", number % 200 == 50 ? "14" : "15");
        const Camera camera{.eye = {0.5 * number, 0.0, 4.0}};
        canvas.bind();
        renderer.draw(maps.show(sea, number / 60.0), camera, Look{}, {.width = 64, .height = 36});
    };
    for (int i = 0; i < 200; ++i) frame(i);
    const int objects = test::count_objects();
    const double memory = test::resident_megabytes();
    for (int i = 200; i < 2200; ++i) frame(i);
    EXPECT_EQ(test::count_objects(), objects);
    EXPECT_LT(test::resident_megabytes() - memory, 2.0);
}

TEST_F(PreviewTest, ComputedByEitherThePictureIsTheSame) {
    Ocean sea(two_cascades(), {.foam_start = FoamStart::empty});
    Renderer renderer({.cells = 32});
    const Camera camera{.eye = {0.0, 0.0, 5.0}, .heading = 40.0, .pitch = -8.0};
    std::vector<std::uint8_t> pictures[2];
    for (const bool compute : {false, true}) {
        SeaMaps maps({.compute = compute, .foam_resolution = 256});
        pictures[compute ? 1 : 0] = picture(renderer, maps.show(sea, 8.0), camera);
    }
    EXPECT_LE(largest_difference(pictures[0], pictures[1]), 2);
}

}  // namespace
}  // namespace ocean::preview
