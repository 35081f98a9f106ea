// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Caustics: the light of the sun that waves gather on a level plane below them, as one map of the
// sea's period. It comes from the whole of a surface, so it is no channel: a sample of it knows its
// neighbours.
#pragma once

#include <cstdint>
#include <vector>

#include "ocean/channel.hpp"
#include "ocean/subject_kind.hpp"
#include "ocean/surface.hpp"

namespace ocean {

class ThreadPool;

struct CausticsSettings {
    double depth = 10.0;         // m, of the plane below the sea's mean level
    double sun_altitude = 90.0;  // degrees above the horizon
    double sun_bearing = 0.0;    // degrees counter-clockwise from +x, where the sun stands
};
inline constexpr double kLeastCausticsDepth = 0.01;  // m
inline constexpr double kMostCausticsDepth = 100.0;
/// Below it the waves shade each other, which is left out here.
inline constexpr double kLeastCausticsSun = 5.0;  // degrees

/// The channels of a surface that caustics are made of.
inline constexpr ChannelSet kCausticsChannels = {Channel::dx, Channel::dy, Channel::height,
                                                 Channel::nx, Channel::ny, Channel::nz};
/// As users ask for it.
inline constexpr Product kCausticsProduct = {.name = "caustics",
                                             .channels = {},
                                             .count = 0,
                                             .unit = "",
                                             .subject = kSeaKind,
                                             .precision = Precision::half,
                                             .run_lengths = RunLengths::never};

/// Irradiance of the plane over what it is under flat water, resolution^2 values [j][i]: the mean
/// over the cell of sample (i, j), whose middle is (i, j) period / resolution. The map's mean is 1.
/// Equal bits for any number of threads; a surface shifted by whole samples has its caustics
/// shifted. Throws Error invalid_value for settings out of range and for a surface without
/// kCausticsChannels.
std::vector<float> make_caustics(const Surface& surface, const CausticsSettings& settings,
                                 ThreadPool& pool);

/// Memory that make_caustics takes, at most, with what it returns.
std::uint64_t caustics_bytes(int resolution);

}  // namespace ocean
