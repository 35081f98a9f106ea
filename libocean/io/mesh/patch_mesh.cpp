// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps as triangles. Maps of a domain that wraps have N x N samples and no seam; the mesh has the
// vertices of the seam twice, a period apart, so that its copies tile the plane.
#include <algorithm>
#include <array>
#include <cmath>

#include "attribute_names.hpp"
#include "ocean/error.hpp"
#include "ocean/io/mesh.hpp"
#include "require_channels.hpp"
#include "turn_vectors.hpp"

namespace ocean::io {
namespace {

constexpr std::array kPlace = {Channel::dx, Channel::dy, Channel::height};

// Returns the step of the vertex grid: 24 bits of a float hold every multiple of it up to `extent`,
// so that adding a period is exact and both sides of a seam round to the same point.
double grid_step(double extent) {
    const int integer_bits = std::max(8, static_cast<int>(std::ceil(std::log2(extent))));
    return std::ldexp(1.0, integer_bits - 24);
}

/// Returns an upper bound of all coordinates [m].
double reach_of(const Surface& surface) {
    const Domain& domain = surface.domain();
    double largest = 0.0;
    for (const Channel channel : kPlace) {
        for (const float value : surface.channel(channel)) {
            largest = std::max(largest, std::abs(static_cast<double>(value)));
        }
    }
    return std::max(std::abs(domain.origin[0]), std::abs(domain.origin[1])) +
           std::max(domain.size[0], domain.size[1]) + largest;
}

/// Calls visit(sample, i, j) for each vertex, in rows from the south.
template <typename Visit>
void for_each_vertex(const Domain& domain, const Visit& visit) {
    const auto [columns, rows] = patch_vertices(domain);
    const auto [width, height] = domain.samples;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int sample = j % height * width + i % width;
            visit(static_cast<std::size_t>(sample), i, j);
        }
    }
}

std::size_t vertex_count(const Domain& domain) {
    const auto [columns, rows] = patch_vertices(domain);
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
}

std::vector<float> values_at_vertices(const Surface& surface, const Product& product) {
    const Domain& domain = surface.domain();
    const auto components = static_cast<std::size_t>(product.count);
    std::array<std::span<const float>, 3> maps;
    for (std::size_t c = 0; c < components; ++c) maps[c] = surface.channel(product.channels[c]);
    std::vector<float> values(components * vertex_count(domain));
    float* next = values.data();
    for_each_vertex(domain, [&](std::size_t sample, int, int) {
        for (std::size_t c = 0; c < components; ++c) *next++ = maps[c][sample];
    });
    return values;
}

std::vector<float> place_vertices(const Surface& surface) {
    const Domain& domain = surface.domain();
    const double step = grid_step(reach_of(surface));
    // A domain that does not wrap has no seam: its vertices are rounded to floats only.
    const auto snap = [&](double value) {
        return domain.wraps ? std::nearbyint(value / step) * step : value;
    };
    const bool moves = surface.has(Channel::dx) && surface.has(Channel::dy);
    const auto dx = surface.channel(Channel::dx), dy = surface.channel(Channel::dy);
    const auto heights = surface.channel(Channel::height);
    const std::array cell = {domain.step(0), domain.step(1)};
    std::vector<float> positions(3 * vertex_count(domain));
    float* next = positions.data();
    // The sample is snapped, then moved by whole periods, which gives equal bits on both sides.
    const auto coordinate = [&](std::size_t axis, int index, double offset) {
        const bool again = index == domain.samples[axis];
        const double place = domain.origin[axis] + (again ? 0 : index) * cell[axis] + offset;
        return static_cast<float>(snap(place) + (again ? domain.size[axis] : 0.0));
    };
    for_each_vertex(domain, [&](std::size_t sample, int i, int j) {
        *next++ = coordinate(0, i, moves ? double{dx[sample]} : 0.0);
        *next++ = coordinate(1, j, moves ? double{dy[sample]} : 0.0);
        *next++ = static_cast<float>(snap(heights[sample]));
    });
    return positions;
}

