// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See gauge_summary.hpp.
#include "gauge_summary.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ocean/internal/json.hpp"
#include "text.hpp"

namespace ocean::app {

std::vector<GaugeSummary> summarize(const GaugeSeries& series, const std::vector<Gauge>& gauges,
                                    const SampleTimes& times, double degrees_of_freedom) {
    std::vector<GaugeSummary> summaries;
    for (std::size_t g = 0; g < gauges.size(); ++g) {
        const std::vector<double> elevation = series.elevation(g);
        GaugeSpectrum spectrum = estimate_spectrum(elevation, times.rate, degrees_of_freedom);
        const SeaEstimate sea = estimate_sea(elevation, times.rate, spectrum);
        summaries.push_back(
            {gauges[g].name, count_waves(elevation, times.rate), sea, std::move(spectrum)});
    }
    return summaries;
}

namespace {

/// Returns "2.01 (1.88 .. 2.16)".
std::string with_limits(const Estimate& estimate) {
    if (!std::isfinite(estimate.value)) return "-";
    const std::string value = format_text("%.3g", estimate.value);
    if (!std::isfinite(estimate.lower)) return value;
    return value + format_text(" (%.3g .. %.3g)", estimate.lower, estimate.upper);
}

Json number_json(double value) {
    return json_number_or_null(value, significant<9>);
}

Json estimate_json(const Estimate& estimate) {
    return JsonObject()
        .add("value", number_json(estimate.value))
        .add("lower", number_json(estimate.lower))
        .add("upper", number_json(estimate.upper));
}

JsonObject gauge_json(const GaugeSummary& gauge) {
    const WaveCount& count = gauge.count;
    return JsonObject()
        .add("name", gauge.name)
        .add("waves", count.waves)
        .then_lines(5)
        .add("significant_wave_height", estimate_json(gauge.sea.significant_wave_height))
        .add("zero_crossing_period", estimate_json(gauge.sea.zero_crossing_period))
        .add("significant_height", number_json(count.significant_height))
        .add("tenth_height", number_json(count.tenth_height))
        .add("mean_height", number_json(count.mean_height))
        .add("highest_wave", number_json(count.highest_wave))
        .add("highest_crest", number_json(count.highest_crest))
        .add("mean_period", estimate_json(count.mean_period))
        .add("significant_period", number_json(count.significant_period))
        .add("degrees_of_freedom", number_json(gauge.spectrum.degrees_of_freedom))
        .add("frequency_step", number_json(gauge.spectrum.frequency_step));
}

}  // namespace

std::string summary_table(const std::vector<GaugeSummary>& summaries) {
    constexpr const char* kFormat = "%s  %6s  %-22s  %7s  %7s  %-22s  %s\n";
    std::size_t width = 5;
    for (const GaugeSummary& gauge : summaries) width = std::max(width, gauge.name.size());
    const auto padded = [width](const std::string& name) {
        return name + std::string(width - name.size(), ' ');
    };
    std::string table = format_text(kFormat, padded("gauge").c_str(), "waves", "Hs [m]", "H1/3",
                                    "Hmax", "Tz [s]", "Tm02 [s]");
    for (const GaugeSummary& gauge : summaries) {
        const WaveCount& count = gauge.count;
        const auto cell = [](double value) { return format_text("%.3g", value); };
        table +=
            format_text(kFormat, padded(gauge.name).c_str(), std::to_string(count.waves).c_str(),
                        with_limits(gauge.sea.significant_wave_height).c_str(),
                        cell(count.significant_height).c_str(), cell(count.highest_wave).c_str(),
                        with_limits(count.mean_period).c_str(),
                        with_limits(gauge.sea.zero_crossing_period).c_str());
    }
    return table;
}

std::string summary_json(const std::vector<GaugeSummary>& summaries, const SampleTimes& times) {
    JsonArray gauges(JsonLines{4});
    for (const GaugeSummary& gauge : summaries) gauges.add(gauge_json(gauge));
    return JsonObject(JsonLines{2})
               .add("from", Json(times.from, significant<12>))
               .add("to", Json(times.at(times.count() - 1), significant<12>))
               .add("rate", Json(times.rate, significant<12>))
               .add("samples", times.count())
               .add("gauges", gauges)
               .text() +
           "\n";
}

}  // namespace ocean::app
