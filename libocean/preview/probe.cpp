// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/preview/probe.hpp"

#include <vector>

#include "ocean/internal/preview/canvas.hpp"

namespace ocean::preview {
namespace {

/// Pixels along a side: odd, so that the centre of the middle pixel is the place. Its neighbours
/// serve the derivatives.
constexpr int kSide = 3;

/// Returns the middle pixel of a small picture from above. texel: of the scene's finest map [m].
template <typename Shown>
std::array<float, 4> middle_pixel(Renderer& renderer, const Shown& shown, const Camera& camera,
                                  const std::array<double, 2>& place, double texel, View view,
                                  int cascade = -1) {
    const Canvas canvas(kSide, kSide, GL_RGBA32F);
    DrawOptions options;
    options.width = options.height = kSide;
    options.view = view;
    options.cascade = cascade;
    options.ground = false;
    canvas.bind();
    renderer.draw_from_above(shown, camera, place[0], place[1], 0.01 * kSide * texel, options);
    const std::vector<float> pixels = canvas.rgba();
    const float* found = &pixels[4 * (kSide * (kSide / 2) + kSide / 2)];
    return {found[0], found[1], found[2], found[3]};
}

}  // namespace

std::optional<Probe> probe(Renderer& renderer, const DrawnSea& sea, const Camera& camera,
                           const std::array<double, 2>& place, int cascade) {
    const auto middle = [&](View view) {
        return middle_pixel(renderer, sea, camera, place, finest_texel(sea), view, cascade);
    };
    const auto foam = middle(View::foam);
    if (foam[3] == 0.0f) return std::nullopt;  // cleared, and nothing drawn
    const auto numbers = middle(View::numbers);
    return Probe{numbers[0], numbers[1], numbers[2], numbers[3], foam[0]};
}

std::optional<LandProbe> probe(Renderer& renderer, const DrawnLand& land, const Camera& camera,
                               const std::array<double, 2>& place) {
    const auto middle = [&](View view) {
        return middle_pixel(renderer, land, camera, place, texel_of(land), view);
    };
    if (middle(View::height)[3] == 0.0f) return std::nullopt;  // cleared, and nothing drawn
    const auto numbers = middle(View::numbers);
    return LandProbe{numbers[0], numbers[1], numbers[2]};
}

}  // namespace ocean::preview