void check(const Surface& surface) {
    require_channels(surface, {Channel::height});
    const auto [columns, rows] = surface.domain().samples;
    if (columns > 1 && rows > 1) return;
    throw Error(ErrorKind::invalid_value,
                "a mesh needs two samples along a side; the surface has " +
                    std::to_string(columns) + " x " + std::to_string(rows));
}

bool holds(ChannelSet channels, const Product& product) {
    return (channels | product.set()).size() == channels.size();
}

}  // namespace

const Attribute* Mesh::find(std::string_view name) const {
    const auto found = std::ranges::find(attributes, name, &Attribute::name);
    return found == attributes.end() ? nullptr : &*found;
}

std::array<int, 2> patch_vertices(const Domain& domain) {
    const int seam = domain.wraps ? 1 : 0;
    return {domain.samples[0] + seam, domain.samples[1] + seam};
}

// Splits each quad (i, j) into two triangles along the diagonal of POV-Ray's height_field.
std::vector<int> patch_triangles(const Domain& domain) {
    const auto [width, rows] = patch_vertices(domain);
    std::vector<int> triangles;
    triangles.reserve(6 * static_cast<std::size_t>(width - 1) * static_cast<std::size_t>(rows - 1));
    for (int j = 0; j + 1 < rows; ++j) {
        for (int i = 0; i + 1 < width; ++i) {
            const int a = j * width + i;
            const int corners[] = {a, a + 1, a + width, a + 1, a + width + 1, a + width};
            triangles.insert(triangles.end(), std::begin(corners), std::end(corners));
        }
    }
    return triangles;
}

std::vector<int> patch_triangles(int resolution) {
    return patch_triangles(Domain::tile(1.0, resolution));
}

void cut_dry_squares(const Domain& domain, std::span<const float> dry,
                     std::vector<int>& triangles) {
    constexpr std::size_t kCorners = 6;  // of a square
    const auto width = static_cast<std::size_t>(patch_vertices(domain)[0]);
    const auto is_wet = [&](std::size_t vertex) { return dry[vertex] < 0.5f; };
    std::size_t kept = 0;
    for (std::size_t at = 0; at < triangles.size(); at += kCorners) {
        const auto first = static_cast<std::size_t>(triangles[at]);
        if (!is_wet(first + 1) && !is_wet(first + width)) continue;
        std::copy_n(triangles.begin() + static_cast<std::ptrdiff_t>(at), kCorners,
                    triangles.begin() + static_cast<std::ptrdiff_t>(kept));
        kept += kCorners;
    }
    triangles.resize(kept);
}

std::vector<float> patch_uv(const Domain& domain) {
    const auto [columns, rows] = patch_vertices(domain);
    std::vector<float> uv(2 * vertex_count(domain));
    float* next = uv.data();
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            *next++ = static_cast<float>(static_cast<double>(i) / (columns - 1));
            *next++ = static_cast<float>(static_cast<double>(j) / (rows - 1));
        }
    }
    return uv;
}

Mesh make_patch_mesh(const Surface& surface, Faces faces, std::span<const Product> products) {
    check(surface);
    const Domain& domain = surface.domain();
    Mesh mesh{.positions = place_vertices(surface), .domain = domain};
    if (faces == Faces::triangles) {
        mesh.triangles = patch_triangles(domain);
        mesh.attributes.push_back({std::string(kUv), 2, patch_uv(domain)});
    }
    const ChannelSet place{Channel::dx, Channel::dy, Channel::height};
    for (const Product& product : products) {
        const bool is_position = holds(place, product);
        if (product.count == 0 || is_position || !holds(surface.channels(), product)) continue;
        std::vector<float> values = values_at_vertices(surface, product);
        if (product.name == kNormal) {
            mesh.normals = std::move(values);
        } else {
            mesh.attributes.push_back(
                {std::string(product.name), product.count, std::move(values), product.vector});
        }
    }
    return mesh;
}

void turn_y_up(Mesh& mesh) {
    turn_vectors_y_up(mesh.positions);
    turn_vectors_y_up(mesh.normals);
    for (Attribute& attribute : mesh.attributes) {
        if (attribute.vector) turn_vectors_y_up(attribute.values);
    }
}

}  // namespace ocean::io
