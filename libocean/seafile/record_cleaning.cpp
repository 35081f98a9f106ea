// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Removes artefacts of estimators that no sea has: see clean_record in record_rules.hpp.
#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "ocean/internal/record_rules.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

/// Returns the variance of a spectrum over frequency by the trapezoid rule [m^2].
double variance(const SpectrumRecord& record) {
    double sum = 0.0;
    for (std::size_t i = 1; i < record.frequency.size(); ++i) {
        sum += 0.5 * (record.density[i] + record.density[i - 1]) *
               (record.frequency[i] - record.frequency[i - 1]);
    }
    return sum;
}

void scale(std::span<double> values, double factor) {
    for (double& value : values) value *= factor;
}

/// Sets negative values to 0.
void clip(std::span<double> values) {
    for (double& value : values) value = std::max(value, 0.0);
}

/// Clips directions so that each frequency keeps its density, the integral over its directions, if
/// that integral is above 0.
void clip_directions(SpectrumRecord& record) {
    const std::vector<double>& d = record.direction;
    const std::size_t width = d.size();
    for (std::size_t i = 0; i < record.frequency.size(); ++i) {
        const std::span row(record.directional_density.data() + i * width, width);
        clip(row);
        double integral = 0.0;
        for (std::size_t j = 0; j < width; ++j) {
            const double before = j > 0 ? d[j - 1] : d.back() - 360.0;
            const double after = j + 1 < width ? d[j + 1] : d.front() + 360.0;
            integral += row[j] * 0.5 * (after - before);
        }
        if (integral > 0.0) scale(row, std::max(record.density[i], 0.0) / integral);
    }
}

void leave_out_first_bin(SpectrumRecord& record) {
    const double density = record.density.front();
    if (density > 0.0) {
        record.warnings.push_back("a density of " + shortest_text(density) +
                                  " m^2/Hz at 0 Hz, which is not a wave, is left out");
    }
    for (auto* values :
         {&record.frequency, &record.density, &record.a1, &record.b1, &record.a2, &record.b2}) {
        if (!values->empty()) values->erase(values->begin());
    }
    auto& directional = record.directional_density;
    directional.erase(directional.begin(),
                      directional.begin() + static_cast<std::ptrdiff_t>(record.direction.size()));
}

}  // namespace

void clean_record(SpectrumRecord& record) {
    const std::size_t count = record.frequency.size();
    const bool parallel = count >= 2 && record.density.size() == count &&
                          record.directional_density.size() == count * record.direction.size();
    if (!parallel) return;  // record_fault reports it
    if (record.frequency.front() == 0.0) leave_out_first_bin(record);

    const std::vector<double>& values =
        record.is_directional() ? record.directional_density : record.density;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    if (!(*least < 0.0) || !(*least >= -kMaxNoise * *most)) return;
    const auto below =
        std::count_if(values.begin(), values.end(), [](double v) { return v < 0.0; });
    record.warnings.push_back(std::to_string(below) + " of " + std::to_string(values.size()) +
                              " densities are below 0, the lowest by " +
                              fixed_text(-100.0 * *least / *most, 2) +
                              " % of the highest: they count as 0, and the others keep the energy");
    const double asked = variance(record);
    if (record.is_directional()) clip_directions(record);
    clip(record.density);
    const double clipped = variance(record);
    if (!(asked > 0.0 && clipped > 0.0)) return;
    scale(record.density, asked / clipped);
    scale(record.directional_density, asked / clipped);
}

}  // namespace ocean
