// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/camera_control.hpp"

#include <algorithm>
#include <cmath>

namespace ocean::app {
namespace {

constexpr double kRadians = 0.017453292519943295;
constexpr double kEyeHeight = 1.7;       // [m], of a person who walks or sits in a boat
constexpr double kBoat = 2.5;            // [m] along each side
constexpr double kMinHeight = 0.3;       // [m] over the water, so that no wave hides the view
constexpr double kWheelStep = 1.15;      // factor of a distance or an angle
constexpr double kMaxHeight = 100000.0;  // [m]

double surface_height(Ocean& sea, double time, double x, double y) {
    const WorldPoint place{x, y};
    QuerySample sample{};
    sea.query(time, {&place, 1}, {&sample, 1}, {.foam = false});
    return sample.height;
}

}  // namespace

void CameraControl::step(const CameraInput& input, double seconds, Ocean& sea, double time) {
    preview::Camera& c = camera_;
    const double before_heading = c.heading * kRadians, before_pitch = c.pitch * kRadians;
    c.heading = std::remainder(c.heading + input.turn_left, 360.0);
    c.pitch = std::clamp(c.pitch + input.turn_up, -89.9, 89.9);
    const double h = c.heading * kRadians, p = c.pitch * kRadians;

    if (mode == CameraMode::orbit) {
        // Around the point that was ahead.
        const double d = orbit_distance_;
        const double x = c.eye[0] + d * std::cos(before_pitch) * std::cos(before_heading);
        const double y = c.eye[1] + d * std::cos(before_pitch) * std::sin(before_heading);
        const double z = c.eye[2] + d * std::sin(before_pitch);
        orbit_distance_ =
            std::clamp(d * std::pow(kWheelStep, -input.closer) * std::exp(-seconds * input.ahead),
                       1.0, kMaxHeight);
        c.eye = {x - orbit_distance_ * std::cos(p) * std::cos(h),
                 y - orbit_distance_ * std::cos(p) * std::sin(h),
                 std::max(kMinHeight, z - orbit_distance_ * std::sin(p))};
        return;
    }
    c.field_of_view = std::clamp(c.field_of_view * std::pow(kWheelStep, -input.closer), 1.0, 120.0);
    // A higher eye flies faster, so that the picture moves at the same rate.
    const double still = mode == CameraMode::fly ? std::max(6.0, 0.7 * c.eye[2]) : 3.0;
    const double step = still * (input.fast ? 6.0 : 1.0) * seconds;
    c.eye[0] += step * (input.ahead * std::cos(h) + input.right * std::sin(h));
    c.eye[1] += step * (input.ahead * std::sin(h) - input.right * std::cos(h));
    if (mode == CameraMode::fly) {
        const double climb = input.up + input.ahead * std::sin(p);
        c.eye[2] = std::clamp(c.eye[2] + step * climb, kMinHeight, kMaxHeight);
        return;
    }
    if (mode == CameraMode::walk) {
        c.eye[2] = std::max(kEyeHeight, surface_height(sea, time, c.eye[0], c.eye[1]) + kMinHeight);
        return;
    }
    const FloatBody body{c.eye[0], c.eye[1], c.heading, kBoat, kBoat};
    FloatPose pose{};
    sea.float_poses(time, {&body, 1}, {&pose, 1});
    c.eye[2] = pose.position[2] + kEyeHeight;
}

}  // namespace ocean::app
