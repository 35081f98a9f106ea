// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A context with a sea in it.
#pragma once

#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/preview/canvas.hpp"
#include "ocean/internal/preview/probe.hpp"
#include "ocean/internal/preview/renderer.hpp"
#include "ocean/internal/preview/sea_maps.hpp"
#include "unit/test_seas.hpp"

namespace ocean::preview {

inline constexpr double kPeriod = 400.0;

inline Parameters two_cascades() {
    Parameters parameters = test::wind_sea(128, kPeriod);
    parameters.grid.cascades = 2;
    return parameters;
}

/// Maps of the processor, with small windows of a sea that does not repeat.
inline SeaMapsOptions small_windows() {
    SeaMapsOptions options;
    options.compute = false;
    options.coast.samples = 64;
    return options;
}

inline Camera looking(const std::array<double, 3>& eye, const std::array<double, 3>& at) {
    Camera camera;
    camera.eye = eye;
    camera.look_at(at);
    return camera;
}

/// A context with a sea in it. Any message of the driver is a failure.
class PreviewTest : public ::testing::Test {
  protected:
    void TearDown() override {
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        for (const std::string& message : context_.messages()) ADD_FAILURE() << message;
    }

    std::vector<std::uint8_t> picture(Renderer& renderer, const DrawnSea& sea, const Camera& camera,
                                      const Look& look = {}, int width = 160, int height = 90) {
        const Canvas canvas(width, height, GL_RGBA8);
        renderer.draw(sea, camera, look, {.width = width, .height = height});
        return canvas.rgb();
    }
    /// Returns the numbers of each pixel: see View::numbers in libocean/preview/view_table.hpp.
    std::vector<float> numbers(Renderer& renderer, const DrawnSea& sea, const Camera& camera,
                               int side, const Look& look = {}) {
        const Canvas canvas(side, side, GL_RGBA32F);
        renderer.draw(sea, camera, look, {.width = side, .height = side, .view = View::numbers});
        return canvas.rgba();
    }

    /// Returns the significant height of a period that is seen from above.
    double height(Renderer& renderer, const DrawnSea& sea) {
        const Camera above{.eye = {0.5 * kPeriod, 0.5 * kPeriod, 0.5 * kPeriod},
                           .heading = 0.0,
                           .pitch = -90.0,
                           .field_of_view = 90.0};
        double squares = 0.0;
        const auto values = numbers(renderer, sea, above, 64);
        for (std::size_t p = 1; p < values.size(); p += 4) squares += values[p] * values[p];
        return 4.0 * std::sqrt(squares / (64.0 * 64.0));
    }

    /// Expects the drawn heights of the region at some of its labels; returns the largest of them.
    static double expect_heights_of_the_region(Ocean& ocean, double time, const Domain& labels,
                                               Renderer& renderer, const DrawnSea& sea,
                                               const Camera& camera) {
        const Surface region =
            ocean.region(time, labels, {Channel::dx, Channel::dy, Channel::height});
        const int columns = labels.samples[0];
        double highest = 0.0;
        for (std::size_t n = 0; n < labels.count(); n += 10) {
            const auto [x, y] =
                labels.place(static_cast<int>(n) % columns, static_cast<int>(n) / columns);
            const auto at = [&](Channel channel) {
                return static_cast<double>(region.channel(channel)[n]);
            };
            const auto found =
                probe(renderer, sea, camera, {x + at(Channel::dx), y + at(Channel::dy)});
            EXPECT_TRUE(found) << x << " " << y;
            if (!found) continue;
            // The quantum is that of a vertex in a picture: 1/256 of a pixel of 5 mm.
            EXPECT_NEAR(found->mesh_height, at(Channel::height),
                        1e-5 * sea.significant_wave_height + 2e-5)
                << x << " " << y;
            highest = std::max(highest, std::abs(at(Channel::height)));
        }
        return highest;
    }

    /// Returns the light of each pixel, row after row, the bottom row first: R, G, B, 1.
    std::vector<float> light(Renderer& renderer, const DrawnSea& sea, const Camera& camera,
                             const Look& look, int width, int height) {
        const Canvas canvas(width, height, GL_RGBA32F);
        DrawOptions options;
        options.width = width;
        options.height = height;
        options.linear = true;
        renderer.draw(sea, camera, look, options);
        return canvas.rgba();
    }

  private:
    const gl::HeadlessContext context_{{.debug = true}};
    const gl::HeadlessContext::Current current_{context_};
};

}  // namespace ocean::preview
