// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The scene of a window, with the backend that computes it. Another file may make it a scene of
// another kind.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "live_sea.hpp"
#include "preview_options.hpp"
#include "scene.hpp"
#include "workload.hpp"

namespace ocean::app {

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
    LiveScene(const OpenedScene& opened, LiveSceneOptions options);

    const SceneRow& row() const { return *row_; }
    Scene& operator*() const { return *scene_; }
    Scene* operator->() const { return scene_.get(); }

    /// Shows another subject, at its start. Throws Error.
    void open(const OpenedScene& opened);
    /// Computes the scene by another backend. Throws Error.
    void choose_backend(const std::string& name);

  private:
    LiveSceneOptions options_;
    ChosenBackend backend_;
    const SceneRow* row_ = nullptr;
    std::unique_ptr<Scene> scene_;
    bool paused_ = false;  // of the sea before a scene that stands still
};

}  // namespace ocean::app
