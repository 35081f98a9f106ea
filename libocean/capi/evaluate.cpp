// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks what a host asks for and has the maps written into its buffers, vectors turned to its
// axes.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "guard.hpp"
#include "ocean/detail.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/sea_bed.hpp"
#include "outputs.hpp"
#include "sea_handle.hpp"

namespace ocean::capi {
namespace {

/// The bytes of a band that has its mean_square.
constexpr std::size_t kMeanSquareEnd = sizeof(ocean_detail_band);

/// Returns the mean square of the slopes that a reader finds between the samples of a periodic map,
/// 0 for a map without both slopes. With weights 1 - t and t along each side the mean over all
/// places is (2, 1) / 3 of the covariance at lags 0 and 1:
///     (4 C(0,0) + 2 (C(1,0) + C(0,1)) + (C(1,1) + C(1,-1)) / 2) / 9
double read_mean_square(const MapOutput& map, int samples) {
    const auto component = [&map](Channel channel) {
        const auto used = map.used();
        return static_cast<std::size_t>(
            std::ranges::find(used, Quantity(channel), &MapOutput::Component::quantity) -
            used.begin());
    };
    const std::array<std::size_t, 2> slopes = {component(Channel::slope_x),
                                               component(Channel::slope_y)};
    if (std::max(slopes[0], slopes[1]) >= map.used().size()) return 0.0;
    const auto n = static_cast<std::size_t>(samples);
    const auto at = [&](std::size_t i, std::size_t j) {
        const float* const sample = map.data + (j % n) * map.pitch(samples) +
                                    (i % n) * static_cast<std::size_t>(map.components);
        return std::array<double, 2>{sample[slopes[0]], sample[slopes[1]]};
    };
    double sum = 0.0;
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = 0; i < n; ++i) {
            const auto here = at(i, j);
            const auto east = at(i + 1, j);
            const auto north = at(i, j + 1);
            const auto east_north = at(i + 1, j + 1);
            const auto west_north = at(i + n - 1, j + 1);
            for (std::size_t c = 0; c < 2; ++c) {
                sum += here[c] * (4.0 * here[c] + 2.0 * (east[c] + north[c]) +
                                  0.5 * (east_north[c] + west_north[c]));
            }
        }
    }
    return sum / 9.0 / static_cast<double>(n * n);
}

/// mean_square is that of `map`, nullptr: 0.
ocean_detail_band band_of(const DetailBand& from, const MapOutput* map, int samples) {
    return {.shortest_wave = from.shortest_wave,
            .longest_wave = from.longest_wave,
            .tile = from.tile,
            .variance_x = from.variance.x,
            .variance_y = from.variance.y,
            .covariance = from.variance.xy,
            .mean_square = map == nullptr ? 0.0 : read_mean_square(*map, samples)};
}

/// Has write(region, maps) fill the outputs of a request at a time [s].
template <typename Write>
ocean_result in_region(ocean_sea* sea, double time, const ocean_region_request* request,
                       const Write& write) {
    return in_handle(sea, [&] {
        require(request, "request");
        require_finite(time, "time", "seconds");
        std::vector<MapOutput>& maps = sea->map_outputs;
        const Domain region = read_region(request, maps);
        write(region, maps);
    });
}

}  // namespace
}  // namespace ocean::capi

using namespace ocean;
using namespace ocean::capi;

ocean_result ocean_map_resolution(const ocean_sea* sea, int32_t* resolution) {
    return in_handle(sea, [&] {
        require(resolution, "resolution");
        *resolution = default_map_resolution(sea->ocean->parameters().grid);
    });
}

ocean_result ocean_cascade_periods(const ocean_sea* sea, double* periods, size_t* count) {
    return in_handle(sea, [&] {
        require(count, "count");
        const Grid& grid = sea->ocean->parameters().grid;
        const std::vector<int> divisors = cascade_divisors(grid);
        const std::size_t room = std::exchange(*count, divisors.size());
        if (periods == nullptr) return;
        if (room < divisors.size()) {
            throw CallError(OCEAN_BUFFER_TOO_SMALL, "there are " + std::to_string(divisors.size()) +
                                                        " cascades; periods has room for " +
                                                        std::to_string(room));
        }
        for (const int divisor : divisors) *periods++ = grid.patch_size / divisor;
    });
}

ocean_result ocean_evaluate(ocean_sea* sea, const ocean_request* request) {
    return in_handle(sea, [&] {
        const ocean_request asked =
            read_struct(request, offsetof(ocean_request, output_size), "ocean_request");
        require_finite(asked.time, "time", "seconds");
        const Grid& grid = sea->ocean->parameters().grid;
        if (asked.cascade < 0 || asked.cascade > grid.cascades) {
            refuse({.parameter = "cascade",
                    .value = std::to_string(asked.cascade),
                    .allowed = "0 (the whole sea) .. " + std::to_string(grid.cascades)});
        }
        require_reserved(asked.reserved, "reserved");
        const int resolution = map_resolution(
            asked.resolution, asked.cascade == 0 ? default_map_resolution(grid) : grid.resolution);
        std::vector<MapOutput>& maps = sea->map_outputs;
        read_outputs(asked, request->struct_size, resolution, maps);
        // The buffers were measured for this resolution: any other would overrun them.
        if (asked.cascade == 0) {
            sea->ocean->evaluate_into(asked.time, maps, resolution);
        } else {
            sea->ocean->evaluate_cascade_into(static_cast<std::size_t>(asked.cascade - 1),
                                              asked.time, maps, resolution);
        }
    });
}

