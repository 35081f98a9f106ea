// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A drop in the air, from its birth alone: position and velocity at any age in closed form.
#pragma once

#include <array>
#include <cstdint>

#include "ocean/spray.hpp"

namespace ocean {

using Vector3 = std::array<double, 3>;  // x, y, z

/// The air over the crests, in which drops fall.
struct SprayAir {
    double wind_speed = 0.0;  // m/s, U10
    double direction = 0.0;   // radians from +x, counter-clockwise
    double gravity = 9.81;    // m/s^2
};

/// Returns the air in the strongest known wind; calm air if no wind is known.
SprayAir spray_air(const Parameters& parameters);
/// Returns u* = U10 sqrt(C_d) [m/s].
double friction_velocity(double wind_speed);
/// Returns the mean wind one metre above the crests [m/s].
double crest_wind(double wind_speed);
/// Returns the share of the whitecaps that the wind tears drops from, 0 .. 1.
double spume_onset(double wind_speed);
/// Returns the radius of drops [m] for a uniform number of [0, 1): each radius occurs with its
/// share of the water.
double spume_radius(double uniform);
/// Returns tau of dv/dt = -(v - u)/tau - g [s], for a drop that falls at its terminal velocity.
double response_time(double radius, double gravity);

/// The data that determine a particle's flight.
struct SprayBirth {
    std::uint64_t id;
    double since;      // time after its tick [s]
    Vector3 place;     // m
    Vector3 velocity;  // m/s
    Vector3 gust;      // m/s, the air's velocity
    double mixing;     // deviation of the air's vertical velocity [m/s]
    Vector3 drift;     // limit of its velocity: the air's minus the fall [m/s]
    double response;   // s
    double radius;     // m
    double life;       // s
};

/// Returns the particle at an age [s].
SprayParticle particle_at(const SprayBirth& birth, double age);
/// Returns the mist of a birth at an age below `lifetime` [s].
MistPuff puff_at(const SprayBirth& birth, double age, double lifetime);
/// Returns the age, at most `lifetime`, at which the drop falls through the level of still water
/// or, if born below it, through the height of its birth. The life of `birth` need not be set yet.
double life_of(const SprayBirth& birth, double lifetime);

}  // namespace ocean
