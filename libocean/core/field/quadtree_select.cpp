// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The walk through a quadtree of land.
#include <algorithm>
#include <cmath>

#include "ocean/error.hpp"
#include "ocean/internal/land_quadtree.hpp"

namespace ocean {
namespace {

/// A square of the plane [m]. Its corners are labels of vertices, bit by bit, so that even with
/// rounding all vertices of a square are at least as far from the eye as its nearest point.
struct Square {
    double x0, y0, x1, y1;
};

/// The squares of one view.
class Walk {
  public:
    Walk(const QuadtreeSettings& settings, const LandView& view, const HeightBounds& bounds,
         std::vector<LandPatch>& patches)
        : settings_(settings), view_(view), bounds_(bounds), patches_(patches) {}

    void run() {
        const int level = settings_.levels - 1;
        const double side = settings_.patch * settings_.spacing_of(level);
        std::array<double, 4> reach;  // [m]
        for (std::size_t axis = 0; axis < 2; ++axis) {
            reach[axis] = view_.eye[axis] - settings_.farthest;
            reach[axis + 2] = view_.eye[axis] + settings_.farthest;
            if (!settings_.edge) continue;
            reach[axis] = std::max(reach[axis], settings_.edge->low[axis]);
            reach[axis + 2] = std::min(reach[axis + 2], settings_.edge->high[axis]);
        }
        const auto cell = [&](double at) {
            return static_cast<std::int64_t>(std::floor(at / side));
        };
        for (std::int64_t j = cell(reach[1]); j <= cell(reach[3]); ++j) {
            for (std::int64_t i = cell(reach[0]); i <= cell(reach[2]); ++i) {
                const Square square = node_square(level, i, j);
                const double distance = nearest(square);
                if (exists(square, distance)) visit(level, i, j, square, distance);
            }
        }
    }

  private:
    Square node_square(int level, std::int64_t i, std::int64_t j) const {
        const double spacing = settings_.spacing_of(level);
        const auto label = [&](std::int64_t index) {
            return static_cast<double>(index * settings_.patch) * spacing;
        };
        return {label(i), label(j), label(i + 1), label(j + 1)};
    }

    double nearest(const Square& s) const {
        return plane_distance(
            view_, {std::clamp(view_.eye[0], s.x0, s.x1), std::clamp(view_.eye[1], s.y0, s.y1)});
    }

    bool exists(const Square& s, double distance) const {
        if (distance > settings_.farthest) return false;
        if (!settings_.edge) return true;
        const LandEdge& edge = *settings_.edge;
        return s.x0 < edge.high[0] && s.x1 > edge.low[0] && s.y0 < edge.high[1] &&
               s.y1 > edge.low[1];
    }

    /// Returns false if the box over a square lies outside one of the planes.
    bool is_seen(const Square& s) const {
        if (view_.planes.empty()) return true;
        const std::pair<float, float> heights = bounds_(s.x0, s.y0, s.x1 - s.x0);
        for (const std::array<double, 4>& p : view_.planes) {
            const double x = p[0] > 0.0 ? s.x1 : s.x0;
            const double y = p[1] > 0.0 ? s.y1 : s.y0;
            const double z = double{p[2] > 0.0 ? heights.second : heights.first};
            if (p[0] * x + p[1] * y + p[2] * z + p[3] < 0.0) return false;
        }
        return true;
    }

    void visit(int level, std::int64_t i, std::int64_t j, const Square& square, double distance) {
        if (!is_seen(square)) return;
        const double finer = level > 0 ? settings_.range_of(level - 1) : 0.0;
        if (distance >= finer) {
            patches_.push_back({level, i, j, false});
            return;
        }
        // The child under the eye comes first, the opposite child last.
        const Square first = node_square(level - 1, 2 * i, 2 * j);
        const int near = (view_.eye[0] < first.x1 ? 0 : 1) | (view_.eye[1] < first.y1 ? 0 : 2);
        for (int turn = 0; turn < 4; ++turn) {
            const int q = near ^ turn;
            const std::int64_t a = 2 * i + (q & 1), b = 2 * j + (q >> 1);
            const Square child = node_square(level - 1, a, b);
            const double d = nearest(child);
            if (!exists(child, d)) continue;
            if (d < finer) {
                visit(level - 1, a, b, child, d);
            } else if (is_seen(child)) {
                patches_.push_back({level, a, b, true});
            }
        }
    }

    const QuadtreeSettings& settings_;
    const LandView& view_;
    const HeightBounds& bounds_;
    std::vector<LandPatch>& patches_;
};

void validate_view(const LandView& view, const HeightBounds& bounds) {
    for (const double value : {view.eye[0], view.eye[1], view.eye[2], view.ground}) {
        if (!(std::abs(value) <= kMaxQuadtreeCoordinate)) {
            throw Error(ErrorKind::invalid_value,
                        ErrorFields{.what = "is not finite or too far from the origin",
                                    .parameter = "view",
                                    .allowed = "eye and ground within -1e8 .. 1e8 m"});
        }
    }
    if (!view.planes.empty() && !bounds) {
        throw Error(
            ErrorKind::invalid_value,
            ErrorFields{.what = "has planes, but no bounds of heights", .parameter = "view"});
    }
}

}  // namespace

void select(const QuadtreeSettings& settings, const LandView& view, const HeightBounds& bounds,
            std::vector<LandPatch>& patches) {
    validate(settings);
    validate_view(view, bounds);
    patches.clear();
    Walk(settings, view, bounds, patches).run();
}

std::vector<LandPatch> select(const QuadtreeSettings& settings, const LandView& view,
                              const HeightBounds& bounds) {
    std::vector<LandPatch> patches;
    select(settings, view, bounds, patches);
    return patches;
}

std::uint64_t triangles_of(const QuadtreeSettings& settings, std::span<const LandPatch> patches) {
    std::uint64_t triangles = 0;
    for (const LandPatch& patch : patches) {
        const auto side = static_cast<std::uint64_t>(patch.quads(settings));
        triangles += 2 * side * side;
    }
    return triangles;
}

}  // namespace ocean
