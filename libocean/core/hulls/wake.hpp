// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The wake of one hull at one time: a layer of linear waves over the square around the hull, which
// does not wrap. Its height, displacement and rates are added to the open sea's at the same label.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "field/jet.hpp"
#include "hulls/track_path.hpp"
#include "hulls/wake_lattice.hpp"
#include "hulls/wake_nodes.hpp"
#include "hulls/wake_turns.hpp"
#include "ocean/domain.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/internal/wave_sum.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/parameters.hpp"
#include "ocean/query.hpp"
#include "waves/labels/open_surface.hpp"

namespace ocean {

class ThreadPool;

/// The share of the waves that the rim leaves along one axis.
struct RimFactor {
    double value;
    double slope;  // [1/m]
};

class Wake {
  public:
    /// The hull must be valid. loop_period: of the sea.
    Wake(const Hull& hull, const Water& water, double loop_period, ThreadPool& pool);

    /// Takes another track of the hull, and keeps the sums over the past that both tracks share, as
    /// when rows are appended to a track. The bits are those of a new wake. Returns false, and
    /// changes nothing, if its speeds call for another square.
    bool follow(const Hull& hull, const Water& water);

    /// Computes the waves of a time [s]. rates: reads have derivatives in time. The bits depend on
    /// the time alone, not on earlier times, and are the same for any number of threads. Times of
    /// one span of the clock share most of the work.
    void move_to(double time, bool rates, ThreadPool& pool);
    /// Makes the maps for reads at labels between x = `first` and `last` [m], on all threads. Other
    /// reads make theirs on the calling thread.
    void prepare(double first, double last, ThreadPool& pool) const;

    /// Returns true if the square holds a label.
    bool holds(double x, double y) const;
    /// Returns the first sample of a domain along an axis that the square may hold, and the end.
    std::array<int, 2> samples(const Domain& domain, std::size_t axis) const;
    /// Returns the share of the waves that the rim leaves at a label, 0 .. 1.
    double share_at(double x, double y) const;
    /// Returns the share of a trail that is shown at a label: it falls to 0 towards the border.
    double trail_share_at(WorldPoint label) const;
    /// Returns the waves at a label of the square; 0 at its rim. Several threads may read at once.
    LinearWaves<Jet> read(double x, double y) const;
    /// Reads the waves at the samples of a domain. prepare() must have made the maps there.
    class Rows;
    /// Returns the same from a sum over all waves in double precision.
    LinearWaves<Jet> read_exactly(double x, double y) const;
    /// Makes the sums of this time for read_exactly.
    void prepare_sums(const Water& water);

    const WakeSize& size() const { return size_; }
    const WakePast& past() const { return past_; }
    /// Returns the waves of the time, relative to past().place.centre, as those of the time 0.
    Modes modes() const;
    /// Returns a bound of the displacement at choppiness 1 [m], as query_bounds() does.
    double farthest() const { return farthest_; }

    static std::uint64_t bytes(int resolution);

  private:
    WakePlace place_at(double time) const {
        return wake_place(path_, time, size_.side, size_.side / size_.resolution);
    }
    /// Sums the past up to the begin of a span of the clock, in the windows of its ends.
    void settle(std::int64_t span, ThreadPool& pool);
    /// Adds the ticks of the span up to a number.
    void add_ticks(int ticks, ThreadPool& pool);
    /// Runs a frame over a past; `frame` lacks the past, the waves and the result.
    void run_frame(WakeFrame frame, const WakePast& past, PageVector<float>& to, ThreadPool& pool);

    WakeSize size_;
    TrackPath path_;
    WakeClock clock_;
    WakeLattice lattice_;
    WakePast past_;  // since the begin of the span
    Modes still_;    // the waves without amplitudes
    OpenSurface map_;
    PageVector<float> factors_;        // of the spline
    std::vector<std::size_t> places_;  // of packed amplitudes
    PageVector<float> amplitudes_;     // re, im
    PageVector<float> sums_;           // re, im in the window of the span's begin, then of its end
    std::optional<std::int64_t> span_;
    WakePlace settled_;        // at the begin of the span
    PathVector ends_;          // middle of the window at its end
    PageVector<float> ticks_;  // re, im of what the span's first ticks_added_ ticks add
    int ticks_added_ = 0;
    WakeTurns turns_;
    double farthest_ = 0.0;
    std::optional<WaveSum> sum_;
};

/// Reads row by row. The wake must live longer, at the same time.
class Wake::Rows {
  public:
    Rows(const Wake& wake, const Domain& domain);

    /// Writes the waves, without choppiness, of samples of row j, from sample `first` on; 0 outside
    /// the square. Several threads may read at once.
    void read(int j, std::size_t first, std::span<LinearWaves<Jet>> waves) const;

  private:
    /// Returns the places of the columns in the square, from its centre.
    static std::vector<double> columns(const Wake& wake, const Domain& domain);
    Rows(const Wake& wake, const Domain& domain, std::span<const double> x);

    const Wake& wake_;
    Domain domain_;
    std::size_t begin_;            // the first column in the square
    std::vector<RimFactor> rims_;  // of columns in the square
    OpenSurface::Lines lines_;
};

}  // namespace ocean
