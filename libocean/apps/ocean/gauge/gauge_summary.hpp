// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The statistics of the sea at each gauge: as values, as a readable table and as JSON.
#pragma once

#include <string>
#include <vector>

#include "ocean/internal/gauge.hpp"
#include "ocean/internal/gauge_series.hpp"

namespace ocean::app {

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

}  // namespace ocean::app
