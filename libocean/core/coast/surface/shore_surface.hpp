// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface of a sea over its bed, a pure function of label and time. The waves of each band and
// sector are the open sea's at a shifted place, with a phase and an amplitude of the coast; their
// sum is limited to the highest wave that the depth carries and takes the skewed, asymmetric shape
// of waves that are about to break. Where the waves feel no bed this is the open sea, and towards
// the border of the bed it fades into the open sea.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coast/loops/band_sector_task.hpp"
#include "coast/loops/band_signals.hpp"
#include "coast/statics/breaking.hpp"
#include "coast/statics/shore_statics.hpp"
#include "coast/surface/open_spans.hpp"
#include "coast/surface/surf_labels.hpp"
#include "coast/surface/swash.hpp"
#include "field/jet.hpp"
#include "ocean/internal/coast_waves.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/internal/wave_sum.hpp"
#include "ocean/parameters.hpp"
#include "ocean/query.hpp"
#include "waves/labels/label_point.hpp"
#include "waves/labels/open_surface.hpp"

namespace ocean {

class ThreadPool;
struct BlockPlaces;
struct BlockSignal;
struct ShoalingBlock;

/// The surface at one label.
struct ShorePoint : LabelPoint {
    float bed = 0.0f;       // height of the bed below the label [m]; meaningless beyond the bed
    float on_bed = 0.0f;    // weight of the coast's surface: 1 over the bed, 0 beyond its border
    float surf = 0.0f;      // 0 where waves break by the wind, 1 where they break by the
                            // depth or where no waves arrive
    float breaking = 0.0f;  // source of foam by breaking waves and at the water line, 0 .. 1
    float wetness = 1.0f;   // wetness of the ground at this moment, 0 .. 1
};

/// Sums over the waves that a backend has written for a CoastRequest, from the label `first` on.
/// Empty: no backend has summed.
struct ReadySums {
    std::span<const float> sums;
    std::size_t labels = 0;  // labels of the request
    std::size_t first = 0;
};

/// One band and sector of waves at a place, before the limiter.
struct LocalWave {
    Jet real, imaginary;      // the analytic signal [m]
    double wavenumber = 0.0;  // of the band's middle at the local depth [rad/m]
    double direction = 0.0;   // travel direction [rad]
};

/// The weights of the waves at a place.
struct LocalSea {
    bool is_over_bed = false;
    double bed = 0.0;              // height of the bed [m]
    double depth = 0.0;            // depth that the waves feel [m]
    double bed_influence = 0.0;    // weight of bands and sectors; 1 - it: open sea
    double limited = 1.0;          // factor by the limiter
    double short_wave_gain = 1.0;  // factor on the waves in no band
    double coast = 0.0;            // weights at the border of the bed
    double open = 1.0;
};

/// The open sea's waves of one time, mode by mode in double precision. Exact reads of a
/// ShoreSurface use them instead of its maps.
struct ShoreSums {
    WaveSum open;
    WaveSum remainder;  // the waves that are in no band
    double time = 0.0;  // [s]

    void set_time(double to);
};

class ShoreSurface {
  public:
    /// Rates are derivatives in time, which double the work of move_to.
    enum class Rates { without, with };

    /// `shown`: samples of the sea's map whose waves count. Shares the statics; keeps no reference
    /// to other arguments.
    ShoreSurface(const Modes& modes, const Parameters& parameters, const ShoreStatics& statics,
                 int shown, Rates rates, ThreadPool& pool);

    /// Begins another time [s], with rates only on request. No thread may read meanwhile. `cells`:
    /// only read_surf at the labels of these cells may follow.
    void move_to(double time, Rates rates, ThreadPool& pool, const SignalCells* cells = nullptr);
    /// Returns whether every read at its time is allowed.
    bool is_whole() const { return signals_.is_whole(); }
    /// Returns the cells that read_surf reads at labels.
    SignalCells cells(std::span<const SurfLabels* const> labels, ThreadPool& pool) const;
    /// Returns whether rates of its time may be read.
    bool has_rates() const { return signals_.has_rates(); }
    double time() const { return time_; }
    Rates rates() const { return rates_; }
    /// Makes the maps of the open sea that read() needs at the labels of a region, on all threads,
    /// from the modes of the constructor. Required before read() at another time, which throws
    /// Error invalid_value where a map is missing.
    void prepare(const Modes& modes, const Domain& labels, ThreadPool& pool);
    /// Makes the maps of the open sea that read() needs between x = `first` and `last` [m]. Strips
    /// beyond are made on their first read, on the calling thread.
    void prepare(const Modes& modes, double first, double last, ThreadPool& pool);
    /// Writes the surface at each label, on the calling thread. `parts` selects the parts of
    /// heights and offsets; other parts are 0, and `all` needs Rates::with. Values have the same
    /// bits whichever parts are written. Several threads may read at once. `exact`: sums each mode,
    /// at the time of `exact`, without prepare() and move_to(). `ready`: the sums of a backend.
    void read(std::span<const WorldPoint> labels, JetParts parts, std::span<ShorePoint> points,
              const ShoreSums* exact = nullptr, ReadySums ready = {}) const;
    /// Returns the input with which a backend sums the waves. Valid until the next move_to.
    CoastWaves waves() const;
    /// Writes ShorePoint::breaking, the source of foam, and the depth of the water [m] at labels in
    /// the surf and in the swash; without room for the source the depth alone. Only in the swash
    /// the depth includes waves; elsewhere it is still water's.
    void read_surf(const SurfLabels& labels, std::span<float> breaking,
                   std::span<float> depths) const;

