// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How keys, mouse and joystick move the camera.
#pragma once

#include "ocean/ocean.hpp"
#include "ocean/preview/picture.hpp"

namespace ocean::app {

enum class CameraMode { fly, walk, orbit, floating };

/// What a person asks of the camera in one step; -1 .. 1 where it is a direction.
struct CameraInput {
    double ahead = 0.0;
    double right = 0.0;
    double up = 0.0;
    double turn_left = 0.0;  // degrees
    double turn_up = 0.0;    // degrees
    double closer = 0.0;     // steps of a wheel
    bool fast = false;
};

class CameraControl {
  public:
    explicit CameraControl(const preview::Camera& camera) : camera_(camera) {}

    /// Moves for so many seconds. The sea says where walking feet and floats are.
    void step(const CameraInput& input, double seconds, Ocean& sea, double time);
    void reset(const preview::Camera& camera) { camera_ = camera; }

    const preview::Camera& camera() const { return camera_; }
    preview::Camera& camera() { return camera_; }
    CameraMode mode = CameraMode::fly;

  private:
    preview::Camera camera_;
    double orbit_distance_ = 60.0;  // m
};

}  // namespace ocean::app
