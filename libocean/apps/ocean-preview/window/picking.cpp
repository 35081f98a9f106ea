// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/picking.hpp"

#include "ocean/text.hpp"

namespace ocean::app {

std::optional<PickedWater> pick_water(LiveSea& sea, const preview::Camera& camera,
                                      const std::array<double, 2>& place, double aspect) {
    constexpr int kSteps = 3;
    PickedWater picked{};
    double level = 0.0;
    for (int step = 0;; ++step) {
        const auto met = camera.meet_level(place[0], place[1], aspect, level);
        if (!met) return std::nullopt;
        picked.point = {(*met)[0], (*met)[1]};
        if (step == kSteps) return picked;
        sea.ocean().query(sea.time(), {&picked.point, 1}, {&picked.sample, 1}, {.foam = false});
        level = picked.sample.height;
    }
}

std::string describe(const PickedWater& picked, preview::Renderer& renderer,
                     const preview::ShownSea& shown, const preview::Camera& camera, int cascade) {
    const auto& [point, sample] = picked;
    const auto drawn = preview::probe(renderer, shown, camera, {point.x, point.y}, cascade);
    return format_text("x %.2f  y %.2f  height %.2f m\nnormal %.2f %.2f %.2f\nfoam %.2f", point.x,
                       point.y, sample.height, sample.normal[0], sample.normal[1], sample.normal[2],
                       drawn ? drawn->cover : 0.0);
}

}  // namespace ocean::app
