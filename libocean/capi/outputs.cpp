// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See outputs.hpp. Vectors are turned to the axes of the host.
#include "outputs.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "ocean/channel.hpp"
#include "ocean/domain.hpp"
#include "ocean/enum_words.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/land_mask.hpp"

namespace ocean::capi {
namespace {

constexpr int kMaxComponents = 4;
constexpr int kUntouched = -1;

constexpr char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
/// Returns "OCEAN_DX" for "dx".
std::string c_name(std::string_view channel) {
    std::string name = "OCEAN_";
    std::ranges::transform(channel, std::back_inserter(name), upper);
    return name;
}

using CChannel = decltype(OCEAN_DX);
constexpr bool is_c_name(std::string_view word, std::string_view channel) {
    return word.starts_with("OCEAN_") && std::ranges::equal(word.substr(6), channel, {}, {}, upper);
}
/// Returns true if libocean.h has the channels of the rows under their names, numbered from First.
template <auto& Rows, int First, int... Row>
constexpr bool are_in_c(std::integer_sequence<int, Row...>) {
    return (is_c_name(enumerator_word<static_cast<CChannel>(First + Row)>(), Rows[Row].name) &&
            ...);
}
template <auto& Rows, int First>
constexpr bool kAreInC =
    are_in_c<Rows, First>(std::make_integer_sequence<int, static_cast<int>(std::size(Rows))>()) &&
    enumerator_word<static_cast<CChannel>(First + std::size(Rows))>().empty();
static_assert(kAreInC<kChannels, 0>, "libocean.h has other channels than core's table");
static_assert(kAreInC<kMaskProducts, kFirstMask>, "libocean.h has other masks than core's table");

/// Returns the floats of the smallest buffer that holds the map. Throws CallError if no buffer can
/// be so large.
std::size_t needed_floats(const MapOutput& map, int columns, std::size_t rows,
                          const std::string& name) {
    const std::size_t width = map.width(columns);
    const std::size_t pitch = map.pitch(columns);
    if (pitch < width || pitch > SIZE_MAX / sizeof(float) / rows) {
        refuse({.parameter = name + ".row_pitch",
                .value = std::to_string(pitch),
                .allowed = "0, or " + std::to_string(width) + " floats or more"});
    }
    return (rows - 1) * pitch + width;
}

void require_axes(std::int32_t axes, const std::string& name) {
    if (axes >= OCEAN_ZUP && axes <= OCEAN_TNB) return;
    refuse({.parameter = name,
            .value = std::to_string(axes),
            .allowed = "OCEAN_ZUP, OCEAN_YUP, OCEAN_TNB"});
}

void check_output(const ocean_output& output, const std::string& name) {
    if (output.channels < 1 || output.channels > kMaxComponents) {
        refuse({.parameter = name + ".channels",
                .value = std::to_string(output.channels),
                .allowed = "1 .. 4"});
    }
    require_axes(output.axes, name + ".axes");
    require_reserved(output.reserved, name + ".reserved");
    require(output.data, (name + ".data").c_str());
    for (int c = 0; c < output.channels; ++c) {
        if (output.channel[c] == kUntouched) continue;
        const std::int32_t channel = output.channel[c];
        if (channel >= 0 && channel < kChannelCount) continue;
        if (is_mask(static_cast<Channel>(channel))) continue;
        refuse({.parameter = name + ".channel[" + std::to_string(c) + "]",
                .value = std::to_string(channel),
                .allowed = c_name(kChannels.front().name) + " .. " + c_name(kChannels.back().name) +
                           ", of a terrain and of a sea over a bed also " +
                           c_name(kMaskProducts.front().name) + " .. " +
                           c_name(kMaskProducts.back().name) +
                           ", or -1 to leave that component as it is"});
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

}  // namespace

MapOutput map_output(const ocean_output& output, const std::string& name, int columns, int rows) {
    check_output(output, name);
    MapOutput map{output.data, output.channels, {}, output.row_pitch, output.seam != 0};
    const std::size_t needed =
        needed_floats(map, columns, static_cast<std::size_t>(rows) + (map.seam ? 1 : 0), name);
    if (output.count < needed) {
        refuse(name + ".count = " + std::to_string(output.count) + "; a map of " +
               std::to_string(columns) + " x " + std::to_string(rows) + " samples of " +
               std::to_string(output.channels) + " channels needs " + std::to_string(needed));
    }
    const auto sources = turned(output);
    for (std::size_t c = 0; c < static_cast<std::size_t>(output.channels); ++c) {
        if (sources[c].channel == kUntouched) continue;
        map.component[c] = {static_cast<Channel>(sources[c].channel), sources[c].sign};
    }
    return map;
}

int map_resolution(int asked, int shown) {
    if (asked == 0) return shown;
    if (!is_resolution(asked)) {
        refuse({.parameter = "resolution",
                .value = std::to_string(asked),
                .allowed = "0 (ocean_map_resolution) or a power of two, 32 .. 8192"});
    }
    return asked;
}

std::string_view axes_name(std::int32_t axes) {
    constexpr std::array<std::string_view, 3> kNames = {"zup", "yup", "tnb"};
    static_assert(OCEAN_ZUP == 0 && OCEAN_YUP == 1 && OCEAN_TNB == 2);
    require_axes(axes, "axes");
    return kNames[static_cast<std::size_t>(axes)];
}

MapOutput map_output(const ocean_output& output, const std::string& name, int resolution) {
    return map_output(output, name, resolution, resolution);
}

void read_outputs(const ocean_request& asked, std::size_t caller_struct_size, int resolution,
                  std::vector<MapOutput>& maps) {
    read_outputs(OutputArray(asked, caller_struct_size), asked.output_count, resolution, resolution,
                 maps);
}

void read_outputs(const OutputArray& outputs, std::size_t count, int columns, int rows,
                  std::vector<MapOutput>& maps) {
    maps.clear();
    for (std::size_t i = 0; i < count; ++i) {
        maps.push_back(map_output(outputs[i], "outputs[" + std::to_string(i) + "]", columns, rows));
    }
    if (channels_of(maps).empty()) {
        refuse("no output names a channel: there is nothing to compute");
    }
}

void require_metres(const char* name, double value, double lowest) {
    if (value >= lowest && value <= kFarthest) return;
    refuse({.parameter = name,
            .value = shortest_text(value),
            .allowed = shortest_text(lowest) + " .. " + shortest_text(kFarthest) + " m"});
}

Domain region_domain(double x, double y, double cell, std::int32_t columns, std::int32_t rows) {
    const auto require_side = [](const char* name, std::int32_t side) {
        if (side >= 2 && side <= kMaxRegionSide) return;
        refuse({.parameter = name,
                .value = std::to_string(side),
                .allowed = "2 .. " + std::to_string(kMaxRegionSide)});
    };
    require_side("columns", columns);
    require_side("rows", rows);
    require_metres("x", x, -kFarthest);
    require_metres("y", y, -kFarthest);
    require_metres("cell", cell, 1e-3);
    return {{x, y}, {cell * (columns - 1), cell * (rows - 1)}, {columns, rows}, false};
}

Domain read_region(const ocean_region_request* request, std::vector<MapOutput>& maps) {
    const auto asked = read_struct(request, sizeof(ocean_region_request), "ocean_region_request");
    const Domain region = region_domain(asked.x, asked.y, asked.cell, asked.columns, asked.rows);
    read_outputs(OutputArray(asked.outputs, asked.output_count, asked.output_size),
                 asked.output_count, asked.columns, asked.rows, maps);
    for (const MapOutput& map : maps) {
        if (map.seam) refuse("outputs: a region has no seam");
    }
    return region;
}

void write_domain(const Domain& own, ocean_domain* domain) {
    require(domain, "domain");
    require_struct_size(domain->struct_size, sizeof(ocean_domain), "struct_size", "ocean_domain",
                        sizeof(ocean_domain));
    *domain = {.struct_size = sizeof(ocean_domain),
               .x = own.origin[0],
               .y = own.origin[1],
               .cell = own.step(0),
               .columns = own.samples[0],
               .rows = own.samples[1],
               .wraps = own.wraps ? 1 : 0,
               .reserved = 0};
}

}  // namespace ocean::capi
