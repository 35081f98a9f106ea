// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spray: the drops that a strong wind tears off whitecaps. Crests merge and split, so a crest
// cannot be followed; an event can: the whitecap of one cell of a fixed lattice of the sea crosses
// 1/2 upwards at a tick of the foam's clock. Particles are born there, and each is a pure function
// of its birth: its position, its velocity and its end. Spray is the stage between the whitecap
// maps of the surface and the files of points; Ocean::spray follows it over time. Over a bed the
// fronts of waves that break by the depth turn white too, and the wind tears drops off them as off
// whitecaps. A region of a sea with hulls throws spray where the sum of waves and wakes breaks; the
// sheets that a bow throws up in calm air are no whitecaps, and none.
//
// A particle stands for a parcel of drops of one size. The number of drops is known only to a
// factor of a million [Andreas 1998], so the density is an artistic choice.
//
//     const SpraySettings settings{.lifetime = 2.0, .density = 0.25};
//     for (const SprayParticle& drop : ocean.spray(12.0, settings)) {
//         draw(drop.x, drop.y, drop.z, drop.radius);
//     }
//     for (const MistPuff& puff : ocean.mist(12.0, settings)) {
//         blur(puff.x, puff.y, puff.z, puff.deviation);
//     }
#pragma once

#include <cstdint>
#include <optional>

#include "ocean/channel.hpp"
#include "ocean/domain.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

struct Lattice;
struct Sea;

/// The settings of spray; everything else follows from the sea.
struct SpraySettings {
    /// Max age of a particle [s], 0.05 .. 10; in a loop at most half the loop.
    double lifetime = 2.0;
    /// Particles for each square metre that turns white, by label as whitecaps are counted, 0 ..
    /// 1000. Winds below 11 m/s make fewer, below 7 m/s none.
    double density = 0.25;
    /// Approximate max of particles alive at once, 1 .. 100 million: a tick that would exceed its
    /// share makes that share only, thinned evenly over the sea.
    int most = 1'000'000;

    bool operator==(const SpraySettings&) const = default;
};
/// Throws Error invalid_value for settings out of range.
void validate(const SpraySettings& settings);

/// A particle at one time. Right-handed, z up.
struct SprayParticle {
    /// A hash of seed, cell, tick and number within the event: the same in every frame of the
    /// particle's life, and in a loop at every repetition. Two of a million particles share an id
    /// with a probability of 3e-8; two particles of one tick never do.
    std::uint64_t id;
    double x, y, z;     // [m]; born within one period, which it may leave; copies tile, but
                        // not over a bed and not of a region
    double vx, vy, vz;  // d/dt of the position [m/s]
    double age;         // since its birth [s]
    double life;        // age at which it ends, fixed at its birth [s]
    double radius;      // of each drop [m]
};

/// A puff of mist that the birth of a particle leaves in the air: drops too small to fall, which
/// move with the gust that tore them off, and spread. A Gaussian.
struct MistPuff {
    double x, y, z;    // its centre [m]
    double deviation;  // [m]
    double share;      // remaining share of the initial mass, 1 .. 0
};

/// Returns the lattice that spray is emitted on: a power of two that depends only on the size of
/// the patch, with cells of at most 2.5 m, or 512 cells along a side if these are larger.
/// Independent of all settings.
Lattice spray_lattice(const Grid& grid);
/// Returns the samples that spray is emitted on: spray_lattice's, or for a sea over a bed the whole
/// bed, else for a region of a sea with hulls that region, with cells by the same rule for its
/// longer side.
Domain spray_domain(const Parameters& parameters, const std::optional<Domain>& region = {});
/// The channels that a map of spray_domain's samples must have.
inline constexpr ChannelSet kSprayChannels = {Channel::dx,      Channel::dy, Channel::height,
                                              Channel::vx,      Channel::vy, Channel::vz,
                                              Channel::whitecap};

/// Returns an upper bound of the particles alive at once at any time of the sea. If foam_coverage
/// knows the wind, its whitecap coverage bounds them more closely than SpraySettings::most, but not
/// those of a region.
std::uint64_t max_spray_particles(const Sea& sea, const SpraySettings& settings,
                                  const std::optional<Domain>& region = {});
/// Returns the bytes of the maps of a spray_domain that does not repeat.
std::uint64_t spray_map_bytes(const Domain& domain);
/// Returns the bytes for following that many particles, which are included, beside the maps of the
/// lattice.
std::uint64_t spray_bytes(std::uint64_t particles);

}  // namespace ocean
