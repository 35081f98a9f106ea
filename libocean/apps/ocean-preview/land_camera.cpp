// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "land_camera.hpp"

#include <algorithm>

#include "ocean/internal/text.hpp"

namespace ocean::app {

std::string place_on_ground(const PreviewOptions& options, const CameraGround& ground,
                            preview::Camera& camera) {
    if (!ground.is_solid) return "";
    if (options.eye_place == EyePlace::not_given && ground.middle) {
        std::ranges::copy(*ground.middle, camera.eye.begin());
    }
    const double surface = ground.height(camera.eye[0], camera.eye[1]);
    const double wanted = camera.eye[2];
    switch (options.eye_place) {
        case EyePlace::not_given:
            camera.eye[2] = surface + ground.rise;
            break;
        case EyePlace::on_ground:
            camera.eye[2] = surface + kEyeHeight;
            break;
        case EyePlace::at:
            camera.eye[2] = std::max(wanted, surface + ground.clearance);
            break;
    }
    if (options.look_at) camera.look_at(*options.look_at);
    if (options.eye_place != EyePlace::at || camera.eye[2] == wanted) return "";
    return format_text(
        "--eye: Z = %g is in the ground, which is %.2f m high there; it was raised "
        "to %.2f",
        wanted, surface, camera.eye[2]);
}

std::optional<std::array<double, 2>> middle_of(const Domain& domain) {
    if (domain.wraps) return std::nullopt;
    return std::array{domain.origin[0] + 0.5 * domain.size[0],
                      domain.origin[1] + 0.5 * domain.size[1]};
}

}  // namespace ocean::app
