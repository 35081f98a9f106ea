// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: no light of an environment is lost when its sun is taken out, the sun stands where it
// stood, and water mirrors what is above it.
#include "ocean/internal/preview/environment.hpp"

#include "gl/leftovers.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/water_types.hpp"
#include "preview_fixture.hpp"
#include "refusal.hpp"
#include "sky.hpp"
#include "wave/wave.hpp"

namespace ocean::preview {
namespace {

using Rgb3 = std::array<double, 3>;
/// A function from a direction, a unit vector, to the light from there.
using Light = std::function<Rgb3(const std::array<double, 3>&)>;

constexpr int kFiner = 4;  // samples of a texel along a side

/// Returns a picture of the whole sphere, the nadir first, as the help of --environment says.
std::vector<float> paint(int width, int height, const Light& light) {
    std::vector<float> rgb;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            Rgb3 sum{};
            for (int s = 0; s < kFiner * kFiner; ++s) {
                const double u = (i + (s % kFiner + 0.5) / kFiner) / width;
                const double v = (j + (s / kFiner + 0.5) / kFiner) / height;
                const double bearing = -(u - 0.5) * kTwoPi, elevation = (v - 0.5) * kPi;
                const Rgb3 here =
                    light({std::cos(elevation) * std::cos(bearing),
                           std::cos(elevation) * std::sin(bearing), std::sin(elevation)});
                for (std::size_t c = 0; c < 3; ++c) sum[c] += here[c] / (kFiner * kFiner);
            }
            for (const double channel : sum) rgb.push_back(static_cast<float>(channel));
        }
    }
    return rgb;
}

double degrees_between(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / kPi;
}

std::array<double, 3> toward(double altitude, double bearing) {
    const double a = altitude * kPi / 180.0, b = bearing * kPi / 180.0;
    return {std::cos(a) * std::cos(b), std::cos(a) * std::sin(b), std::sin(a)};
}

/// A sky that is brighter towards the horizon and round its sun, whose disc of .6 degrees it has.
Light sunny(const std::array<double, 3>& sun) {
    return [sun](const std::array<double, 3>& direction) {
        const double away = degrees_between(direction, sun);
        const double sky = 1.0 - 0.6 * std::max(direction[2], 0.0) + 0.8 * std::exp(-away / 8.0);
        const double disc = away < 0.6 ? 40000.0 : 0.0;
        return Rgb3{0.7 * sky + disc, 0.8 * sky + 0.9 * disc, sky + 0.7 * disc};
    };
}

/// Returns the irradiance of a level surface that faces up, over pi.
Rgb3 level_light(int width, int height, const std::vector<float>& rgb) {
    Rgb3 sum{};
    for (int j = height / 2; j < height; ++j) {
        const double low = std::sin((static_cast<double>(j) / height - 0.5) * kPi);
        const double high = std::sin((static_cast<double>(j + 1) / height - 0.5) * kPi);
        for (int i = 0; i < width; ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                const auto at = 3 * static_cast<std::size_t>(j * width + i) + c;
                sum[c] += rgb[at] * (high * high - low * low) / width;
            }
        }
    }
    return sum;
}

TEST(Environment, TheSunIsFoundAndNoLightIsLost) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> altitude(3.0, 88.0), circle(-180.0, 180.0);
    constexpr int kWidth = 512, kHeight = 256;
    double farthest = 0.0, most_lost = 0.0;
    for (int n = 0; n < 20; ++n) {
        const double up = altitude(random), bearing = circle(random), turn = circle(random);
        const auto rgb = paint(kWidth, kHeight, sunny(toward(up, bearing)));
        const auto environment =
            std::make_shared<const Environment>(make_environment(kWidth, kHeight, rgb));
        ASSERT_TRUE(environment->sun) << up << ", " << bearing;

        Look look;
        look.environment = environment;
        look.environment_turn = turn;
        const Sky sky = make_sky(look);
        const auto found = sky.sun_direction;
        farthest = std::max(
            farthest, degrees_between({found.x, found.y, found.z}, toward(up, bearing + turn)));
        const Rgb3 before = level_light(kWidth, kHeight, rgb);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto i = static_cast<int>(c);
            const double after = sky.sun_colour[i] * found.z + sky.light[i];
            most_lost = std::max(most_lost, std::abs(after / before[c] - 1.0));
            // The disc is cut off: what is left is as bright as its surroundings, times 4.
            for (std::size_t p = c; p < environment->rgb.size(); p += 3) {
                ASSERT_LT(environment->rgb[p], 12.0f);
            }
        }
    }
    EXPECT_LT(farthest, 0.5);
    EXPECT_LT(most_lost, 0.01);
    RecordProperty("farthest_degrees", std::to_string(farthest));
    RecordProperty("most_lost", std::to_string(most_lost));
}

