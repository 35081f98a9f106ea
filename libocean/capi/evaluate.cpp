// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks what a host asks for and has the maps written into its buffers, vectors turned to its
// axes.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "guard.hpp"
#include "ocean/cascades.hpp"
#include "ocean/detail.hpp"
#include "ocean/error.hpp"
#include "ocean/ocean.hpp"
#include "sea_handle.hpp"

namespace ocean::capi {
namespace {

constexpr int kMaxComponents = 4;
constexpr int kUntouched = -1;
/// The bytes of a band that has its mean_square.
constexpr std::size_t kMeanSquareEnd = sizeof(ocean_detail_band);

/// The channels of libocean.h, with the names that they have in core's table.
struct NamedChannel {
    int number;
    std::string_view name;
};
constexpr NamedChannel kNamed[] = {
    {OCEAN_DX, "dx"},
    {OCEAN_DY, "dy"},
    {OCEAN_HEIGHT, "height"},
    {OCEAN_NX, "nx"},
    {OCEAN_NY, "ny"},
    {OCEAN_NZ, "nz"},
    {OCEAN_SLOPE_X, "slope_x"},
    {OCEAN_SLOPE_Y, "slope_y"},
    {OCEAN_JACOBIAN, "jacobian"},
    {OCEAN_WHITECAP, "whitecap"},
    {OCEAN_FOAM, "foam"},
    {OCEAN_VX, "vx"},
    {OCEAN_VY, "vy"},
    {OCEAN_VZ, "vz"},
    {OCEAN_DX_X, "dx_x"},
    {OCEAN_DY_Y, "dy_y"},
    {OCEAN_DX_Y, "dx_y"},
    {OCEAN_COVER, "cover"},
};
static_assert(std::ranges::equal(kNamed, kChannels,
                                 [number = 0](const NamedChannel& ours,
                                              const ChannelInfo& core) mutable {
                                     return ours.number == number++ && ours.name == core.name;
                                 }),
              "libocean.h has other channels than core's table");

/// "OCEAN_DX"
std::string c_name(int channel) {
    std::string name = "OCEAN_";
    for (const char c : kNamed[channel].name) {
        name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return name;
}

/// Returns the floats of the smallest buffer that holds the map. Throws CallError if no buffer can
/// be so large.
std::size_t needed_floats(const MapOutput& map, int resolution, const std::string& name) {
    const std::size_t width = map.width(resolution);
    const std::size_t rows = width / static_cast<std::size_t>(map.components);
    const std::size_t pitch = map.pitch(resolution);
    if (pitch < width || pitch > SIZE_MAX / sizeof(float) / rows) {
        refuse({.parameter = name + ".row_pitch",
                .value = std::to_string(pitch),
                .allowed = "0, or " + std::to_string(width) + " floats or more"});
    }
    return (rows - 1) * pitch + width;
}

void check_output(const ocean_output& output, const std::string& name) {
    if (output.channels < 1 || output.channels > kMaxComponents) {
        refuse({.parameter = name + ".channels",
                .value = std::to_string(output.channels),
                .allowed = "1 .. 4"});
    }
    if (output.axes < OCEAN_ZUP || output.axes > OCEAN_TNB) {
        refuse({.parameter = name + ".axes",
                .value = std::to_string(output.axes),
                .allowed = "OCEAN_ZUP, OCEAN_YUP, OCEAN_TNB"});
    }
    require_reserved(output.reserved, name + ".reserved");
    require(output.data, (name + ".data").c_str());
    for (int c = 0; c < output.channels; ++c) {
        if (output.channel[c] == kUntouched) continue;
        if (output.channel[c] < 0 || output.channel[c] >= kChannelCount) {
            refuse({.parameter = name + ".channel[" + std::to_string(c) + "]",
                    .value = std::to_string(output.channel[c]),
                    .allowed = c_name(0) + " .. " + c_name(kChannelCount - 1) +
                               ", or -1 to leave that component as it is"});
        }
    }
}

/// The channel that one component of an output receives, and its sign.
struct Source {
    int channel;
    float sign;
};

/// Returns true if three components are the x, y and z of a vector.
bool is_vector(std::span<const std::int32_t, 3> channels) {
    return std::ranges::any_of(kProducts, [channels](const Product& product) {
        return product.vector &&
               std::ranges::equal(product.channels, channels, {},
                                  [](Channel channel) { return static_cast<int>(channel); });
    });
}

/// The component's channels with whole vectors turned: (x, z, -y) or (x, z, y).
std::array<Source, kMaxComponents> turned(const ocean_output& output) {
    std::array<Source, kMaxComponents> sources;
    for (std::size_t c = 0; c < kMaxComponents; ++c) sources[c] = {output.channel[c], 1.0f};
    if (output.axes == OCEAN_ZUP) return sources;
    const std::span<const std::int32_t, kMaxComponents> channels(output.channel);
    for (std::size_t c = 0; c + 2 < static_cast<std::size_t>(output.channels); ++c) {
        if (!is_vector(channels.subspan(c).first<3>())) continue;
        sources[c + 1] = {channels[c + 2], 1.0f};
        sources[c + 2] = {channels[c + 1], output.axes == OCEAN_YUP ? -1.0f : 1.0f};
    }
    return sources;
}

/// As a map of `resolution` samples a side. Throws CallError for what libocean.h does not allow.
MapOutput map_output(const ocean_output& output, const std::string& name, int resolution) {
    check_output(output, name);
    MapOutput map{output.data, output.channels, {}, output.row_pitch, output.seam != 0};
    const std::size_t needed = needed_floats(map, resolution, name);
    if (output.count < needed) {
        refuse(name + ".count = " + std::to_string(output.count) + "; a map of " +
               std::to_string(resolution) + " x " + std::to_string(resolution) + " samples of " +
               std::to_string(output.channels) + " channels needs " + std::to_string(needed));
    }
    const auto sources = turned(output);
    for (std::size_t c = 0; c < static_cast<std::size_t>(output.channels); ++c) {
        if (sources[c].channel == kUntouched) continue;
        map.component[c] = {static_cast<Channel>(sources[c].channel), sources[c].sign};
    }
    return map;
}

/// The outputs of a request, whose struct may be that of an older header.
class OutputArray {
  public:
    OutputArray(const ocean_request& request, std::size_t caller_struct_size)
        : OutputArray(request.outputs, request.output_count,
                      request.output_size > 0 ? request.output_size
                      : caller_struct_size < offsetof(ocean_request, cascade)
                          ? kFirstOutput
                          : sizeof(ocean_output)) {}
    OutputArray(const ocean_output* outputs, std::size_t count, std::size_t output_size)
        : bytes_(reinterpret_cast<const unsigned char*>(outputs)), size_(output_size) {
        require_struct_size(size_, kFirstOutput, "output_size", "ocean_output",
                            sizeof(ocean_output));
        if (count > 0) require(outputs, "outputs");
    }
    ocean_output operator[](std::size_t i) const {
        return read_bytes<ocean_output>(bytes_ + i * size_, size_, "ocean_output");
    }

  private:
    static constexpr std::size_t kFirstOutput = offsetof(ocean_output, row_pitch);

    const unsigned char* bytes_;
    std::size_t size_;
};

int map_resolution(int asked, int shown) {
    if (asked == 0) return shown;
    if (!is_resolution(asked)) {
        refuse({.parameter = "resolution",
                .value = std::to_string(asked),
                .allowed = "0 (ocean_map_resolution) or a power of two, 32 .. 8192"});
    }
    return asked;
}

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

}  // namespace
}  // namespace ocean::capi

using namespace ocean;
using namespace ocean::capi;

ocean_result ocean_map_resolution(const ocean_sea* sea, int32_t* resolution) {
    return guarded([&] {
        const Visit visit(sea);
        require(resolution, "resolution");
        *resolution = default_map_resolution(sea->ocean->parameters().grid);
    });
}

ocean_result ocean_cascade_periods(const ocean_sea* sea, double* periods, size_t* count) {
    return guarded([&] {
        const Visit visit(sea);
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
    return guarded([&] {
        const Visit visit(sea);
        require(request, "request");
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
        const OutputArray outputs(asked, request->struct_size);
        std::vector<MapOutput>& maps = sea->map_outputs;
        maps.clear();
        for (std::size_t i = 0; i < asked.output_count; ++i) {
            maps.push_back(
                map_output(outputs[i], "outputs[" + std::to_string(i) + "]", resolution));
        }
        if (channels_of(maps).empty()) {
            refuse("no output names a channel: there is nothing to compute");
        }
        // The buffers were measured for this resolution: any other would overrun them.
        if (asked.cascade == 0) {
            sea->ocean->evaluate_into(asked.time, maps, resolution);
        } else {
            sea->ocean->evaluate_cascade_into(static_cast<std::size_t>(asked.cascade - 1),
                                              asked.time, maps, resolution);
        }
    });
}

ocean_result ocean_cover_power(ocean_sea* sea, double time, int32_t resolution, double* power) {
    return guarded([&] {
        const Visit visit(sea);
        require(power, "power");
        require_finite(time, "time", "seconds");
        const Grid& grid = sea->ocean->parameters().grid;
        *power =
            sea->ocean->cover_power(time, map_resolution(resolution, default_map_resolution(grid)));
    });
}

ocean_result ocean_detail(ocean_sea* sea, const ocean_detail_request* request, size_t* count,
                          double* residual) {
    return guarded([&] {
        const Visit visit(sea);
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
            throw CallError(OCEAN_BUFFER_TOO_SMALL,
                            "band_count = " + std::to_string(asked.band_count) + "; there are " +
                                std::to_string(budget.bands.size()));
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
