// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What gauges read over time, wherever they are and go.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/parameters.hpp"
#include "ocean/wave_sum.hpp"

namespace ocean {

class Ocean;
class ThreadPool;

/// Where a gauge is at one time; z up from still water.
struct GaugePlace {
    double x;  // m
    double y;
    double z;
};

struct Gauge {
    struct Fix {
        double time;  // s
        GaugePlace place;
    };

    std::string name;
    std::vector<Fix> track;   // in order of time, straight between; a single one is left at:
    double velocity_x = 0.0;  // m/s
    double velocity_y = 0.0;

    GaugePlace at(double time) const;
};

/// The times from + i / rate up to `to`.
struct SampleTimes {
    double from;  // s
    double to;
    double rate;  // Hz

    std::size_t count() const;
    double at(std::size_t i) const { return from + static_cast<double>(i) / rate; }
};

/// A number for each time, gauge and column, in this order, columns side by side.
struct GaugeSeries {
    static constexpr std::array<std::string_view, 10> kColumns = {
        "time",    "x",          "y",          "elevation",  "slope_x",
        "slope_y", "velocity_x", "velocity_y", "velocity_z", "pressure"};

    static constexpr std::size_t kElevation = 3;

    std::size_t times = 0;
    std::size_t gauges = 0;
    std::vector<double> values;

    std::span<const double> reading(std::size_t time, std::size_t gauge) const {
        return std::span(values).subspan((time * gauges + gauge) * kColumns.size(),
                                         kColumns.size());
    }
    /// Of one gauge over all times.
    std::vector<double> elevation(std::size_t gauge) const;
};

/// Bytes that read_gauge_series needs.
std::uint64_t gauge_series_bytes(const Modes& modes, const Parameters& parameters,
                                 const std::vector<Gauge>& gauges, std::size_t times, int threads);

/// Exact: all modes summed at each place and time. The same bits for any number of threads.
/// `progress` is told the times done, some times in between. A sea with a take is made anew for
/// each time at which it changes.
GaugeSeries read_gauge_series(Ocean& ocean, const std::vector<Gauge>& gauges,
                              const SampleTimes& times, ThreadPool& pool,
                              const std::function<void(std::size_t)>& progress);

/// About how many modes of the grid lie so near to the spectrum's peak that a series of `duration`
/// seconds takes them for one wave; infinite in still water and for no duration. With few of them
/// an estimate is one of the place and not of the sea.
double modes_at_peak(Ocean& ocean, double duration);

}  // namespace ocean