TEST(Environment, AnOvercastSkyHasNoSun) {
    // Three times as bright at the zenith as at the horizon, as the CIE's.
    const auto overcast = paint(256, 128, [](const std::array<double, 3>& direction) {
        const double light = (1.0 + 2.0 * std::max(direction[2], 0.0)) / 3.0;
        return Rgb3{light, light, light};
    });
    const Environment environment = make_environment(256, 128, overcast);
    EXPECT_FALSE(environment.sun);
    EXPECT_NEAR(environment.light[0], 7.0 / 9.0, 1e-3);
    // Nor has one with a broken pixel, which is no more seen.
    std::vector<float> broken = overcast;
    std::fill_n(&broken[3 * (100 * 256 + 40)], 3, 20.0f);
    const Environment mended = make_environment(256, 128, broken);
    EXPECT_FALSE(mended.sun);
    EXPECT_LT(*std::ranges::max_element(mended.rgb), 5.0f);
    EXPECT_NEAR(mended.light[0], environment.light[0], 0.01 * environment.light[0]);
}

TEST(Environment, RefusesWhatIsNone) {
    const std::vector<float> rgb(3 * 16 * 8, 1.0f);
    EXPECT_NO_THROW(make_environment(16, 8, rgb));
    test::expect_refusal(ErrorKind::invalid_value, "an environment of 8 x 16 texels",
                         [&] { make_environment(8, 16, rgb); });
    EXPECT_THROW(make_environment(16, 8, std::span(rgb).subspan(3)), Error);
    std::vector<float> wrong = rgb;
    wrong[77] = -1.0f;
    EXPECT_THROW(make_environment(16, 8, wrong), Error);
    wrong[77] = std::nanf("");
    EXPECT_THROW(make_environment(16, 8, wrong), Error);
}

/// Without a wind.
class FlatSea {
  public:
    DrawnSea show() { return maps_.show(sea_, 3.0); }

  private:
    static Parameters calm() {
        Parameters parameters = test::wind_sea(64);
        parameters.waves.front().wind_speed = 0.0;
        return parameters;
    }

    Ocean sea_{calm(), {.foam_start = FoamStart::empty}};
    SeaMaps maps_{{.compute = false, .foam_resolution = 64}};
};

class EnvironmentTest : public PreviewTest {
  protected:
    Look look_of(int width, int height, const Light& light) {
        const auto rgb = paint(width, height, light);
        Look look;
        look.visibility = 0.0;
        look.foam_amount = 0.0;
        look.environment =
            std::make_shared<const Environment>(make_environment(width, height, rgb));
        return look;
    }
};

TEST_F(EnvironmentTest, TheBackgroundLiesAsTheHelpSays) {
    Ocean sea(test::wind_sea(32), {.foam_start = FoamStart::empty});
    SeaMaps maps({.compute = false, .foam_resolution = 32});
    Renderer renderer({.cells = 16});
    const DrawnSea shown = maps.show(sea, 0.0);
    // Red is the part of the way from the left edge, green that from the lower one.
    std::vector<float> rgb;
    for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 128; ++i) {
            const float u = (static_cast<float>(i) + 0.5f) / 128.0f;
            const float v = (static_cast<float>(j) + 0.5f) / 64.0f;
            rgb.insert(rgb.end(), {u, v, 1.0f});
        }
    }
    Look look;
    look.environment = std::make_shared<const Environment>(make_environment(128, 64, rgb));
    ASSERT_FALSE(look.environment->sun);
    for (const double turn : {0.0, 30.0, -100.0}) {
        look.environment_turn = turn;
        for (const double right : {0.0, 90.0, -90.0, 150.0, -20.0}) {  // clockwise from its middle
            for (const double up : {10.0, 45.0, 80.0}) {
                const Camera camera{.eye = {0.0, 0.0, 5.0},
                                    .heading = turn - right,
                                    .pitch = up,
                                    .field_of_view = 5.0};
                const auto pixels = light(renderer, shown, camera, look, 33, 33);
                const float* middle = &pixels[4 * (33 * 16 + 16)];
                EXPECT_NEAR(middle[0], 0.5 + right / 360.0, 2e-3) << turn << ", " << right;
                EXPECT_NEAR(middle[1], 0.5 + up / 180.0, 2e-3) << turn << ", " << up;
            }
        }
    }
}

