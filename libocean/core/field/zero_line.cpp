// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Distances: see zero_line.hpp. The line crosses edges of the grid between two rows and between two
// columns. Crossings of the first kind lie on columns, so that their distance transform is
// separable although they do not lie on samples: the nearest crossing in each column, then the
// lower envelope of parabolas along each row [Felzenszwalb and Huttenlocher 2012]. Crossings of the
// second kind take the axes in the other order. The exact distance then follows from the line's
// parts at the nearest crossing.
#include "zero_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ocean {
namespace {

constexpr float kNoCrossing = std::numeric_limits<float>::infinity();
constexpr float kLeast = 1e-6f;  // min distance of land, to keep its sign [samples]
constexpr double kExact = 2.5;   // [samples]
constexpr int kExactReach = 3;   // squares to each side that contain all lines within kExact

struct Point {
    double x, y;
};

bool is_land(float value) {
    return value > 0.0f;
}

/// Returns the position of the zero between two samples of different sides, 0 .. 1.
double crossing(float from, float to) {
    return double{from} / (double{from} - double{to});
}

/// Writes the offset from each sample of a line to the nearest crossing in it, or kNoCrossing.
void offsets_in_line(const float* line, int length, float* offsets) {
    double place = -HUGE_VAL;
    for (int k = 0; k < length; ++k) {
        if (k > 0 && is_land(line[k - 1]) != is_land(line[k])) {
            place = k - 1 + crossing(line[k - 1], line[k]);
        }
        offsets[k] = static_cast<float>(place - k);
    }
    place = HUGE_VAL;
    for (int k = length - 1; k >= 0; --k) {
        if (k + 1 < length && is_land(line[k]) != is_land(line[k + 1])) {
            place = k + crossing(line[k], line[k + 1]);
        }
        const auto after = static_cast<float>(place - k);
        if (after < -offsets[k]) offsets[k] = after;
        if (std::isinf(offsets[k])) offsets[k] = kNoCrossing;
    }
}

/// The lower envelope of the parabolas (x - k)^2 + offsets[k]^2.
class Envelope {
  public:
    explicit Envelope(int length)
        : sites_(static_cast<std::size_t>(length)), begins_(static_cast<std::size_t>(length)) {}

    /// Calls use(k, site) for each sample of a line with the parabola that is lowest at k.
    template <typename Use>
    void visit(const float* offsets, int length, const Use& use) {
        int count = 0;
        const auto height = [&](int k) {
            return double{offsets[k]} * double{offsets[k]} + 1.0 * k * k;
        };
        for (int k = 0; k < length; ++k) {
            if (offsets[k] == kNoCrossing) continue;
            double begin = -HUGE_VAL;
            for (; count > 0; --count) {
                const int other = sites_[static_cast<std::size_t>(count - 1)];
                begin = (height(k) - height(other)) / (2.0 * (k - other));
                if (begin > begins_[static_cast<std::size_t>(count - 1)]) break;
                begin = -HUGE_VAL;
            }
            sites_[static_cast<std::size_t>(count)] = k;
            begins_[static_cast<std::size_t>(count)] = begin;
            ++count;
        }
        if (count == 0) return;
        for (int k = 0, n = 0; k < length; ++k) {
            while (n + 1 < count && begins_[static_cast<std::size_t>(n + 1)] < k) ++n;
            use(k, sites_[static_cast<std::size_t>(n)]);
        }
    }

  private:
    std::vector<int> sites_;
    std::vector<double> begins_;
};

/// Finds the nearest of all crossings that lie between samples along the lines `along`.
class CrossingSearch {
  public:
    CrossingSearch(std::span<const float> map, std::span<float> offsets, GridPasses& passes)
        : map_(map),
          offsets_(offsets),
          passes_(passes),
          floats_(passes.pool()),
          squares_(passes.pool()),
          indices_(passes.pool()) {}

    /// Lowers squared distances, and updates `nearest` with them. `on` are the lines on which the
    /// crossings lie, `other` the lines of the other axis. The first search overwrites all values.
    void search(const GridLines& on, const GridLines& other, bool first_search,
                std::span<float> squares, std::span<std::uint32_t> nearest) {
        passes_.run(on.count, [&](int first, int lanes, int thread) {
            const std::size_t size = buffer_size(on);
            float* const lines = floats_.of(thread, 2 * size);
            float* const found = lines + size;
            load_lines(map_.data(), on, first, lanes, lines);
            for (int l = 0; l < lanes; ++l) {
                offsets_in_line(lines + l * on.length, on.length, found + l * on.length);
            }
            store_lines(found, on, first, lanes, offsets_.data());
        });
        passes_.run(other.count, [&](int first, int lanes, int thread) {
            const std::size_t size = buffer_size(other);
            float* const offsets = floats_.of(thread, size);
            float* const lowest = squares_.of(thread, size);
            std::uint32_t* const indices = indices_.of(thread, size);
            load_lines(offsets_.data(), other, first, lanes, offsets);
            if (first_search) {
                std::fill(lowest, lowest + size, kNoCrossing);
            } else {
                load_lines(squares.data(), other, first, lanes, lowest);
                load_lines(nearest.data(), other, first, lanes, indices);
            }
            Envelope envelope(other.length);
            for (int l = 0; l < lanes; ++l) {
                const float* const line = offsets + l * other.length;
                float* const low = lowest + l * other.length;
                std::uint32_t* const index = indices + l * other.length;
                envelope.visit(line, other.length, [&](int k, int site) {
                    const double along = k - site, across = double{line[site]};
                    const auto square = static_cast<float>(along * along + across * across);
                    if (!(square < low[k])) return;
                    low[k] = square;
                    const int beside = static_cast<int>(first + l + across + 0.5);
                    index[k] = static_cast<std::uint32_t>(other.index(beside, site));
                });
            }
            store_lines(lowest, other, first, lanes, squares.data());
            store_lines(indices, other, first, lanes, nearest.data());
        });
    }

