// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The scene of a window: a running sea or a land, with the backend that computes it. Another file
// may make it one of the other kind.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "live_land.hpp"
#include "live_sea.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/preview/renderer.hpp"
#include "preview_options.hpp"
#include "scene_argument.hpp"

namespace ocean::app {

/// The surface that carries a camera.
struct CameraGround {
    std::function<double(double x, double y)> height;  // of the surface [m]
    /// Returns the height of a floating body [m]; empty: nothing floats on the surface.
    std::function<double(double x, double y, double heading)> boat;
    double clearance = 0.3;  // [m], of the lowest eye above the surface, so that it hides nothing
    bool is_solid = false;   // a camera that flies stays above the surface, not above height 0
};

struct LiveSceneOptions {
    const PreviewOptions& preview;  // outlive the scene
    gl::ContextInfo info;
    int threads = 0;
    /// Called with each new running sea before anything else is done with it; may be empty.
    std::function<void(LiveSea& sea)> on_sea = {};
    /// Called with the reason when another backend than the chosen one computes the scene.
    std::function<void(const std::string& reason)> fell_back = {};
};

/// The OpenGL context of the constructor must be current in every call, also in the destructor. A
/// function that throws Error has changed nothing.
class LiveScene {
  public:
    LiveScene(const OpenedScene& scene, LiveSceneOptions options);

    preview::SceneKind kind() const;
    // The shown one; the other is null.
    LiveSea* sea() { return sea_.get(); }
    const LiveSea* sea() const { return sea_.get(); }
    LiveLand* land() { return land_.get(); }
    const LiveLand* land() const { return land_.get(); }

    /// Computes the scene at its time, a coast around an eye [m]. Throws Error, and shown() stays.
    void show(const std::array<double, 3>& eye);
    const preview::DrawnScene& shown() const { return shown_; }
    /// Advances a sea's clock and fades [s].
    void advance(double seconds);
    /// Returns true if the picture stays the same until something is changed; see pending().
    bool is_still() const;
    preview::Pending pending() const;
    CameraGround ground();

    /// Sets a parameter. Throws Error.
    void set(const std::string& name, const std::string& value);
    /// Shows another scene, at its start. Throws Error.
    void open(const OpenedScene& scene);
    /// Returns the scene to save: as it was opened or changed.
    OpenedScene opened() const;

    const Backend& backend() const;
    /// Returns why a backend cannot compute the scene, or "" if it can.
    std::string why_not(const Backend& backend) const;
    /// Computes the scene by another backend. Throws Error.
    void choose_backend(const std::string& name);

  private:
    template <typename Model>
    const Backend& fitting_backend(const Model& model);
    std::unique_ptr<LiveSea> make_sea(const Sea& sea);
    std::unique_ptr<LiveLand> make_land(const TerrainModel& terrain);

    LiveSceneOptions options_;
    Backend backend_;  // the chosen one
    std::unique_ptr<LiveSea> sea_;
    std::unique_ptr<LiveLand> land_;
    bool paused_ = false;  // of the sea before a land
    preview::DrawnScene shown_;
};

/// Returns the text of a scene's own file.
std::string text_of(const OpenedScene& scene);

}  // namespace ocean::app