TEST_F(EnvironmentTest, FromBelowTheSkyIsInSnellsWindowAlone) {
    Renderer renderer({.cells = 32});
    constexpr double kLight = 0.9, kDepth = 5.0;
    const Look look = look_of(64, 32, [](const auto&) { return Rgb3{kLight, kLight, kLight}; });
    FlatSea flat;
    const DrawnSea shown = flat.show();
    const WaterType& type = water_type(look.water_type);
    // Critical is 41.4 degrees above the horizontal.
    for (const double pitch : {89.0, 60.0, 44.0, 39.0, 20.0, -30.0}) {
        const Camera camera{.eye = {0.0, 0.0, -kDepth}, .pitch = pitch, .field_of_view = 0.1};
        const auto pixels = light(renderer, shown, camera, look, 3, 3);
        const double up = std::sin(pitch * kPi / 180.0);
        const double refracted = std::sqrt(1.0 - kWaterIor * kWaterIor * (1.0 - up * up));
        for (std::size_t c = 0; c < 3; ++c) {
            const double loss = type.absorption[c] + 0.1 * type.scattering[c];
            const auto glow = [&](double z) {
                const double above = kLight * std::exp(-loss * kDepth);
                return type.water_leaving_albedo()[c] * above * (4.0 + 6.0 * std::max(z, 0.0));
            };
            const double left = up > 0.0 ? std::exp(-loss * kDepth / up) : 0.0;
            double at_surface = glow(-up);
            if (refracted > 0.0) {
                const double mirrored =
                    wave::double_precision::water_reflectance(refracted, kWaterIor);
                at_surface = mirrored * at_surface + (1.0 - mirrored) * kLight;
            }
            const double expected = left * at_surface + (1.0 - left) * glow(up);
            EXPECT_NEAR(pixels[4 * 4 + c] / expected, 1.0, 0.01) << pitch << " degrees, " << c;
        }
    }
}

TEST_F(EnvironmentTest, TheComputedSkyLightsAsItIsDrawn) {
    Renderer renderer({.cells = 32});
    FlatSea flat;
    const DrawnSea shown = flat.show();
    for (const double altitude : {-3.0, 4.0, 35.0}) {
        const Look look{.sun_altitude = altitude, .sun_bearing = 70.0};
        // Squares of the sine of the elevation are uniform where directions are weighed by it.
        constexpr int kUp = 8, kAround = 16;
        double sum[3] = {};
        for (int i = 0; i < kUp * kAround; ++i) {
            const Camera camera{
                .eye = {0.0, 0.0, 5.0},
                .heading = 360.0 * (i % kAround + 0.5) / kAround,
                .pitch = std::asin(std::sqrt((i / kAround + 0.5) / kUp)) * 180.0 / kPi,
                .field_of_view = 0.1};
            const auto pixels = light(renderer, shown, camera, look, 3, 3);
            for (std::size_t c = 0; c < 3; ++c) sum[c] += pixels[4 * 4 + c] / (kUp * kAround);
        }
        const Sky sky = make_sky(look);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(sky.light[c] / sum[c], 1.0, 0.02) << altitude << " degrees, " << c;
        }
    }
}

TEST_F(EnvironmentTest, TheAirHidesFarWaterAsReckoned) {
    Renderer renderer({.cells = 32});
    constexpr double kLight = 0.9, kHeight = 600.0;
    Look look = look_of(64, 32, [](const auto&) { return Rgb3{kLight, kLight, kLight}; });
    FlatSea flat;
    const DrawnSea shown = flat.show();
    for (const double distance : {900.0, 2500.0, 9000.0}) {
        // The Earth's curve hides distance^2 / 2 R of the eye's height.
        const double above = kHeight + distance * distance / (2.0 * 6371000.0);
        const Camera camera{.eye = {0.0, 0.0, kHeight},
                            .heading = 30.0,
                            .pitch = -std::asin(above / distance) * 180.0 / kPi,
                            .field_of_view = 0.05};
        const auto green = [&](double visibility) {
            look.visibility = visibility;
            const auto pixels = light(renderer, shown, camera, look, 5, 5);
            return static_cast<double>(pixels[4 * 12 + 1]);
        };
        const double clear = green(0.0);
        ASSERT_LT(clear, 0.8 * kLight);
        for (const double visibility : {2e3, 2e4}) {
            const double left = std::exp(-3.912 * distance / visibility);
            const double expected = left * clear + (1.0 - left) * kLight;
            EXPECT_NEAR(green(visibility) / expected, 1.0, 2e-3) << distance << " m";
        }
    }
}

