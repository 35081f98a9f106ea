// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The quadtree of land: which squares of the plane are drawn, at which spacing of their vertices,
// and where a vertex is shown, after [Strugar 2009]. Meshes and the preview draw the same patches.
//
// A vertex of level l has an index (i, j) and the label (i, j) s(l), s(l) = spacing 2^l. A node of
// level l is a square of `patch` quads a side. All distances d are to the plane z = ground under
// the eye, d^2 = (x - eye.x)^2 + (y - eye.y)^2 + (eye.z - ground)^2: one function of the label for
// selection and morph, free of heights. With R(l) = range s(l), a node is divided if its nearest
// point is nearer than R(l - 1); a quarter that is farther away is drawn with the node's spacing.
//
// No cracks. Where squares of levels l and l' > l touch, the point that they share is at least
// R(l' - 1) from the eye, because the coarser square was not divided there, and less than
// R(l) + sqrt(2) patch s(l), because the finer one lies in a node that begins within R(l). If
//     range >= sqrt(2) patch / (2 morph_start - 1)
// then that distance is at most morph_start R(l + 1) < R(l + 1): so l' = l + 1, the coarser mesh
// has not begun to morph along the border, and the finer one has ended (share 1, snapped).
// `validate` refuses other settings.
//
// Morph. A vertex of level l shows z = mix(h(l), c, share): h(l) the height sampled for s(l), c the
// linear surface of level l + 1 at the same label. Both levels cut their quads from (0, 0) to
// (1, 1), so c is the mean of h(l + 1) at the two ends of the parent's edge that the vertex halves:
// along x for (odd, even), along y for (even, odd), along the diagonal for (odd, odd). Vertices do
// not slide: share 1 shows the mesh of level l + 1, and a change of level changes no height.
//
// Snap. From 1/4 spacing before R(l) on, odd vertices move onto an end of the edge that they halve:
// (odd, even) to i + 1, (even, odd) to j + 1, (odd, odd) to (i - 1, j - 1). These directions run
// around each triangle of the parent in one sense (right, up, back along the diagonal). Hence for
// any subset of its three halved edges the four small triangles tile it without a flip or a sliver:
// two snapped vertices never stand at the two ends of the edge of a third that is not snapped, so
// that a triangle has two equal vertices, and is dropped, or an area. Share is 1 from 7/4
// spacings before R(l) on, more than 1/4 + sqrt(2): the triangles around a snapped vertex lie on
// the parent's planes, and snapping changes nothing that is shown. Along a border to a coarser
// level all vertices are snapped, and both sides have the same points, bit by bit.
//
// Edge. On land that exists once, labels beyond the edge are clamped onto it, and c takes the
// clamped parents. Only there can a vertex leave the line between its parents; it therefore slides
// to their middle as its share grows, so that share 1 is the clamped parent mesh. Quads beyond the
// edge become triangles with two equal vertices. A clamped label stays in its square: the argument
// about borders holds for it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ocean/query.hpp"

namespace ocean {

inline constexpr double kMaxQuadtreeCoordinate = 1e8;  // of edges, eyes and distances [m]

/// A rectangle of land that exists once [m].
struct LandEdge {
    std::array<double, 2> low{};
    std::array<double, 2> high{};

    bool operator==(const LandEdge&) const = default;
};

/// The fineness of a quadtree. Threads may share one.
struct QuadtreeSettings {
    double spacing = 0.5;  // of the vertices of level 0 [m], 0.001 .. 1e6
    int patch = 16;        // quads along a side of a node, 4 .. 1024, a multiple of 4
    int levels = 15;       // 1 .. 30
    /// Distance at which a level ends, in its spacings, min_range or more. Over land with an rms
    /// slope of 0.35 and waves down to 2 m, 140 moves no shown point by more than 0.2 pixels a
    /// frame (1280 pixels in 60 degrees, 30 m/s at 24 frames/s). Patches of 32 quads need 150 for
    /// the same, and 1.4 times the triangles.
    double range = 140.0;
    double morph_start = 0.585;         // as a share of the range, above 0.5
    double farthest = 150e3;            // squares beyond are not drawn [m]
    std::optional<LandEdge> edge = {};  // absent: land without end

