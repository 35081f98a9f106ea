// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the shown surface is folded, and which labels are shown there. The signs of the Jacobians
// of all labels shown at one place add up to 1, so that a place shows several labels only if one of
// them has J < 0: places that are not near such a label need no search. For the others all cells of
// the label lattice that are shown near them are listed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "ocean/query.hpp"
#include "query/spline_map.hpp"

namespace ocean {

class FoldIndex {
  public:
    /// `map` holds dx, dy at choppiness 1 as its first two fields. Cells lie between the samples of
    /// a lattice of `resolution`.
    FoldIndex(const SplineMap& map, double choppiness, int resolution, ThreadPool& pool);

    /// Of a surface that is not folded everywhere, at most.
    static std::uint64_t bytes(int resolution);

    /// Largest horizontal displacement, m.
    double reach() const { return reach_; }
    /// The middles of all cells that may show a place within one period, as far from it as they are
    /// displaced: labels to start a search from. None where no fold is near: one label is shown
    /// there. Empties `labels` first.
    void labels_near(double x, double y, std::vector<WorldPoint>& labels) const;

  private:
    struct Offset {
        float x, y;
    };
    /// Tiles that a cell is shown in, wrapped; `last` belongs to it.
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
    /// Around all that a cell shows.
    struct Box {
        Range x, y;
    };
    /// Corners bound what is shown between them but for the bend of the surface, which moves the
    /// edge of a fold: boxes are larger than their corners by this part of themselves and of the
    /// spacing.
    static constexpr double kMargin = 0.25;

    std::vector<float> place_samples(const SplineMap& map, double choppiness, ThreadPool& pool);
    void index_cells(const std::vector<float>& jacobian);
    Box box_of(int i, int j) const;
    TileRange tiles_of(int i, int j) const;
    template <typename Visit>
    void each_tile(const TileRange& range, const Visit& visit) const;
    std::size_t tile_at(double x, double y) const;
    std::size_t sample_at(int i, int j) const;

    Lattice lattice_;
    int tiles_ = 1;  // a side
    double reach_ = 0.0;
    bool hopeless_ = false;             // so folded that the lists would not end: no search
    std::vector<Offset> offset_;        // of each sample of the lattice, m; empty without folds
    std::vector<std::uint32_t> begin_;  // of each tile's part of cells_, and the end
    std::vector<std::uint32_t> cells_;  // j * resolution + i
};

}  // namespace ocean
