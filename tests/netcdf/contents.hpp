// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Contents of NetCDF files made by hand.
#pragma once

#include <stdexcept>

#include "netcdf_content.hpp"
#include "netcdf_records.hpp"
#include "testing.hpp"

namespace ocean::netcdf {

inline constexpr double kDegree = std::numbers::pi / 180.0;
inline constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

inline std::size_t points(const Content& content, const Variable& v) {
    std::size_t count = 1;
    for (const std::size_t d : v.dimensions) count *= content.dimensions[d].size;
    return count;
}

/// Returns the fault of the file, or of its first record that cannot be used.
inline std::string fault_of(const Content& content) {
    try {
        for (const SpectrumRecord& record : records_from(content)) {
            if (!record.fault.empty()) return record.fault;
        }
    } catch (const Fault& fault) {
        return fault.what();
    }
    return "";
}

inline Variable& find(Content& content, const std::string& name) {
    for (Variable& v : content.variables) {
        if (v.name == name) return v;
    }
    throw std::out_of_range(name);
}

inline Variable numbers(const std::string& name, std::vector<std::size_t> dimensions,
                        std::map<std::string, std::string> attributes, std::vector<double> values) {
    return {name, std::move(dimensions), std::move(attributes), false, std::move(values), {}};
}

/// wavespectra's: two times, two sites, two frequencies, four directions; value
/// t*1000+s*100+f*10+d.
inline Content wavespectra() {
    Content content;
    content.dimensions = {{"time", 2}, {"site", 2}, {"freq", 2}, {"dir", 4}};
    std::vector<double> values;
    for (int i = 0; i < 32; ++i) {
        values.push_back(i / 16 * 1000 + i / 8 % 2 * 100 + i / 4 % 2 * 10 + i % 4);
    }
    content.variables = {
        numbers("efth", {0, 1, 2, 3}, {{"units", "m2 s degree-1"}}, values),
        numbers("time", {0}, {{"units", "hours since 2020-02-28 22:00:00"}}, {0.0, 3.0}),
        numbers("lat", {1}, {}, {-38.0, 50.0}),
        numbers("lon", {1}, {}, {174.0, -3.0}),
        numbers("dpt", {1}, {}, {55.0, 60.0}),
        numbers("freq", {2}, {{"units", "Hz"}}, {0.1, 0.2}),
        numbers("dir", {3}, {{"units", "degree"}}, {0.0, 90.0, 180.0, 270.0}),
    };
    return content;
}

/// The value of a record in the bin of waves that come from `from`.
inline double value_from(const SpectrumRecord& record, std::size_t frequency, double from) {
    const double travel = std::fmod(630.0 - from, 360.0);
    for (std::size_t j = 0; j < record.direction.size(); ++j) {
        if (std::abs(record.direction[j] - travel) < 1e-9) {
            return record.directional_density[frequency * record.direction.size() + j];
        }
    }
    return kMissing;
}

}  // namespace ocean::netcdf
