// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The index of folds; see query_folds.hpp.
#include "query/query_folds.hpp"

#include <algorithm>
#include <cmath>

#include "base/wave.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

constexpr int kCellsPerTile = 4;  // along each axis
/// A cell is squeezed if a corner's Jacobian is below this: it may be less within the cell.
constexpr float kSqueezed = 0.25f;
/// Cells are shown in one to four tiles; where they are in sixteen on average, neighbouring labels
/// lie tens of cells apart and there is no surface left to search.
constexpr std::uint64_t kMaxTilesPerCell = 16;

}  // namespace

FoldIndex::FoldIndex(const SplineMap& map, double choppiness, int resolution, ThreadPool& pool)
    : lattice_{resolution, map.lattice().period}, tiles_(resolution / kCellsPerTile) {
    if (choppiness == 0.0) return;
    const std::vector<float> jacobian = place_samples(map, choppiness, pool);
    float largest = 0.0f;
    for (const Offset& o : offset_) largest = std::max(largest, o.x * o.x + o.y * o.y);
    reach_ = 1.1 * std::sqrt(static_cast<double>(largest));
    const bool folds = *std::min_element(jacobian.begin(), jacobian.end()) < kSqueezed;
    if (folds) index_cells(jacobian);
    if (begin_.empty()) std::vector<Offset>().swap(offset_);
}

/// Fills offset_; the result is the Jacobian of each sample.
std::vector<float> FoldIndex::place_samples(const SplineMap& map, double choppiness,
                                            ThreadPool& pool) {
    offset_.resize(lattice_.size());
    std::vector<float> jacobian(lattice_.size());
    const double spacing = lattice_.period / lattice_.resolution;
    const auto c = static_cast<float>(choppiness);
    pool.for_each_range(lattice_.resolution, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            for (int i = 0; i < lattice_.resolution; ++i) {
                const SplineJet jet = map.jet(i * spacing, j * spacing);
                const std::size_t at = sample_at(i, j);
                offset_[at] = {c * jet.value[0], c * jet.value[1]};
                jacobian[at] = wave::single_precision::surface_jacobian(
                    c, -jet.by_x[0], -jet.by_y[1], -0.5f * (jet.by_y[0] + jet.by_x[1]));
            }
        }
    });
    return jacobian;
}

void FoldIndex::index_cells(const std::vector<float>& jacobian) {
    const int n = lattice_.resolution;
    std::uint64_t area = 0;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const TileRange range = tiles_of(i, j);
            area += static_cast<std::uint64_t>(range.count_x) *
                    static_cast<std::uint64_t>(range.count_y);
        }
    }
    hopeless_ = area > kMaxTilesPerCell * lattice_.size();
    if (hopeless_) return;

    const Lattice tiles{tiles_, lattice_.period};
    std::vector<char> squeezed(tiles.size(), 0);
    begin_.assign(tiles.size() + 1, 0);
    const auto each_cell = [&](const auto& visit) {
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) visit(i, j, tiles_of(i, j));
        }
    };
    each_cell([&](int i, int j, const TileRange& range) {
        const float least =
            std::min({jacobian[sample_at(i, j)], jacobian[sample_at(i + 1, j)],
                      jacobian[sample_at(i, j + 1)], jacobian[sample_at(i + 1, j + 1)]});
        if (least >= kSqueezed) return;
        each_tile(range, [&](std::size_t tile) { squeezed[tile] = 1; });
    });
    each_cell([&](int, int, const TileRange& range) {
        each_tile(range, [&](std::size_t tile) { begin_[tile + 1] += squeezed[tile] != 0; });
    });
    for (std::size_t t = 0; t + 1 < begin_.size(); ++t) begin_[t + 1] += begin_[t];
    cells_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    each_cell([&](int i, int j, const TileRange& range) {
        each_tile(range, [&](std::size_t tile) {
            if (squeezed[tile] == 0) return;
            cells_[next[tile]++] = static_cast<std::uint32_t>(sample_at(i, j));
        });
    });
}

std::uint64_t FoldIndex::bytes(int resolution) {
    const std::uint64_t cells = Lattice{resolution, 1.0}.size();
    constexpr std::uint64_t listed = 4;  // a cell is shown in one to four tiles
    return cells * (sizeof(Offset) + sizeof(float) + listed * sizeof(std::uint32_t));
}

std::size_t FoldIndex::sample_at(int i, int j) const {
    const int mask = lattice_.resolution - 1;
    return static_cast<std::size_t>(j & mask) * static_cast<std::size_t>(lattice_.resolution) +
           static_cast<std::size_t>(i & mask);
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
    const auto tile = [&](double a) {
        return static_cast<long long>(std::floor(a * tiles_ / lattice_.period));
    };
    const auto count = [&](long long first, long long last) {
        return static_cast<int>(std::min<long long>(last - first + 1, tiles_));
    };
    const long long first_x = tile(box.x.low);
    const long long first_y = tile(box.y.low);
    return {first_x, first_y, count(first_x, tile(box.x.high)), count(first_y, tile(box.y.high))};
}

template <typename Visit>
void FoldIndex::each_tile(const TileRange& range, const Visit& visit) const {
    const long long mask = tiles_ - 1;
    for (int j = 0; j < range.count_y; ++j) {
        const auto row = static_cast<std::size_t>((range.first_y + j) & mask);
        for (int i = 0; i < range.count_x; ++i) {
            visit(row * static_cast<std::size_t>(tiles_) +
                  static_cast<std::size_t>((range.first_x + i) & mask));
        }
    }
}

std::size_t FoldIndex::tile_at(double x, double y) const {
    const double per_metre = tiles_ / lattice_.period;
    const auto along = [&](double a) {
        return static_cast<std::size_t>(std::min(static_cast<int>(a * per_metre), tiles_ - 1));
    };
    return along(y) * static_cast<std::size_t>(tiles_) + along(x);
}

void FoldIndex::labels_near(double x, double y, std::vector<WorldPoint>& labels) const {
    labels.clear();
    if (begin_.empty()) return;
    const double spacing = lattice_.period / lattice_.resolution;
    const std::size_t tile = tile_at(x, y);
    for (std::uint32_t at = begin_[tile]; at < begin_[tile + 1]; ++at) {
        const int i = static_cast<int>(cells_[at]) & (lattice_.resolution - 1);
        const int j = static_cast<int>(cells_[at]) / lattice_.resolution;
        const Box box = box_of(i, j);
        // The copy of this cell that is shown nearest to the place.
        const double shift_x = lattice_.period * std::round((box.x.low - x) / lattice_.period);
        const double shift_y = lattice_.period * std::round((box.y.low - y) / lattice_.period);
        if (!box.x.holds(x + shift_x) || !box.y.holds(y + shift_y)) continue;
        labels.push_back({(i + 0.5) * spacing - shift_x, (j + 0.5) * spacing - shift_y});
    }
}

}  // namespace ocean
