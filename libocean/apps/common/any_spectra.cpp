// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See any_spectra.hpp.
#include "any_spectra.hpp"

#include <cmath>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/netcdf_spectra.hpp"
#include "ocean/seafile.hpp"
#include "text.hpp"

namespace ocean::app {

std::vector<SpectrumRecord> read_any_spectra(const std::string& path) {
    return is_netcdf(text::first_bytes(path, 8)) ? read_netcdf_spectra(path) : read_spectra(path);
}

std::string origin_text(const SpectrumRecord& record) {
    std::string text = record.station;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (!record.time.empty()) add(record.time + " UTC");
    if (!std::isnan(record.latitude) && !std::isnan(record.longitude)) {
        const double east = std::remainder(record.longitude, 360.0);
        add(format_text("%.3f %c %.3f %c", std::abs(record.latitude),
                        record.latitude < 0.0 ? 'S' : 'N', std::abs(east), east < 0.0 ? 'W' : 'E'));
    }
    return text.empty() ? "an unnamed place and time" : text;
}

}  // namespace ocean::app