    /// Returns the spacing of the vertices of a level [m].
    double spacing_of(int level) const {
        return spacing * static_cast<double>(std::int64_t{1} << level);
    }
    /// Returns the distance at which a level ends [m].
    double range_of(int level) const { return range * spacing_of(level); }
};

/// Returns the min range, in spacings, at which levels meet without cracks; infinite if morph_start
/// is 0.5 or less.
double min_range(const QuadtreeSettings& settings);

/// Throws Error invalid_value for settings out of their ranges, for a range below `min_range`, for
/// less than four spacings between the start of the morph and the range, and for squares of the
/// coarsest level that are smaller than 1/64 of `farthest`.
void validate(const QuadtreeSettings& settings);

/// A square to draw: `quads` a side, its lower left corner at vertex (i, j) quads of its level.
struct LandPatch {
    int level;
    std::int64_t i, j;  // its corner, in its sides from the world's origin
    bool quarter;       // half the side of a node, with the node's spacing

    int quads(const QuadtreeSettings& settings) const {
        return quarter ? settings.patch / 2 : settings.patch;
    }
    bool operator==(const LandPatch&) const = default;
};

/// An eye over land. Any `ground` gives a closed mesh; a ground without waves of a few metres keeps
/// the levels from flickering as the eye moves.
struct LandView {
    std::array<double, 3> eye{};
    double ground = 0.0;  // height of the ground under the eye [m]
    /// The frustum: planes (a, b, c, d), inside where a x + b y + c z + d >= 0. Empty: all round.
    std::span<const std::array<double, 4>> planes = {};
};

/// Returns the lowest and highest height at any spacing [m] in the square with the lower left
/// corner (x, y).
using HeightBounds = std::function<std::pair<float, float>(double x, double y, double side)>;

/// Replaces `patches` by the squares to draw, near ones first within each node; allocates only
/// where the vector grows. The squares do not overlap and cover the land up to `farthest`, apart
/// from what is outside the planes. `bounds` is called only if the view has planes. Throws as
/// validate, and Error invalid_value for an eye or ground that is not finite or farther than 1e8 m
/// from the origin, or planes without bounds.
void select(const QuadtreeSettings& settings, const LandView& view, const HeightBounds& bounds,
            std::vector<LandPatch>& patches);
/// Returns the squares to draw in a new vector.
std::vector<LandPatch> select(const QuadtreeSettings& settings, const LandView& view,
                              const HeightBounds& bounds);

/// Returns the number of triangles of the patches, before any are dropped as degenerate.
std::uint64_t triangles_of(const QuadtreeSettings& settings, std::span<const LandPatch> patches);

/// Returns the share of the next coarser surface in what a level shows at a distance [m]: 0 up to
/// morph_start of its range, 1 from 7/4 spacings before the range on, between them linear in the
/// distance squared; always 0 on the coarsest level.
double morph_at(const QuadtreeSettings& settings, int level, double distance);

/// Returns true where the odd vertices of a level stand on even ones: from 1/4 spacing before the
/// range on.
bool snaps_at(const QuadtreeSettings& settings, int level, double distance);

/// Returns the distance of the view to the point (x, y) of its plane [m].
double plane_distance(const LandView& view, WorldPoint point);

/// The index of a vertex in the lattice of its level.
struct LandIndex {
    std::int64_t i, j;

    bool operator==(const LandIndex&) const = default;
};

/// Returns the label of a vertex, on the edge if it lies beyond [m].
WorldPoint land_label(const QuadtreeSettings& settings, int level, LandIndex index);

/// A vertex as a view shows it.
struct LandVertex {
    WorldPoint label;                  // where the height of its own level is sampled
    WorldPoint shown;                  // where it stands
    double share;                      // share of the coarser surface in its height, 0 .. 1
    std::array<LandIndex, 2> parents;  // vertices of the next level, by even indices of this level

    /// Returns the vertex's height from the height of its own level and the next level's heights at
    /// its parents. A height whose share is 0 may be anything.
    double height(float own, float first, float second) const;
};

/// Returns where a vertex of a level is shown, the same place in all patches that have the vertex.
LandVertex land_vertex(const QuadtreeSettings& settings, const LandView& view, int level,
                       LandIndex index);

}  // namespace ocean
