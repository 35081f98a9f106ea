// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Readings of gauges over time, on tracks through the sea.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/wave_sum.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

class Ocean;
class ThreadPool;

/// The position of a gauge at one time; z up from still water.
struct GaugePlace {
    double x;  // [m]
    double y;
    double z;
};

struct Gauge {
    struct Fix {
        double time;  // [s]
        GaugePlace place;
    };

    std::string name;
    std::vector<Fix> track;   // ordered by time, straight between fixes
    double velocity_x = 0.0;  // [m/s]; only for a single fix
    double velocity_y = 0.0;

    GaugePlace at(double time) const;
};

/// The times from + i / rate, up to `to`.
struct SampleTimes {
    double from;  // [s]
    double to;    // [s]
    double rate;  // [Hz]

    std::size_t count() const;
    double at(std::size_t i) const { return from + static_cast<double>(i) / rate; }
};

/// A number for each time, gauge and column, in this order: the columns of a reading are adjacent.
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
    /// Returns the elevations of one gauge at all times [m].
    std::vector<double> elevation(std::size_t gauge) const;
};

/// Returns the bytes that read_gauge_series needs.
std::uint64_t gauge_series_bytes(const Modes& modes, const Parameters& parameters,
                                 const std::vector<Gauge>& gauges, std::size_t times, int threads);

/// Returns all readings, exact: all modes are summed at each point and time. The bits are the same
/// for any number of threads. `progress` is called now and then with the number of times done. A
/// sea with a take is computed anew for each time at which it changes.
GaugeSeries read_gauge_series(Ocean& ocean, const std::vector<Gauge>& gauges,
                              const SampleTimes& times, ThreadPool& pool,
                              const std::function<void(std::size_t)>& progress);

/// Returns about how many modes of the grid lie so close to the spectrum's peak that a series of
/// `duration` [s] cannot separate them; infinite for still water and for a duration of 0. If they
/// are few, an estimate describes the gauge's position and not the sea.
double modes_at_peak(Ocean& ocean, double duration);

}  // namespace ocean
