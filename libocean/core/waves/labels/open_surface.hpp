// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Waves that no bed has changed, at any label: the periodic maps of some modes, read by cubic
// splines that are fine enough for a stated error.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>

#include "field/jet.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/internal/wave_sum.hpp"
#include "waves/query/spline_map.hpp"
#include "waves/query/spline_strips.hpp"

namespace ocean {

class ThreadPool;

/// Height and horizontal displacement D of linear waves at one label; a point is displayed at its
/// label minus choppiness times D.
template <typename Scalar>
struct LinearWaves {
    Scalar height;          // [m]
    Scalar displacement_x;  // [m]
    Scalar displacement_y;
};

/// Returns the waves of a sum over modes at one label. Scalar: Jet, or Plain without derivatives.
template <typename Scalar>
LinearWaves<Scalar> waves_of(const LinearSample& at) {
    const auto scalar = [](double value, double by_x, double by_y, double by_t) {
        if constexpr (std::is_same_v<Scalar, Jet>) {
            return Jet(static_cast<float>(value), static_cast<float>(by_x),
                       static_cast<float>(by_y), static_cast<float>(by_t));
        } else {
            return Plain(static_cast<float>(value));
        }
    };
    return {scalar(at.height, at.slope_x, at.slope_y, at.height_rate),
            scalar(at.displacement_x, at.gradient_xx, at.gradient_xy, at.displacement_x_rate),
            scalar(at.displacement_y, at.gradient_xy, at.gradient_yy, at.displacement_y_rate)};
}

class OpenSurface {
  public:
    /// Chooses the smallest spline that shows the waves of a map of `shown` samples with an rms
    /// error of heights of at most `tolerance` [m], but with at most 4096 samples and at most twice
    /// the map's: see height_error().
    OpenSurface(const Modes& modes, int shown, double tolerance, ThreadPool& pool);
    /// Shows amplitudes that the caller writes to packed(), times the factor(), by a spline of
    /// twice as many samples as the map. The modes give their lattice.
    OpenSurface(const Modes& modes, int shown, ThreadPool& pool);

    /// Returns the factor that turns the amplitude of a mode into one of the spline.
    ModeFactor factor(const Modes& modes) const;
    /// Returns the modes that the next time shows, if the caller writes them.
    PackedModes& packed() { return maps_->strips.packed(); }

    /// Begins a time, unless it has begun; makes no map. `modes` must be the constructor's modes.
    /// rates: reads have derivatives in time.
    void move_to(const Modes& modes, double time, bool rates, ThreadPool& pool);
    /// Ends the time that has begun; its memory stays.
    void forget() { has_begun_ = false; }
    /// Makes the strips for reads at x from `first` to `last` [m], on all threads. Other reads make
    /// their strips on the calling thread.
    void prepare(double first, double last, ThreadPool& pool) const;

    /// Returns the waves at a label [m]. Scalar: Jet, or Plain without derivatives. Several threads
    /// may read at once. Throws Error invalid_value if no time has begun.
    template <typename Scalar>
    LinearWaves<Scalar> read(double x, double y) const;
    /// Reads the waves along lines of one y each. prepare() must have made the strips there.
    class Lines;
    /// Returns the rms error of heights [m]: aliases of the shortest waves.
    double height_error() const { return height_error_; }

  private:
    /// The maps are large, and regions without foam need none: they are made when a time begins.
    struct Maps {
        Maps(const Modes& modes, Lattice lattice, const ModeFactor& factor, ThreadPool& pool)
            : strips(modes, lattice.resolution, factor, pool), position(lattice, pool) {}

        SplineStrips strips;
        SplineMap position;
        std::optional<SplineMap> velocity;
    };
    struct Place {
        double x, y;  // within the period
    };
    /// Returns the label's position within the period, and makes its strips.
    Place place(double x, double y) const;

    int shown_;
    int samples_;
    double period_;
    double height_error_ = 0.0;
    std::unique_ptr<Maps> maps_;
    bool has_begun_ = false;
    bool rates_ = false;
};

/// Reads at places x that all lines share and that only grow. The surface must live longer, at the
/// same time.
class OpenSurface::Lines {
  public:
    /// x, and each y, must lie within half a period of 0.
    Lines(const OpenSurface& surface, std::span<const double> x)
        : surface_(surface), places_({surface.samples_, surface.period_}, x) {}

    /// Writes the waves at places of a line, from place `first` on.
    void read(double y, std::size_t first, std::span<LinearWaves<Jet>> waves) const;

  private:
    const OpenSurface& surface_;
    SplineMap::Lines places_;
};

template <>
LinearWaves<Jet> OpenSurface::read(double x, double y) const;
template <>
LinearWaves<Plain> OpenSurface::read(double x, double y) const;

}  // namespace ocean
