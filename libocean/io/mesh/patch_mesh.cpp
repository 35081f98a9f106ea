// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One period of the sea as triangles. The maps have N x N samples and no seam; the mesh has the
// seam's vertices twice, a period apart, so that copies of it tile the plane.
#include <algorithm>
#include <array>
#include <cmath>

#include "ocean/io/mesh.hpp"
#include "require_channels.hpp"
#include "turn_vectors.hpp"

namespace ocean::io {
namespace {

// Step of the vertex grid: 24 bits of a float hold every multiple of it up to `extent`, so adding a
// period to a vertex is exact, and both sides of a seam round to the same point.
double grid_step(double extent) {
    const int integer_bits = std::max(8, static_cast<int>(std::ceil(std::log2(extent))));
    return std::ldexp(1.0, integer_bits - 24);
}

double largest_offset(const Surface& surface) {
    double largest = 0.0;
    for (const Channel channel : {Channel::dx, Channel::dy, Channel::height}) {
        for (const float value : surface.channel(channel)) {
            largest = std::max(largest, std::abs(static_cast<double>(value)));
        }
    }
    return largest;
}

}  // namespace

// The quads (i, j) as two triangles each, with the diagonal of POV-Ray's height_field.
std::vector<int> patch_triangles(int n) {
    std::vector<int> triangles;
    triangles.reserve(6 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    const int width = n + 1;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = j * width + i;
            const int corners[] = {a, a + 1, a + width, a + 1, a + width + 1, a + width};
            triangles.insert(triangles.end(), std::begin(corners), std::end(corners));
        }
    }
    return triangles;
}

Mesh make_patch_mesh(const Surface& surface, Faces faces) {
    require_channels(surface, {Channel::dx, Channel::dy, Channel::height});
    const auto n = static_cast<std::size_t>(surface.resolution());
    const double cell = surface.period() / static_cast<double>(n);
    const double step = grid_step(surface.period() + largest_offset(surface));
    const auto snap = [step](double value) { return std::nearbyint(value / step) * step; };

    constexpr std::array kNormal = {Channel::nx, Channel::ny, Channel::nz};
    constexpr std::array kVelocity = {Channel::vx, Channel::vy, Channel::vz};
    const auto has = [&](const auto& channels) {
        return std::ranges::all_of(channels, [&](Channel c) { return surface.has(c); });
    };
    const bool normal = has(kNormal), velocity = has(kVelocity);
    const bool foam = surface.has(Channel::foam), cover = surface.has(Channel::cover);
    Mesh mesh;
    const std::size_t vertices = (n + 1) * (n + 1);
    mesh.positions.reserve(3 * vertices);
    if (normal) mesh.normals.reserve(3 * vertices);
    if (velocity) mesh.velocities.reserve(3 * vertices);
    if (foam) mesh.foam.reserve(vertices);
    if (cover) mesh.cover.reserve(vertices);
    for (std::size_t j = 0; j <= n; ++j) {
        for (std::size_t i = 0; i <= n; ++i) {
            const std::size_t at = (j % n) * n + i % n;
            // The sample is snapped, then moved by whole periods: equal bits on both sides.
            const double x =
                snap(static_cast<double>(i % n) * cell + surface.channel(Channel::dx)[at]);
            const double y =
                snap(static_cast<double>(j % n) * cell + surface.channel(Channel::dy)[at]);
            const double z = snap(surface.channel(Channel::height)[at]);
            mesh.positions.push_back(static_cast<float>(x + (i == n ? surface.period() : 0.0)));
            mesh.positions.push_back(static_cast<float>(y + (j == n ? surface.period() : 0.0)));
            mesh.positions.push_back(static_cast<float>(z));
            for (std::size_t c = 0; c < 3; ++c) {
                if (normal) mesh.normals.push_back(surface.channel(kNormal[c])[at]);
                if (velocity) mesh.velocities.push_back(surface.channel(kVelocity[c])[at]);
            }
            if (foam) mesh.foam.push_back(surface.channel(Channel::foam)[at]);
            if (cover) mesh.cover.push_back(surface.channel(Channel::cover)[at]);
        }
    }
    if (faces == Faces::triangles) mesh.triangles = patch_triangles(surface.resolution());
    return mesh;
}

void turn_y_up(Mesh& mesh) {
    for (std::vector<float>* vectors : {&mesh.positions, &mesh.normals, &mesh.velocities}) {
        turn_vectors_y_up(*vectors);
    }
}

}  // namespace ocean::io
