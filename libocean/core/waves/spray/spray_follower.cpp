// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spray over time; see spray_follower.hpp.
#include "waves/spray/spray_follower.hpp"

#include <algorithm>
#include <cmath>

#include "ocean/domain.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/sea.hpp"
#include "ocean/sea_bed.hpp"

namespace ocean {
namespace {

/// Returns the longest life [s]. In a loop a birth repeats, and a particle must be gone before its
/// copy appears, for at least as long as it lived.
double longest_life(const SpraySettings& settings, double loop_period) {
    return loop_period > 0.0 ? std::min(settings.lifetime, 0.5 * loop_period) : settings.lifetime;
}

/// Returns the number of ticks whose particles may live: one more than a life spans, because a
/// particle is born within a step after its tick, and the newest tick.
std::int64_t living_ticks(const FoamClock& clock, double lifetime) {
    const auto ticks = static_cast<std::int64_t>(std::floor(lifetime / clock.step)) + 2;
    return clock.ticks_per_loop > 0 ? std::min(ticks, clock.ticks_per_loop) : ticks;
}

void require_range(const char* name, double value, double least, double most) {
    if (value >= least && value <= most) return;
    const std::string given = to_text(value);
    const std::string allowed = to_text(least) + " .. " + to_text(most);
    throw Error(ErrorKind::invalid_value,
                std::string("spray: ") + name + " = " + given + "; allowed: " + allowed,
                {.parameter = name, .value = given, .allowed = allowed});
}

/// Returns the strongest wind that a sea has at any time [m/s].
double strongest_wind_ever(const Sea& sea) {
    double strongest = 0.0;
    for (const WaveSystem& system : sea.parameters.waves) {
        strongest = std::max(strongest, system.wind_above().value_or(0.0));
    }
    for (const TakeEvent& event : sea.take.events) {
        if (!event.parameter.info->holds<&WaveSystem::wind_speed>()) continue;
        if (const auto* wind = std::get_if<double>(&event.value)) {
            strongest = std::max(strongest, *wind);
        }
    }
    return strongest;
}

}  // namespace

void validate(const SpraySettings& settings) {
    require_range("lifetime", settings.lifetime, 0.05, 10.0);
    require_range("density", settings.density, 0.0, 1000.0);
    require_range("most", settings.most, 1, 1e8);
}

namespace {

/// Returns the number of cells along a side of that length [m].
int cells_along(double side) {
    constexpr int kMin = 64, kUsual = 512, kMax = 1024;
    int n = kMin;
    while (n < kMax && side / n > (n < kUsual ? 2.5 : 4.0)) n *= 2;
    return n;
}

}  // namespace

Lattice spray_lattice(const Grid& grid) {
    return {std::min(cells_along(grid.patch_size), default_map_resolution(grid)), grid.patch_size};
}

Domain spray_domain(const Parameters& parameters, const std::optional<Domain>& region) {
    const SeaBed* const bed = parameters.water.bed.get();
    if (!bed && !region) {
        const Lattice lattice = spray_lattice(parameters.grid);
        return Domain::tile(lattice.period, lattice.resolution);
    }
    const Domain& part = bed ? bed->domain : *region;
    const double side = std::max(part.size[0], part.size[1]);
    return with_cell(part, side / cells_along(side));
}

std::uint64_t spray_map_bytes(const Domain& domain) {
    // The map, that of the next tick, and a mask of what is dry.
    return domain.count() * (2 * kSprayChannels.size() + 1) * sizeof(float);
}

std::uint64_t max_spray_particles(const Sea& sea, const SpraySettings& settings,
                                  const std::optional<Domain>& region) {
    const Parameters& parameters = sea.parameters;
    const double wind = strongest_wind_ever(sea);
    const double density = settings.density * spume_onset(wind);
    if (density <= 0.0) return 0;
    double most = settings.most;
    const auto plays_coverage = [](const TakeEvent& event) {
        return event.parameter.info->holds<&SurfaceSettings::foam_coverage>();
    };
    const bool by_wind = !parameters.water.bed && !region &&  // depth and wakes break waves too
                         parameters.surface.foam_coverage == FoamCoverage::monahan &&
                         std::ranges::none_of(sea.take.events, plays_coverage);
    if (by_wind) {
        // In seas of 9 to 30 m/s a place stays white for longer than this; a few crests more are
        // random.
        constexpr double kShortestWhite = 0.25;  // s
        const double area = parameters.grid.patch_size * parameters.grid.patch_size;
        const double rate = monahan_coverage(wind) * area / kShortestWhite;
        const double lifetime = longest_life(settings, parameters.time.loop_period);
        const double mean = density * rate * lifetime;
        most = std::min(most, mean + 10.0 * std::sqrt(mean));
    }
    return static_cast<std::uint64_t>(std::ceil(most));
}

std::uint64_t spray_bytes(std::uint64_t particles) {
    return particles * (sizeof(SprayBirth) + sizeof(SprayParticle));
}

SprayFollower::SprayFollower(const SpraySettings& settings, const FoamClock& clock,
                             const Domain& domain, std::uint32_t seed)
    : settings_(settings),
      clock_(clock),
      seed_(seed),
      lifetime_(longest_life(settings, clock.loop_period)),
      ticks_(living_ticks(clock, lifetime_)),
      map_(domain, 0.0, kSprayChannels) {}

void SprayFollower::go_to(double time, const SpraySource& source) {
    now_ = clock_.moment(time);
    for (std::int64_t back = ticks_ - 1; back >= 0; --back) {
        const std::int64_t tick = clock_.before(now_.tick, back);
        if (!born_.contains(tick)) make(tick, source);
    }
    forget_far_from(now_.tick);
}

template <typename Visit>
void SprayFollower::for_each_birth(const Visit& visit) const {
    for (std::int64_t back = ticks_ - 1; back >= 0; --back) {
        const double since = now_.since + static_cast<double>(back) * clock_.step;
        for (const SprayBirth& birth : born_.at(clock_.before(now_.tick, back))) {
            const double age = since - birth.since;
            if (age >= 0.0 && age < lifetime_) visit(birth, age);
        }
    }
}

std::vector<SprayParticle> SprayFollower::particles() const {
    std::vector<SprayParticle> particles;
    for_each_birth([&](const SprayBirth& birth, double age) {
        if (age < birth.life) particles.push_back(particle_at(birth, age));
    });
    return particles;
}

std::vector<MistPuff> SprayFollower::mist() const {
    std::vector<MistPuff> puffs;
    for_each_birth([&](const SprayBirth& birth, double age) {
        puffs.push_back(puff_at(birth, age, lifetime_));
    });
    return puffs;
}

void SprayFollower::make(std::int64_t tick, const SpraySource& source) {
    const std::int64_t before = clock_.before(tick, 1);
    if (white_tick_ != before) {
        // Requests all channels, as at any tick: the last bits of one channel may depend on the
        // others.
        source.tick(clock_.time_of(before), map_);
        white_ = white_cells(map_);
        white_tick_ = before;
    }
    const SprayAir air = source.tick(clock_.time_of(tick), map_);
    const SprayTick now{seed_,
                        tick,
                        clock_.step,
                        lifetime_,
                        settings_.density,
                        static_cast<double>(settings_.most) / static_cast<double>(ticks_),
                        air};
    born_[tick] = births_of(now, map_, white_);
    white_ = white_cells(map_);
    white_tick_ = tick;
}

void SprayFollower::forget_far_from(std::int64_t tick) {
    constexpr std::int64_t kSlack = 3;  // sub-frames may step back, and a sequence run backwards
    std::erase_if(born_, [&](const auto& kept) {
        const std::int64_t older = clock_.ticks_between(kept.first, tick);
        const std::int64_t newer = clock_.ticks_between(tick, kept.first);
        const bool near = (older >= 0 && older < ticks_ + kSlack) || (newer >= 0 && newer < kSlack);
        return !near;
    });
}

void SprayFollower::forget_from(double time) {
    std::erase_if(born_, [&](const auto& kept) { return clock_.time_of(kept.first) >= time; });
    white_tick_.reset();
}

}  // namespace ocean
