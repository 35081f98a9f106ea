// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The mesh of land in a picture: the squares of the quadtree that the camera sees, with the heights
// of their vertices in a texture, drawn as instances of one small grid.
//
// Heights are made by other threads. A picture that cannot wait for all of them is drawn as from an
// eye that is so high that it has no squares of the levels that lack some: coarser near the eye,
// but closed, because selection and morph see the same eye.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "clipmap.hpp"
#include "drawable.hpp"
#include "height_ranges.hpp"
#include "ocean/internal/land_quadtree.hpp"
#include "patch_maker.hpp"
#include "patch_textures.hpp"

namespace ocean::preview {

/// The view that a picture's patches were chosen for, as the vertex shader needs it.
struct DrawnLattice {
    QuadtreeSettings settings;
    std::array<std::int64_t, 2> snapped{};  // the eye in spacings of level 0, rounded down
    double height = 0.0;                    // of the eye over the plane of distances [m]
};

class LandPatches {
  public:
    /// live: pictures do not wait for all patches, and those ahead of a flight are made in advance.
    explicit LandPatches(const RendererOptions& options);

    /// Draws this land from now on, which must outlive the pictures.
    void show(const DrawnLand& land);
    /// Returns the distance beyond which no ground is seen [m].
    double farthest(double eye_height) const;
    /// Chooses the patches of a picture and makes the missing ones. Throws Error.
    DrawnLattice choose(const PictureFrame& frame);
    /// Draws them with the current program. Leaves its vertex array bound.
    void draw() const;

    GLuint heights() const { return rows_.texture(); }
    /// Returns the texture of slopes that the land's map lacks, or 0.
    GLuint slopes() const { return layers_.texture(); }
    Pending pending() const;
    const LandStatistics& statistics() const { return statistics_; }

  private:
    /// A quarter of a node, as shaders/preview/land_vertex.glsl reads it.
    struct Instance {
        std::array<std::int32_t, 4> place;   // corner of the node in level 0 from the snapped eye;
                                             // level; row of its heights
        std::array<std::int32_t, 2> corner;  // of the quarter in the node [vertices]
        std::int32_t layer;                  // of its slopes, or -1
    };

    void make_grid();
    QuadtreeSettings settings_for(double eye_height) const;
    /// Returns bounds of the heights in a square, which lies lower by the drop of the round Earth.
    std::pair<float, float> bounds(const LandView& view, double x, double y, double side) const;
    bool sees(const LandView& view, double x, double y, double side) const;
    void select_seen(const LandView& view);
    /// Returns the nodes of the selection that are not resident; keeps the others.
    std::vector<PatchKey> missing();
    void fetch(std::vector<PatchKey> lacking, bool at_once);
    void upload_made();
    void prefetch(const LandView& view);
    bool has_detail(const PatchKey& key) const;
    void fetch_detail();
    void place_instances(const DrawnLattice& lattice, const LandView& view);

    bool live_, shows_detail_;
    std::chrono::duration<double> patience_;
    const DrawnLand* land_ = nullptr;
    std::shared_ptr<const LandFunction> function_;  // of the resident patches
    std::optional<HeightRanges> ranges_;
    QuadtreeSettings settings_;
    PatchMaker maker_, detail_maker_;
    PatchRows rows_;
    PatchLayers layers_;
    double detail_cell_ = 0.0;  // texels of slopes are made that are smaller [m]
    gl::VertexArray array_;
    gl::Buffer vertices_, indices_, instances_;
    int index_count_ = 0;
    std::vector<LandPatch> patches_, ahead_;
    std::vector<Instance> placed_;
    std::optional<std::array<double, 3>> eye_before_;
    bool lacks_ = false;         // the last picture lacks patches
    bool lacks_detail_ = false;  // or their slopes
    LandStatistics statistics_;
};

}  // namespace ocean::preview
