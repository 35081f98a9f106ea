// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Symmetric equations G x = b whose rows may depend on each other, as places near each other ask
// nearly the same of the waves. A row that follows from those before it is left out; it holds if
// the right-hand side agrees.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ocean {

/// A symmetric matrix of sums, row by row.
struct Gram {
    explicit Gram(std::size_t rows = 0) : size(rows), values(rows * rows) {}
    double& at(std::size_t i, std::size_t j) { return values[i * size + j]; }
    double at(std::size_t i, std::size_t j) const { return values[i * size + j]; }

    std::size_t size;
    std::vector<double> values;
};

/// The factors of a Gram matrix, scaled by its diagonal.
class DependentRows {
  public:
    explicit DependentRows(const Gram& gram);

    /// Returns x for the first rows alone; 0 for a row that depends on rows before it.
    /// right: as many numbers as there are rows to solve.
    std::vector<double> solve(std::span<const double> right) const;
    /// Returns right G^-1 right.
    double form(std::span<const double> right) const;
    bool is_dependent(std::size_t row) const { return lower_.at(row, row) == 0.0; }

  private:
    /// Returns the inverse of the lower factor times the scaled right-hand side.
    std::vector<double> forward(std::span<const double> right) const;

    Gram lower_;                 // of scale * G * scale
    std::vector<double> scale_;  // 1 / root of the diagonal; 0 for a row without variance
};

}  // namespace ocean
