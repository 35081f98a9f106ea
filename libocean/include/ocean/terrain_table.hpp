// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The parameter table of a terrain: for each parameter its path, unit, label, help, range and the
// stage that it dirties. Terrain file, command line, C API, Blender, preview and README are loops
// over it.
//
//     set_parameter(model, "beta", "2.2");
//     set_parameter(model, "terrain.gullies.depth", "0.05");
//     validate(model);  // the rules between parameters
//     std::string text = get_parameter(model, "rms");
//     for (const TerrainRow& row : terrain_table().rows) {
//         panel.add(row.label, row.soft_min, row.soft_max);
//     }
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ocean/table.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean {

/// The stages of a terrain, in their order. A row names the first stage that a change of its
/// parameter dirties: the noise of its waves, their amplitudes, the shape that erosion and shore
/// give it, or the height added to all samples.
enum class TerrainStage { noise, filter, shape, offset };
template <>
struct StagesOf<TerrainModel> {
    using type = TerrainStage;
};

using TerrainRow = TableRow<TerrainModel>;

/// Returns the table of a terrain.
const Table<TerrainModel>& terrain_table();

/// Sets a parameter from text. Rules between parameters are not checked, so that several can be set
/// in any order; call validate afterwards. A new `measured` or `base` drops the data read for the
/// old value. Throws Error invalid_value and changes nothing if the name or the value is refused.
void set_parameter(TerrainModel& terrain, std::string_view name, std::string_view text);
/// Returns a parameter as text: numbers in the shortest form that reads back to the same bits, ""
/// for an unset parameter. Throws Error invalid_value for an unknown name.
std::string get_parameter(const TerrainModel& terrain, std::string_view name);

/// Returns the row that switches the row's section on: the first row of [terrain.gullies],
/// [terrain.stream] or [terrain.coast], where 0 means off. Null for a row of another section.
const TerrainRow* switch_of(const TerrainRow& row);
/// Returns true if the row's section is off, so that the parameter has no effect.
bool is_switched_off(const TerrainModel& terrain, const TerrainRow& row);

/// Returns the first stage that a change from `before` to `after` dirties; none if they are equal.
std::optional<TerrainStage> first_dirty_stage(const TerrainModel& before,
                                              const TerrainModel& after);

/// Checks the rules between parameters (limits of wavelengths in order, layers that fit the patch,
/// either rms or range ...). Throws Error invalid_value. Every stage may rely on validated
/// parameters.
void validate(const TerrainModel& terrain);

}  // namespace ocean
