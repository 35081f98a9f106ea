// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Wave gauges, spray, crests and textures of foam: checks each request and copies its answer out.
// Particles of spray are counted first and computed once.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "guard.hpp"
#include "ocean/internal/find_crest.hpp"
#include "ocean/internal/foam_texture.hpp"
#include "ocean/internal/gauge_series.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/ocean.hpp"
#include "ocean/spray.hpp"
#include "ocean/thread_pool.hpp"
#include "outputs.hpp"
#include "sea_handle.hpp"

using namespace ocean;
using namespace ocean::capi;

namespace {

constexpr std::size_t kFixDoubles = 4;
constexpr std::size_t kMaxTimes = 100'000'000;
constexpr double kShortestSide = 1.0;  // of a region of spray [m]

SampleTimes sample_times(const ocean_gauge_request& asked) {
    require_time(asked.start);
    require_time(asked.end);
    if (!(asked.end >= asked.start)) {
        refuse({.parameter = "end",
                .value = std::to_string(asked.end),
                .allowed = "start = " + std::to_string(asked.start) + " or later"});
    }
    if (!(asked.rate > 0.0) || !((asked.end - asked.start) * asked.rate < kMaxTimes)) {
        refuse({.parameter = "rate",
                .value = std::to_string(asked.rate),
                .allowed = "more than 0 Hz, and at most " + std::to_string(kMaxTimes) + " times"});
    }
    return {asked.start, asked.end, asked.rate};
}

Gauge gauge_of(const ocean_gauge& from, const std::string& name) {
    require(from.fixes, (name + ".fixes").c_str());
    if (from.fix_count == 0) {
        refuse({.parameter = name + ".fix_count", .value = "0", .allowed = "1 or more"});
    }
    Gauge gauge{name, {}, from.velocity[0], from.velocity[1]};
    for (std::size_t i = 0; i < from.fix_count; ++i) {
        const double* fix = from.fixes + kFixDoubles * i;
        const std::string which = name + ".fixes[" + std::to_string(i) + "]";
        if (!std::all_of(fix, fix + kFixDoubles, [](double x) { return std::isfinite(x); })) {
            refuse({.what = "a number is not finite", .parameter = which});
        }
        if (i > 0 && !(fix[0] > gauge.track.back().time)) {
            refuse({.what = "is no later than the one before it", .parameter = which});
        }
        gauge.track.push_back({fix[0], {fix[1], fix[2], fix[3]}});
    }
    if (!std::isfinite(gauge.velocity_x) || !std::isfinite(gauge.velocity_y)) {
        refuse({.what = "is not finite", .parameter = name + ".velocity"});
    }
    return gauge;
}

std::vector<Gauge> gauges_of(const ocean_gauge_request& asked) {
    require_struct_size(asked.gauge_size, sizeof(ocean_gauge), "gauge_size", "ocean_gauge",
                        sizeof(ocean_gauge));
    if (asked.gauge_count > 0) require(asked.gauges, "gauges");
    std::vector<Gauge> gauges;
    const auto* bytes = reinterpret_cast<const unsigned char*>(asked.gauges);
    for (std::size_t g = 0; g < asked.gauge_count; ++g, bytes += asked.gauge_size) {
        gauges.push_back(gauge_of(read_bytes<ocean_gauge>(bytes, asked.gauge_size, "ocean_gauge"),
                                  "gauges[" + std::to_string(g) + "]"));
    }
    return gauges;
}

ocean_spray_particle particle_of(const SprayParticle& from) {
    return {from.id,
            {from.x, from.y, from.z},
            {static_cast<float>(from.vx), static_cast<float>(from.vy), static_cast<float>(from.vz)},
            static_cast<float>(from.age),
            static_cast<float>(from.life),
            static_cast<float>(from.radius)};
}

/// Returns the region of a request; nothing if all its numbers are 0. Throws CallError.
std::optional<Domain> spray_region(const ocean_spray_request& asked) {
    const auto& [x0, y0, x1, y1] = asked.region;
    if (x0 == 0.0 && y0 == 0.0 && x1 == 0.0 && y1 == 0.0) return std::nullopt;
    require_metres("region[0]", x0, -kFarthest);
    require_metres("region[1]", y0, -kFarthest);
    require_metres("region[2]", x1, x0 + kShortestSide);
    require_metres("region[3]", y1, y0 + kShortestSide);
    return Domain{{x0, y0}, {x1 - x0, y1 - y0}, {2, 2}, false};
}

/// Returns the particles that an earlier call counted and that were not copied yet, or makes them
/// now.
std::vector<SprayParticle> spray_of(ocean_sea& sea, double time, const SpraySettings& settings,
                                    const std::optional<Domain>& region) {
    const std::uint64_t revision = sea.ocean->revision();
    if (auto counted = std::exchange(sea.counted_spray, std::nullopt);
        counted && counted->revision == revision && counted->time == time &&
        counted->settings == settings && counted->region == region) {
        return std::move(counted->particles);
    }
    return sea.ocean->spray(time, settings, region);
}

}  // namespace

