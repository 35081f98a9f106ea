// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes a model as a file through its table: the inverse of TableReader.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "ocean/seafile.hpp"
#include "ocean/table.hpp"
#include "toml_text.hpp"

namespace ocean {

/// Returns a chosen parameter's line, "resolution = 512\n"; empty to leave it out.
template <typename Model>
using LineOfParameter = std::function<std::string(const RefOf<Model>&)>;
/// Returns the text after the keys of a section or of a list item.
using TextAfterKeys = std::function<std::string(std::string_view section, std::size_t item)>;

/// Returns "key = value\n"; empty for a value that the row leaves out because it is unset or
/// neutral.
template <typename Model>
std::string parameter_line(const Model& model, const RefOf<Model>& ref) {
    const ParameterValue value = value_of(model, ref);
    if (ref.info->is_left_out(value)) return "";
    return std::string(ref.info->key) + " = " + toml_value(value) + "\n";
}

/// Returns the lines of one section of the table, or of one item of a list.
template <typename Model>
std::string section_lines(const Table<Model>& table, std::string_view section, std::size_t item,
                          const LineOfParameter<Model>& line) {
    std::string out;
    for (const TableRow<Model>& row : table.rows) {
        if (row.section == section) out += line({&row, item});
    }
    return out;
}

/// Returns "libocean = 1", then each section of the table that has a line, and each item of a list.
template <typename Model>
std::string table_text(const Table<Model>& table, const Model& model,
                       const LineOfParameter<Model>& line, const TextAfterKeys& after = nullptr) {
    std::string out = "libocean = " + std::to_string(kSeaFileVersion) + "\n";
    for (const TableSection& section : table.sections) {
        const std::string name(section.name);
        for (std::size_t item = 0; item < items_of(table, name, model); ++item) {
            const std::string lines = section_lines(table, name, item, line);
            if (section.is_list()) {
                out += "\n[[" + name + "]]\n" + lines;
            } else if (!lines.empty()) {
                out += "\n[" + name + "]\n" + lines;
            }
            if (after) out += after(name, item);
        }
    }
    return out;
}

/// Returns the lines of every key that is set and not neutral; TableReader reads them back to the
/// same bits.
template <typename Model>
std::string table_text(const Table<Model>& table, const Model& model) {
    return table_text<Model>(table, model,
                             [&](const RefOf<Model>& ref) { return parameter_line(model, ref); });
}

}  // namespace ocean
