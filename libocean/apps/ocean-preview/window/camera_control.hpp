// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The camera's movements by keys, mouse and gamepad.
#pragma once

#include "ocean/internal/preview/picture.hpp"
#include "scene.hpp"

namespace ocean::app {

enum class CameraMode { fly, walk, orbit, floating };
/// Returns the number of modes over a ground: without a boat none floats.
inline int camera_modes(const CameraGround& ground) {
    return ground.boat ? 4 : 3;
}

/// The requested movement of the camera in one step; directions are -1 .. 1.
struct CameraInput {
    double ahead = 0.0;
    double right = 0.0;
    double up = 0.0;
    double turn_left = 0.0;  // [degrees]
    double turn_up = 0.0;    // [degrees]
    double closer = 0.0;     // steps of a wheel
    bool fast = false;
};

class CameraControl {
  public:
    explicit CameraControl(const preview::Camera& camera) : camera_(camera) {}

    /// Moves the camera for so many seconds. A walking or floating camera is carried by the
    /// surface; one that floats walks where nothing floats. Throws Error.
    void step(const CameraInput& input, double seconds, const CameraGround& ground);
    /// Carries or raises the camera after a change of the surface. Throws Error.
    void stay_above(const CameraGround& ground) { step({}, 0.0, ground); }
    void reset(const preview::Camera& camera) { camera_ = camera; }

    const preview::Camera& camera() const { return camera_; }
    preview::Camera& camera() { return camera_; }
    CameraMode mode = CameraMode::fly;

  private:
    void orbit(const CameraInput& input, double seconds, const preview::Camera& before,
               const CameraGround& ground);

    preview::Camera camera_;
    double orbit_distance_ = 60.0;  // [m]
};

}  // namespace ocean::app