ocean_result ocean_gauges(ocean_sea* sea, const ocean_gauge_request* request, size_t* times) {
    return in_handle(sea, [&] {
        require(request, "request");
        require(times, "times");
        const ocean_gauge_request asked =
            read_struct(request, sizeof(ocean_gauge_request), "ocean_gauge_request");
        const SampleTimes when = sample_times(asked);
        const std::vector<Gauge> gauges = gauges_of(asked);
        *times = when.count();
        if (asked.values == nullptr) return;
        const std::size_t needed = when.count() * gauges.size() * GaugeSeries::kColumns.size();
        require_capacity("value_count", asked.value_count, needed,
                         std::to_string(when.count()) + " times of " +
                             std::to_string(gauges.size()) + " gauges need " +
                             std::to_string(needed));
        Ocean& ocean = *sea->ocean;
        require_memory(gauge_series_bytes(ocean.modes(), ocean.parameters(), gauges, when.count(),
                                          ocean.pool().size()),
                       "a series of so many readings", "ask for fewer at once");
        const GaugeSeries series =
            read_gauge_series(ocean, gauges, when, ocean.pool(), [](std::size_t) {});
        std::ranges::copy(series.values, asked.values);
    });
}

ocean_result ocean_spray(ocean_sea* sea, const ocean_spray_request* request, size_t* count) {
    return in_handle(sea, [&] {
        require(request, "request");
        require(count, "count");
        const ocean_spray_request asked =
            read_struct(request, offsetof(ocean_spray_request, region), "ocean_spray_request");
        require_reserved(asked.reserved, "reserved");
        if (asked.particles != nullptr) {
            require_struct_size(asked.particle_size, sizeof(std::uint64_t), "particle_size",
                                "ocean_spray_particle", sizeof(ocean_spray_particle));
        }
        const SpraySettings settings{asked.lifetime, asked.density, asked.most};
        const std::optional<Domain> region = spray_region(asked);
        std::vector<SprayParticle> particles = spray_of(*sea, asked.time, settings, region);
        *count = particles.size();
        const bool fits = asked.particle_count >= particles.size();
        if (asked.particles == nullptr || !fits) {
            const std::size_t needed = particles.size();
            sea->counted_spray = CountedSpray{sea->ocean->revision(), asked.time, settings, region,
                                              std::move(particles)};
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

ocean_result ocean_find_crest(ocean_sea* sea, double from, double to, const double* box,
                              ocean_crest* crest) {
    return in_handle(sea, [&] {
        require_time(from);
        require_time(to);
        require(crest, "crest");
        require_struct_size(crest->struct_size, sizeof(ocean_crest), "struct_size", "ocean_crest",
                            sizeof(ocean_crest));
        CrestWindow window{.from = from, .to = to};
        if (box != nullptr) {
            for (std::size_t i = 0; i < 4; ++i) {
                require_finite(box[i], "box[" + std::to_string(i) + "]", "m");
            }
            window.place = {box[0], box[1], box[2], box[3]};
        }
        const FoundCrest found = find_highest_crest(*sea->ocean, window);
        *crest = {sizeof(ocean_crest), found.time, found.x, found.y, found.height};
    });
}

ocean_result ocean_foam_texture(const ocean_foam_texture_request* request,
                                const ocean_options* options, double* period) {
    return guarded([&] {
        const ocean_foam_texture_request asked =
            read_struct(request, sizeof(ocean_foam_texture_request), "ocean_foam_texture_request");
        require(asked.kind, "kind");
        const FoamTextureSettings settings{find_foam_texture(asked.kind), asked.size, asked.seed};
        require_foam_texture_size(settings.size);
        const OceanOptions given = read_options(options);
        const auto side = static_cast<std::size_t>(settings.size);
        if (asked.data != nullptr) {
            require_capacity("count", asked.count, side * side,
                             "the texture has " + std::to_string(side * side) + " texels");
            ThreadPool pool(given.threads, given.run_jobs);
            pool.set_interrupt(given.interrupt);
            std::ranges::copy(make_foam_texture(settings, pool), asked.data);
        }
        if (period != nullptr) *period = foam_texture_info(settings.kind).period;
    });
}
