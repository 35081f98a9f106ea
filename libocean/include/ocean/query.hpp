// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Queries: the displayed surface at points of the world: height, normal, velocity and foam at a
// buoy, a ship or a camera; the pose of a floating body on it; and the motion of the water below
// it.
//
//     const WorldPoint buoys[] = {{10.0, 20.0}, {30.0, 20.0}};
//     QuerySample samples[2];
//     ocean.query(12.0, buoys, samples, {.foam = false});
//     place(samples[0].height, samples[0].normal);
//
//     const FloatBody boat{.x = 0.0, .y = 0.0, .heading = 90.0, .length = 12.0, .width = 4.0};
//     FloatPose pose;
//     ocean.float_poses(12.0, {&boat, 1}, {&pose, 1});
#pragma once

namespace ocean {

/// A position on the surface, whose height a query finds.
struct WorldPoint {
    double x;  // [m]
    double y;
};

/// A point in the water; z up from still water.
struct WaterPoint {
    double x;  // [m]
    double y;
    double z;
};

struct QuerySample {
    double height;       // [m]
    double normal[3];    // unit, of the displayed surface, on the side seen from above
    double velocity[3];  // d/dt of the displayed point at its label [m/s]
    double label[2];     // the label displayed here [m]
    double foam;         // 0 .. 1
    bool folded;         // several labels are displayed here: this is the top one
    bool undecided;      // the search may have missed a label: perhaps not the top one
};

struct QueryOptions {
    bool exact = false;  // sum all modes in double precision
    int refine = 1;      // 1, 2, 4 ...: interpolate on maps finer by this factor
    bool foam = true;    // false: foam is 0 and costs nothing
    /// Samples of the displayed map: shorter waves do not count. 0 = the modes' own resolution.
    int resolution = 0;

    bool operator==(const QueryOptions&) const = default;
};

/// The rectangle that a body covers on the water.
struct FloatBody {
    double x, y;     // its centre [m]
    double heading;  // of its bow, counter-clockwise from +x (east) [degrees]
    double length;   // along the heading [m]
    double width;    // [m]
};

struct FloatPose {
    double position[3];  // the body's x and y, and the height of the plane there [m]
    double up[3];        // unit vectors of the tilted body
    double forward[3];
    double pitch;  // bow up [degrees]
    double roll;   // port side (left of the heading) up [degrees]
};

/// The motion of the water at a fixed point, by linear theory.
struct WaterMotion {
    double velocity_x, velocity_y, velocity_z;  // [m/s]
    double pressure;                            // without the hydrostatic part [Pa]

    bool operator==(const WaterMotion&) const = default;
};

}  // namespace ocean
