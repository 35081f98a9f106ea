// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See sea_argument.hpp.
#include "sea_argument.hpp"

#include <filesystem>

#include "any_spectra.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/io/read_provenance.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "standard_input.hpp"

namespace ocean::app {
namespace {

constexpr std::string_view kPresetPrefix = "preset:";

Sea read_source(const std::string& source) {
    if (source.starts_with(kPresetPrefix)) {
        const Preset& preset = find_preset(source.substr(kPresetPrefix.size()));
        return parse_sea(preset.toml, source, "", read_any_spectra);
    }
    if (source == kStandardInput) {
        return parse_sea(read_standard_input(kMaxSeaFileBytes), "standard input", "",
                         read_any_spectra);
    }
    if (text::is_pipe_or_device(source)) {
        // The first bytes of a pipe cannot be read twice.
        const std::string content = text::read_file_or_pipe(source, kMaxSeaFileBytes);
        return parse_sea(content, source, "", read_any_spectra);
    }
    const auto provenance = io::read_provenance(source);
    if (!provenance) return read_sea(source, read_any_spectra);
    if (provenance->kind != kSeaKind) {
        throw Error(ErrorKind::bad_file, source + ": shows a " + text::printable(provenance->kind) +
                                             " instead of a sea");
    }
    return parse_sea(provenance->text, source, "", read_any_spectra);
}

void assign(Parameters& parameters, const std::string& name, std::string value) {
    const std::string_view key = find_parameter(name).info->key;
    if ((key == "file" || key == "take") && !value.empty()) {
        value = std::filesystem::absolute(utf8_path(value))
                    .string();  // relative to the working directory
    }
    set_parameter(parameters, name, value);
}

void assign_text(Parameters& parameters, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw Error(ErrorKind::invalid_value,
                    "--set " + assignment + ": allowed is NAME=VALUE, such as wind_speed=12");
    }
    assign(parameters, assignment.substr(0, equals), assignment.substr(equals + 1));
}

}  // namespace

OptionGroup sea_options(SeaArgument& argument, bool required) {
    return {
        "Sea",
        {{"SEA", &argument.source, "",
          "A sea file, - for standard input, an EXR file that was baked from one, or preset:NAME",
          required},
         {"--set", &argument.assignments, "NAME=VALUE",
          "Change a parameter, such as wind_speed=12 or waves.1.fetch=50000; may be "
          "repeated"}}};
}

Sea open_sea(const SeaArgument& argument) {
    Sea sea = read_source(argument.source);
    for (const std::string& assignment : argument.assignments) {
        assign_text(sea.parameters, assignment);
    }
    resolve_files(sea, utf8_path(argument.source).parent_path().string(), read_any_spectra);
    validate(sea);
    return sea;
}

void set_in_sea(Sea& sea, const std::string& name, const std::string& value) {
    assign(sea.parameters, name, value);
    resolve_files(sea, "", read_any_spectra);
    validate(sea);
}

}  // namespace ocean::app