ocean_result ocean_region(ocean_sea* sea, double time, const ocean_region_request* request) {
    return in_region(sea, time, request, [&](const Domain& region, auto& maps) {
        sea->ocean->region_into(time, region, maps);
    });
}

ocean_result ocean_wake_count(const ocean_sea* sea, size_t* count) {
    return in_handle(sea, [&] {
        require(count, "count");
        *count = sea->ocean->parameters().hulls.size();
    });
}

ocean_result ocean_wake_domain(const ocean_sea* sea, size_t hull, double time,
                               ocean_domain* domain) {
    return in_handle(sea, [&] {
        require_finite(time, "time", "seconds");
        write_domain(sea->ocean->wake_domain(hull, time), domain);
    });
}

ocean_result ocean_wake_region(ocean_sea* sea, size_t hull, double time,
                               const ocean_region_request* request) {
    return in_region(sea, time, request, [&](const Domain& region, auto& maps) {
        sea->ocean->wake_into(hull, time, region, maps);
    });
}

ocean_result ocean_wake_add(ocean_sea* sea, size_t hull, double time,
                            const ocean_region_request* request) {
    return in_region(sea, time, request, [&](const Domain& region, auto& maps) {
        sea->ocean->add_wake(hull, time, region, maps);
    });
}

ocean_result ocean_bed_region(const ocean_sea* sea, double x, double y, double cell,
                              int32_t columns, int32_t rows, float* heights) {
    return in_handle(sea, [&] {
        require(heights, "heights");
        const Domain region = region_domain(x, y, cell, columns, rows);
        const SeaBed* const bed = sea->ocean->parameters().water.bed.get();
        if (bed == nullptr) {
            throw CallError(OCEAN_UNSUPPORTED, "this sea has no bed (water.seabed)");
        }
        write_bed_heights(*bed, region, {heights, region.count()});
    });
}

ocean_result ocean_cover_power(ocean_sea* sea, double time, int32_t resolution, double* power) {
    return in_handle(sea, [&] {
        require(power, "power");
        require_finite(time, "time", "seconds");
        const Grid& grid = sea->ocean->parameters().grid;
        *power =
            sea->ocean->cover_power(time, map_resolution(resolution, default_map_resolution(grid)));
    });
}

ocean_result ocean_detail(ocean_sea* sea, const ocean_detail_request* request, size_t* count,
                          double* residual) {
    return in_handle(sea, [&] {
        require(request, "request");
        require(count, "count");
        const ocean_detail_request asked =
            read_struct(request, sizeof(ocean_detail_request), "ocean_detail_request");
        const Grid& grid = sea->ocean->parameters().grid;
        DetailSettings settings;
        settings.resolution = map_resolution(asked.resolution, default_map_resolution(grid));
        if (asked.samples != 0) settings.samples = asked.samples;
        if (asked.bands != nullptr) {
            require_struct_size(asked.band_size, sizeof(double), "band_size", "ocean_detail_band",
                                sizeof(ocean_detail_band));
        }
        const DetailBudget budget = sea->ocean->detail_budget(asked.time, settings);
        if (asked.bands != nullptr && asked.band_count < budget.bands.size()) {
            *count = budget.bands.size();
            require_capacity("band_count", asked.band_count, *count,
                             "there are " + std::to_string(*count));
        }
        if (asked.outputs != nullptr) {
            const OutputArray outputs(asked.outputs, asked.output_count, asked.output_size);
            std::vector<MapOutput>& maps = sea->map_outputs;
            maps.clear();
            for (std::size_t i = 0; i < asked.output_count; ++i) {
                maps.push_back(
                    map_output(outputs[i], "outputs[" + std::to_string(i) + "]", settings.samples));
            }
            sea->ocean->detail_into(asked.time, maps, settings);
        }
        *count = budget.bands.size();
        if (residual != nullptr) *residual = budget.residual;
        if (asked.bands == nullptr) return;
        auto* out = reinterpret_cast<unsigned char*>(asked.bands);
        const std::size_t drawn = asked.outputs == nullptr || asked.band_size < kMeanSquareEnd
                                      ? 0
                                      : sea->map_outputs.size();
        for (std::size_t i = 0; i < budget.bands.size(); ++i) {
            const ocean_detail_band band = band_of(
                budget.bands[i], i < drawn ? &sea->map_outputs[i] : nullptr, settings.samples);
            std::memcpy(out, &band, std::min(asked.band_size, sizeof(band)));
            out += asked.band_size;
        }
    });
}
