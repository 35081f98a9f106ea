// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Directional quantities beside a spectrum without directions: chooses among the quantities that a
// NetCDF file has for each frequency, finds their convention, and computes directional moments.
#pragma once

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "direction_sense.hpp"
#include "netcdf_layout.hpp"
#include "ocean/parameters.hpp"

namespace ocean::netcdf {

/// Returns how well a variable's names fit a quantity, 0 if they do not.
int bin_rank(BinQuantity quantity, const std::string& name, const std::string& standard_name);
/// Returns true for a name whose writers all mean the direction that waves come from.
bool is_known_to_come_from(const std::string& name);

class BinDirections {
  public:
    /// Chooses the first complete set of: four moments; two directions and two ratios; two
    /// directions and two spreads; the first moment; a direction and a ratio; a direction and a
    /// spread; a direction.
    BinDirections(const Content& content, const Layout& layout);

    bool exist() const { return source_ != Source::none; }
    /// Returns the assumptions that hold for all records.
    const std::vector<std::string>& warnings() const { return warnings_; }

    /// Returns a variable's value at a frequency of a record, or NaN if it is missing.
    using ValueOf = std::function<double(const Variable&)>;
    /// Appends the moments of one frequency. Throws Fault for impossible values.
    void append(SpectrumRecord& record, const ValueOf& value_of) const;

  private:
    enum class Source {
        none,
        moments,
        directions_and_ratios,
        directions_and_spreads,
        first_moment,
        direction_and_ratio,
        direction_and_spread,
        direction,
    };
    void find_moment_sense(const Content& content, const Variable& spectrum);
    void find_direction_sense(const Content& content, const Variable& spectrum);
    void find_units();
    bool mean_follows(const DirectionSense& moments) const;

    bool has(std::initializer_list<BinQuantity> quantities) const;
    double ratio(BinQuantity quantity, const ValueOf& value_of) const;
    double direction(BinQuantity quantity, const ValueOf& value_of) const;
    double spread_ratio(BinQuantity quantity, const ValueOf& value_of) const;
    std::complex<double> moment(BinQuantity a, BinQuantity b, const ValueOf& value_of) const;

    std::array<const Variable*, kBinQuantities> variable_{};
    std::array<double, kBinQuantities> scale_{};  // factor to degrees, or to ratios
    Source source_ = Source::none;
    DirectionSense moment_sense_, direction_sense_;
    std::vector<std::string> warnings_;
};

/// Returns the factor from units of a variable of directions or spreads to degrees. Throws Fault
/// for an unknown unit.
double degrees_per_unit(const Variable& variable);

}  // namespace ocean::netcdf
