// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One spectrum of a Spotter buoy (Sofar Ocean), downloaded as CSV or as JSON of the maker's
// interface: the same quantities under nearly the same names. Stands between a reader of either
// format and the record.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/enum_words.hpp"
#include "ocean/parameters.hpp"

namespace ocean::spotter {

/// The quantities at one frequency. The moments are those of the direction that waves travel to,
/// counter-clockwise from east, as in libocean; `direction` is the mean that they come from,
/// clockwise from north.
enum class Quantity { frequency, density, a1, b1, a2, b2, direction, spread };
inline constexpr std::size_t kQuantities = enum_count<Quantity>();

/// By quantity, as JSON names them; CSV writes f for the frequency.
inline constexpr std::array<std::string_view, kQuantities> kNames = {
    "frequency", "varianceDensity", "a1", "b1", "a2", "b2", "direction", "directionalSpread"};

/// By quantity, then by bin; NaN = missing. A quantity that the file has not is empty.
using Bins = std::array<std::vector<double>, kQuantities>;

/// Returns the fault of a value, with its spelling in the file and the allowed values; empty for a
/// good one.
std::string fault(Quantity quantity, double value, std::string_view spelled);
/// Returns the fault of a latitude or a longitude [degrees]; empty for a good one.
std::string latitude_fault(double value, std::string_view spelled);
std::string longitude_fault(double value, std::string_view spelled);

/// Returns the fault of the bins as a whole; empty for good ones.
std::string fault(const Bins& bins);
/// Returns true if there are at least two frequencies with a density.
bool has_spectrum(const Bins& bins);
/// Sets the spectrum of a record: bins without density are left out; directions are the moments
/// where the file has them, else the mean and the spread. Needs bins without a fault.
void set_spectrum(SpectrumRecord& record, const Bins& bins);

}  // namespace ocean::spotter
