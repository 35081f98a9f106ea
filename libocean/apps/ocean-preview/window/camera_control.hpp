// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The camera's movements by keys, mouse and gamepad.
#pragma once

#include "ocean/ocean.hpp"
#include "ocean/preview/picture.hpp"

namespace ocean::app {

enum class CameraMode { fly, walk, orbit, floating };

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

    /// Moves the camera for so many seconds. A walking or floating camera is carried by the sea at
    /// a time [s]. Throws Error.
    void step(const CameraInput& input, double seconds, Ocean& sea, double time);
    void reset(const preview::Camera& camera) { camera_ = camera; }

    const preview::Camera& camera() const { return camera_; }
    preview::Camera& camera() { return camera_; }
    CameraMode mode = CameraMode::fly;

  private:
    preview::Camera camera_;
    double orbit_distance_ = 60.0;  // [m]
};

}  // namespace ocean::app
