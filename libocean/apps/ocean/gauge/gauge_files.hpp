// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The outputs of `ocean gauge`: readings as CSV or .npy, spectra as CSV, and the statistics of the
// sea as a readable table and as JSON.
#pragma once

#include <string>
#include <vector>

#include "ocean/internal/gauge.hpp"
#include "ocean/internal/gauge_series.hpp"

namespace ocean::app {

/// The statistics of the sea at a gauge.
struct GaugeSummary {
    std::string name;
    WaveCount count;
    SeaEstimate sea;
    GaugeSpectrum spectrum;
};

std::vector<GaugeSummary> summarize(const GaugeSeries& series, const std::vector<Gauge>& gauges,
                                    const SampleTimes& times, double degrees_of_freedom);

std::string summary_table(const std::vector<GaugeSummary>& summaries);
std::string summary_json(const std::vector<GaugeSummary>& summaries, const SampleTimes& times);

/// Returns CSV with a line for each time and gauge.
std::string series_csv(const GaugeSeries& series, const std::vector<Gauge>& gauges);
/// Returns a NumPy file: float64, C order, shape (times, gauges, GaugeSeries::kColumns).
std::string series_npy(const GaugeSeries& series);
/// Returns CSV with a line for each gauge and frequency.
std::string spectrum_csv(const std::vector<GaugeSummary>& summaries);

}  // namespace ocean::app
