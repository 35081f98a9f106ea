// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/preview/probe.hpp"

#include "ocean/preview/canvas.hpp"

namespace ocean::preview {
namespace {

/// Odd: the middle of the middle pixel is the place. Its neighbours are for the derivatives.
constexpr int kSide = 3;

}  // namespace

std::optional<Probe> probe(Renderer& renderer, const ShownSea& sea, const Camera& camera,
                           const std::array<double, 2>& place, int cascade) {
    const Canvas canvas(kSide, kSide, GL_RGBA32F);
    DrawOptions options;
    options.width = options.height = kSide;
    options.view = View::numbers;
    options.cascade = cascade;
    renderer.draw_from_above(sea, camera, place[0], place[1], 0.01 * kSide * finest_texel(sea),
                             options);
    const std::vector<float> pixels = canvas.rgba();
    const float* middle = &pixels[4 * (kSide * (kSide / 2) + kSide / 2)];
    if (middle[3] <= 0.0f) return std::nullopt;
    return Probe{middle[0], middle[1], middle[2], middle[3]};
}

}  // namespace ocean::preview
