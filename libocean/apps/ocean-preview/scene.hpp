// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A scene: one subject while it is shown, in a window or in pictures without one. The program works
// by these interfaces alone; a subject joins it by a SceneRow.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/domain.hpp"
#include "ocean/internal/gl/sea_textures.hpp"
#include "ocean/internal/preview/renderer.hpp"
#include "ocean/seafile.hpp"
#include "ocean/subject.hpp"
#include "stage_picture.hpp"
#include "subject_argument.hpp"

namespace ocean::app {

struct ChosenBackend;
class LiveScene;
class LiveSea;
struct PanelState;
struct PreviewOptions;

/// A resolved and validated sea, terrain or other subject, as a file describes it.
using OpenedScene = std::shared_ptr<const Subject>;

/// The surface that carries a camera.
struct CameraGround {
    std::function<double(double x, double y)> height;  // of the surface [m]
    /// Returns the height of a floating body [m]; empty: nothing floats on the surface.
    std::function<double(double x, double y, double heading)> boat = {};
    double clearance = 0.3;  // [m], of the lowest eye above the surface, so that it hides nothing
    bool is_solid = false;   // a camera that flies stays above the surface, not above height 0
    // The eye of a camera without --eye over solid ground.
    double rise = 8.0;                                 // [m] above the surface
    std::optional<std::array<double, 2>> middle = {};  // its place [m]; nothing: that of any camera
    /// Land that exists once: an eye without --eye and --look-at stands where the view is open.
    std::optional<Domain> outlook = {};
    std::optional<double> water_level = {};  // of that land [m]
};

/// How the pictures of a scene follow each other.
enum class Pace {
    window,  // as time goes on; what takes long is computed beside them
    frames,  // as time goes on; each picture waits for all that it shows
    stills,  // each is a function of the subject and the time, with settled foam
};

/// All references outlive the scene.
struct SceneOptions {
    const PreviewOptions& preview;
    ChosenBackend& backend;
    int threads = 0;
    Pace pace = Pace::window;
    std::function<void(std::int64_t done, std::int64_t total)> foam_progress = {};
    gl::AfterStage after_stage = {};
};

/// The OpenGL context of the constructor must be current in every call, also in the destructor. A
/// function that throws Error has changed nothing.
class Scene {
  public:
    Scene() = default;
    virtual ~Scene() = default;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    /// Computes the scene at its time, around an eye [m]. Throws Error, and what was shown stays.
    virtual void show(const std::array<double, 3>& eye) = 0;
    /// Draws what show() computed into the current framebuffer. Throws Error.
    virtual void draw(preview::Renderer& renderer, const preview::Camera& camera,
                      const preview::Look& look, const preview::DrawOptions& options) const = 0;
    /// Returns true if pictures that take their time shade each sample of a pixel.
    virtual bool is_finer_than_pixels() const { return false; }
    /// Sets a parameter; a file that it names is read, relative to the working directory. Throws
    /// Error.
    virtual void set(const std::string& name, const std::string& value) = 0;
    /// Shows another subject of the same kind, at its start. Throws Error.
    virtual void open(const OpenedScene& opened) = 0;
    /// Returns the subject to save: as it was opened or changed.
    virtual OpenedScene opened() const = 0;
    virtual CameraGround ground() = 0;
    /// Returns warnings about what is shown, a sentence each.
    virtual std::vector<std::string> warnings() { return {}; }

    // The clock of a scene that moves [s].
    virtual void go_to(double /*time*/) {}
    virtual void advance(double /*seconds*/) {}
    virtual void pause() {}
    /// Returns true if the picture stays the same until something is changed; see pending().
    virtual bool is_still() const { return true; }
    virtual preview::Pending pending() const { return preview::Pending::nothing; }
    /// Returns the running sea, for its clock, its recording and its bridge; null for a scene that
    /// cannot be performed.
    virtual LiveSea* performed() { return nullptr; }
    /// Returns the eye of the first show(), before ground() knows the surface; nothing if show()
    /// gives the same for all eyes.
    virtual std::optional<std::array<double, 3>> first_eye(const PreviewOptions&) const {
        return std::nullopt;
    }

