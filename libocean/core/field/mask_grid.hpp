// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A mask on a grid, read linearly between its samples, so that it keeps its range.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include "field/bilinear.hpp"
#include "ocean/domain.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

class MaskGrid {
  public:
    using Values = std::shared_ptr<const PageVector<float>>;

    /// values: row-major, one for each sample of a domain that exists once.
    MaskGrid(const Domain& domain, Values values) : domain_(domain), values_(std::move(values)) {}

    /// Returns the value at a place; beyond the domain, the value of its edge.
    float at(double x, double y) const {
        const auto [i, u] = place(x, 0);
        const auto [j, v] = place(y, 1);
        const auto columns = static_cast<std::size_t>(domain_.samples[0]);
        const float* const low = values_->data() + j * columns + i;
        const float* const high = low + columns;
        return static_cast<float>(bilinear(low[0], low[1], high[0], high[1], u, v));
    }
    std::size_t bytes() const { return sizeof(float) * values_->size(); }

  private:
    /// Returns the sample before a coordinate, and the share of the step to the next sample.
    std::pair<std::size_t, double> place(double at, std::size_t axis) const {
        const double last = domain_.samples[axis] - 1;
        const double u = std::clamp((at - domain_.origin[axis]) / domain_.step(axis), 0.0, last);
        const double i = std::min(std::floor(u), last - 1.0);
        return {static_cast<std::size_t>(i), u - i};
    }

    Domain domain_;
    Values values_;
};

}  // namespace ocean
