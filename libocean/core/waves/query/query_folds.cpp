// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The index of folds; see query_folds.hpp.
#include "waves/query/query_folds.hpp"

#include <array>
#include <cmath>

#include "base/prefault_pages.hpp"
#include "ocean/thread_pool.hpp"
#include "wave/wave.hpp"

namespace ocean {
namespace {

/// A cell is squeezed if a corner's Jacobian is below this, because it may be lower within the
/// cell.
constexpr float kSqueezed = 0.25f;
/// Limit of the average number of tiles in which a cell is displayed, normally one to four. At this
/// limit neighbouring labels lie tens of cells apart, and no surface is left to search.
constexpr std::size_t kMaxTilesPerCell = 16;

}  // namespace

FoldIndex::FoldIndex(double period, int resolution, ThreadPool& pool)
    : lattice_{resolution, period},
      tiles_(resolution / kCellsPerTile),
      across_(resolution / kBlock),
      labels_(across_ * across_),
      measured_(across_ * across_),
      places_(across_ * across_),
      offset_(lattice_.size()),
      jacobian_(lattice_.size()),
      cells_of_(static_cast<std::size_t>(labels_.count())),
      cells_(static_cast<std::size_t>(places_.count())) {
    prefault_pages(offset_, pool);
    prefault_pages(jacobian_, pool);
}

void FoldIndex::begin(double choppiness, double reach) {
    choppiness_ = choppiness;
    reach_ = reach;
    labels_.clear();
    measured_.clear();
    places_.clear();
}

FoldIndex::LabelBlocks FoldIndex::labels_of(int place) const {
    const double reach = reach_ / lattice_.period * lattice_.resolution;
    const double blocks = std::ceil((reach + 1.0) / kBlock);
    if (!(2.0 * blocks + 2.0 < across_)) return {0, across_, across_};
    const int away = static_cast<int>(blocks);
    return {place - away, 2 * away + 2, 2 * away + 1};
}

template <typename Visit>
void FoldIndex::each_label_block(int place, int LabelBlocks::*count, const Visit& visit) const {
    const LabelBlocks along_x = labels_of(place % across_);
    const LabelBlocks along_y = labels_of(place / across_);
    const int mask = across_ - 1;
    for (int j = 0; j < along_y.*count; ++j) {
        for (int i = 0; i < along_x.*count; ++i) {
            visit(((along_y.first + j) & mask) * across_ + ((along_x.first + i) & mask));
        }
    }
}

void FoldIndex::make(const SplineMap& map, std::span<const int> blocks, ThreadPool* pool) {
    if (choppiness_ == 0.0) {
        places_.make(blocks, nullptr,
                     [this](int block, int) { cells_[static_cast<std::size_t>(block)] = {}; });
        return;
    }
    TileSet labels(labels_.count());
    for (const int place : blocks) {
        each_label_block(place, &LabelBlocks::count, [&](int block) { labels.add(block); });
    }
    labels_.make(labels.list(), pool, [&](int block, int) { place_samples(map, block); });
    TileSet cells(labels_.count());
    for (const int place : blocks) {
        each_label_block(place, &LabelBlocks::cells, [&](int block) { cells.add(block); });
    }
    measured_.make(cells.list(), pool, [&](int block, int) { measure_cells(block); });
    places_.make(blocks, pool, [&](int block, int) { list_cells(block); });
}

template <typename Visit>
void FoldIndex::each_sample(int block, const Visit& visit) const {
    const int first_i = block % across_ * kBlock;
    const int first_j = block / across_ * kBlock;
    for (int j = first_j; j < first_j + kBlock; ++j) {
        for (int i = first_i; i < first_i + kBlock; ++i) visit(i, j);
    }
}

/// Computes the offsets and Jacobians of the samples of one block of labels.
void FoldIndex::place_samples(const SplineMap& map, int block) {
    const int step = map.lattice().resolution / lattice_.resolution;
    const auto c = static_cast<float>(choppiness_);
    each_sample(block, [&](int i, int j) {
        const SplineJet jet = map.jet_of_sample(i * step, j * step);
        const std::size_t at = sample_at(i, j);
        offset_[at] = {c * jet.value[0], c * jet.value[1]};
        jacobian_[at] = wave::single_precision::surface_jacobian(
            c, -jet.by_x[0], -jet.by_y[1], -0.5f * (jet.by_y[0] + jet.by_x[1]));
    });
}

/// Measures a block: the max span of its cells along an axis, and where the compressed ones are
/// displayed.
void FoldIndex::measure_cells(int block) {
    Measured& measured = cells_of_[static_cast<std::size_t>(block)];
    measured.widest = 0.0f;
    measured.squeezed.clear();
    each_sample(block, [&](int i, int j) {
        const std::size_t corners[] = {sample_at(i, j), sample_at(i + 1, j), sample_at(i, j + 1),
                                       sample_at(i + 1, j + 1)};
        const Offset first = offset_[corners[0]];
        float least = jacobian_[corners[0]];
        for (const std::size_t corner : corners) {
            const Offset other = offset_[corner];
            measured.widest = std::max(
                {measured.widest, std::abs(other.x - first.x), std::abs(other.y - first.y)});
            least = std::min(least, jacobian_[corner]);
        }
        if (least < kSqueezed) measured.squeezed.push_back(tiles_of(i, j));
    });
}

/// Returns the box of the first corner of a cell of a block of labels, if any part of the cell is
/// displayed in the tiles `tiles`.
FoldIndex::Box FoldIndex::corners_for(int place, const TileBounds& tiles, int labels) const {
    const double spacing = lattice_.period / lattice_.resolution;
    // A box is the span of the corners, each at most this far from the first, plus a margin.
    const double span =
        spacing + static_cast<double>(cells_of_[static_cast<std::size_t>(labels)].widest);
    const double around = (1.0 + 2.0 * kMargin) * span + kMargin * spacing;
    const auto along = [&](int place_block, int label_block, int first, int last) {
        const double low = (place_block * kBlockTiles + first) * kCellsPerTile * spacing;
        const double high = (place_block * kBlockTiles + last + 1) * kCellsPerTile * spacing;
        // The copy of these tiles that is nearest to the labels, for labels that do not span the
        // period.
        const double shift =
            lattice_.period *
            std::round((0.5 * (low + high) / spacing - (label_block + 0.5) * kBlock) /
                       lattice_.resolution);
        return Range{low - around - shift, high + around - shift};
    };
    return {along(place % across_, labels % across_, tiles.first_x, tiles.last_x),
            along(place / across_, labels / across_, tiles.first_y, tiles.last_y)};
}

/// Finds the tiles of a block of places in which squeezed cells are shown, and lists all cells that
/// are shown in these tiles.
void FoldIndex::list_cells(int block) {
    Cells& cells = cells_[static_cast<std::size_t>(block)];
    cells = {};
    std::array<char, kTilesOfBlock> squeezed{};
    TileBounds bounds;
    each_label_block(block, &LabelBlocks::cells, [&](int labels) {
        for (const TileRange& range : cells_of_[static_cast<std::size_t>(labels)].squeezed) {
            each_tile(range, block, [&](std::size_t tile) {
                squeezed[tile] = 1;
                bounds.add(static_cast<int>(tile));
            });
        }
    });
    if (bounds.empty()) return;

    struct Shown {
        std::uint32_t tile, cell;
    };
    std::vector<Shown> shown;
    constexpr std::size_t kMax = kMaxTilesPerCell * kBlock * kBlock;
    const double spacing = lattice_.period / lattice_.resolution;
    const bool all_round = labels_of(block % across_).count == across_;
    each_label_block(block, &LabelBlocks::cells, [&](int labels) {
        const Box near = all_round ? Box::everywhere() : corners_for(block, bounds, labels);
        each_sample(labels, [&](int i, int j) {
            const Offset offset = offset_[sample_at(i, j)];
            const double x = i * spacing + static_cast<double>(offset.x);
            const double y = j * spacing + static_cast<double>(offset.y);
            if (!near.x.holds(x) || !near.y.holds(y) || shown.size() > kMax) return;
            each_tile(tiles_of(i, j), block, [&](std::size_t tile) {
                if (squeezed[tile] == 0) return;
                shown.push_back({static_cast<std::uint32_t>(tile),
                                 static_cast<std::uint32_t>(sample_at(i, j))});
            });
        });
    });
    cells.hopeless = shown.size() > kMax;
    if (cells.hopeless) return;
    cells.begin.assign(kTilesOfBlock + 1, 0);
    for (const Shown& s : shown) ++cells.begin[s.tile + 1];
    for (std::size_t t = 0; t < kTilesOfBlock; ++t) cells.begin[t + 1] += cells.begin[t];
    cells.cell.resize(shown.size());
    std::vector<std::uint32_t> next(cells.begin.begin(), cells.begin.end() - 1);
    for (const Shown& s : shown) cells.cell[next[s.tile]++] = s.cell;
}

std::uint64_t FoldIndex::bytes(int resolution) {
    const std::uint64_t cells = Lattice{resolution, 1.0}.size();
    constexpr std::uint64_t listed = 4;  // a cell is shown in one to four tiles
    return cells * (sizeof(Offset) + sizeof(float) + listed * sizeof(std::uint32_t));
}

FoldIndex::Box FoldIndex::box_of(int i, int j) const {
    const double spacing = lattice_.period / lattice_.resolution;
    Box box;
    for (const int b : {j, j + 1}) {
        for (const int a : {i, i + 1}) {
            const Offset offset = offset_[sample_at(a, b)];
            box.x.add(a * spacing + static_cast<double>(offset.x));
            box.y.add(b * spacing + static_cast<double>(offset.y));
        }
    }
    box.x.widen(spacing);
    box.y.widen(spacing);
    return box;
}

FoldIndex::TileRange FoldIndex::tiles_of(int i, int j) const {
    const Box box = box_of(i, j);
    const auto tile = [&](double a) { return floor_index(a * tiles_ / lattice_.period); };
    const auto count = [&](long long first, long long last) {
        return static_cast<int>(std::min<long long>(last - first + 1, tiles_));
    };
    const long long first_x = tile(box.x.low);
    const long long first_y = tile(box.y.low);
    return {first_x, first_y, count(first_x, tile(box.x.high)), count(first_y, tile(box.y.high))};
}

/// Visits the tiles of a box in a block of points, numbered within it row by row.
template <typename Visit>
void FoldIndex::each_tile(const TileRange& range, int block, const Visit& visit) const {
    const long long mask = tiles_ - 1;
    const long long first_column = block % across_ * kBlockTiles;
    const long long first_row = block / across_ * kBlockTiles;
    for (int j = 0; j < range.count_y; ++j) {
        const long long row = ((range.first_y + j) & mask) - first_row;
        if (row < 0 || row >= kBlockTiles) continue;
        for (int i = 0; i < range.count_x; ++i) {
            const long long column = ((range.first_x + i) & mask) - first_column;
            if (column < 0 || column >= kBlockTiles) continue;
            visit(static_cast<std::size_t>(row * kBlockTiles + column));
        }
    }
}

WorldPoint FoldIndex::guess(WorldPoint place) const {
    WorldPoint label = place;
    for (int looks = 0; looks < kLooks; ++looks) label = look(place, label);
    return label;
}

bool FoldIndex::labels_near(double x, double y, std::vector<WorldPoint>& labels) const {
    labels.clear();
    const Cells& cells = cells_[static_cast<std::size_t>(block_of(x, y))];
    if (cells.hopeless) return false;
    if (cells.begin.empty()) return true;
    const double spacing = lattice_.period / lattice_.resolution;
    const std::size_t tile =
        tile_along(y) % kBlockTiles * kBlockTiles + tile_along(x) % kBlockTiles;
    for (std::uint32_t at = cells.begin[tile]; at < cells.begin[tile + 1]; ++at) {
        const int i = static_cast<int>(cells.cell[at]) & (lattice_.resolution - 1);
        const int j = static_cast<int>(cells.cell[at]) / lattice_.resolution;
        const Box box = box_of(i, j);
        // The copy of this cell that is shown nearest to the place.
        const double shift_x = lattice_.period * std::round((box.x.low - x) / lattice_.period);
        const double shift_y = lattice_.period * std::round((box.y.low - y) / lattice_.period);
        if (!box.x.holds(x + shift_x) || !box.y.holds(y + shift_y)) continue;
        labels.push_back({(i + 0.5) * spacing - shift_x, (j + 0.5) * spacing - shift_y});
    }
    return true;
}

}  // namespace ocean
