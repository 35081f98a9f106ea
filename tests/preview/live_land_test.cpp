// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a slider redoes only the stages that its parameter dirties; a window goes from a sea to a
// terrain and back; the camera is never in the ground; stages are shown as they are.
#include "ocean-preview/land_camera.hpp"
#include "ocean-preview/live_scene.hpp"
#include "ocean-preview/stage_picture.hpp"
#include "ocean-preview/terrain_scene.hpp"
#include "ocean-preview/window/camera_control.hpp"
#include "ocean/error.hpp"
#include "ocean/terrainfile.hpp"
#include "unit/test_seas.hpp"

namespace ocean::app {
namespace {

TerrainModel hills() {
    TerrainModel terrain;
    terrain.resolution = 64;
    terrain.patch_size = 640.0;
    terrain.rms = 40.0;
    terrain.mean = -500.0;  // an eye over still water would be far above it
    return terrain;
}

class LiveLandTest : public ::testing::Test {
  protected:
    void TearDown() override {
        for (const std::string& message : context_.messages()) ADD_FAILURE() << message;
    }
    LiveSceneOptions options() {
        return {.preview = preview_, .info = gl::context_info(), .threads = 1};
    }

    PreviewOptions preview_;

  private:
    const gl::HeadlessContext context_{{.debug = true}};
    const gl::HeadlessContext::Current current_{context_};
};

TEST_F(LiveLandTest, ASliderRedoesTheStagesThatItDirties) {
    LiveScene scene(make_subject(hills()), options());
    auto& land = dynamic_cast<TerrainScene&>(*scene);
    const auto runs_of = [&](const char* name, const char* value) {
        const TerrainRuns before = land.terrain().runs();
        land.set(name, value);
        land.show();
        land.show();
        const TerrainRuns after = land.terrain().runs();
        return TerrainRuns{after.noise - before.noise, after.filter - before.filter,
                           after.maps - before.maps, after.shape - before.shape};
    };
    for (const auto& [name, value] : {std::pair{"beta", "2.4"},
                                      {"rms", "12"},
                                      {"outer_scale", "300"},
                                      {"ridge_wavelength", "90"},
                                      {"ridge_direction", "40"},
                                      {"anisotropy", "2"},
                                      {"direction", "30"}}) {
        EXPECT_EQ(runs_of(name, value), (TerrainRuns{0, 1, 1, 1})) << name;
    }
    EXPECT_EQ(runs_of("mean", "20"), (TerrainRuns{0, 0, 1, 1}));
    EXPECT_EQ(runs_of("seed", "9"), (TerrainRuns{1, 1, 1, 1}));
    EXPECT_EQ(runs_of("seed", "9"), (TerrainRuns{0, 0, 0}));
    EXPECT_THROW(land.set("beta", "99"), Error);
    EXPECT_EQ(land.terrain().model().beta, 2.4);
    // Undo unsets a number that was unset.
    land.set("rms", "");
    EXPECT_FALSE(land.terrain().model().rms);
}

TEST_F(LiveLandTest, ASeaAndATerrainTakeEachOthersPlace) {
    Parameters parameters = test::wind_sea(32, 200.0);
    LiveScene scene(make_subject(Sea{parameters, {}}), options());
    scene->show({});
    EXPECT_EQ(&scene.row(), &kSeaScene);
    EXPECT_NE(scene->performed(), nullptr);
    scene.open(make_subject(hills()));
    EXPECT_EQ(&scene.row(), &kTerrainScene);
    EXPECT_EQ(scene->performed(), nullptr);
    EXPECT_TRUE(scene->is_still());
    EXPECT_EQ(scene->opened()->text(), write_terrain(hills()));
    EXPECT_GT(scene->ground().rise, 0.0);  // it is shown
    // A terrain that is refused leaves the scene as it is.
    TerrainModel wrong = hills();
    wrong.beta = -1.0;
    wrong.rms = 2.0;
    wrong.range = {0.0, 1.0};
    EXPECT_THROW(scene.open(make_subject(wrong)), Error);
    EXPECT_EQ(find_terrain(*scene->opened())->beta, 2.0);
    scene.open(make_subject(Sea{parameters, {}}));
    EXPECT_EQ(&scene.row(), &kSeaScene);
    scene->show({});
}

TEST_F(LiveLandTest, TheCameraWalksOnTheGroundAndIsNeverInIt) {
    LiveScene scene(make_subject(hills()), options());
    const CameraGround ground = scene->ground();
    CameraControl camera(preview_.camera);
    for (const CameraMode mode : {CameraMode::walk, CameraMode::fly, CameraMode::orbit}) {
        camera.mode = mode;
        preview::Camera start;
        start.eye = {10.0, 20.0, ground.height(10.0, 20.0) + 1.7};
        camera.reset(start);
        for (int step = 0; step < 300; ++step) {
            // Ahead and down, in all directions.
            camera.step({.ahead = 1.0, .up = -1.0, .turn_left = 3.0, .turn_up = -0.2}, 0.2, ground);
            const auto& [x, y, z] = camera.camera().eye;
            const double over = z - ground.height(x, y);
            ASSERT_GE(over, ground.clearance - 1e-9) << static_cast<int>(mode) << " " << step;
            if (mode == CameraMode::walk) {
                ASSERT_NEAR(over, kEyeHeight, 1e-9);
            }
        }
    }
    // Ground that rises lifts the eye.
    camera.mode = CameraMode::fly;
    scene->set("mean", "800");
    scene->show({});
    camera.stay_above(scene->ground());
    EXPECT_GT(camera.camera().eye[2], 500.0);
}

TEST_F(LiveLandTest, AFirstEyeStandsOnTheGroundWhereverThatIs) {
    LiveScene scene(make_subject(hills()), options());
    const CameraGround land = scene->ground();
    const auto eye_of = [&](EyePlace place, std::array<double, 3> eye, std::string& warning) {
        preview_.eye_place = place;
        preview_.camera.eye = eye;
        preview::Camera camera = preview_.camera;
        warning = place_on_ground(preview_, land, camera);
        return camera.eye[2];
    };
    const double ground = land.height(30.0, 40.0);
    std::string warning;
    EXPECT_NEAR(eye_of(EyePlace::on_ground, {30.0, 40.0, 0.0}, warning), ground + 1.7, 1e-9);
    EXPECT_EQ(warning, "");
    EXPECT_GT(eye_of(EyePlace::not_given, {30.0, 40.0, 8.0}, warning), ground + 1.7);
    EXPECT_EQ(warning, "");
    EXPECT_EQ(eye_of(EyePlace::at, {30.0, 40.0, 8.0}, warning), 8.0);
    EXPECT_EQ(warning, "");
    EXPECT_GT(eye_of(EyePlace::at, {30.0, 40.0, ground - 25.0}, warning), ground);
    EXPECT_NE(warning.find("is in the ground"), std::string::npos) << warning;
}

TEST_F(LiveLandTest, AFirstEyeOnLandThatEndsLooksAtWaterAndReliefOverOpenGround) {
    CameraGround land;
    land.is_solid = true;
    land.rise = 10.0;
    land.middle = {0.0, 0.0};
    land.outlook = Domain{.origin = {-600.0, -600.0}, .size = {1200.0, 1200.0}, .wraps = false};
    const auto first = [&](std::optional<double> heading = {}) {
        preview_.has_heading = heading.has_value();
        preview::Camera camera;
        camera.heading = heading.value_or(0.0);
        EXPECT_EQ(place_on_ground(preview_, land, camera), "");
        EXPECT_EQ(camera.eye[2], land.height(camera.eye[0], camera.eye[1]) + 10.0);
        EXPECT_EQ(camera.heading, heading.value_or(camera.heading));
        return camera;
    };
    const auto bearing_off = [](const preview::Camera& camera, double x, double y) {
        const double towards = std::atan2(y - camera.eye[1], x - camera.eye[0]);
        return std::abs(std::remainder(towards * 180.0 / std::numbers::pi - camera.heading, 360.0));
    };
    // A pond in a plain. The eye stands beside it, and looks at it also where its heading is given.
    land.water_level = 18.0;
    land.height = [](double x, double y) {
        return std::hypot(x + 300.0, y - 250.0) < 100.0 ? 18.0 : 20.0;
    };
    for (const std::optional<double> heading : {std::optional<double>(), std::optional(-45.0)}) {
        const preview::Camera camera = first(heading);
        EXPECT_GT(land.height(camera.eye[0], camera.eye[1]), 18.0);
        EXPECT_LT(bearing_off(camera, -300.0, 250.0), 30.0);
    }
    // A range in the east, and to the east of all places but one a wall as high as the eye.
    land.water_level.reset();
    land.height = [](double x, double y) {
        if (x > 600.0) return 500.0;
        const bool wall = std::abs(std::remainder(x - 70.0, 100.0)) < 10.0;
        return wall && std::hypot(x - 50.0, y - 50.0) > 45.0 ? 12.0 : 0.0;
    };
    const preview::Camera camera = first();
    EXPECT_EQ(camera.eye[0], 50.0);
    EXPECT_EQ(camera.eye[1], 50.0);
    EXPECT_LT(bearing_off(camera, 650.0, 50.0), 30.0);
    // A place that is looked at is seen from the middle.
    preview_.look_at = {0.0, 100.0, 0.0};
    EXPECT_EQ(first().eye[0], 0.0);
}

/// The greys of a picture, 0 .. 255.
std::vector<double> greys(const StagePicture& picture) {
    std::vector<double> values;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) values.push_back(picture.rgb[i]);
    return values;
}

TEST_F(LiveLandTest, TheStagesAreWhiteNoiseItsTransformAndTheFilter) {
    Terrain land(hills());
    const TerrainStages stages = terrain_stages(land);
    const int side = 64;
    const std::vector<double> noise = greys(make_stage_picture(stages, "noise"));
    const double mean = std::accumulate(noise.begin(), noise.end(), 0.0) / (side * side);
    double square = 0.0, beside = 0.0;
    for (std::size_t i = 0; i < noise.size(); ++i) {
        const std::size_t next = i % side + 1 < side ? i + 1 : i + 1 - side;
        square += (noise[i] - mean) * (noise[i] - mean);
        beside += (noise[i] - mean) * (noise[next] - mean);
    }
    EXPECT_NEAR(mean, 127.5, 3.0);
    EXPECT_NEAR(std::sqrt(square / (side * side)), 42.5, 2.0);  // a sixth of the greys
    EXPECT_LT(std::abs(beside / square), 4.0 / side);           // four standard errors

    // Means of rings around the middle: flat for the noise, falling for the filter.
    const auto ring = [&](const char* name, double inner, double outer) {
        const std::vector<double> values = greys(make_stage_picture(stages, name));
        double sum = 0.0;
        int count = 0;
        for (int j = 1; j < side; ++j) {
            for (int i = 1; i < side; ++i) {
                const double k = std::hypot(i - side / 2, j - side / 2);
                if (k < inner || k >= outer) continue;
                sum += values[static_cast<std::size_t>(j * side + i)];
                ++count;
            }
        }
        return sum / count;
    };
    EXPECT_NEAR(ring("transform", 1.0, 16.0), ring("transform", 16.0, 32.0), 8.0);
    for (const char* name : {"filter", "spectrum"}) {
        EXPECT_GT(ring(name, 1.0, 4.0), 1.5 * ring(name, 16.0, 32.0)) << name;
    }
}

}  // namespace
}  // namespace ocean::app
