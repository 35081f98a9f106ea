// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See horizon_mesh.hpp. Distances of rows grow geometrically and columns have equal angles, so that
// all quads look about equally large from the camera. Each vertex shows the waves that the spacing
// of its neighbours can resolve; shorter waves only tilt its normal
// (shaders/wave/visible_slope.glsl).
#include "ocean/internal/io/horizon_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "map_pyramid.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/io/visible_slope.hpp"
#include "wave/wave.hpp"

namespace ocean::io {
namespace {

using wave::double_precision::earth_drop, wave::double_precision::earth_radius;

constexpr int kMaxVertices = 50'000'000;  // a limit of `int` faces and of practical text files

// The spacings of the rows and columns of the fan.
struct Fan {
    double nearest, growth, half_angle,
        step;  // growth: ratio of neighbouring distances; angles [rad]

    double distance(int row) const { return nearest * std::pow(growth, row); }
    // Returns the largest gap to a neighbour [m]: waves shorter than two gaps would alias.
    double spacing(double distance) const { return distance * std::max(growth - 1.0, step); }
};

void check(const View& view) {
    const auto refuse = [](const char* what, double value, const char* allowed) {
        throw Error(ErrorKind::invalid_value, std::string(what) + " of the view is " +
                                                  std::to_string(value) + "; allowed: " + allowed);
    };
    // The comparisons are written so that NaN fails them.
    if (!(view.height > 0.0 && view.height <= 20000.0))
        refuse("height", view.height, "0 .. 20000 m");
    if (!(view.field_of_view >= 1.0 && view.field_of_view <= 150.0)) {
        refuse("field_of_view", view.field_of_view, "1 .. 150 degrees");
    }
    if (view.columns < 2 || view.rows < 2 || view.columns > kMaxVertices / view.rows) {
        refuse("columns x rows", static_cast<double>(view.columns) * view.rows,
               "2 x 2 .. 50 million");
    }
    if (!(view.nearest >= 0.0 && view.horizon >= 0.0)) {
        refuse("nearest or horizon", std::min(view.nearest, view.horizon), ">= 0 m");
    }
    if (!(view.unresolved_slope_variance >= 0.0 && view.unresolved_slope_variance <= 1.0)) {
        refuse("unresolved_slope_variance", view.unresolved_slope_variance, "0 .. 1");
    }
    if (!std::isfinite(view.x) || !std::isfinite(view.y) || !std::isfinite(view.heading)) {
        throw Error(ErrorKind::invalid_value, "the position or heading of the view is not finite");
    }
}

Fan make_fan(const View& view, const Surface& finest) {
    Fan fan{};
    // At 0.6 of the height the camera looks down by 59 degrees.
    fan.nearest = view.nearest > 0.0 ? view.nearest : 0.6 * view.height;
    double farthest = view.horizon;
    if (farthest == 0.0) {
        const auto heights = finest.channel(Channel::height);
        const double crest = std::max(0.1f, *std::max_element(heights.begin(), heights.end()));
        // The distance at which the highest crest sinks below the horizon, with a margin.
        farthest = 1.05 * (horizon_distance(view.height) + horizon_distance(crest));
    }
    if (!(farthest > fan.nearest)) {
        throw Error(ErrorKind::invalid_value, "the view's horizon of " + std::to_string(farthest) +
                                                  " m must be farther than its nearest row");
    }
    fan.growth = std::pow(farthest / fan.nearest, 1.0 / (view.rows - 1));
    // The lower corners of a view that looks down span a wider angle than its middle, and
    // displacement moves the edge inwards.
    fan.half_angle = (0.58 * view.field_of_view + 6.0) * kPi / 180.0;
    fan.step = 2.0 * fan.half_angle / (view.columns - 1);
    return fan;
}

struct Vertex {
    double x, y, z;
    double normal_x, normal_y, normal_z;
};

// Returns the normal of the resolved waves, tilted towards the eye by the filtered ones. East and
// north are the eye's; the curved Earth leans away from it by distance/R.
void turn_normal(Vertex& vertex, const PyramidSample& sample, const View& view, double distance) {
    const double to_eye_x = view.x - vertex.x, to_eye_y = view.y - vertex.y;
    const double range = std::max(std::hypot(to_eye_x, to_eye_y), 1e-3);
    const double ex = to_eye_x / range, ey = to_eye_y / range;
    // A folded crest has no slope; normals are limited to 84 degrees from the vertical.
    const double up = std::max(sample.normal_z, 0.1);
    double lean_x = sample.normal_x / up - ex * distance / earth_radius();
    double lean_y = sample.normal_y / up - ey * distance / earth_radius();

    const double isotropic = 0.5 * view.unresolved_slope_variance;
    const SlopeVariance& v = sample.left_out;
    const double along_x = (v.xx + isotropic) * ex + v.xy * ey;  // V e
    const double along_y = v.xy * ex + (v.yy + isotropic) * ey;
    const double variance = along_x * ex + along_y * ey;
    if (variance > 1e-12) {
        const double elevation = (view.height - vertex.z) / range + lean_x * ex + lean_y * ey;
        const double seen = mean_visible_slope(std::sqrt(variance), elevation) / variance;
        lean_x += seen * along_x;
        lean_y += seen * along_y;
    }
    const double length = std::sqrt(lean_x * lean_x + lean_y * lean_y + 1.0);
    vertex.normal_x = lean_x / length;
    vertex.normal_y = lean_y / length;
    vertex.normal_z = 1.0 / length;
}

Vertex make_vertex(const MapPyramid& maps, const View& view, const Fan& fan, double distance,
                   double angle) {
    const double x = view.x + distance * std::cos(angle);
    const double y = view.y + distance * std::sin(angle);
    const PyramidSample sample = maps.sample(x, y, fan.spacing(distance));
    Vertex vertex{};
    vertex.x = x + sample.dx;
    vertex.y = y + sample.dy;
    vertex.z = sample.height - earth_drop(distance);
    turn_normal(vertex, sample, view, distance);
    return vertex;
}

// Rounds to the decimals that are visible at this distance: short numbers make a smaller file.
double decimal_grid(double distance) {
    return distance < 100.0 ? 1e4 : distance < 2000.0 ? 1e3 : 1e2;
}

std::vector<int> fan_triangles(int rows, int columns) {
    std::vector<int> triangles;
    triangles.reserve(6 * static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
    for (int row = 0; row + 1 < rows; ++row) {
        for (int column = 0; column + 1 < columns; ++column) {
            const int a = row * columns + column;
            const int b = a + columns;
            const int corners[] = {a, b, b + 1, a, b + 1, a + 1};
            triangles.insert(triangles.end(), std::begin(corners), std::end(corners));
        }
    }
    return triangles;
}

}  // namespace

double horizon_distance(double height) {
    return wave::double_precision::horizon_distance(height);
}

Mesh make_horizon_mesh(std::span<const Surface> levels, const View& view) {
    check(view);
    if (!levels.empty() && !levels[0].domain().is_tile()) {
        throw Error(ErrorKind::invalid_value,
                    "a mesh to the horizon needs maps that repeat from the world's origin on");
    }
    const MapPyramid maps(levels);
    const Fan fan = make_fan(view, levels[0]);
    const double first_angle = view.heading * kPi / 180.0 - fan.half_angle;
    const auto vertices = 3 * static_cast<std::size_t>(view.rows * view.columns);
    Mesh mesh;
    mesh.positions.reserve(vertices);
    mesh.normals.reserve(vertices);
    for (int row = 0; row < view.rows; ++row) {
        const double distance = fan.distance(row);
        const double grid = decimal_grid(distance);
        for (int column = 0; column < view.columns; ++column) {
            const Vertex vertex =
                make_vertex(maps, view, fan, distance, first_angle + column * fan.step);
            for (const double value : {vertex.x, vertex.y, vertex.z}) {
                mesh.positions.push_back(static_cast<float>(std::nearbyint(value * grid) / grid));
            }
            for (const double value : {vertex.normal_x, vertex.normal_y, vertex.normal_z}) {
                mesh.normals.push_back(static_cast<float>(value));
            }
        }
    }
    mesh.triangles = fan_triangles(view.rows, view.columns);
    return mesh;
}

}  // namespace ocean::io
