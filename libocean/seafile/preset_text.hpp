// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Presets as files: the few lines that a reader needs, under their description; shared by those of
// seas and of terrains.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ocean/seafile.hpp"
#include "table_writer.hpp"

namespace ocean {

/// Returns the line of a key with its unit and label as a comment.
std::string labelled_line(const std::string& line, std::string_view unit, std::string_view label);

/// Returns a preset: name, description and notes, the latter in lines, as comments above the keys.
Preset described_preset(const std::string& name, const std::string& description,
                        std::string_view notes, const std::string& keys);

/// Returns the keys of a preset's file. is_shown(ref, line): whether the line of a key that is set
/// stands in it.
template <typename Model, typename IsShown>
std::string preset_keys(const Table<Model>& table, const Model& model, const IsShown& is_shown) {
    return table_text<Model>(table, model, [&](const RefOf<Model>& ref) -> std::string {
        const std::string line = parameter_line(model, ref);
        if (line.empty() || !is_shown(ref, line)) return "";
        return labelled_line(line, ref.info->unit, ref.info->label);
    });
}

/// Returns the preset of that name. noun: what an error calls one; allowed: the names that it
/// lists. Throws Error not_found.
const Preset& find_preset_in(std::span<const Preset> presets, std::string_view name,
                             std::string_view noun, std::string_view allowed);

}  // namespace ocean
