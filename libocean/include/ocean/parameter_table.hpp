// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The parameter table of a sea: for each parameter its path, unit, label, help, range, class and
// what it dirties. Sea file, command line, C API, Blender, preview, bridge and README are loops
// over it. table.hpp has what is true of the table of any model.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ocean/parameters.hpp"
#include "ocean/table.hpp"

namespace ocean {

/// The first stage of the chain that must be redone when a parameter changes.
enum class Stage { spectrum, modes, surface, foam, clock };
template <>
struct StagesOf<Parameters> {
    using type = Stage;
};

using ParameterInfo = TableRow<Parameters>;
/// A parameter found by name: `item`, the wave system, counts only for those of [[waves]].
using ParameterRef = RefOf<Parameters>;

const Table<Parameters>& sea_table();
/// Returns the rows of sea_table().
std::span<const ParameterInfo> parameter_table();

/// Finds "grid.resolution", "waves.1.wind_speed", or a bare key; a bare key of [[waves]] means
/// waves.0. Throws Error invalid_value naming the nearest known name.
ParameterRef find_parameter(std::string_view name);

/// As text, for command lines, wires and the C API. Numbers are read and written without regard
/// to the locale, shortest form that reads back to the same bits. A refused value changes nothing.
/// Rules between parameters are not checked here, so that several can be set in any order; call
/// validate when all are. Another `file` or `record` drops the record of the old one.
void set_parameter(Parameters& parameters, std::string_view name, std::string_view text);
std::string get_parameter(const Parameters& parameters, std::string_view name);

/// "wind_speed, fetch, ...": what a take may change.
std::string live_parameter_names();

/// The first stage to be redone when parameters change from `before` to `after`; nothing if none.
std::optional<Stage> first_dirty_stage(const Parameters& before, const Parameters& after);

/// Rules between parameters (band limits in order, a measured system has its record ...).
/// Throws Error. Every stage may rely on a validated value.
void validate(const Parameters& parameters);

/// The table as a Markdown table (the README's) and as JSON (an array of objects).
std::string parameters_markdown();
std::string parameters_json();

}  // namespace ocean
