// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See gauge_files.hpp.
#include "gauge_files.hpp"

#include <bit>
#include <span>

#include "ocean/internal/text.hpp"
#include "text.hpp"

namespace ocean::app {
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
