// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "live_scene.hpp"

#include <utility>

namespace ocean::app {

LiveScene::LiveScene(const OpenedScene& opened, LiveSceneOptions options)
    : options_(std::move(options)),
      backend_{preview_backend(options_.preview.backend).value_or(best_backend(options_.info)),
               options_.info, [this](const std::string& reason) {
                   if (options_.fell_back) options_.fell_back(reason);
               }} {
    open(opened);
}

void LiveScene::open(const OpenedScene& opened) {
    const SceneRow& row = row_of(*opened);
    if (&row == row_) return scene_->open(opened);
    std::unique_ptr<Scene> made = row.show(
        *opened, {.preview = options_.preview, .backend = backend_, .threads = options_.threads});
    if (const LiveSea* const before = scene_ ? scene_->performed() : nullptr) {
        paused_ = before->paused;
    }
    scene_ = std::move(made);
    row_ = &row;
    if (LiveSea* const sea = scene_->performed()) {
        sea->paused = paused_;
        if (options_.on_sea) options_.on_sea(*sea);
    }
}

void LiveScene::choose_backend(const std::string& name) {
    backend_.chosen = preview_backend(name).value_or(backend_.chosen);
    scene_->compute_anew();
}

}  // namespace ocean::app
