// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a subject of a host, a tilted plane, is opened, shown in a picture, probed, walked on,
// changed, undone and saved as a sea is, although the program has no code for it but its row.
#include <epoxy/gl.h>

#include "console.hpp"
#include "interrupt.hpp"
#include "ocean-preview/live_scene.hpp"
#include "ocean-preview/offscreen_run.hpp"
#include "ocean-preview/panel/changes.hpp"
#include "ocean-preview/scene_argument.hpp"
#include "ocean-preview/window/camera_control.hpp"
#include "ocean-preview/window/session_files.hpp"
#include "ocean/internal/text.hpp"
#include "refusal.hpp"
#include "temporary_folder.hpp"
#include "unit/test_seas.hpp"

namespace ocean::app {
namespace {

/// height = slope x
class Plane final : public Subject {
  public:
    explicit Plane(double slope) : slope_(slope) {}

    double slope() const { return slope_; }
    std::string_view kind() const override { return "plane"; }
    std::string text() const override { return "slope = " + shortest_text(slope_) + "\n"; }
    std::vector<std::string> named_files() const override { return {}; }
    void set(std::string_view, std::string_view value) override {
        slope_ = parse_number(std::string(value), "slope", -1.0, 1.0);
    }
    ChannelSet channels() const override { return Channel::height; }
    int default_resolution() const override { return 2; }
    Domain domain(int resolution) const override { return Domain::tile(1.0, resolution); }
    double shortest_wave(int) const override { return 1.0; }
    HeightRange height_range(const MapsOptions&) const override { return {}; }
    std::unique_ptr<SubjectMaps> open(const MapsOptions&) const override { return nullptr; }
    Costs costs() const override { return {}; }

  private:
    double slope_;
};

class PlaneScene final : public Scene {
  public:
    explicit PlaneScene(const Plane& plane) : plane_(plane) {}

    void show(const std::array<double, 3>&) override {}
    /// Rows of the picture that look at the plane are green, the others blue.
    void draw(preview::Renderer&, const preview::Camera& camera, const preview::Look&,
              const preview::DrawOptions& options) const override {
        glEnable(GL_SCISSOR_TEST);
        for (int row = 0; row < options.height; ++row) {
            const double from_top = 1.0 - (row + 0.5) / options.height;
            const double aspect = static_cast<double>(options.width) / options.height;
            const auto sight = camera.line_of_sight(0.5, from_top, aspect);
            const bool meets = sight[2] < plane_.slope() * sight[0];
            glScissor(0, row, options.width, 1);
            glClearColor(0.0f, meets ? 1.0f : 0.0f, meets ? 0.0f : 1.0f, 1.0f);
            glClear(GL_COLOR_BUFFER_BIT);
        }
        glDisable(GL_SCISSOR_TEST);
    }
    void set(const std::string& name, const std::string& value) override {
        plane_.set(name, value);
    }
    void open(const OpenedScene& opened) override { plane_ = dynamic_cast<const Plane&>(*opened); }
    OpenedScene opened() const override { return std::make_shared<Plane>(plane_); }
    CameraGround ground() override {
        return {.height = [plane = plane_](double x, double) { return plane.slope() * x; },
                .is_solid = true};
    }

  private:
    Plane plane_;
};

OpenedScene read_plane(const SubjectArgument& argument) {
    std::string key, equals, value;
    std::ifstream(argument.source) >> key >> equals >> value;
    auto plane = std::make_shared<Plane>(0.0);
    plane->set(key, value);
    return plane;
}

const SceneRow kPlaneScene = {
    .kind = "plane",
    .is_named = [](const std::string& source) { return source.ends_with(".plane"); },
    .open = read_plane,
    .show = [](const Subject& subject, const SceneOptions&) -> std::unique_ptr<Scene> {
        return std::make_unique<PlaneScene>(dynamic_cast<const Plane&>(subject));
    },
    .views = [] { return std::vector<std::string>{"shaded"}; }};

class PlaneSceneTest : public ::testing::Test {
  protected:
    void SetUp() override {
        scene_rows().push_back(&kPlaneScene);
        std::ofstream(file_) << "slope = 0.5\n";
    }
    void TearDown() override { scene_rows().pop_back(); }

    std::string refusal(const PreviewWords& words, std::vector<GivenOption> given = {}) const {
        EnvironmentFiles environments;
        return test::message_of([&] {
            require_fit(preview_options(words, given, environments), open_scene({file_, {}}));
        });
    }

    const test::TemporaryFolder folder_;
    const std::string file_ = folder_.file("hill.plane");
};

TEST_F(PlaneSceneTest, APictureWithoutAWindowShowsItAndProbesPrintIt) {
    PreviewOptions options;
    options.offscreen = folder_.file("hill.png");
    options.size = {32, 32};
    options.probes = {{10.0, 3.0}};
    const RunOptions run_options;
    Console console("test", run_options);
    InterruptWatch interrupts([] {});
    ::testing::internal::CaptureStdout();
    const std::vector<GivenOption> given;
    run_offscreen(options, {}, open_scene({file_, {}}), file_,
                  {run_options, given, console, interrupts});
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "10,3,5\n" + options.offscreen + "\n");
    EXPECT_FALSE(test::read_bytes(options.offscreen).empty());
}

TEST_F(PlaneSceneTest, OptionsThatItLacksAreRefusedWithItsName) {
    PreviewWords words;
    EXPECT_EQ(refusal(words), "");
    words.view = "foam";
    EXPECT_EQ(refusal(words), "--view: a plane has no view 'foam'; allowed: shaded");
    const std::vector<OptionGroup> groups = preview_option_groups(words);
    EXPECT_EQ(refusal({}, {{&groups[0].options[0], "3"}}), "--time is for a sea; this is a plane");
}

TEST_F(PlaneSceneTest, AWindowShowsWalksOnChangesAndSavesIt) {
    const gl::HeadlessContext context;
    const gl::HeadlessContext::Current current(context);
    const PreviewOptions preview;
    LiveScene scene(make_subject(Sea{test::wind_sea(32, 200.0), {}}),
                    {.preview = preview, .info = gl::context_info(), .threads = 1});
    PanelState state;
    open_with_undo(scene, state, open_scene({file_, {}}));
    EXPECT_EQ(scene.row().kind, "plane");
    EXPECT_TRUE(scene->is_still());

    CameraControl camera(preview.camera);
    camera.mode = CameraMode::walk;
    camera.step({.ahead = 1.0}, 4.0, scene->ground());
    EXPECT_NEAR(camera.camera().eye[2], 0.5 * camera.camera().eye[0] + 1.7, 1e-9);
    EXPECT_EQ(camera_modes(scene->ground()), 3);

    EXPECT_TRUE(try_to_set(scene, state, "slope", "0.25"));
    state.changes.push_back({"slope", "0.5"});
    EXPECT_FALSE(try_to_set(scene, state, "slope", "7"));
    EXPECT_EQ(scene->opened()->text(), "slope = 0.25\n");
    SavedScene saved("hill", scene->opened());
    const std::string name = saved.save(*scene->opened(), folder_.file("flat"));
    EXPECT_EQ(test::read_bytes(name), "slope = 0.25\n");
    undo(scene, state);
    EXPECT_EQ(scene->opened()->text(), "slope = 0.5\n");
    undo(scene, state);
    EXPECT_EQ(scene.row().kind, "sea");
    EXPECT_EQ(state.message, "the sea back to what it was");
}

}  // namespace
}  // namespace ocean::app
