// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "frame_block.hpp"

#include <cmath>

#include "ocean/internal/water_types.hpp"
#include "sky.hpp"
#include "wave/wave.hpp"

namespace ocean::preview {
namespace {

using wave::double_precision::earth_radius, wave::double_precision::horizon_distance;

glm::vec4 with(const glm::vec3& rgb, double w) {
    return {rgb, static_cast<float>(w)};
}

void set_sky(FrameBlock& block, const Camera& camera, const Look& look) {
    const Sky sky = make_sky(look);
    block.sun = with(sky.sun_direction, sky.sun_shown);
    block.sun_colour = with(sky.sun_colour, 0.0);
    block.sky_low = with(sky.low, horizon_distance(camera.eye[2]) / earth_radius());
    block.sky_middle = with(sky.middle, sky.mapped);
    block.sky_high = with(sky.high, sky.turn);
    block.sky_shadow = with(sky.shadow, sky.dusk);
    block.sky_light = with(sky.light, 0.0);
}

void set_water_body(FrameBlock& block, const WaterType& type) {
    const Rgb albedo = type.water_leaving_albedo();
    block.water = with(glm::vec3(albedo[0], albedo[1], albedo[2]), kWaterIor);
    for (int c = 0; c < 3; ++c) {
        // Nine tenths of the scattered light go on ahead.
        const auto channel = static_cast<std::size_t>(c);
        block.loss[c] =
            static_cast<float>(type.absorption[channel] + 0.1 * type.scattering[channel]);
    }
}

}  // namespace

bool is_seed(const Look& look, const DrawOptions& options) {
    return look.kind == LookKind::seed && options.view == View::shaded;
}

FrameBlock make_frame_block(const Camera& camera, const Look& look, const DrawOptions& options,
                            const Projection& projection, double farthest) {
    FrameBlock block;
    block.clip_from_world = projection.clip_from_world;
    block.world_from_clip = glm::inverse(projection.clip_from_world);
    block.eye = with(glm::vec3(0.0f, 0.0f, static_cast<float>(camera.eye[2])), 1.0);
    block.depth.x =
        projection.flat ? 0.0f : static_cast<float>(1.0 / std::log2(1.0 + 2.0 * farthest));
    block.look = glm::vec4(look.exposure, look.visibility,
                           projection.pixel_angle / std::sqrt(options.shaded_samples),
                           options.linear ? 1.0 : 0.0);
    block.view = glm::ivec4(static_cast<int>(options.view), 1, 0, 0);
    set_sky(block, camera, look);
    set_water_body(block, water_type(look.water_type));
    if (is_seed(look, options)) {
        block.eye.w = 0.0f;
        block.sky_low = with(kSeedFog, 0.0);
    }
    return block;
}

}  // namespace ocean::preview
