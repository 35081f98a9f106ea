// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast/surface/shore_query.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/query/query_points.hpp"

namespace ocean {
namespace {

constexpr std::size_t kBlock = 64;
constexpr int kSteps = 30;

/// A search for the label that is displayed at a point.
struct Search {
    WorldPoint target;
    WorldPoint label;
    bool converged = false;
};

/// Moves a label by a step of Newton's method; returns false where it has arrived.
bool improve(Search& search, const ShorePoint& found, double tolerance, double longest, int step) {
    const double fx = search.label.x + static_cast<double>(found.dx.value()) - search.target.x;
    const double fy = search.label.y + static_cast<double>(found.dy.value()) - search.target.y;
    if (fx * fx + fy * fy <= tolerance * tolerance) {
        search.converged = true;
        return false;
    }
    const double xx = 1.0 + static_cast<double>(found.dx.by_x());
    const double xy = static_cast<double>(found.dx.by_y());
    const double yx = static_cast<double>(found.dy.by_x());
    const double yy = 1.0 + static_cast<double>(found.dy.by_y());
    const double jacobian = xx * yy - xy * yx;
    // Near folds, and where Newton's method wanders, the damped fixed point continues.
    constexpr double kFlat = 0.02;
    const bool wanders = step >= kSteps / 2 && step % 4 != 3;
    double dx = 0.5 * fx;
    double dy = 0.5 * fy;
    if (std::abs(jacobian) > kFlat && !wanders) {
        dx = (yy * fx - xy * fy) / jacobian;
        dy = (xx * fy - yx * fx) / jacobian;
    }
    const double limit = std::min(1.0, longest / std::max(std::hypot(dx, dy), 1e-30));
    search.label.x -= limit * dx;
    search.label.y -= limit * dy;
    return true;
}

void query_block(const ShoreSurface& surface, std::span<const WorldPoint> points,
                 std::span<QuerySample> samples, std::span<ShorePoint> labelled,
                 const ShoreSums* exact) {
    const double reach = surface.reach();
    const double tolerance = std::max(1e-6 * reach, 1e-6);
    std::array<Search, kBlock> searches;
    std::array<WorldPoint, kBlock> labels;
    std::array<ShorePoint, kBlock> found;
    std::array<std::size_t, kBlock> open;
    for (std::size_t i = 0; i < points.size(); ++i) {
        searches[i] = {points[i], points[i]};
        open[i] = i;
    }
    std::size_t left = points.size();
    for (int step = 0; step < kSteps && left > 0; ++step) {
        for (std::size_t n = 0; n < left; ++n) labels[n] = searches[open[n]].label;
        surface.read(std::span(labels).first(left), JetParts::all, std::span(found).first(left),
                     exact);
        std::size_t kept = 0;
        for (std::size_t n = 0; n < left; ++n) {
            const std::size_t i = open[n];
            labelled[i] = found[n];
            samples[i].label[0] = labels[n].x;
            samples[i].label[1] = labels[n].y;
            if (improve(searches[i], found[n], tolerance, 0.5 * reach + tolerance, step)) {
                open[kept++] = i;
            }
        }
        left = kept;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ShorePoint& point = labelled[i];
        QuerySample& sample = samples[i];
        sample.height = static_cast<double>(point.height.value());
        const std::array<float, 3> normal = shore_normal(point);
        for (std::size_t a = 0; a < 3; ++a) sample.normal[a] = static_cast<double>(normal[a]);
        sample.velocity[0] = static_cast<double>(point.dx.by_t());
        sample.velocity[1] = static_cast<double>(point.dy.by_t());
        sample.velocity[2] = static_cast<double>(point.height.by_t());
        sample.foam = 0.0;
        sample.folded = shore_jacobian(point) < 0.0f;
        sample.undecided = !searches[i].converged;
    }
}

}  // namespace

float shore_jacobian(const ShorePoint& point) {
    return (1.0f + point.dx.by_x()) * (1.0f + point.dy.by_y()) - point.dx.by_y() * point.dy.by_x();
}

std::array<float, 3> shore_normal(const ShorePoint& point) {
    // The cross product of the tangents along x and y.
    const float xx = 1.0f + point.dx.by_x();
    const float yx = point.dy.by_x();
    const float zx = point.height.by_x();
    const float xy = point.dx.by_y();
    const float yy = 1.0f + point.dy.by_y();
    const float zy = point.height.by_y();
    const float nx = yx * zy - zx * yy;
    const float ny = zx * xy - xx * zy;
    const float nz = xx * yy - yx * xy;
    const float length = std::sqrt(nx * nx + ny * ny + nz * nz);
    if (!(length > 0.0f)) return {0.0f, 0.0f, 1.0f};
    const float scale = (nz < 0.0f ? -1.0f : 1.0f) / length;
    return {scale * nx, scale * ny, scale * nz};
}

void require_query_of_coast(const Grid& grid, const QueryOptions& options) {
    const int shown = default_map_resolution(grid);
    if (options.resolution != 0 && options.resolution != shown) {
        throw Error(ErrorKind::unsupported,
                    "resolution = " + std::to_string(options.resolution) +
                        ": over a bed (water.seabed) a query reads all waves of the grid; allowed: "
                        "0 or " +
                        std::to_string(shown));
    }
    spline_resolution(grid.resolution, {.refine = options.refine});
}

void query_shore(const ShoreSurface& surface, std::span<const WorldPoint> points,
                 std::span<QuerySample> samples, std::span<ShorePoint> labelled,
                 const ShoreSums* exact, ThreadPool& pool) {
    // A sum over all modes takes long enough to be a work item of its own.
    const std::size_t piece = exact != nullptr ? 1 : kBlock;
    const std::size_t blocks = (points.size() + piece - 1) / piece;
    pool.for_each_item(static_cast<int>(blocks), [&](int block, int) {
        const std::size_t first = static_cast<std::size_t>(block) * piece;
        const std::size_t count = std::min(piece, points.size() - first);
        query_block(surface, points.subspan(first, count), samples.subspan(first, count),
                    labelled.subspan(first, count), exact);
    });
}

}  // namespace ocean
