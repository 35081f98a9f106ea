// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Particles of spray: counted first, then copied out, computed once.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "guard.hpp"
#include "ocean/ocean.hpp"
#include "ocean/spray.hpp"
#include "sea_handle.hpp"

using namespace ocean;
using namespace ocean::capi;

namespace {

ocean_spray_particle particle_of(const SprayParticle& from) {
    return {from.id,
            {from.x, from.y, from.z},
            {static_cast<float>(from.vx), static_cast<float>(from.vy), static_cast<float>(from.vz)},
            static_cast<float>(from.age),
            static_cast<float>(from.life),
            static_cast<float>(from.radius)};
}

/// Returns the particles that an earlier call counted and that were not copied yet, or makes them
/// now.
std::vector<SprayParticle> spray_of(ocean_sea& sea, double time, const SpraySettings& settings) {
    const std::uint64_t revision = sea.ocean->revision();
    if (auto counted = std::exchange(sea.counted_spray, std::nullopt);
        counted && counted->revision == revision && counted->time == time &&
        counted->settings == settings) {
        return std::move(counted->particles);
    }
    return sea.ocean->spray(time, settings);
}

}  // namespace

ocean_result ocean_spray(ocean_sea* sea, const ocean_spray_request* request, size_t* count) {
    return in_handle(sea, [&] {
        require(request, "request");
        require(count, "count");
        const ocean_spray_request asked =
            read_struct(request, sizeof(ocean_spray_request), "ocean_spray_request");
        require_reserved(asked.reserved, "reserved");
        if (asked.particles != nullptr) {
            require_struct_size(asked.particle_size, sizeof(std::uint64_t), "particle_size",
                                "ocean_spray_particle", sizeof(ocean_spray_particle));
        }
        const SpraySettings settings{asked.lifetime, asked.density, asked.most};
        std::vector<SprayParticle> particles = spray_of(*sea, asked.time, settings);
        *count = particles.size();
        const bool fits = asked.particle_count >= particles.size();
        if (asked.particles == nullptr || !fits) {
            const std::size_t needed = particles.size();
            sea->counted_spray =
                CountedSpray{sea->ocean->revision(), asked.time, settings, std::move(particles)};
            if (asked.particles == nullptr) return;
            require_capacity("particle_count", asked.particle_count, needed,
                             "there are " + std::to_string(needed));
        }
        const std::size_t size = std::min(asked.particle_size, sizeof(ocean_spray_particle));
        auto* out = reinterpret_cast<unsigned char*>(asked.particles);
        for (const SprayParticle& from : particles) {
            const ocean_spray_particle particle = particle_of(from);
            std::memcpy(out, &particle, size);
            out += asked.particle_size;
        }
    });
}
