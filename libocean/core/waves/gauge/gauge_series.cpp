// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The readings of all gauges over time; see gauge_series.hpp. Threads share blocks of times, each
// with its own copy of the modes.
#include "ocean/internal/gauge_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "ocean/internal/cascades.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/gauge.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/ocean.hpp"
#include "ocean/query.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

GaugePlace Gauge::at(double time) const {
    if (track.size() == 1) {
        const auto& [start, place] = track.front();
        return {place.x + velocity_x * (time - start), place.y + velocity_y * (time - start),
                place.z};
    }
    const auto later = std::upper_bound(track.begin() + 1, track.end() - 1, time,
                                        [](double t, const Fix& fix) { return t < fix.time; });
    const Fix& a = *(later - 1);
    const Fix& b = *later;
    const double part = (time - a.time) / (b.time - a.time);
    const auto between = [part](double u, double v) { return u + part * (v - u); };
    return {between(a.place.x, b.place.x), between(a.place.y, b.place.y),
            between(a.place.z, b.place.z)};
}

std::size_t SampleTimes::count() const {
    // A last time that rounding puts just beyond `to` still counts.
    return static_cast<std::size_t>(std::floor((to - from) * rate * (1.0 + 1e-12) + 1e-9)) + 1;
}

std::vector<double> GaugeSeries::elevation(std::size_t gauge) const {
    std::vector<double> result(times);
    for (std::size_t i = 0; i < times; ++i) result[i] = reading(i, gauge)[kElevation];
    return result;
}

namespace {

bool stays_at_its_depth(const Gauge& gauge) {
    return std::ranges::all_of(gauge.track, [&](const Gauge::Fix& fix) {
        return fix.place.z == gauge.track.front().place.z;
    });
}

/// Returns the depths at which gauges stay, whose exponentials are worth keeping.
std::set<double> lasting_depths(const std::vector<Gauge>& gauges) {
    std::set<double> depths;
    for (const Gauge& gauge : gauges) {
        if (stays_at_its_depth(gauge)) depths.insert(gauge.track.front().place.z);
    }
    return depths;
}

/// The number of consecutive times that are reached by steps from one that is set, whichever thread
/// reads them.
constexpr std::size_t kBlock = 32;

using Levels = std::map<double, WaterLevel>;

void read_time(const WaveSum& sea, double choppiness, const SurfaceQuery* query,
               const std::vector<Gauge>& gauges, const Levels& levels, double time,
               std::span<double> values) {
    for (const Gauge& gauge : gauges) {
        const GaugePlace place = gauge.at(time);
        const auto lasting = levels.find(place.z);
        const bool changes = lasting == levels.end();
        const WaterLevel now = changes ? sea.water_level(place.z) : WaterLevel();
        const GaugeReading reading =
            read_gauge(sea, choppiness, place.x, place.y, changes ? now : lasting->second, query);
        const double row[] = {time,
                              place.x,
                              place.y,
                              reading.elevation,
                              reading.slope_x,
                              reading.slope_y,
                              reading.water.velocity_x,
                              reading.water.velocity_y,
                              reading.water.velocity_z,
                              reading.water.pressure};
        std::ranges::copy(row, values.begin());
        values = values.subspan(std::size(row));
    }
}

/// Returns the options of a query on the map that holds all waves.
QueryOptions label_query(const Grid& grid) {
    return {.foam = false, .resolution = default_map_resolution(grid)};
}

}  // namespace

std::uint64_t gauge_series_bytes(const Modes& modes, const Parameters& parameters,
                                 const std::vector<Gauge>& gauges, std::size_t times, int threads) {
    const std::uint64_t values =
        std::uint64_t{times} * gauges.size() * GaugeSeries::kColumns.size() * sizeof(double);
    const std::size_t copies = static_cast<std::size_t>(threads) + 1;
    const std::uint64_t queries =
        may_fold(modes, parameters.surface.choppiness)
            ? copies * SurfaceQuery::bytes(modes, label_query(parameters.grid))
            : 0;
    return values + queries +
           WaveSum::bytes(modes, copies, lasting_depths(gauges).size() + copies, 1);
}

namespace {

/// The wave sums with which one thread reads gauges.
class Reader {
  public:
    explicit Reader(WaveSum start) : sea(std::move(start)) {}

    /// Returns a query of the time: if crests may fold, a reading needs its top sheet.
    const SurfaceQuery* query_at(double time, const Modes& modes, const Parameters& now) {
        if (query_) {
            query_->move_to(modes, now.surface, now.water, time, alone_);
        } else {
            query_.emplace(modes, now.surface, now.water, time, label_query(now.grid), alone_);
        }
        return &*query_;
    }

    WaveSum sea;

