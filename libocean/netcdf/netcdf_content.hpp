// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The part of a NetCDF file that the readers of spectra need, as a plain value: dimensions, and
// variables unpacked to doubles. netcdf_file makes it, netcdf_wire carries it, netcdf_records
// interprets it.
#pragma once

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace ocean::netcdf {

/// Max number of values of all variables together, 512 MiB. The user must split a larger file.
inline constexpr std::size_t kMaxValues = std::size_t{1} << 26;
inline constexpr std::size_t kMaxDimensions = 1024;
inline constexpr std::size_t kMaxVariables = 1024;
inline constexpr std::size_t kMaxVariableDimensions = 16;
inline constexpr std::size_t kMaxAttributes = 256;  // per variable, or of the file
/// Longer names, attributes and texts are cut.
inline constexpr std::size_t kMaxTextBytes = 1000;

struct Dimension {
    std::string name;
    std::size_t size = 0;
    bool operator==(const Dimension&) const = default;
};

struct Variable {
    std::string name;
    std::vector<std::size_t>
        dimensions;  // indices into Content::dimensions; the last varies fastest
    std::map<std::string, std::string> attributes;  // text attributes, and flag_values
    bool is_text = false;
    // One of the two has an element for each point of the dimensions; in a header both are empty.
    std::vector<double> values;  // scale_factor and add_offset applied; NaN = missing
    std::vector<std::string> texts;

    /// Returns the attribute, or "" if the variable does not have it.
    std::string attribute(const std::string& key) const {
        const auto found = attributes.find(key);
        return found == attributes.end() ? "" : found->second;
    }
};

struct Content {
    std::map<std::string, std::string> attributes;  // text attributes of the file
    std::vector<Dimension> dimensions;
    std::vector<Variable> variables;
};

/// Returns the index of a variable's value at a point of all dimensions of the content. kMaxValues
/// prevents an overflow of this and of stride().
inline std::size_t offset(const Content& content, const Variable& variable,
                          const std::vector<std::size_t>& at) {
    std::size_t result = 0;
    for (const std::size_t d : variable.dimensions) {
        result = result * content.dimensions[d].size + at[d];
    }
    return result;
}
/// Returns the step between neighbouring values along a dimension, which the variable must have.
inline std::size_t stride(const Content& content, const Variable& variable, std::size_t dimension) {
    std::size_t result = 1;
    for (std::size_t k = variable.dimensions.size(); variable.dimensions[k - 1] != dimension; --k) {
        result *= content.dimensions[variable.dimensions[k - 1]].size;
    }
    return result;
}

/// A problem of a file: "VARIABLE: problem". The path is added by a caller that knows it.
struct Fault : std::runtime_error {
    explicit Fault(const std::string& what) : std::runtime_error(what), message(what) {}
    Fault(const std::string& of_variable, const std::string& what)
        : std::runtime_error(of_variable + ": " + what), variable(of_variable), message(what) {}

    std::string variable, message;
};

}  // namespace ocean::netcdf
