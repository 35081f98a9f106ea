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
      patches_(resolution / kPatch),
      labels_(patches_ * patches_),
      measured_(patches_ * patches_),
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

FoldIndex::CellRange FoldIndex::labels_of(int place) const {
    const double reach = reach_ / lattice_.period * lattice_.resolution;
    const double blocks = std::ceil((reach + 1.0) / kBlock);
    if (!(2.0 * blocks + 2.0 < across_)) return {0, lattice_.resolution};
    // The corners of a cell lie within reach, so its box spans at most twice the reach and a cell.
    const double box = reach + 1.0 + kMargin * (2.0 * reach + 2.0);
    const int away = static_cast<int>(std::min(std::ceil(box / kPatch) * kPatch, blocks * kBlock));
    return {place * kBlock - away, (place + 1) * kBlock + away};
}

template <typename Visit>
void FoldIndex::each_square(const CellBox& box, int size, const Visit& visit) const {
    const CellRange columns = box.x.in_squares(size);
    const CellRange rows = box.y.in_squares(size);
    const int mask = lattice_.resolution / size - 1;
    for (int j = rows.first; j < rows.end; ++j) {
        for (int i = columns.first; i < columns.end; ++i) {
            visit(i & mask, j & mask,
                  CellBox{box.x.within(i * size, (i + 1) * size),
                          box.y.within(j * size, (j + 1) * size)});
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
    TileSet cells(measured_.count());
    for (const int place : blocks) {
        const CellBox shown = labels_around(place);
        each_square(shown.with_corners(), kPatch,
                    [&](int i, int j, const CellBox&) { labels.add(j * patches_ + i); });
        each_square(shown, kPatch,
                    [&](int i, int j, const CellBox&) { cells.add(j * patches_ + i); });
    }
    labels_.make(labels.list(), pool, [&](int patch, int) { place_samples(map, patch); });
    measured_.make(cells.list(), pool, [&](int patch, int) { measure_cells(patch); });
    places_.make(blocks, pool, [&](int block, int) { list_cells(block); });
}

template <typename Visit>
void FoldIndex::each_sample(const CellBox& box, const Visit& visit) {
    for (int j = box.y.first; j < box.y.end; ++j) {
        for (int i = box.x.first; i < box.x.end; ++i) visit(i, j);
    }
}

/// Computes the offsets and Jacobians of the samples of one patch, which ends at the first corner
/// of the patch of cells of its number: the cells of a box need few samples beyond it.
void FoldIndex::place_samples(const SplineMap& map, int patch) {
    const int step = map.lattice().resolution / lattice_.resolution;
    const auto c = static_cast<float>(choppiness_);
    each_sample(square_at(patch, kFirstSample), [&](int i, int j) {
        const SplineJet jet = map.jet_of_sample(i * step, j * step);
        const std::size_t at = sample_at(i, j);
        offset_[at] = {c * jet.value[0], c * jet.value[1]};
        jacobian_[at] = wave::single_precision::surface_jacobian(
            c, -jet.by_x[0], -jet.by_y[1], -0.5f * (jet.by_y[0] + jet.by_x[1]));
    });
}

/// Measures a patch: the max span of its cells along an axis, and where the compressed ones are
/// displayed.
void FoldIndex::measure_cells(int patch) {
    Measured& measured = cells_of_[static_cast<std::size_t>(patch)];
    measured.widest = 0.0f;
    measured.squeezed.clear();
    each_sample(square_at(patch, 0), [&](int i, int j) {
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

/// Returns the box of the first corners of the cells of which any part may be displayed in the
/// tiles `tiles` of a block of points. widest: max span of these cells beyond their spacing [m].
FoldIndex::Box FoldIndex::corners_for(int block, const TileBounds& tiles, float widest) const {
    const double spacing = lattice_.period / lattice_.resolution;
    // A box is the span of the corners, each at most this far from the first, plus a margin.
    const double span = spacing + static_cast<double>(widest);
    const double around = (1.0 + 2.0 * kMargin) * span + kMargin * spacing;
    const auto along = [&](int place, int first, int last) {
        const double low = (place * kBlockTiles + first) * kCellsPerTile * spacing;
        const double high = (place * kBlockTiles + last + 1) * kCellsPerTile * spacing;
        return Range{low - around, high + around};
    };
    return {along(block % across_, tiles.first_x, tiles.last_x),
            along(block / across_, tiles.first_y, tiles.last_y)};
}

/// Finds the tiles of a block of places in which squeezed cells are shown, and lists all cells that
/// are shown in these tiles.
void FoldIndex::list_cells(int block) {
    Cells& cells = cells_[static_cast<std::size_t>(block)];
    cells = {};
    std::array<char, kTilesOfBlock> squeezed{};
    TileBounds bounds;
    const CellBox labels = labels_around(block);
    float widest = 0.0f;
    each_square(labels, kPatch, [&](int i, int j, const CellBox&) {
        const Measured& measured = cells_of_[static_cast<std::size_t>(j * patches_ + i)];
        widest = std::max(widest, measured.widest);
        for (const TileRange& range : measured.squeezed) {
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
    // Labels all round the period may be displayed in a copy of the block.
    const Box near =
        is_all_round(labels.x) ? Box::everywhere() : corners_for(block, bounds, widest);
    const int mask = lattice_.resolution - 1;
    each_square(labels, kBlock, [&](int, int, const CellBox& part) {
        each_sample(part, [&](int i, int j) {
            const std::size_t cell = sample_at(i, j);
            const double x = i * spacing + static_cast<double>(offset_[cell].x);
            const double y = j * spacing + static_cast<double>(offset_[cell].y);
            if (!near.x.holds(x) || !near.y.holds(y) || shown.size() > kMax) return;
            each_tile(tiles_of(i & mask, j & mask), block, [&](std::size_t tile) {
                if (squeezed[tile] == 0) return;
                shown.push_back(
                    {static_cast<std::uint32_t>(tile), static_cast<std::uint32_t>(cell)});
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
    return cells * (sizeof(Offset) + sizeof(float) + listed * sizeof(std::uint32_t)) +
           cells / (kPatch * kPatch) * sizeof(Measured);
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