  private:
    ThreadPool alone_{1};
    std::optional<SurfaceQuery> query_;
};

/// Returns the numbers of all gauges at one time.
std::size_t row_length(const GaugeSeries& series) {
    return series.gauges * GaugeSeries::kColumns.size();
}
std::span<double> row_of(GaugeSeries& series, std::size_t time) {
    return std::span(series.values).subspan(time * row_length(series), row_length(series));
}

void read_still_sea(Ocean& ocean, const std::vector<Gauge>& gauges, const SampleTimes& times,
                    ThreadPool& pool, const std::function<void(std::size_t)>& progress,
                    GaugeSeries& series) {
    const Parameters& parameters = ocean.parameters();
    const Modes& modes = ocean.modes();
    const WaveSum start(modes, parameters.water);
    Levels levels;
    for (const double z : lasting_depths(gauges)) levels.emplace(z, start.water_level(z));

    const WaveStep step = start.wave_step(1.0 / times.rate);
    const bool folds = may_fold(modes, parameters.surface.choppiness);
    // One reader for each thread.
    std::vector<std::unique_ptr<Reader>> readers(static_cast<std::size_t>(pool.size()));
    const std::size_t batch = 2 * kBlock * static_cast<std::size_t>(pool.size());
    for (std::size_t done = 0; done < series.times; done += batch) {
        const std::size_t end = std::min(done + batch, series.times);
        const std::size_t blocks = (end - done + kBlock - 1) / kBlock;
        pool.for_each_item(static_cast<int>(blocks), [&](int block, int thread) {
            std::unique_ptr<Reader>& reader = readers[static_cast<std::size_t>(thread)];
            if (!reader) reader = std::make_unique<Reader>(start);
            const std::size_t from = done + static_cast<std::size_t>(block) * kBlock;
            for (std::size_t i = from; i < std::min(from + kBlock, end); ++i) {
                i == from ? reader->sea.set_time(times.at(i)) : reader->sea.advance(step);
                const SurfaceQuery* const query =
                    folds ? reader->query_at(times.at(i), modes, parameters) : nullptr;
                read_time(reader->sea, parameters.surface.choppiness, query, gauges, levels,
                          times.at(i), row_of(series, i));
            }
        });
        progress(end);
    }
}

void read_performance(Ocean& ocean, const std::vector<Gauge>& gauges, const SampleTimes& times,
                      const std::function<void(std::size_t)>& progress, GaugeSeries& series) {
    std::unique_ptr<Reader> reader;
    int made = 0;
    for (std::size_t i = 0; i < series.times; ++i) {
        const double time = times.at(i);
        const Modes& modes = ocean.modes(time);
        const Parameters now = ocean.sea().at(time);
        if (!reader) {
            reader = std::make_unique<Reader>(WaveSum(modes, now.water));
        } else if (ocean.stage_runs().modes != made) {
            reader->sea = WaveSum(modes, now.water);
        }
        made = ocean.stage_runs().modes;
        reader->sea.set_time(time);
        const bool folds = may_fold(modes, now.surface.choppiness);
        const SurfaceQuery* const query = folds ? reader->query_at(time, modes, now) : nullptr;
        read_time(reader->sea, now.surface.choppiness, query, gauges, {}, time, row_of(series, i));
        progress(i + 1);
    }
}

/// Reads gauges by exact queries, time by time: over a bed, and where waves bind others.
void read_by_queries(Ocean& ocean, const std::vector<Gauge>& gauges, const SampleTimes& times,
                     const std::function<void(std::size_t)>& progress, GaugeSeries& series) {
    std::vector<WorldPoint> points(gauges.size());
    std::vector<WaterPoint> depths(gauges.size());
    std::vector<QuerySample> samples(gauges.size());
    std::vector<WaterMotion> motions(gauges.size());
    for (std::size_t i = 0; i < series.times; ++i) {
        const double time = times.at(i);
        for (std::size_t g = 0; g < gauges.size(); ++g) {
            const GaugePlace place = gauges[g].at(time);
            points[g] = {place.x, place.y};
            depths[g] = {place.x, place.y, place.z};
        }
        ocean.query(time, points, samples, {.exact = true, .foam = false});
        ocean.water_motion(time, depths, motions, {.exact = true});
        std::span<double> row = row_of(series, i);
        for (std::size_t g = 0; g < gauges.size(); ++g) {
            const QuerySample& sample = samples[g];
            const WaterMotion& water = motions[g];
            const double values[] = {time,
                                     points[g].x,
                                     points[g].y,
                                     sample.height,
                                     -sample.normal[0] / sample.normal[2],
                                     -sample.normal[1] / sample.normal[2],
                                     water.velocity_x,
                                     water.velocity_y,
                                     water.velocity_z,
                                     water.pressure};
            std::ranges::copy(values, row.begin());
            row = row.subspan(std::size(values));
        }
        progress(i + 1);
    }
}

}  // namespace

GaugeSeries read_gauge_series(Ocean& ocean, const std::vector<Gauge>& gauges,
                              const SampleTimes& times, ThreadPool& pool,
                              const std::function<void(std::size_t)>& progress) {
    GaugeSeries series{times.count(), gauges.size(), {}};
    series.values.resize(series.times * row_length(series));
    if (!ocean.repeats() || ocean.parameters().surface.second_order) {
        read_by_queries(ocean, gauges, times, progress, series);
    } else if (ocean.sea().take.empty()) {
        read_still_sea(ocean, gauges, times, pool, progress, series);
    } else {
        read_performance(ocean, gauges, times, progress, series);
    }
    return series;
}

double modes_at_peak(Ocean& ocean, double duration) {
    const Water& water = ocean.parameters().water;
    const double peak = ocean.spectrum().moments(water).peak_omega;
    if (peak <= 0.0 || duration <= 0.0) return std::numeric_limits<double>::infinity();
    // n peak waves fit into the patch. The modes within 1/duration of the peak's frequency lie in a
    // ring of radius n; deep water's 2 n / (f duration) is its width.
    const double patch = ocean.parameters().grid.patch_size;
    const double waves = patch * Dispersion(water).wavenumber(peak) / kTwoPi;
    return 2.0 * kTwoPi * waves * waves / (peak / kTwoPi * duration);
}

}  // namespace ocean
