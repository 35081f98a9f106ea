// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The parameter table of a sea: for each parameter its path, unit, label, help, range, class and
// the stage that it dirties. Sea file, command line, C API, Blender, preview, bridge and README are
// loops over it. table.hpp holds the part that the tables of all models share.
//
//     set_parameter(parameters, "waves.0.wind_speed", "14");
//     set_parameter(parameters, "spectrum", "jonswap");  // a bare key of [[waves]] means waves.0
//     validate(parameters);                              // the rules between parameters
//     std::string text = get_parameter(parameters, "waves.0.fetch");
//     for (const ParameterInfo& row : parameter_table()) {
//         panel.add(row.label, row.soft_min, row.soft_max);
//     }
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ocean/parameters.hpp"
#include "ocean/table.hpp"

namespace ocean {

/// The stages of the chain, in its order. A row names the first stage that a change of its
/// parameter dirties.
enum class Stage { spectrum, modes, surface, foam, clock };
template <>
struct StagesOf<Parameters> {
    using type = Stage;
};

using ParameterInfo = TableRow<Parameters>;
/// A parameter found by name; `item` is the wave system and counts only for rows of [[waves]].
using ParameterRef = RefOf<Parameters>;

/// Returns the table of a sea.
const Table<Parameters>& sea_table();
/// Returns the rows of sea_table().
std::span<const ParameterInfo> parameter_table();

/// Finds "grid.resolution", "waves.1.wind_speed", or a bare key; a bare key of [[waves]] means
/// waves.0. Throws Error invalid_value naming the nearest known name.
ParameterRef find_parameter(std::string_view name);

/// Sets a parameter from text, for command lines, wires and the C API. Numbers are read without
/// regard to the locale. Rules between parameters are not checked, so that several can be set in
/// any order; call validate afterwards. A new `file`, `record` or `place` drops the record that was
/// read for the old value; a new `seabed` or `seabed_unit` drops a bed read from a file. Other keys
/// of a bed move the bed. Throws Error invalid_value and changes nothing if the name or the value
/// is refused.
void set_parameter(Parameters& parameters, std::string_view name, std::string_view text);
/// Returns a parameter as text: numbers in the shortest form that reads back to the same bits, ""
/// for an unset parameter. Throws Error invalid_value for an unknown name.
std::string get_parameter(const Parameters& parameters, std::string_view name);

/// Returns the names of all parameters that a take may change: "wind_speed, fetch, ...".
std::string live_parameter_names();

/// Returns the first stage that a change from `before` to `after` dirties; none if they are equal.
std::optional<Stage> first_dirty_stage(const Parameters& before, const Parameters& after);

/// Checks the rules between parameters (band limits in order, a measured system has its record
/// ...). Throws Error invalid_value. Every stage may rely on validated parameters.
void validate(const Parameters& parameters);

/// Returns the table as Markdown (the README's).
std::string parameters_markdown();
/// Returns the table as a JSON array of objects.
std::string parameters_json();

// ---- Counters of the stages

struct StageRuns {
    int spectrum = 0;
    int modes = 0;
    int packing = 0;    // packings of the modes for a resolution of maps
    int threshold = 0;  // of the whitecaps
    int cover_power = 0;
    int surface = 0;      // requested maps
    int foam_ticks = 0;   // whitecap maps of the foam's clock
    int spray_ticks = 0;  // maps of the spray's lattice

    bool operator==(const StageRuns&) const = default;
};

}  // namespace ocean