    virtual const Backend& backend() const { return Backend::cpu; }
    /// Returns why a backend cannot compute the scene, or "" if it can.
    virtual std::string why_not(const Backend&) const { return ""; }
    /// Computes the scene anew if the chosen backend has changed. Throws Error.
    virtual void compute_anew() {}

    /// Returns one of the row's stages at the scene's time. cascade: of a scene that has several.
    /// Throws Error.
    virtual StagePicture stage(const std::string& /*view*/, int /*cascade*/) { return {}; }
    virtual int cascades() { return 1; }
    /// Returns the numbers of a place [m] as --probe prints them: "X,Y,NUMBER...". Throws Error.
    virtual std::string probe_line(preview::Renderer& renderer, const PreviewOptions& options,
                                   const std::array<double, 2>& place);
    /// Returns lines for a person about what a place of the picture shows, "" for the sky. The
    /// place is 0 .. 1 from the left and from the top; aspect = width/height. Changes the bound
    /// framebuffer and the viewport. Throws Error.
    virtual std::string under_mouse(preview::Renderer& /*renderer*/, const preview::Camera&,
                                    const std::array<double, 2>& /*place*/, double /*aspect*/,
                                    int /*cascade*/) {
        return "";
    }

    /// Returns the place of the surface [m] that a place of the picture shows; nothing for the sky
    /// and for a scene where nothing can be placed. Arguments as of under_mouse(). Throws Error.
    virtual std::optional<std::array<double, 2>> place_under(const preview::Camera&,
                                                             const std::array<double, 2>& /*place*/,
                                                             double /*aspect*/) {
        return std::nullopt;
    }

    // Parts of the panel, drawn inside its window: state, colours, parameters.
    virtual void draw_readings(const PanelState&) const {}
    virtual void draw_look(PanelState&) {}
    virtual void draw_parameters(LiveScene&, PanelState&) {}
};

/// A kind of subject that the preview shows. All members are required but the last three.
struct SceneRow {
    std::string_view kind;  // of its subjects, and their noun
    /// Returns whether a source names a subject of this kind: a preset, a file or a baked file.
    bool (*is_named)(const std::string& source);
    /// Returns the subject that an argument names. Throws Error.
    OpenedScene (*open)(const SubjectArgument& argument);
    std::unique_ptr<Scene> (*show)(const Subject& subject, const SceneOptions& options);
    /// Returns the names of the renderer's views of such a scene.
    std::vector<std::string> (*views)();
    std::span<const std::string_view> stages = {};  // views that are pictures of its computation
    std::span<const Preset> (*presets)() = [] { return std::span<const Preset>(); };
    /// Returns the kind of another subject whose options this one has too, or "".
    std::string_view (*includes)(const Subject&) = [](const Subject&) {
        return std::string_view();
    };
    /// Throws Error for options that this subject cannot be shown with.
    void (*require_fit)(const Subject&, const PreviewOptions&) = [](auto&, auto&) {};
    /// Returns warnings about a subject that is opened at the start of the program.
    std::vector<std::string> (*warnings)(const Subject&) = [](const Subject&) {
        return std::vector<std::string>();
    };
};

extern const SceneRow kSeaScene, kTerrainScene;

/// Returns the rows of all kinds, in the order in which they are listed: a test or a host may add
/// one. Of several rows that name a source the last one opens it; the first, the sea's, names all.
std::vector<const SceneRow*>& scene_rows();
/// Returns the row of a subject that one of them has opened.
const SceneRow& row_of(const Subject& subject);

/// Returns "X,Y" and the numbers, as a line.
std::string probe_text(const std::array<double, 2>& place, std::initializer_list<double> numbers);

}  // namespace ocean::app
