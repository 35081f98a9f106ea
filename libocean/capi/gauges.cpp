// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Wave gauges: checks the request and copies their series out.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "guard.hpp"
#include "ocean/internal/gauge_series.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/ocean.hpp"
#include "sea_handle.hpp"

using namespace ocean;
using namespace ocean::capi;

namespace {

constexpr std::size_t kFixDoubles = 4;
constexpr std::size_t kMaxTimes = 100'000'000;

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
