// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface of an open sea with hulls, a pure function of label and time: the open sea's waves,
// the waves that they bind if the sea is of second order, and the wakes add up at each label, and
// normal, Jacobian and whitecaps follow from the sums. Wakes bind no waves.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hulls/wake.hpp"
#include "ocean/domain.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/internal/wave_sum.hpp"
#include "ocean/parameters.hpp"
#include "ocean/query.hpp"
#include "waves/labels/label_point.hpp"
#include "waves/labels/open_surface.hpp"
#include "waves/query/bound_splines.hpp"

namespace ocean {

class ThreadPool;

class HullSurface {
  public:
    /// `shown`: samples of the sea's map whose waves count. height: significant wave height of the
    /// open sea [m], to which the error of its spline is relative. Keeps no reference to its
    /// arguments.
    HullSurface(const Parameters& parameters, int shown, double height, ThreadPool& pool);

    /// Takes other tracks of the same hulls: see Wake::follow(). Returns false if a wake must be
    /// made anew; the object is of no use then.
    bool follow(const Parameters& parameters);
    /// Takes another open sea of the same map. height: as in the constructor.
    void renew_open_sea(double height);

    /// Begins a time [s], unless it has begun. `modes` must be the same each time.
    void move_to(const Modes& modes, double time, bool rates, ThreadPool& pool);
    /// Begins a time for read_wake() alone.
    void move_wakes_to(double time, bool rates, ThreadPool& pool);
    /// Makes the maps for labels between x = `first` and `last` [m], on all threads.
    void prepare(double first, double last, ThreadPool& pool) const;
    /// Makes the sums over all waves for read(..., exact). The time must have begun with rates.
    void prepare_sums(const Modes& modes, ThreadPool& pool);

    /// Writes the surface at each label. Several threads may read at once. exact: sums all waves.
    void read(std::span<const WorldPoint> labels, std::span<LabelPoint> points,
              bool exact = false) const;

    /// Writes a wake at no more than RegionPiece::kSize samples of row j, from sample `first` on.
    void read_wake(const Wake::Rows& rows, int j, std::size_t first,
                   std::span<LabelPoint> points) const;

    double time() const { return time_; }
    /// Returns the max distance between a label and the point where it is displayed [m].
    double reach() const { return reach_; }
    /// Returns the rms error of heights by the open sea's spline [m].
    double height_error() const { return open_->height_error(); }
    std::span<const std::unique_ptr<Wake>> wakes() const { return wakes_; }

  private:
    LabelPoint displayed(const LinearWaves<Jet>& waves) const;
    LinearWaves<Jet> waves_at(double x, double y, bool exact) const;

    struct Begun {
        double time;
        bool rates;

        bool serves(double at, bool with_rates) const {
            return at == time && (rates || !with_rates);
        }
    };

    Water water_;
    double choppiness_;
    int shown_;
    double height_;
    double open_reach_ = 0.0;
    std::optional<OpenSurface> open_;
    BoundSplines bound_;
    std::vector<std::unique_ptr<Wake>> wakes_;
    double reach_ = 0.0;
    double time_ = 0.0;
    std::optional<Begun> begun_;
    std::optional<Begun> wakes_begun_;
    std::optional<WaveSum> sum_;
    double sum_time_ = 0.0;
};

}  // namespace ocean
