// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/camera_control.hpp"

#include <algorithm>
#include <cmath>

#include "land_camera.hpp"

namespace ocean::app {
namespace {

constexpr double kRadians = 0.017453292519943295;
constexpr double kWheelStep = 1.15;      // factor of a distance or an angle
constexpr double kMaxHeight = 100000.0;  // [m]

/// Returns the lowest height of an eye that flies [m].
double lowest_flight(const CameraGround& ground, const preview::Camera& camera) {
    const double surface = ground.is_solid ? ground.height(camera.eye[0], camera.eye[1]) : 0.0;
    return surface + ground.clearance;
}

}  // namespace

void CameraControl::step(const CameraInput& input, double seconds, const CameraGround& ground) {
    preview::Camera& c = camera_;
    const preview::Camera before = c;
    c.heading = std::remainder(c.heading + input.turn_left, 360.0);
    c.pitch = std::clamp(c.pitch + input.turn_up, -89.9, 89.9);
    if (mode == CameraMode::orbit) return orbit(input, seconds, before, ground);

    const double h = c.heading * kRadians, p = c.pitch * kRadians;
    c.field_of_view = std::clamp(c.field_of_view * std::pow(kWheelStep, -input.closer), 1.0, 120.0);
    // A higher eye flies faster, so that the picture moves at the same rate.
    const double over = ground.is_solid ? c.eye[2] - ground.height(c.eye[0], c.eye[1]) : c.eye[2];
    const double still = mode == CameraMode::fly ? std::max(6.0, 0.7 * over) : 3.0;
    const double step = still * (input.fast ? 6.0 : 1.0) * seconds;
    c.eye[0] += step * (input.ahead * std::cos(h) + input.right * std::sin(h));
    c.eye[1] += step * (input.ahead * std::sin(h) - input.right * std::cos(h));
    if (mode == CameraMode::fly) {
        const double climb = input.up + input.ahead * std::sin(p);
        c.eye[2] = std::clamp(c.eye[2] + step * climb, lowest_flight(ground, c), kMaxHeight);
        return;
    }
    if (mode == CameraMode::floating && ground.boat) {
        c.eye[2] = ground.boat(c.eye[0], c.eye[1], c.heading) + kEyeHeight;
        return;
    }
    const double surface = ground.height(c.eye[0], c.eye[1]);
    c.eye[2] =
        ground.is_solid ? surface + kEyeHeight : std::max(kEyeHeight, surface + ground.clearance);
}

/// Turns around the point that was ahead.
void CameraControl::orbit(const CameraInput& input, double seconds, const preview::Camera& before,
                          const CameraGround& ground) {
    preview::Camera& c = camera_;
    const double before_heading = before.heading * kRadians, before_pitch = before.pitch * kRadians;
    const double h = c.heading * kRadians, p = c.pitch * kRadians;
    const double d = orbit_distance_;
    const double x = c.eye[0] + d * std::cos(before_pitch) * std::cos(before_heading);
    const double y = c.eye[1] + d * std::cos(before_pitch) * std::sin(before_heading);
    const double z = c.eye[2] + d * std::sin(before_pitch);
    orbit_distance_ =
        std::clamp(d * std::pow(kWheelStep, -input.closer) * std::exp(-seconds * input.ahead), 1.0,
                   kMaxHeight);
    c.eye[0] = x - orbit_distance_ * std::cos(p) * std::cos(h);
    c.eye[1] = y - orbit_distance_ * std::cos(p) * std::sin(h);
    c.eye[2] = std::max(lowest_flight(ground, c), z - orbit_distance_ * std::sin(p));
}

}  // namespace ocean::app
