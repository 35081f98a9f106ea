// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Records and estimates of gauges as text and as .npy; see gauge_output.hpp.
#include "gauge_output.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "text.hpp"

namespace ocean::app {
namespace {

/// Quoted where a reader would otherwise see more than one cell.
std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"# ") == std::string::npos && !text.empty()) return text;
    std::string cell = "\"";
    for (const char c : text) {
        if (c == '"') cell += '"';
        cell += c;
    }
    return cell + '"';
}

}  // namespace

std::string record_csv(const GaugeRecord& record, const std::vector<Gauge>& gauges) {
    std::string csv = "time,gauge";
    for (const std::string_view column : std::span(GaugeRecord::kColumns).subspan(1)) {
        csv += "," + std::string(column);
    }
    csv += '\n';
    std::vector<std::string> names;
    for (const Gauge& gauge : gauges) names.push_back(csv_cell(gauge.name));
    for (std::size_t i = 0; i < record.times; ++i) {
        for (std::size_t g = 0; g < record.gauges; ++g) {
            const std::span<const double> values = record.reading(i, g);
            csv += format_text("%.12g,", values[0]) + names[g];
            for (const double value : values.subspan(1)) csv += format_text(",%.9g", value);
            csv += '\n';
        }
    }
    return csv;
}

// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html, version 1.0: magic, the
// length of the header, a Python dictionary, blanks up to a multiple of 64 bytes, the values.
std::string record_npy(const GaugeRecord& record) {
    static_assert(std::endian::native == std::endian::little);
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                         std::to_string(record.times) + ", " + std::to_string(record.gauges) +
                         ", " + std::to_string(GaugeRecord::kColumns.size()) + "), }";
    constexpr std::size_t kBefore = 10;  // bytes
    header.append(63 - (kBefore + header.size()) % 64, ' ');
    header += '\n';
    std::string bytes = "\x93NUMPY\x01";
    bytes += '\0';
    bytes += static_cast<char>(header.size() & 0xff);
    bytes += static_cast<char>(header.size() >> 8);
    bytes += header;
    bytes.append(reinterpret_cast<const char*>(record.values.data()),
                 record.values.size() * sizeof(double));
    return bytes;
}

namespace {

/// "2.01 (1.88 .. 2.16)".
std::string with_limits(const Estimate& estimate) {
    if (!std::isfinite(estimate.value)) return "-";
    const std::string value = format_text("%.3g", estimate.value);
    if (!std::isfinite(estimate.lower)) return value;
    return value + format_text(" (%.3g .. %.3g)", estimate.lower, estimate.upper);
}

std::string number_json(double value) {
    return std::isfinite(value) ? format_text("%.9g", value) : "null";
}

std::string estimate_json(const Estimate& estimate) {
    return "{\"value\": " + number_json(estimate.value) +
           ", \"lower\": " + number_json(estimate.lower) +
           ", \"upper\": " + number_json(estimate.upper) + "}";
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
    std::string json = format_text("{\n  \"from\": %.12g,\n  \"to\": %.12g,\n  \"rate\": %.12g,\n",
                                   times.from, times.at(times.count() - 1), times.rate);
    json += "  \"samples\": " + std::to_string(times.count()) + ",\n  \"gauges\": [";
    for (const GaugeSummary& gauge : summaries) {
        const WaveCount& count = gauge.count;
        json += (json.back() == '[' ? "\n" : ",\n") + ("    {\"name\": " + json_string(gauge.name));
        json += ", \"waves\": " + std::to_string(count.waves);
        const auto estimate = [&](const char* name, const Estimate& value) {
            json += ",\n     \"" + std::string(name) + "\": " + estimate_json(value);
        };
        const auto number = [&](const char* name, double value) {
            json += ",\n     \"" + std::string(name) + "\": " + number_json(value);
        };
        estimate("significant_wave_height", gauge.sea.significant_wave_height);
        estimate("zero_crossing_period", gauge.sea.zero_crossing_period);
        number("significant_height", count.significant_height);
        number("tenth_height", count.tenth_height);
        number("mean_height", count.mean_height);
        number("highest_wave", count.highest_wave);
        number("highest_crest", count.highest_crest);
        estimate("mean_period", count.mean_period);
        number("significant_period", count.significant_period);
        number("degrees_of_freedom", gauge.spectrum.degrees_of_freedom);
        number("frequency_step", gauge.spectrum.frequency_step);
        json += "}";
    }
    return json + "\n  ]\n}\n";
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
