// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See preset_text.hpp.
#include "preset_text.hpp"

#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"

namespace ocean {
namespace {

std::string commented(std::string_view lines) {
    std::string out = "# ";
    for (const char c : lines) out += c == '\n' ? std::string("\n# ") : std::string(1, c);
    return out + "\n";
}

}  // namespace

std::string labelled_line(const std::string& line, std::string_view unit, std::string_view label) {
    const std::string before = unit.empty() ? "" : std::string(unit) + ": ";
    return line.substr(0, line.size() - 1) + "  # " + before + std::string(label) + "\n";
}

Preset described_preset(const std::string& name, const std::string& description,
                        std::string_view notes, const std::string& keys) {
    return {name, description, commented(name + ": " + description) + commented(notes) + keys};
}

const Preset& find_preset_in(std::span<const Preset> presets, std::string_view name,
                             std::string_view noun, std::string_view allowed) {
    std::vector<std::string_view> names;
    for (const Preset& preset : presets) {
        if (preset.name == name) return preset;
        names.push_back(preset.name);
    }
    throw Error(ErrorKind::not_found, "no " + std::string(noun) + " is called '" +
                                          text::printable(name) + "'" + did_you_mean(name, names) +
                                          "; allowed: " + std::string(allowed));
}

}  // namespace ocean
