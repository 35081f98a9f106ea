// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "waves/labels/region_rows.hpp"

#include <cmath>
#include <string>

#include "ocean/error.hpp"
#include "waves/query/query_points.hpp"

namespace ocean {

void require_region(const Domain& domain) {
    const auto is_side = [&](std::size_t axis) {
        return domain.samples[axis] >= 2 && domain.samples[axis] <= kMaxRegionSide &&
               std::isfinite(domain.origin[axis]) && std::isfinite(domain.size[axis]) &&
               domain.size[axis] > 0.0;
    };
    if (!domain.wraps && is_side(0) && is_side(1)) return;
    throw Error(ErrorKind::invalid_value,
                "the region has " + std::to_string(domain.samples[0]) + " x " +
                    std::to_string(domain.samples[1]) +
                    " samples; allowed: a rectangle that does not wrap, 2 .. " +
                    std::to_string(kMaxRegionSide) + " samples along each side");
}

float read_period(const Surface& map, Channel channel, WorldPoint label) {
    const std::span<const float> values = map.channel(channel);
    const int samples = map.resolution();
    const double u = wrapped(label.x, map.period()) / map.period() * samples;
    const double v = wrapped(label.y, map.period()) / map.period() * samples;
    const int i = static_cast<int>(u);
    const int j = static_cast<int>(v);
    const auto at = [&](int column, int row) {
        return values[static_cast<std::size_t>(row & (samples - 1)) *
                          static_cast<std::size_t>(samples) +
                      static_cast<std::size_t>(column & (samples - 1))];
    };
    const auto s = static_cast<float>(u - i);
    const auto t = static_cast<float>(v - j);
    const auto row = [&](int of) { return at(i, of) + s * (at(i + 1, of) - at(i, of)); };
    return row(j) + t * (row(j + 1) - row(j));
}

bool needs_rates(ChannelSet channels) {
    return channels.intersects({Channel::vx, Channel::vy, Channel::vz});
}

bool needs_gradients(ChannelSet channels) {
    return channels.intersects({Channel::nx, Channel::ny, Channel::nz, Channel::slope_x,
                                Channel::slope_y, Channel::dx_x, Channel::dy_y, Channel::dx_y,
                                Channel::jacobian, Channel::whitecap});
}

}  // namespace ocean
