// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// An index of the folds of the displayed surface and of the labels displayed there. The signs of
// the Jacobians of all labels displayed at one point add up to 1, so a point displays several
// labels only if one of them has J < 0: points that are not near such a label need no search. For
// the others, all cells of the label lattice that are displayed near them are listed, block by
// block of points, when needed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "ocean/page_vector.hpp"
#include "ocean/query.hpp"
#include "waves/query/lazy_tiles.hpp"
#include "waves/query/spline_map.hpp"

namespace ocean {

class FoldIndex {
  public:
    static constexpr int kBlock = 32;  // cells of a block of points, along each axis

    /// Makes an index whose cells lie between the samples of a lattice of `resolution`, at most the
    /// map's.
    FoldIndex(double period, int resolution, ThreadPool& pool);

    /// Begins a new surface without any block. `reach` is the max distance of a label from its
    /// displayed point [m].
    void begin(double choppiness, double reach);

    /// Returns an upper bound of the bytes for a surface that is not folded everywhere.
    static std::uint64_t bytes(int resolution);

    int blocks() const { return places_.count(); }
    /// Returns the block that a point within the period lies in.
    int block_of(double x, double y) const {
        return static_cast<int>(tile_along(y)) / kBlockTiles * across_ +
               static_cast<int>(tile_along(x)) / kBlockTiles;
    }
    bool has(int block) const { return places_.has(block); }
    /// Calls visit(column) for one column of the map in each `width` of them that make(block)
    /// reads, and for the columns from which labels displayed there are read.
    template <typename Visit>
    void each_column(const SplineMap& map, int block, int width, const Visit& visit) const;
    /// Makes the missing blocks of these; the map must be ready in the columns that visit() named.
    /// Its first two fields are dx, dy at choppiness 1. One thread at a time.
    void make(const SplineMap& map, std::span<const int> blocks, ThreadPool* pool);

    /// Writes the centres of all cells that may be displayed at a point within one period, shifted
    /// by their displacement: labels to start a search from. Empties `labels` first, and leaves it
    /// empty if no fold is near, where one label is displayed. The block of the point must be
    /// ready. Returns false if the surface is folded so much that the lists were given up.
    bool labels_near(double x, double y, std::vector<WorldPoint>& labels) const;
    /// Approximations of the label displayed at a point where no fold is near: look() improves one,
    /// and guess() returns the result of kLooks looks that begin at the point, near enough to start
    /// a search. The block of the point must be ready.
    static constexpr int kLooks = 2;
    WorldPoint look(WorldPoint place, WorldPoint label) const;
    WorldPoint guess(WorldPoint place) const;
    /// Prefetches the memory for reading a label.
    void prefetch(WorldPoint label) const { __builtin_prefetch(&offset_[sample_near(label)]); }

  private:
    static constexpr int kCellsPerTile = 4;  // along each axis
    static constexpr int kBlockTiles = kBlock / kCellsPerTile;
    static constexpr std::size_t kTilesOfBlock = kBlockTiles * kBlockTiles;

    struct Offset {
        float x, y;
    };
    /// Range of the tiles in which a cell is shown, wrapped; `last` is included.
    struct TileRange {
        long long first_x, first_y;
        int count_x, count_y;
    };
    struct Range {
        double low = std::numeric_limits<double>::infinity();
        double high = -std::numeric_limits<double>::infinity();

        void add(double value) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
        void widen(double spacing) {
            const double margin = kMargin * (high - low + spacing);
            low -= margin;
            high += margin;
        }
        bool holds(double value) const { return value >= low && value <= high; }
    };
    /// Bounds of the displayed points of a cell.
    struct Box {
        Range x, y;

        static Box everywhere() {
            constexpr double kInfinity = std::numeric_limits<double>::infinity();
            return {{-kInfinity, kInfinity}, {-kInfinity, kInfinity}};
        }
    };
    /// A range of tiles in a block of points.
    struct TileBounds {
        int first_x = kBlockTiles, first_y = kBlockTiles;
        int last_x = -1, last_y = -1;

        void add(int tile) {
            first_x = std::min(first_x, tile % kBlockTiles);
            last_x = std::max(last_x, tile % kBlockTiles);
            first_y = std::min(first_y, tile / kBlockTiles);
            last_y = std::max(last_y, tile / kBlockTiles);
        }
        bool empty() const { return last_x < 0; }
    };
    /// The margin of boxes, relative to their size and to the spacing. Corners bound the surface
    /// between them except for its curvature, which shifts the edge of a fold.
    static constexpr double kMargin = 0.25;

    /// Labels are placed and measured in patches, smaller than the blocks of points: what a block
    /// shows reaches a few cells beyond it.
    static constexpr int kPatch = 8;  // cells, along each axis
    static constexpr int kFirstSample = 1 - kPatch;

