// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/io/mesh.hpp"

#include "ply_writer.hpp"
#include "turn_vectors.hpp"

namespace ocean::io {

void turn_y_up(Points& points) {
    turn_vectors_y_up(points.positions);
    turn_vectors_y_up(points.velocities);
}

void write_ply(const Points& points, std::span<const HeaderString> strings,
               const std::string& path) {
    PlyHeader header(strings);
    header.element("vertex", points.size());
    header.properties("float", {"x", "y", "z", "vx", "vy", "vz", "age", "life", "radius"});
    header.properties("uint", {"id_low", "id_high"});
    PlyWriter out(path, header);
    for (std::size_t i = 0; i < points.size(); ++i) {
        out.put(&points.positions[3 * i], 3);
        out.put(&points.velocities[3 * i], 3);
        const float scalars[] = {points.ages[i], points.lives[i], points.radii[i]};
        out.put(scalars, std::size(scalars));
        out.put(&points.ids[i], 1);  // little-endian, so the low half comes first
    }
    out.commit();
}

std::uint64_t points_ply_bytes(std::uint64_t count) {
    return kMaxPlyHead + points_bytes(count);
}

}  // namespace ocean::io
