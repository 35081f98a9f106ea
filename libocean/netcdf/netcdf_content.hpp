// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What the readers of spectra need of a NetCDF file, as a plain value: dimensions, and variables
// unpacked to doubles. Made by netcdf_file, carried by netcdf_wire, understood by netcdf_records.
#pragma once

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace ocean::netcdf {

/// Of all variables together, 512 MiB: a file with more is cut by its user before.
inline constexpr std::size_t kMaxValues = std::size_t{1} << 26;
inline constexpr std::size_t kMaxDimensions = 1024;
inline constexpr std::size_t kMaxVariables = 1024;
inline constexpr std::size_t kMaxVariableDimensions = 16;
inline constexpr std::size_t kMaxAttributes = 256;  // of a variable or of the file
/// Names, attributes and texts end there.
inline constexpr std::size_t kMaxTextBytes = 1000;

struct Dimension {
    std::string name;
    std::size_t size = 0;
    bool operator==(const Dimension&) const = default;
};

struct Variable {
    std::string name;
    std::vector<std::size_t> dimensions;            // of the content; the last varies fastest
    std::map<std::string, std::string> attributes;  // those that are text, and flag_values
    bool is_text = false;
    // One of them, with an element for each point of the dimensions; both empty in a header.
    std::vector<double> values;  // scale_factor and add_offset applied; NaN = missing
    std::vector<std::string> texts;

    /// Empty if there is none.
    std::string attribute(const std::string& key) const {
        const auto found = attributes.find(key);
        return found == attributes.end() ? "" : found->second;
    }
};

struct Content {
    std::map<std::string, std::string> attributes;  // of the whole file, those that are text
    std::vector<Dimension> dimensions;
    std::vector<Variable> variables;
};

/// Where a variable has its value at a point of all dimensions of the content. A variable has few
/// enough values that neither this nor a step overflows.
inline std::size_t offset(const Content& content, const Variable& variable,
                          const std::vector<std::size_t>& at) {
    std::size_t result = 0;
    for (const std::size_t d : variable.dimensions) {
        result = result * content.dimensions[d].size + at[d];
    }
    return result;
}
/// From a value to the next one along a dimension that the variable has.
inline std::size_t stride(const Content& content, const Variable& variable, std::size_t dimension) {
    std::size_t result = 1;
    for (std::size_t k = variable.dimensions.size(); variable.dimensions[k - 1] != dimension; --k) {
        result *= content.dimensions[variable.dimensions[k - 1]].size;
    }
    return result;
}

/// What is wrong with a file: "VARIABLE: what". The path is added where it is known.
struct Fault : std::runtime_error {
    explicit Fault(const std::string& what) : std::runtime_error(what), message(what) {}
    Fault(const std::string& of_variable, const std::string& what)
        : std::runtime_error(of_variable + ": " + what), variable(of_variable), message(what) {}

    std::string variable, message;
};

}  // namespace ocean::netcdf