  private:
    static std::size_t buffer_size(const GridLines& lines) {
        return static_cast<std::size_t>(lines.length) * kGridLanes;
    }

    std::span<const float> map_;
    std::span<float> offsets_;
    GridPasses& passes_;
    LineBuffers<float> floats_, squares_;
    LineBuffers<std::uint32_t> indices_;
};

double squared_distance(Point p, Point a, Point b) {
    const double ux = b.x - a.x, uy = b.y - a.y, vx = p.x - a.x, vy = p.y - a.y;
    const double length = ux * ux + uy * uy;
    const double t = length > 0.0 ? std::clamp((ux * vx + uy * vy) / length, 0.0, 1.0) : 0.0;
    const double dx = vx - t * ux, dy = vy - t * uy;
    return dx * dx + dy * dy;
}

/// The parts of the zero line in squares of four samples.
class LineParts {
  public:
    LineParts(std::span<const float> map, const SampleGrid& grid) : map_(map), grid_(grid) {}

    /// Returns the smaller of `least` and the squared distance of the point (0, 0) to the line in
    /// the square (i, j) .. (i + 1, j + 1), whose first sample lies at `at`.
    double nearer(int i, int j, Point at, double least) const {
        if (i < 0 || j < 0 || i + 1 >= grid_.columns || j + 1 >= grid_.rows) return least;
        const float* const low = &map_[grid_.index(i, j)];
        const float* const high = low + grid_.columns;
        const float value[4] = {low[0], low[1], high[1], high[0]};  // around the square
        const int land[4] = {is_land(value[0]), is_land(value[1]), is_land(value[2]),
                             is_land(value[3])};
        const int sum = land[0] + land[1] + land[2] + land[3];
        if (sum == 0 || sum == 4) return least;
        // Edge e goes from corner e to the next one.
        const auto crossing_of = [&](int e) {
            const double t =
                e < 2 ? crossing(value[e], value[e + 1]) : crossing(value[(e + 1) % 4], value[e]);
            const bool along_x = e % 2 == 0;
            return Point{at.x + (along_x ? t : (e == 1 ? 1.0 : 0.0)),
                         at.y + (along_x ? (e == 2 ? 1.0 : 0.0) : t)};
        };
        const auto part = [&](int from, int to) {
            least =
                std::min(least, squared_distance({0.0, 0.0}, crossing_of(from), crossing_of(to)));
        };
        if (sum == 2 && land[0] == land[2]) {
            const int sea = land[0] != 0 ? 1 : 0;  // corner to cut off, with the opposite one
            part((sea + 3) % 4, sea);
            part(sea + 1, sea + 2);
            return least;
        }
        int edges[2] = {};
        for (int e = 0, found = 0; e < 4; ++e) {
            if (land[e] != land[(e + 1) % 4]) edges[found++] = e;
        }
        part(edges[0], edges[1]);
        return least;
    }

  private:
    std::span<const float> map_;
    SampleGrid grid_;
};

}  // namespace

void zero_line_distance(std::span<const float> map, const SampleGrid& grid,
                        std::span<float> offsets, std::span<float> distance,
                        std::span<std::uint32_t> nearest, GridPasses& passes) {
    const GridLines rows = GridLines::rows(grid), columns = GridLines::columns(grid);
    CrossingSearch crossings(map, offsets, passes);
    crossings.search(columns, rows, true, distance, nearest);
    crossings.search(rows, columns, false, distance, nearest);
    const LineParts parts(map, grid);
    passes.run(grid.rows, [&](int first, int lanes, int) {
        for (int j = first; j < first + lanes; ++j) {
            for (int i = 0; i < grid.columns; ++i) {
                const std::size_t at = grid.index(i, j);
                const int shore_i =
                    static_cast<int>(nearest[at] % static_cast<unsigned>(grid.columns));
                const int shore_j =
                    static_cast<int>(nearest[at] / static_cast<unsigned>(grid.columns));
                double least = double{distance[at]};
                const auto look = [&](int x, int y) {
                    least = parts.nearer(x, y, {1.0 * (x - i), 1.0 * (y - j)}, least);
                };
                if (least < kExact * kExact) {
                    for (int y = j - kExactReach; y < j + kExactReach; ++y) {
                        for (int x = i - kExactReach; x < i + kExactReach; ++x) look(x, y);
                    }
                } else {
                    for (int y = shore_j - 1; y <= shore_j; ++y) {
                        for (int x = shore_i - 1; x <= shore_i; ++x) look(x, y);
                    }
                }
                const auto length = static_cast<float>(std::sqrt(least));
                distance[at] = is_land(map[at]) ? std::max(length, kLeast) : -length;
            }
        }
    });
}

}  // namespace ocean
