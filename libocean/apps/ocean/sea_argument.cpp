// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The SEA argument; see sea_argument.hpp.
#include "sea_argument.hpp"

#include <CLI/CLI.hpp>
#include <fstream>
#include <memory>

#include "ocean/error.hpp"
#include "ocean/io.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/platform.hpp"
#include "ocean/seafile.hpp"

namespace ocean::app {
namespace {

constexpr std::string_view kPresetPrefix = "preset:";

/// By content, not by name.
bool is_exr(const std::string& path) {
    std::ifstream file(utf8_path(path), std::ios::binary);
    char magic[4] = {};
    return file.read(magic, 4) && std::string_view(magic, 4) == "\x76\x2f\x31\x01";
}

Sea sea_of_exr(const std::string& path) {
    for (const auto& [key, value] : io::read_exr_header(path)) {
        if (key == "ocean:sea") return parse_sea(value, path, "");
    }
    throw Error(ErrorKind::bad_file,
                path + ": no sea is in this file; only files that `ocean bake` wrote hold one");
}

Sea read_source(const std::string& source) {
    if (source.starts_with(kPresetPrefix)) {
        const Preset& preset = find_preset(source.substr(kPresetPrefix.size()));
        return parse_sea(preset.toml, source, "");
    }
    return is_exr(source) ? sea_of_exr(source) : read_sea(source);
}

void assign_text(Parameters& parameters, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw Error(ErrorKind::invalid_value,
                    "--set " + assignment + ": allowed is NAME=VALUE, such as wind_speed=12");
    }
    set_parameter(parameters, assignment.substr(0, equals), assignment.substr(equals + 1));
}

/// Files named on the command line are relative to the current folder, those of a sea file to it.
std::string spectrum_file(const WaveSystem& now, const WaveSystem& before,
                          const std::string& source) {
    if (now.file != before.file) return now.file;
    return (utf8_path(source).parent_path() / utf8_path(now.file)).string();
}

/// A new `file` or `record` must not leave the old record in place.
void choose_records_again(Parameters& parameters, const Parameters& before,
                          const std::string& source) {
    for (std::size_t i = 0; i < parameters.waves.size(); ++i) {
        WaveSystem& now = parameters.waves[i];
        const WaveSystem& old = before.waves[i];
        const bool same = now.file == old.file && now.record == old.record && now.measured;
        if (now.spectrum != SpectrumKind::measured || now.file.empty() || same) continue;
        const std::string file = spectrum_file(now, old, source);
        now.measured = std::make_shared<const SpectrumRecord>(
            choose_record(read_spectra(file), now.record, file));
    }
}

}  // namespace

void add_sea_argument(CLI::App& command, SeaArgument& argument) {
    command
        .add_option("SEA", argument.source,
                    "A sea file, an EXR file that was baked from one, or preset:NAME")
        ->required()
        ->type_name("");
    command
        .add_option("--set", argument.assignments,
                    "Change a parameter, such as wind_speed=12 or waves.1.fetch=50000; may be "
                    "repeated")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false)
        ->group("Sea");
}

Sea open_sea(const SeaArgument& argument) {
    Sea sea = read_source(argument.source);
    const Parameters before = sea.parameters;
    for (const std::string& assignment : argument.assignments) {
        assign_text(sea.parameters, assignment);
    }
    choose_records_again(sea.parameters, before, argument.source);
    validate(sea.parameters);
    return sea;
}

}  // namespace ocean::app
