// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "land_camera.hpp"

#include <algorithm>

#include "ocean/text.hpp"

namespace ocean::app {

double lowest_eye(const preview::ShownLand& land) {
    return std::min(0.3, 0.2 * preview::texel_of(land));
}

std::string place_on_land(const PreviewOptions& options, const preview::ShownLand& land,
                          preview::Camera& camera) {
    const Domain& domain = land.field->domain();
    if (options.eye_place == EyePlace::not_given && !domain.wraps) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            camera.eye[axis] = domain.origin[axis] + 0.5 * domain.size[axis];
        }
    }
    const double ground = land.surface_at(camera.eye[0], camera.eye[1]);
    const double wanted = camera.eye[2];
    switch (options.eye_place) {
        case EyePlace::not_given:
            camera.eye[2] = ground + kEyeHeight + 0.25 * land.rms;
            break;
        case EyePlace::on_ground:
            camera.eye[2] = ground + kEyeHeight;
            break;
        case EyePlace::at:
            camera.eye[2] = std::max(wanted, ground + lowest_eye(land));
            break;
    }
    if (options.look_at) camera.look_at(*options.look_at);
    if (options.eye_place != EyePlace::at || camera.eye[2] == wanted) return "";
    return format_text(
        "--eye: Z = %g is in the ground, which is %.2f m high there; it was raised "
        "to %.2f",
        wanted, ground, camera.eye[2]);
}

}  // namespace ocean::app
