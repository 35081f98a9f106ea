// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Points with a size and a motion, such as spray, for renderers that draw or splat them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ocean/io/provenance.hpp"

namespace ocean::io {

/// Arrays of the same points, z up, metres and seconds.
struct Points {
    std::vector<float> positions;    // x, y, z of each
    std::vector<float> velocities;   // m/s, x, y, z of each
    std::vector<float> ages;         // s since the birth of each
    std::vector<float> lives;        // s, the age at which each ends
    std::vector<float> radii;        // m
    std::vector<std::uint64_t> ids;  // the same in every frame

    std::size_t size() const { return ids.size(); }
};
/// Bytes of so many.
constexpr std::uint64_t points_bytes(std::uint64_t count) {
    constexpr std::uint64_t kFloats = 9;
    return count * (kFloats * sizeof(float) + sizeof(std::uint64_t));
}
/// y up instead of z: (x, z, -y).
void turn_y_up(Points& points);

/// Binary PLY, little-endian: vertices x, y, z, vx, vy, vz, age, life, radius as floats, id_low and
/// id_high as uints, for PLY has no integers of 64 bits: id = id_high 2^32 + id_low. Its header is
/// read by read_ply_header. Throws Error output.
void write_ply(const Points& points, std::span<const HeaderString> strings,
               const std::string& path);
/// Bytes of such a file, at most, without its comments.
std::uint64_t points_ply_bytes(std::uint64_t count);

}  // namespace ocean::io