TEST_F(EnvironmentTest, WaterMirrorsAUniformSkyAsReckoned) {
    Renderer renderer({.cells = 32});
    const Rgb3 radiance{0.8, 1.0, 1.3};
    const Look look = look_of(64, 32, [&](const auto&) { return radiance; });
    ASSERT_FALSE(look.environment->sun);
    const Rgb albedo = water_type(look.water_type).water_leaving_albedo();
    const auto mean = [](const std::vector<float>& pixels, std::size_t channel) {
        double sum = 0.0;
        for (std::size_t p = channel; p < pixels.size(); p += 4) sum += pixels[p];
        return 4.0 * sum / static_cast<double>(pixels.size());
    };
    struct Case {
        double wind, height, pitch;
    };
    // Flat; and so far away that all waves are roughness.
    for (const auto& [wind, height, pitch] : {Case{0.0, 20.0, -10.0},
                                              {0.0, 20.0, -30.0},
                                              {0.0, 20.0, -80.0},
                                              {10.0, 20000.0, -15.0},
                                              {10.0, 20000.0, -30.0},
                                              {10.0, 20000.0, -80.0}}) {
        Parameters parameters = test::wind_sea(64);
        parameters.waves.front().wind_speed = wind;
        parameters.surface.choppiness = 0.0;
        Ocean sea(parameters, {.foam_start = FoamStart::empty});
        SeaMaps maps({.compute = false, .foam_resolution = 64});
        const DrawnSea shown = maps.show(sea, 3.0);
        for (std::size_t c = 0; c < 3; ++c) {
            double found = 0.0;
            for (const double heading : {0.0, 90.0}) {  // slopes of both add up
                const Camera camera{.eye = {0.0, 0.0, height},
                                    .heading = heading,
                                    .pitch = pitch,
                                    .field_of_view = 1.0};
                found += 0.5 * mean(light(renderer, shown, camera, look, 17, 17), c);
            }
            // The Earth's curve turns far water by distance/R.
            const double distance = height / std::tan(-pitch * kPi / 180.0);
            const double cosine = std::sin(-pitch * kPi / 180.0 - distance / 6371000.0);
            const double reflected = wave::double_precision::rough_water_reflectance(
                cosine, std::sqrt(0.5 * shown.mean_square_slope));
            const double expected = (reflected + (1.0 - reflected) * albedo[c]) * radiance[c];
            EXPECT_NEAR(found / expected, 1.0, 0.01) << wind << " m/s, " << pitch << ", " << c;
        }
    }
}

TEST_F(EnvironmentTest, ItsSunIsAGlitterAndNoSpark) {
    Ocean sea(test::wind_sea(64), {.foam_start = FoamStart::empty});
    SeaMaps maps({.compute = false, .foam_resolution = 64});
    Renderer renderer({.cells = 32});
    const DrawnSea shown = maps.show(sea, 3.0);
    const Look look = look_of(1024, 512, sunny(toward(30.0, 0.0)));
    const auto brightest = [&](double heading) {
        const auto pixels =
            light(renderer, shown, {.eye = {0.0, 0.0, 500.0}, .heading = heading, .pitch = -30.0},
                  look, 64, 36);
        return *std::ranges::max_element(pixels);
    };
    // Texels of 40000 would be 800 in any facet.
    EXPECT_GT(brightest(0.0), 4.0f * brightest(180.0));
    EXPECT_LT(brightest(180.0), 2.0f);

    // The same one is uploaded once; another frees it.
    const Look other = look_of(64, 32, [](const auto&) { return Rgb3{1.0, 1.0, 1.0}; });
    light(renderer, shown, {}, Look{}, 16, 16);  // and the foam's pattern, with the first foam
    const int objects = test::count_objects();
    for (const Look& each : {look, look, other, Look{}, look}) {
        light(renderer, shown, {}, each, 16, 16);
        EXPECT_EQ(test::count_objects(), objects);
    }
}

}  // namespace
}  // namespace ocean::preview
