// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The files that `ocean gauge` writes: readings as CSV or .npy, and spectra as CSV.
#pragma once

#include <string>
#include <vector>

#include "gauge_summary.hpp"

namespace ocean::app {

/// Returns CSV with a line for each time and gauge.
std::string series_csv(const GaugeSeries& series, const std::vector<Gauge>& gauges);
/// Returns a NumPy file: float64, C order, shape (times, gauges, GaugeSeries::kColumns).
std::string series_npy(const GaugeSeries& series);
/// Returns CSV with a line for each gauge and frequency.
std::string spectrum_csv(const std::vector<GaugeSummary>& summaries);

}  // namespace ocean::app
