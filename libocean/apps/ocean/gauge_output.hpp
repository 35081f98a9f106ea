// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What `ocean gauge` writes: the readings as CSV or .npy, and what they say about the sea as a
// table, as JSON and as spectra.
#pragma once

#include <string>
#include <vector>

#include "gauge_points.hpp"
#include "gauge_record.hpp"
#include "ocean/gauge.hpp"

namespace ocean::app {

/// A line for each time and gauge.
std::string record_csv(const GaugeRecord& record, const std::vector<Gauge>& gauges);
/// A NumPy file: float64, C order, shape (times, gauges, GaugeRecord::kColumns).
std::string record_npy(const GaugeRecord& record);

/// What the record of one gauge says.
struct GaugeSummary {
    std::string name;
    WaveCount count;
    SeaEstimate sea;
    GaugeSpectrum spectrum;
};

std::string summary_table(const std::vector<GaugeSummary>& summaries);
std::string summary_json(const std::vector<GaugeSummary>& summaries, const SampleTimes& times);
/// A line for each gauge and frequency.
std::string spectrum_csv(const std::vector<GaugeSummary>& summaries);

}  // namespace ocean::app
