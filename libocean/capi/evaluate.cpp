// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks what a host asks for and has the maps written into its buffers, vectors turned to its
// axes.
#include "evaluate.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

#include "guard.hpp"
#include "ocean/cascades.hpp"
#include "ocean/error.hpp"
#include "ocean/ocean.hpp"
#include "sea_handle.hpp"

namespace ocean::capi {
namespace {

constexpr int kMaxComponents = 4;
constexpr int kUntouched = -1;

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

ChannelSet check_output(const ocean_output& output, const std::string& name, int resolution) {
    if (output.channels < 1 || output.channels > kMaxComponents) {
        refuse(name + ".channels = " + std::to_string(output.channels) + "; allowed: 1 .. 4");
    }
    if (output.axes < OCEAN_ZUP || output.axes > OCEAN_TNB) {
        refuse(name + ".axes = " + std::to_string(output.axes) +
               "; allowed: OCEAN_ZUP, OCEAN_YUP, OCEAN_TNB");
    }
    require(output.data, (name + ".data").c_str());
    const std::size_t needed =
        Lattice{resolution, 1.0}.size() * static_cast<std::size_t>(output.channels);
    if (output.count < needed) {
        refuse(name + ".count = " + std::to_string(output.count) + "; a map of " +
               std::to_string(resolution) + " x " + std::to_string(resolution) + " samples of " +
               std::to_string(output.channels) + " channels needs " + std::to_string(needed));
    }
    ChannelSet channels;
    for (int c = 0; c < output.channels; ++c) {
        if (output.channel[c] == kUntouched) continue;
        if (output.channel[c] < 0 || output.channel[c] >= kChannelCount) {
            refuse(name + ".channel[" + std::to_string(c) +
                   "] = " + std::to_string(output.channel[c]) + "; allowed: " + c_name(0) + " .. " +
                   c_name(kChannelCount - 1) + ", or -1 to leave that component as it is");
        }
        channels = channels | static_cast<Channel>(output.channel[c]);
    }
    return channels;
}

/// What one component of an output receives.
struct Source {
    int channel;
    float sign;
};

/// Whether three components are the x, y and z of a vector.
bool is_vector(std::span<const std::int32_t, 3> channels) {
    return std::ranges::any_of(kProducts, [channels](const Product& product) {
        return product.count == 3 &&
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

}  // namespace

void check_outputs(std::span<const ocean_output> outputs, int resolution) {
    ChannelSet channels;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const std::string name = "outputs[" + std::to_string(i) + "]";
        channels = channels | check_output(outputs[i], name, resolution);
    }
    if (channels.empty()) refuse("no output names a channel: there is nothing to compute");
}

MapOutput map_output(const ocean_output& output) {
    const auto sources = turned(output);
    MapOutput result{output.data, output.channels, {}};
    for (std::size_t c = 0; c < static_cast<std::size_t>(output.channels); ++c) {
        if (sources[c].channel == kUntouched) continue;
        result.component[c] = {static_cast<Channel>(sources[c].channel), sources[c].sign};
    }
    return result;
}

}  // namespace ocean::capi

using namespace ocean;
using namespace ocean::capi;

namespace {

int checked_resolution(const ocean_request& request, const Parameters& parameters) {
    const int resolution = request.resolution;
    if (resolution == 0) return default_map_resolution(parameters.grid);
    if (!is_resolution(resolution)) {
        refuse("resolution = " + std::to_string(resolution) +
               "; allowed: 0 (ocean_map_resolution) or a power of two, 32 .. 8192");
    }
    return resolution;
}

}  // namespace

ocean_result ocean_map_resolution(const ocean_sea* sea, int32_t* resolution) {
    return guarded([&] {
        const Visit visit(sea);
        require(resolution, "resolution");
        *resolution = default_map_resolution(sea->ocean->parameters().grid);
    });
}

ocean_result ocean_evaluate(ocean_sea* sea, const ocean_request* request) {
    return guarded([&] {
        const Visit visit(sea);
        require(request, "request");
        const ocean_request asked = read_struct(request, sizeof(ocean_request), "ocean_request");
        if (!std::isfinite(asked.time)) {
            refuse("time = " + std::to_string(asked.time) +
                   "; allowed: a finite number of seconds");
        }
        if (asked.output_count > 0) require(asked.outputs, "outputs");
        const std::span outputs(asked.outputs, asked.output_count);
        const int resolution = checked_resolution(asked, sea->ocean->parameters());
        check_outputs(outputs, resolution);
        std::vector<MapOutput>& maps = sea->map_outputs;
        maps.clear();
        for (const ocean_output& output : outputs) maps.push_back(map_output(output));
        // The buffers were measured for this resolution: any other would overrun them.
        sea->ocean->evaluate_into(asked.time, maps, resolution);
    });
}
