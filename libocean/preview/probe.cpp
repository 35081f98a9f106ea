// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/preview/probe.hpp"

#include "ocean/preview/canvas.hpp"

namespace ocean::preview {
namespace {

/// Pixels along a side: odd, so that the centre of the middle pixel is the place. Its neighbours
/// serve the derivatives.
constexpr int kSide = 3;

}  // namespace

std::optional<Probe> probe(Renderer& renderer, const ShownSea& sea, const Camera& camera,
                           const std::array<double, 2>& place, int cascade) {
    const Canvas canvas(kSide, kSide, GL_RGBA32F);
    const auto middle = [&](View view) {
        DrawOptions options;
        options.width = options.height = kSide;
        options.view = view;
        options.cascade = cascade;
        canvas.bind();
        renderer.draw_from_above(sea, camera, place[0], place[1], 0.01 * kSide * finest_texel(sea),
                                 options);
        const std::vector<float> pixels = canvas.rgba();
        const float* found = &pixels[4 * (kSide * (kSide / 2) + kSide / 2)];
        return std::array<float, 4>{found[0], found[1], found[2], found[3]};
    };
    const auto foam = middle(View::foam);
    if (foam[3] == 0.0f) return std::nullopt;  // cleared, and nothing drawn
    const auto numbers = middle(View::numbers);
    return Probe{numbers[0], numbers[1], numbers[2], numbers[3], foam[0]};
}

}  // namespace ocean::preview
