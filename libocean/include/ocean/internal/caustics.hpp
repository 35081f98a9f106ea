// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Caustics: sunlight that the waves focus on a level plane below them, as one map of the sea's
// period. They depend on the whole surface, so they are not a channel: a sample of a channel does
// not know its neighbours.
#pragma once

#include <cstdint>
#include <vector>

#include "ocean/channel.hpp"
#include "ocean/surface.hpp"

namespace ocean {

class ThreadPool;

/// The plane and the sun of a caustics map.
struct CausticsSettings {
    double depth = 10.0;         // of the plane below the sea's mean level [m]
    double sun_altitude = 90.0;  // above the horizon [degrees]
    double sun_bearing = 0.0;    // of the sun, counter-clockwise from +x [degrees]
};
inline constexpr double kMinCausticsDepth = 0.01;  // [m]
inline constexpr double kMaxCausticsDepth = 100.0;
/// Below this altitude waves shade each other, which make_caustics does not model.
inline constexpr double kMinCausticsSunAltitude = 5.0;  // [degrees]

/// The channels that a surface needs for make_caustics.
inline constexpr ChannelSet kCausticsChannels = {Channel::dx, Channel::dy, Channel::height,
                                                 Channel::nx, Channel::ny, Channel::nz};
/// The name by which users request caustics.
inline constexpr Product kCausticsProduct = {.name = "caustics",
                                             .channels = {},
                                             .count = 0,
                                             .unit = "",
                                             .subject = kSeaKind,
                                             .precision = Precision::half,
                                             .run_lengths = RunLengths::never,
                                             .help =
                                                 "Sunlight on a level plane below the waves, 1 "
                                                 "under flat water"};

/// Returns the irradiance of the plane, relative to the same plane under flat water: resolution^2
/// values [j][i], each the mean over the cell whose centre is the sample (i, j) * period /
/// resolution. The mean of the map is 1. The bits are the same for any number of threads, and a
/// surface shifted by whole samples gives the caustics shifted by as many. Throws Error
/// invalid_value for settings out of range and for a surface without kCausticsChannels.
std::vector<float> make_caustics(const Surface& surface, const CausticsSettings& settings,
                                 ThreadPool& pool);

/// Returns an upper bound of the bytes that make_caustics needs, its result included.
std::uint64_t caustics_bytes(int resolution);

}  // namespace ocean
