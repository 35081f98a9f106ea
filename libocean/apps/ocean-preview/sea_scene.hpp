// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea as a scene: open, or over a bed as a coast.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "live_sea.hpp"
#include "ocean/internal/gl/stages.hpp"
#include "scene.hpp"

namespace ocean::app {

class SeaScene final : public Scene {
  public:
    SeaScene(const Sea& sea, const SceneOptions& options);

    void show(const std::array<double, 3>& eye) override { shown_ = live_.show(eye); }
    void draw(preview::Renderer& renderer, const preview::Camera& camera, const preview::Look& look,
              const preview::DrawOptions& options) const override {
        renderer.draw(shown_, camera, look, options);
    }
    /// Near detail is finer; without it one light for all samples is as smooth and four times as
    /// fast.
    bool is_finer_than_pixels() const override { return !shown_.tiles.empty(); }
    void set(const std::string& name, const std::string& value) override { live_.set(name, value); }
    void open(const OpenedScene& opened) override { live_.open(sea_of(*opened)); }
    OpenedScene opened() const override { return make_subject(live_.sea()); }
    CameraGround ground() override;
    std::vector<std::string> warnings() override;

    void go_to(double time) override { live_.go_to(time); }
    void advance(double seconds) override { live_.advance(seconds); }
    void pause() override { live_.paused = true; }
    bool is_still() const override {
        return live_.paused && !live_.fading() && !live_.coast_in_work();
    }
    preview::Pending pending() const override { return live_.pending(); }
    LiveSea* performed() override { return &live_; }
    std::optional<std::array<double, 3>> first_eye(const PreviewOptions& options) const override;

    const Backend& backend() const override { return live_.computing().backend; }
    std::string why_not(const Backend& backend) const override;
    void compute_anew() override { live_.compute_anew(); }

    StagePicture stage(const std::string& view, int cascade) override;
    int cascades() override;
    std::string probe_line(preview::Renderer& renderer, const PreviewOptions& options,
                           const std::array<double, 2>& place) override;
    std::string under_mouse(preview::Renderer& renderer, const preview::Camera& camera,
                            const std::array<double, 2>& place, double aspect,
                            int cascade) override;

    std::optional<std::array<double, 2>> place_under(const preview::Camera& camera,
                                                     const std::array<double, 2>& place,
                                                     double aspect) override;

    void draw_readings(const PanelState& state) const override;
    void draw_look(PanelState& state) override;
    void draw_parameters(LiveScene& scene, PanelState& state) override;

  private:
    /// Returns the water that a place of the picture shows, found by a few steps of the query.
    struct SeenWater {
        WorldPoint place;
        QuerySample sample;
    };
    std::optional<SeenWater> water_under(const preview::Camera& camera,
                                         const std::array<double, 2>& place, double aspect);

    SceneOptions options_;
    LiveSea live_;
    preview::DrawnSea shown_;
    gl::StageMaker stages_;
};

}  // namespace ocean::app
