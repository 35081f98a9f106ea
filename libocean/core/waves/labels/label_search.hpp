// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Queries of a surface that is known by label: the label that is displayed at each point of the
// world, found by Newton's method, and the surface there.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "ocean/query.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/labels/label_point.hpp"

namespace ocean {

/// The search for the label that is displayed at one point.
struct LabelSearch {
    WorldPoint target;
    WorldPoint label;
    bool converged = false;

    static constexpr int kSteps = 30;

    /// Moves the label by a step of Newton's method; returns false where it has arrived. `found`:
    /// the surface at the label.
    bool improve(const LabelPoint& found, double tolerance, double longest, int step) {
        const double fx = label.x + static_cast<double>(found.dx.value()) - target.x;
        const double fy = label.y + static_cast<double>(found.dy.value()) - target.y;
        if (fx * fx + fy * fy <= tolerance * tolerance) {
            converged = true;
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
        label.x -= limit * dx;
        label.y -= limit * dy;
        return true;
    }
};

/// Writes the sample of a point; foam is 0.
inline void write_sample(const LabelPoint& point, const LabelSearch& search, QuerySample& sample) {
    sample.height = static_cast<double>(point.height.value());
    const std::array<float, 3> normal = label_normal(point);
    for (std::size_t a = 0; a < 3; ++a) sample.normal[a] = static_cast<double>(normal[a]);
    sample.velocity[0] = static_cast<double>(point.dx.by_t());
    sample.velocity[1] = static_cast<double>(point.dy.by_t());
    sample.velocity[2] = static_cast<double>(point.height.by_t());
    sample.foam = 0.0;
    sample.folded = label_jacobian(point) < 0.0f;
    sample.undecided = !search.converged;
}

/// The points that search_labels moves together.
inline constexpr std::size_t kSearchBlock = 64;

/// Writes one sample for each of up to kSearchBlock points, and to `labelled` the surface at the
/// labels found. read(labels, points) writes the surface at labels; Point is a LabelPoint or
/// derived from it.
template <typename Point, typename Read>
void search_block(const Read& read, double reach, std::span<const WorldPoint> points,
                  std::span<QuerySample> samples, std::span<Point> labelled) {
    const double tolerance = std::max(1e-6 * reach, 1e-6);
    std::array<LabelSearch, kSearchBlock> searches;
    std::array<WorldPoint, kSearchBlock> labels;
    std::array<Point, kSearchBlock> found;
    std::array<std::size_t, kSearchBlock> open;
    for (std::size_t i = 0; i < points.size(); ++i) {
        searches[i] = {points[i], points[i]};
        open[i] = i;
    }
    std::size_t left = points.size();
    for (int step = 0; step < LabelSearch::kSteps && left > 0; ++step) {
        for (std::size_t n = 0; n < left; ++n) labels[n] = searches[open[n]].label;
        read(std::span<const WorldPoint>(labels).first(left), std::span(found).first(left));
        std::size_t kept = 0;
        for (std::size_t n = 0; n < left; ++n) {
            const std::size_t i = open[n];
            labelled[i] = found[n];
            samples[i].label[0] = labels[n].x;
            samples[i].label[1] = labels[n].y;
            if (searches[i].improve(found[n], tolerance, 0.5 * reach + tolerance, step)) {
                open[kept++] = i;
            }
        }
        left = kept;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        write_sample(labelled[i], searches[i], samples[i]);
    }
}

/// Writes one sample for each point, on all threads; the bits are the same for any number of them.
/// reach: max distance between a label and the point where it is displayed [m]. piece: points of a
/// work item, at most kSearchBlock; 1 for reads that take long. Points must be finite. For the
/// other arguments see search_block.
template <typename Point, typename Read>
void search_labels(const Read& read, double reach, std::size_t piece,
                   std::span<const WorldPoint> points, std::span<QuerySample> samples,
                   std::span<Point> labelled, ThreadPool& pool) {
    const std::size_t blocks = (points.size() + piece - 1) / piece;
    pool.for_each_item(static_cast<int>(blocks), [&](int block, int) {
        const std::size_t first = static_cast<std::size_t>(block) * piece;
        const std::size_t count = std::min(piece, points.size() - first);
        search_block(read, reach, points.subspan(first, count), samples.subspan(first, count),
                     labelled.subspan(first, count));
    });
}

}  // namespace ocean
