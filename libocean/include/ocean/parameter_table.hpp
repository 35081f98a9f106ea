// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The parameter table: for each parameter its path, unit, label, help, range, class and what it
// dirties. Sea file, command line, C API, Blender, preview, bridge and README are loops over it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

enum class ParameterClass {
    live,     // changes amplitudes or the mapping: may glide, may stand in a take
    rebuild,  // changes the set of modes: cross-faded by live tools, refused in a take
};

/// The first stage of the chain that must be redone when a parameter changes.
enum class Stage { spectrum, modes, surface, foam, clock };

/// Where the value lives: a member of one section of Parameters.
using ParameterMember =
    std::variant<double Water::*, int Grid::*, double Grid::*, std::vector<int> Grid::*,
                 double SurfaceSettings::*, FoamCoverage SurfaceSettings::*, double Timing::*,
                 int Timing::*, std::string Timing::*, std::uint32_t Parameters::*,
                 SpectrumKind WaveSystem::*, SpreadingKind WaveSystem::*, Estimator WaveSystem::*,
                 double WaveSystem::*, int WaveSystem::*, std::string WaveSystem::*,
                 std::optional<double> WaveSystem::*>;

struct ParameterInfo {
    std::string_view section;  // "water" .. "random", or "waves" (one per wave system)
    std::string_view key;
    std::string_view unit;  // "" for a pure number or a word
    std::string_view label;
    std::string_view help;
    ParameterMember member;
    double min;  // hard range, inclusive; unused for words and texts
    double max;
    double soft_min;  // what a slider offers
    double soft_max;
    ParameterClass change;
    Stage dirties;
    /// Words of another parameter of the section, "jonswap, tma": while that has another word,
    /// this one does nothing. Empty: it always counts.
    std::string_view used_by = "";
    /// The smallest value that is not 0, where 0 is a word for "none".
    double least = 0.0;

    bool per_wave_system() const { return section == "waves"; }
    /// "water.depth", or "waves.N.wind_speed" with the system's number.
    std::string path(std::size_t wave = 0) const;
    /// The words allowed, in enum order; empty for numbers and texts.
    std::span<const std::string_view> choices() const;
    /// "float", "int", "enum", "text" or "list".
    std::string_view type() const;
};

std::span<const ParameterInfo> parameter_table();

/// A parameter found by name: `wave` counts only for those of a wave system.
struct ParameterRef {
    const ParameterInfo* info = nullptr;
    std::size_t wave = 0;

    bool same_as(const ParameterRef& other) const {
        return info == other.info && (wave == other.wave || !info->per_wave_system());
    }
};

/// Finds "grid.resolution", "waves.1.wind_speed", or a bare key; a bare key of [[waves]] means
/// waves.0. Throws Error invalid_value naming the nearest known names.
ParameterRef find_parameter(std::string_view name);

/// A typed value on its way between text or TOML and a member; words are texts.
using ParameterValue = std::variant<double, std::int64_t, std::string, std::vector<std::int64_t>>;

/// Checks type and hard range and stores. What does not pass is an Error invalid_value with name,
/// value and allowed range.
/// So is a wave system that is not there: none is made on the fly.
void assign(Parameters& parameters, const ParameterRef& ref, const ParameterValue& value);
/// The value as the type the table gives; an unset optional gives an empty text.
ParameterValue value_of(const Parameters& parameters, const ParameterRef& ref);

/// As text, for command lines, wires and the C API. Numbers are read and written without regard
/// to the locale, shortest form that reads back to the same bits. A refused value changes nothing.
/// Rules between parameters are not checked here, so that several can be set in any order; call
/// validate when all are. Another `file` or `record` drops the record of the old one.
void set_parameter(Parameters& parameters, std::string_view name, std::string_view text);
std::string get_parameter(const Parameters& parameters, std::string_view name);
std::string to_text(const ParameterValue& value);

/// "0.01 .. inf m", "one of monahan, threshold", "a power of two, 32 .. 8192".
std::string allowed_values(const ParameterInfo& info);

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
