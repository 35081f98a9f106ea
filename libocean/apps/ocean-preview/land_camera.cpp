// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "land_camera.hpp"

#include <algorithm>

#include "ocean/internal/text.hpp"

namespace ocean::app {

/// Height of an eye without --eye over the surface of a coast [m].
constexpr double kOverCoast = 8.0;

double lowest_eye(const preview::DrawnLand& land) {
    return std::min(0.3, 0.2 * preview::texel_of(land));
}

double lowest_eye(const preview::DrawnCoast&) {
    return 0.3;
}

namespace {

/// rise: of an eye without --eye over the surface [m].
template <typename Shown>
std::string place_on(const PreviewOptions& options, const Shown& shown, const Domain& domain,
                     double rise, preview::Camera& camera) {
    if (options.eye_place == EyePlace::not_given && !domain.wraps) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            camera.eye[axis] = domain.origin[axis] + 0.5 * domain.size[axis];
        }
    }
    const double ground = shown.surface_at(camera.eye[0], camera.eye[1]);
    const double wanted = camera.eye[2];
    switch (options.eye_place) {
        case EyePlace::not_given:
            camera.eye[2] = ground + rise;
            break;
        case EyePlace::on_ground:
            camera.eye[2] = ground + kEyeHeight;
            break;
        case EyePlace::at:
            camera.eye[2] = std::max(wanted, ground + lowest_eye(shown));
            break;
    }
    if (options.look_at) camera.look_at(*options.look_at);
    if (options.eye_place != EyePlace::at || camera.eye[2] == wanted) return "";
    return format_text(
        "--eye: Z = %g is in the ground, which is %.2f m high there; it was raised "
        "to %.2f",
        wanted, ground, camera.eye[2]);
}

}  // namespace

std::string place_on_land(const PreviewOptions& options, const preview::DrawnLand& land,
                          preview::Camera& camera) {
    return place_on(options, land, land.function->domain(), kEyeHeight + 0.25 * land.rms, camera);
}

std::string place_on_coast(const PreviewOptions& options, const preview::DrawnCoast& coast,
                           preview::Camera& camera) {
    return place_on(options, coast, coast.bed->domain, kOverCoast, camera);
}

std::array<double, 3> eye_on_coast(const PreviewOptions& options, const SeaBed& bed) {
    std::array<double, 3> eye = options.camera.eye;
    if (options.eye_place == EyePlace::at) return eye;
    for (std::size_t axis = 0; axis < 2 && options.eye_place == EyePlace::not_given; ++axis) {
        eye[axis] = bed.domain.origin[axis] + 0.5 * bed.domain.size[axis];
    }
    eye[2] = kEyeHeight;
    return eye;
}

}  // namespace ocean::app
