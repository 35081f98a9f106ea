// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "field/quad_grid.hpp"

#include <algorithm>

namespace ocean {
namespace {

/// The cell of a domain that contains a place, along one axis.
struct Cell {
    int first;  // the sample before the place
    float fraction;

    Cell(double place, int samples) {
        const double inside = std::clamp(place, 0.0, static_cast<double>(samples - 1));
        first = std::min(static_cast<int>(inside), std::max(samples - 2, 0));
        fraction = static_cast<float>(inside - first);
    }
};

Quad four_times(float x) {
    return Quad{x, x, x, x};
}

/// Returns the index of the first sample of a row; beyond the border, of the border row.
std::size_t row_index(const Domain& domain, int row) {
    return static_cast<std::size_t>(std::clamp(row, 0, domain.samples[1] - 1)) *
           static_cast<std::size_t>(domain.samples[0]);
}

/// Returns the sum of four quads with weights, which are numbers or quads.
template <typename Weights>
Quad weighed(const Weights& w, const Quad* quads) {
    return w[0] * quads[0] + w[1] * quads[1] + w[2] * quads[2] + w[3] * quads[3];
}

/// Writes the four components of each quad to an array of its own.
void transpose(const std::array<Quad, kShoreBlock>& quads, std::size_t count,
               std::array<BlockFloats, 4>& out) {
    for (std::size_t l = 0; l < count; l += 4) {
        const Quad a = quads[l], b = quads[l + 1], c = quads[l + 2], d = quads[l + 3];
        const Quad ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
        const Quad ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
        const Quad cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
        const Quad cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
        const auto store = [&](std::size_t field, Quad four) {
            __builtin_memcpy(out[field].data() + l, &four, sizeof(four));
        };
        store(0, __builtin_shufflevector(ab, cd, 0, 1, 4, 5));
        store(1, __builtin_shufflevector(ab, cd, 2, 3, 6, 7));
        store(2, __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5));
        store(3, __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7));
    }
}

}  // namespace

void GridPlaces::find(const Domain& domain, std::size_t n, const double* x, const double* y) {
    const double per_metre = 1.0 / domain.step(0);
    count_ = n;
    runs_ = 0;
    int before = 0;
    for (std::size_t l = 0; l < n; ++l) {
        const Cell column((x[l] - domain.origin[0]) * per_metre, domain.samples[0]);
        // A gap longer than the four samples of a label ends the run.
        Run* run = runs_ > 0 ? &run_[runs_ - 1] : nullptr;
        const bool goes_on = run != nullptr && y[l] == y[l - 1] && column.first >= before &&
                             column.first <= before + 4 &&
                             column.first + 3 - run->column <= kColumns;
        if (!goes_on) {
            run = &run_[runs_++];
            run->column = column.first - 1;
            const Cell row((y[l] - domain.origin[1]) * per_metre, domain.samples[1]);
            run->along_y = CubicWeights(row.fraction);
            for (int a = 0; a < 4; ++a) {
                run->row[static_cast<std::size_t>(a)] = row_index(domain, row.first + a - 1);
            }
        }
        before = column.first;
        run->last = l + 1;
        run->columns = column.first + 3 - run->column;
        Label& label = label_[l];
        label.column = static_cast<std::size_t>(column.first - 1 - run->column);
        const CubicWeights weights(column.fraction);
        for (std::size_t a = 0; a < 4; ++a) {
            label.weight[a] = four_times(weights.value[a]);
            label.slope[a] = four_times(weights.slope[a]);
        }
    }
}

QuadGrid::QuadGrid(const Domain& domain, const std::array<std::span<const float>, 4>& fields)
    : domain_(domain), per_metre_(1.0 / domain.step(0)), quads_(domain.count()) {
    for (std::size_t i = 0; i < quads_.size(); ++i) {
        Quad quad{};
        for (std::size_t field = 0; field < 4; ++field) {
            if (!fields[field].empty()) quad[static_cast<int>(field)] = fields[field][i];
        }
        quads_[i] = quad;
    }
}

QuadSample QuadGrid::read(double x, double y) const {
    const Cell column((x - domain_.origin[0]) * per_metre_, domain_.samples[0]);
    const Cell row((y - domain_.origin[1]) * per_metre_, domain_.samples[1]);
    const CubicWeights along_x(column.fraction);
    const CubicWeights along_y(row.fraction);
    const auto per_metre = static_cast<float>(per_metre_);
    std::array<const Quad*, 4> rows;
    for (int a = 0; a < 4; ++a) {
        rows[static_cast<std::size_t>(a)] = quads_.data() + row_index(domain_, row.first + a - 1);
    }
    std::array<Quad, 4> sum, slope;
    for (int a = 0; a < 4; ++a) {
        const auto i = static_cast<std::size_t>(a);
        const auto at =
            static_cast<std::size_t>(std::clamp(column.first + a - 1, 0, domain_.samples[0] - 1));
        const std::array<Quad, 4> quads = {rows[0][at], rows[1][at], rows[2][at], rows[3][at]};
        sum[i] = weighed(along_y.value, quads.data());
        slope[i] = per_metre * weighed(along_y.slope, quads.data());
    }
    return {weighed(along_x.value, sum.data()), per_metre * weighed(along_x.slope, sum.data()),
            weighed(along_x.value, slope.data())};
}

void QuadGrid::read(const GridPlaces& places, bool slopes, QuadBlock& out) const {
    slopes ? read_places<true>(places, out) : read_places<false>(places, out);
}

template <bool kSlopes>
void QuadGrid::read_places(const GridPlaces& places, QuadBlock& out) const {
    // The sums along y for the columns of a run.
    std::array<Quad, GridPlaces::kColumns> sum, slope;
    std::array<Quad, kShoreBlock> value, by_x, by_y;
    const auto per_metre = static_cast<float>(per_metre_);
    const int last_sample = domain_.samples[0] - 1;
    std::size_t l = 0;
    for (std::size_t r = 0; r < places.runs_; ++r) {
        const GridPlaces::Run& run = places.run_[r];
        for (int c = 0; c < run.columns; ++c) {
            const auto at = static_cast<std::size_t>(std::clamp(run.column + c, 0, last_sample));
            const std::array<Quad, 4> quads = {quads_[run.row[0] + at], quads_[run.row[1] + at],
                                               quads_[run.row[2] + at], quads_[run.row[3] + at]};
            const auto to = static_cast<std::size_t>(c);
            sum[to] = weighed(run.along_y.value, quads.data());
            if constexpr (kSlopes) {
                slope[to] = per_metre * weighed(run.along_y.slope, quads.data());
            }
        }
        for (; l < run.last; ++l) {
            const GridPlaces::Label& label = places.label_[l];
            const Quad* const sums = sum.data() + label.column;
            value[l] = weighed(label.weight, sums);
            if constexpr (kSlopes) {
                by_x[l] = per_metre * weighed(label.slope, sums);
                by_y[l] = weighed(label.weight, slope.data() + label.column);
            }
        }
    }
    // Completes the last vector of labels.
    for (; l % 4 != 0; ++l) value[l] = by_x[l] = by_y[l] = Quad{};
    transpose(value, l, out.value);
    if constexpr (kSlopes) {
        transpose(by_x, l, out.by_x);
        transpose(by_y, l, out.by_y);
    }
}

}  // namespace ocean