    /// A range of cells along one axis; `first` may be negative, and `end` lies after the last.
    struct CellRange {
        int first, end;

        /// Returns the range of the squares of `size` cells that hold these cells.
        CellRange in_squares(int size) const {
            return {static_cast<int>(std::floor(static_cast<double>(first) / size)),
                    static_cast<int>(std::ceil(static_cast<double>(end) / size))};
        }
        CellRange within(int low, int high) const {
            return {std::max(first, low), std::min(end, high)};
        }
    };
    struct CellBox {
        CellRange x, y;

        /// Returns the box of the samples at the corners of these cells.
        CellBox with_corners() const { return {{x.first, x.end + 1}, {y.first, y.end + 1}}; }
    };
    /// Returns the labels that may be shown in a block of points, along one axis: whole patches.
    CellRange labels_of(int place) const;
    CellBox labels_around(int place) const {
        return {labels_of(place % across_), labels_of(place / across_)};
    }
    bool is_all_round(CellRange labels) const {
        return labels.end - labels.first == lattice_.resolution;
    }
    /// Calls visit(i, j, cells) for the squares of `size` cells, numbered within the period, that
    /// hold cells of a box, and for these cells.
    template <typename Visit>
    void each_square(const CellBox& box, int size, const Visit& visit) const;
    void place_samples(const SplineMap& map, int patch);
    void measure_cells(int patch);
    void list_cells(int block);
    Box corners_for(int block, const TileBounds& tiles, float widest) const;
    template <typename Visit>
    static void each_sample(const CellBox& box, const Visit& visit);
    /// Returns the square of a patch that begins `offset` cells after the patch's number says.
    CellBox square_at(int patch, int offset) const {
        const int i = patch % patches_ * kPatch + offset;
        const int j = patch / patches_ * kPatch + offset;
        return {{i, i + kPatch}, {j, j + kPatch}};
    }
    Box box_of(int i, int j) const;
    TileRange tiles_of(int i, int j) const;
    template <typename Visit>
    void each_tile(const TileRange& range, int block, const Visit& visit) const;
    std::size_t tile_along(double x) const;
    std::size_t sample_at(int i, int j) const;
    std::size_t sample_near(WorldPoint label) const;

    struct Measured {
        float widest;                     // max span of a cell beyond its spacing [m]
        std::vector<TileRange> squeezed;  // tiles that show the squeezed cells
    };
    /// The cells that are shown in the squeezed tiles of a block of places.
    struct Cells {
        std::vector<std::uint32_t> begin;  // of each tile, and the end; empty: no folds
        std::vector<std::uint32_t> cell;   // j * resolution + i
        bool hopeless = false;             // the lists were given up
    };

    Lattice lattice_;
    int tiles_;    // a side
    int across_;   // blocks a side
    int patches_;  // a side
    double choppiness_ = 0.0;
    double reach_ = 0.0;
    LazyTiles labels_;                // patches whose samples are placed
    LazyTiles measured_;              // patches whose cells are measured
    LazyTiles places_;                // blocks whose cells are listed
    PageVector<Offset> offset_;       // of each sample of the lattice [m]
    PageVector<float> jacobian_;      // of each sample
    std::vector<Measured> cells_of_;  // one for each patch of labels
    std::vector<Cells> cells_;        // one for each block of points
};

inline std::size_t FoldIndex::tile_along(double x) const {
    const double per_metre = tiles_ / lattice_.period;
    return static_cast<std::size_t>(std::min(static_cast<int>(x * per_metre), tiles_ - 1));
}

inline std::size_t FoldIndex::sample_at(int i, int j) const {
    const int mask = lattice_.resolution - 1;
    return static_cast<std::size_t>(j & mask) * static_cast<std::size_t>(lattice_.resolution) +
           static_cast<std::size_t>(i & mask);
}

inline std::size_t FoldIndex::sample_near(WorldPoint label) const {
    const double per_metre = lattice_.resolution / lattice_.period;
    const auto index = [&](double a) { return static_cast<int>(floor_index(a * per_metre + 0.5)); };
    return sample_at(index(label.x), index(label.y));
}

inline WorldPoint FoldIndex::look(WorldPoint place, WorldPoint label) const {
    if (choppiness_ == 0.0) return place;
    const Offset offset = offset_[sample_near(label)];
    return {place.x - static_cast<double>(offset.x), place.y - static_cast<double>(offset.y)};
}

template <typename Visit>
void FoldIndex::each_column(const SplineMap& map, int block, int width, const Visit& visit) const {
    const int size = map.lattice().resolution;
    const int step = size / lattice_.resolution;
    const CellRange labels = labels_of(block % across_);
    const int first = (labels.first + kFirstSample) * step - 1;
    const int last = std::min(labels.end * step + 2, first + size);
    for (int column = first; column < last; column += width) visit(column & (size - 1));
    visit(last & (size - 1));
}

}  // namespace ocean
