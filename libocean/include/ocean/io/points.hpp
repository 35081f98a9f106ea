// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Points with a size and a velocity, such as spray, for renderers that draw or splat them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ocean/provenance.hpp"

namespace ocean::io {

/// Points as parallel arrays, z up, in metres and seconds.
struct Points {
    std::vector<float> positions;    // x, y, z [m]
    std::vector<float> velocities;   // x, y, z [m/s]
    std::vector<float> ages;         // time since birth [s]
    std::vector<float> lives;        // age at death [s]
    std::vector<float> radii;        // [m]
    std::vector<std::uint64_t> ids;  // the same in every frame

    std::size_t size() const { return ids.size(); }
};
/// Returns the memory of `count` points [bytes].
constexpr std::uint64_t points_bytes(std::uint64_t count) {
    constexpr std::uint64_t kFloats = 9;
    return count * (kFloats * sizeof(float) + sizeof(std::uint64_t));
}
/// Turns positions and velocities from z up to y up: (x, y, z) becomes (x, z, -y).
void turn_y_up(Points& points);

/// Writes binary PLY, little-endian: vertices x, y, z, vx, vy, vz, age, life, radius as floats, and
/// id_low and id_high as uints, because PLY has no 64-bit integers: id = id_high 2^32 + id_low.
/// read_ply_header reads the header. Throws Error output.
void write_ply(const Points& points, std::span<const HeaderString> strings,
               const std::string& path);
/// Returns an upper bound of the size of a PLY file of points without its comments [bytes].
std::uint64_t points_ply_bytes(std::uint64_t count);

}  // namespace ocean::io
