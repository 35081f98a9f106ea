// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See gauge_files.hpp.
#include "gauge_files.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

#include "ocean/internal/json.hpp"
#include "ocean/internal/text.hpp"
#include "text.hpp"

namespace ocean::app {
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

std::string series_csv(const GaugeSeries& series, const std::vector<Gauge>& gauges) {
    std::string csv = "time,gauge";
    for (const std::string_view column : std::span(GaugeSeries::kColumns).subspan(1)) {
        csv += "," + std::string(column);
    }
    csv += '\n';
    std::vector<std::string> names;
    for (const Gauge& gauge : gauges) names.push_back(csv_cell(gauge.name));
    for (std::size_t i = 0; i < series.times; ++i) {
        for (std::size_t g = 0; g < series.gauges; ++g) {
            const std::span<const double> values = series.reading(i, g);
            csv += format_text("%.12g,", values[0]) + names[g];
            for (const double value : values.subspan(1)) csv += format_text(",%.9g", value);
            csv += '\n';
        }
    }
    return csv;
}

// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html, version 1.0: magic, the
// length of the header, a Python dictionary, blanks up to a multiple of 64 bytes, the values.
std::string series_npy(const GaugeSeries& series) {
    static_assert(std::endian::native == std::endian::little);
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                         std::to_string(series.times) + ", " + std::to_string(series.gauges) +
                         ", " + std::to_string(GaugeSeries::kColumns.size()) + "), }";
    constexpr std::size_t kBefore = 10;  // [bytes]
    header.append(63 - (kBefore + header.size()) % 64, ' ');
    header += '\n';
    std::string bytes = "\x93NUMPY\x01";
    bytes += '\0';
    bytes += static_cast<char>(header.size() & 0xff);
    bytes += static_cast<char>(header.size() >> 8);
    bytes += header;
    bytes.append(reinterpret_cast<const char*>(series.values.data()),
                 series.values.size() * sizeof(double));
    return bytes;
}

std::string spectrum_csv(const std::vector<GaugeSummary>& summaries) {
    std::string csv = "gauge,frequency,density,lower,upper\n";
    for (const GaugeSummary& gauge : summaries) {
        const std::string name = csv_cell(gauge.name);
        const Estimate unit = gauge.spectrum.limits();
        for (std::size_t i = 0; i < gauge.spectrum.density.size(); ++i) {
            const double density = gauge.spectrum.density[i];
            csv += name + format_text(",%.9g,%.9g,%.9g,%.9g\n", gauge.spectrum.frequency(i),
                                      density, density * unit.lower, density * unit.upper);
        }
    }
    return csv;
}

}  // namespace ocean::app
