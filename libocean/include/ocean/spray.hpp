// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spray: the drops that a strong wind tears off where the sea turns white. Crests merge and split
// and have no names that last; events have: a cell of one fixed lattice of the sea whose whitecap
// crosses 1/2 upwards at a tick of the foam's clock. Particles are born there, and each is a pure
// function of its birth: where it is, how fast, and when it ends. Between the whitecap maps of the
// surface and the files of points; Ocean::spray follows it over time.
//
// A particle stands for a parcel of drops of one size: how many drops there are is known to a
// factor of a million [Andreas 1998], so that the density is for who makes the picture to choose.
#pragma once

#include <cstdint>

#include "ocean/channel.hpp"
#include "ocean/grid.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

struct Sea;

/// What is asked for; all else is the sea's.
struct SpraySettings {
    /// s, the greatest age of a particle: 0.05 .. 10. In a loop at most half the loop.
    double lifetime = 2.0;
    /// Particles for each square metre that turns white, by label as whitecaps are counted:
    /// 0 .. 1000. In winds below 11 m/s fewer, below 7 m/s none.
    double density = 0.25;
    /// Alive at once, about: where a tick would make more than its share of these it makes so
    /// many, all over the sea alike. 1 .. 100 million.
    int most = 1'000'000;

    bool operator==(const SpraySettings&) const = default;
};
/// Throws Error invalid_value for what is out of range.
void validate(const SpraySettings& settings);

/// At one time. Right-handed, z up.
struct SprayParticle {
    /// A hash of seed, cell, tick and number in its event: the same from birth to end in every
    /// frame, in a loop every time round. Of a million particles two share one with a probability
    /// of 3e-8, of the same tick never.
    std::uint64_t id;
    double x, y, z;     // m; born within one period, then it may leave it: copies tile
    double vx, vy, vz;  // m/s, d/dt of the place
    double age;         // s since its birth
    double life;        // s, the age at which it ends: known from its birth
    double radius;      // m, of each of its drops
};

/// Mist that the birth of a particle leaves in the air: of drops too small to fall, which go with
/// the gust that tore them off, and spread. A Gaussian.
struct MistPuff {
    double x, y, z;    // m, its middle
    double deviation;  // m
    double share;      // 1 .. 0 of what it began with
};

/// The lattice that spray is emitted on: a power of two by the size of the patch, with cells of at
/// most 2.5 m as long as 512 a side are enough. Of the sea alone, never of what is asked for.
Lattice spray_lattice(const Grid& grid);
/// What a map of it must hold.
inline constexpr ChannelSet kSprayChannels = {Channel::dx,      Channel::dy, Channel::height,
                                              Channel::vx,      Channel::vy, Channel::vz,
                                              Channel::whitecap};

/// Particles that are alive at once at any time of the sea, at most; a whitecap coverage of the
/// wind that `foam_coverage` knows of bounds them closer than SpraySettings::most.
std::uint64_t most_spray(const Sea& sea, const SpraySettings& settings);
/// Bytes that following so many takes beside the maps of the lattice, their particles included.
std::uint64_t spray_bytes(std::uint64_t particles);

}  // namespace ocean
