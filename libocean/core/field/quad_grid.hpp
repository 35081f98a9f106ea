// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Four scalar maps of a coast side by side, read between their samples by Catmull and Rom's cubic,
// which passes through the samples and has continuous derivatives: surfaces made of such maps have
// continuous normals. Labels are read in blocks: their positions are found once for all maps of a
// domain, and labels of one row share the sums along y.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "field/cubic.hpp"
#include "field/jet.hpp"
#include "ocean/domain.hpp"

namespace ocean {

/// The number of labels that are read together.
inline constexpr std::size_t kShoreBlock = 64;
/// A number for each label of a block. Loops over it may run to a whole vector of 64 bytes.
using BlockFloats = std::array<float, kShoreBlock>;

/// The four fields at one place, with their derivatives [1/m].
struct QuadSample {
    Quad value{};
    Quad by_x{};
    Quad by_y{};
};

/// The four fields at the labels of a block.
struct QuadBlock {
    alignas(64) std::array<BlockFloats, 4> value{};
    alignas(64) std::array<BlockFloats, 4> by_x{};  // [1/m]
    alignas(64) std::array<BlockFloats, 4> by_y{};
};
template <typename Scalar>
Scalar field_at(const QuadBlock& block, std::size_t field, std::size_t label);
template <>
inline Jet field_at(const QuadBlock& block, std::size_t field, std::size_t label) {
    return {block.value[field][label], block.by_x[field][label], block.by_y[field][label]};
}
template <>
inline Plain field_at(const QuadBlock& block, std::size_t field, std::size_t label) {
    return block.value[field][label];
}

/// Multiplies a field of a label by a number.
inline void scale_field(QuadBlock& block, std::size_t field, std::size_t label, const Jet& by) {
    const Jet product = by * field_at<Jet>(block, field, label);
    block.value[field][label] = product.value();
    block.by_x[field][label] = product.by_x();
    block.by_y[field][label] = product.by_y();
}
inline void scale_field(QuadBlock& block, std::size_t field, std::size_t label, const Plain& by) {
    block.value[field][label] *= by.value();
}

/// The weights of four neighbouring samples at a place, and their derivatives [1/sample].
struct CubicWeights {
    std::array<float, 4> value;
    std::array<float, 4> slope;

    CubicWeights() = default;
    explicit CubicWeights(float t) : value(catmull_rom(t)), slope(catmull_rom_slopes(t)) {}
};

/// The positions of up to kShoreBlock labels among the samples of a domain.
class GridPlaces {
  public:
    /// Finds n labels [m]. The domain must not wrap.
    void find(const Domain& domain, std::size_t n, const double* x, const double* y);

  private:
    friend class QuadGrid;
    static constexpr int kColumns = 80;
    /// Consecutive labels of one row of labels, from west to east.
    struct Run {
        std::size_t last;  // label after the run
        int column;        // first column of its samples; may be beyond the border
        int columns;
        std::array<std::size_t, 4> row;  // index of the first sample of each row
        CubicWeights along_y;
    };
    struct Label {
        std::array<Quad, 4> weight;  // along x, each four times
        std::array<Quad, 4> slope;
        std::size_t column;  // column in the run
    };

    std::size_t count_ = 0;
    std::size_t runs_ = 0;
    std::array<Run, kShoreBlock> run_;
    std::array<Label, kShoreBlock> label_;
};

/// Row-major samples over a domain that does not wrap. Beyond its border the edge values continue.
/// Immutable; any thread may read it.
class QuadGrid {
  public:
    QuadGrid() = default;
    /// Takes up to four maps of domain.count() values each; missing ones are 0.
    QuadGrid(const Domain& domain, const std::array<std::span<const float>, 4>& fields);

    const Domain& domain() const { return domain_; }
    /// Returns the samples, row-major.
    std::span<const Quad> quads() const { return quads_; }
    std::size_t bytes() const { return quads_.size() * sizeof(Quad); }
    /// Returns the fields at a place [m].
    QuadSample read(double x, double y) const;
    /// Writes the fields at places that were found in this domain, and with `slopes` their
    /// derivatives. The values have the same bits with and without slopes.
    void read(const GridPlaces& places, bool slopes, QuadBlock& out) const;

  private:
    template <bool kSlopes>
    void read_places(const GridPlaces& places, QuadBlock& out) const;

    Domain domain_;
    double per_metre_ = 0.0;
    std::vector<Quad> quads_;
};

}  // namespace ocean
