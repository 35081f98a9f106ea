// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The shown positions of the vertices of a quadtree of land. ocean/internal/land_quadtree.hpp has
// the argument.
#include <algorithm>
#include <cmath>

#include "ocean/internal/land_quadtree.hpp"

namespace ocean {
namespace {

// Distances before the range, in spacings. Triangles around a snapped vertex end sqrt(2) from it
// and must lie on the parent's planes: kFlat > kSnap + sqrt(2). kSnap leaves room for distances in
// float.
constexpr double kSnap = 0.25;
constexpr double kFlat = 1.75;

double clamped(const QuadtreeSettings& settings, std::size_t axis, double value) {
    return std::clamp(value, settings.edge->low[axis], settings.edge->high[axis]);
}

bool is_odd(std::int64_t index) {
    return (index & 1) != 0;
}

/// Returns the ends of the parent's edge that a vertex halves; for a vertex of the parent, the
/// vertex itself twice.
std::array<LandIndex, 2> parents_of(LandIndex v) {
    const std::int64_t i = v.i & 1, j = v.j & 1;
    return {LandIndex{v.i - i, v.j - j}, LandIndex{v.i + i, v.j + j}};
}

/// Returns the end of its edge that a vertex snaps to: right, up, or back along the diagonal.
LandIndex snap_of(LandIndex v) {
    const std::array<LandIndex, 2> ends = parents_of(v);
    return is_odd(v.i) && is_odd(v.j) ? ends[0] : ends[1];
}

}  // namespace

double plane_distance(const LandView& view, WorldPoint point) {
    const double x = point.x - view.eye[0], y = point.y - view.eye[1];
    const double z = view.eye[2] - view.ground;
    return std::sqrt(x * x + y * y + z * z);
}

double morph_at(const QuadtreeSettings& settings, int level, double distance) {
    if (level + 1 >= settings.levels) return 0.0;
    const double d = distance / settings.spacing_of(level);
    const double begin = settings.morph_start * settings.range, end = settings.range - kFlat;
    return std::clamp((d * d - begin * begin) / (end * end - begin * begin), 0.0, 1.0);
}

bool snaps_at(const QuadtreeSettings& settings, int level, double distance) {
    return level + 1 < settings.levels &&
           distance >= (settings.range - kSnap) * settings.spacing_of(level);
}

WorldPoint land_label(const QuadtreeSettings& settings, int level, LandIndex index) {
    const double spacing = settings.spacing_of(level);
    WorldPoint label{static_cast<double>(index.i) * spacing,
                     static_cast<double>(index.j) * spacing};
    if (settings.edge) {
        label = {clamped(settings, 0, label.x), clamped(settings, 1, label.y)};
    }
    return label;
}

double LandVertex::height(float own, float first, float second) const {
    if (share == 0.0) return double{own};
    const double coarse = 0.5 * (double{first} + double{second});
    return share == 1.0 ? coarse : double{own} + share * (coarse - double{own});
}

LandVertex land_vertex(const QuadtreeSettings& settings, const LandView& view, int level,
                       LandIndex index) {
    LandVertex vertex;
    vertex.label = land_label(settings, level, index);
    vertex.shown = vertex.label;
    const double distance = plane_distance(view, vertex.label);
    if (snaps_at(settings, level, distance)) {
        const LandIndex end = snap_of(index);
        vertex.shown = land_label(settings, level, end);
        vertex.share = 1.0;
        vertex.parents = {end, end};
        return vertex;
    }
    vertex.share = morph_at(settings, level, distance);
    vertex.parents = parents_of(index);
    if (settings.edge && vertex.share > 0.0) {
        const WorldPoint a = land_label(settings, level, vertex.parents[0]);
        const WorldPoint b = land_label(settings, level, vertex.parents[1]);
        vertex.shown.x += vertex.share * (0.5 * (a.x + b.x) - vertex.label.x);
        vertex.shown.y += vertex.share * (0.5 * (a.y + b.y) - vertex.label.y);
    }
    return vertex;
}

}  // namespace ocean