    /// Returns the weights at a place and writes its waves; empty if none feels the bed. The
    /// signals must have been moved to the time; prepare() is not needed. exact: see read().
    LocalSea local_sea(WorldPoint place, std::vector<LocalWave>& waves,
                       const ShoreSums* exact = nullptr) const;
    /// Returns sums of the surface's modes at time 0; `modes` and `water` are the constructor's.
    ShoreSums sums(const Modes& modes, const Water& water) const;
    /// Returns the modes of the waves that are in no band.
    const Modes& remainder_modes() const { return remainder_modes_; }

    const ShoreStatics& statics() const { return statics_; }
    const RunUpSea& run_up() const { return run_up_; }
    const LimiterGain& limiter_gain() const { return limiter_gain_; }
    double choppiness() const { return choppiness_; }
    /// Returns the rms error of heights by the splines of the open sea [m].
    double height_error() const { return open_.height_error(); }
    /// Returns the max distance between a label and the point where it is displayed [m].
    double reach() const { return reach_; }

  private:
    template <typename Scalar>
    struct Block;
    template <typename Scalar>
    void read_block(Block<Scalar>& block, const ReadySums& ready,
                    std::span<ShorePoint> points) const;
    template <typename Scalar>
    void find_shoaling(Block<Scalar>& block) const;
    template <typename Scalar>
    void find_lee(Block<Scalar>& block, std::size_t i) const;
    template <typename Scalar>
    void lower_in_lee(Block<Scalar>& block) const;
    template <typename Scalar>
    void finish(Block<Scalar>& block, std::span<ShorePoint> points) const;
    /// Returns the depth of the water at a label in the swash [m], from the waves in bands alone.
    float swash_depth(const SurfLabels& labels, std::size_t at,
                      const SwashWaves<float>& waves) const;
    /// Turns the surface into swash where a place lies in the swash of its breaking waves, and
    /// writes wetness and foam. bed_influence: see Block.
    template <typename Scalar>
    void apply_swash(const SwashPlace<Scalar>& place, const SwashWaves<Scalar>& waves,
                     const Scalar& bed_influence, LinearWaves<Scalar>& surface,
                     ShorePoint& point) const;
    void prepare(const Modes& modes, const OpenSpans& spans, ThreadPool& pool);
    /// Writes where labels lie in the maps of the coast.
    void find_places(BlockPlaces& places) const;
    /// Takes up to kShoreBlock labels from `first` on.
    void find_places(const SurfLabels& labels, std::size_t first, BlockPlaces& places) const;
    /// Reads the delays of a band and sector, and writes the places to which they shift labels.
    void shift(std::size_t waves, const BlockPlaces& places, bool slopes, QuadBlock& delay,
               double* x, double* y) const;
    /// Adds all waves at labels that feel the bed; without `displaces`, the values of Z alone.
    void add_waves(JetParts parts, bool displaces, const ShoreSums* exact,
                   ShoalingBlock& block) const;
    /// Copies a backend's sums instead of adding waves.
    static void take_sums(JetParts parts, const ReadySums& ready, ShoalingBlock& block);
    void add_left(std::size_t waves, JetParts parts, const ShoreSums* exact,
                  ShoalingBlock& block) const;
    /// Writes the signal of one band and sector at `count` places.
    void read_signal(std::size_t waves, std::size_t count, const double* x, const double* y,
                     JetParts parts, const ShoreSums* exact, BlockSignal& signal) const;

    ShoreStatics statics_;
    RunUpSea run_up_;
    double choppiness_;
    int shown_;
    double reach_;
    Modes remainder_modes_;
    OpenSurface open_;
    OpenSurface remainder_;
    BandSignals signals_;
    LimiterGain limiter_gain_;
    double time_ = 0.0;
    Rates rates_;
    BandSectorLoop band_sector_loop_;
    std::optional<Domain> region_;
    OpenSpans region_spans_;  // spans of region_
};

}  // namespace ocean
