// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A terrain as a scene, which stands still until it is changed.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "ocean/internal/preview/land_maps.hpp"
#include "ocean/internal/terrain_stages.hpp"
#include "ocean/terrain.hpp"
#include "scene.hpp"

namespace ocean::app {

class TerrainScene final : public Scene {
  public:
    TerrainScene(const TerrainModel& model, const SceneOptions& options);

    Terrain& terrain() { return *terrain_; }

    /// Redoes only the stages that changes dirty.
    void show(const std::array<double, 3>& = {}) override;
    void draw(preview::Renderer& renderer, const preview::Camera& camera, const preview::Look& look,
              const preview::DrawOptions& options) const override {
        renderer.draw(shown_, camera, look, options);
    }
    void set(const std::string& name, const std::string& value) override;
    void open(const OpenedScene& opened) override;
    OpenedScene opened() const override;
    CameraGround ground() override;
    /// Returns none while the land changes.
    std::vector<std::string> warnings() override;

    const Backend& backend() const override { return backend_; }
    std::string why_not(const Backend& backend) const override;
    void compute_anew() override { change(terrain_->model()); }

    StagePicture stage(const std::string& view, int cascade) override;
    std::string probe_line(preview::Renderer& renderer, const PreviewOptions& options,
                           const std::array<double, 2>& place) override;
    std::string under_mouse(preview::Renderer& renderer, const preview::Camera& camera,
                            const std::array<double, 2>& place, double aspect,
                            int cascade) override;

    void draw_readings(const PanelState& state) const override;
    void draw_look(PanelState& state) override;
    void draw_parameters(LiveScene& scene, PanelState& state) override;

  private:
    const Backend& fitting_backend(const TerrainModel& model) const;
    TerrainOptions terrain_options(const Backend& backend) const {
        return {.threads = options_.threads, .backend = backend};
    }
    void change(TerrainModel model);

    SceneOptions options_;
    Backend backend_;
    std::unique_ptr<Terrain> terrain_;
    preview::LandMaps maps_;
    preview::DrawnLand shown_;
    TerrainStages stages_;
    Revision stages_of_;  // the modes of the stages
    StagePicture stage_;  // the last one, which takes longer than a frame
    std::string stage_view_;
    std::vector<std::string> warnings_;
    std::shared_ptr<const LandFunction> warned_, seen_;  // of the warnings, and of the call before
};

}  // namespace ocean::app
