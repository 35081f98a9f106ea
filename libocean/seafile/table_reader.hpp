// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a model from a file through its table, strictly and in the order of the file: a key without
// effect is an error, never ignored. The table covers sections, lists of sections and nested
// sections; a model's own reader reads all other contents of its files.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/checked_text.hpp"
#include "table_file.hpp"

namespace ocean {

/// The parts of a model's files that are not parameters.
template <typename Model>
struct OwnParts {
    std::vector<std::string_view> roots = {};  // names of root entries, "take"
    std::function<void(const TomlEntry&)> read_root = nullptr;
    /// Reads a key of a section that is not a parameter; returns false if the model does not know
    /// it either.
    std::function<bool(Model&, std::string_view section, std::size_t item, const TomlEntry&)>
        read_key = nullptr;
    /// Called for each section of the table, but not for lists, before the section's keys are read.
    std::function<void(Model&, std::string_view section)> begin_section = nullptr;
};

template <typename Model>
class TableReader {
  public:
    TableReader(const Table<Model>& table, std::string name, OwnParts<Model> own = {})
        : table_(table), own_(std::move(own)), file_(std::move(name)) {}

    /// Returns the model of the file, without checks of rules between its parameters. Throws Error
    /// "NAME:LINE: ...".
    Model read(const toml::table& root) {
        file_.require_version(root, table_.kind);
        const std::vector<std::string_view> sections = root_names(table_.sections);
        for (const TomlEntry& entry : in_file_order(root)) {
            if (entry.key == kVersionKey) continue;
            if (std::ranges::find(own_.roots, entry.key) != own_.roots.end()) {
                own_.read_root(entry);
            } else if (std::ranges::find(sections, entry.key) != sections.end()) {
                read_section(entry, std::string(entry.key));
            } else {
                file_.require_kind(entry, table_.kind);
                file_.refuse_root(entry, specs_of(table_), sections, own_.roots);
            }
        }
        return std::move(model_);
    }

    const TableFile& file() const { return file_; }

  private:
    const TableSection* find_section(std::string_view name) const {
        const auto found = std::ranges::find(table_.sections, name, &TableSection::name);
        return found != table_.sections.end() ? &*found : nullptr;
    }
    const TableRow<Model>* find_row(std::string_view section, std::string_view key) const {
        for (const TableRow<Model>& row : table_.rows) {
            if (row.section == section && row.key == key) return &row;
        }
        return nullptr;
    }
    bool stands_inside(std::string_view section) const {
        const std::string inside = std::string(section) + ".";
        return std::ranges::any_of(table_.sections, [&](const TableSection& other) {
            return other.name == section || other.name.starts_with(inside);
        });
    }

    void read_section(const TomlEntry& entry, const std::string& name) {
        const TableSection* section = find_section(name);
        if (section == nullptr || !section->is_list()) {
            const toml::table& table = file_.section_of(entry, name);
            if (section != nullptr && own_.begin_section) own_.begin_section(model_, name);
            return read_keys(table, name, 0, name);
        }
        const toml::array& list = file_.list_of(entry, *section);
        const auto first = std::ranges::find(table_.rows, section->name, &TableRow<Model>::section);
        first->member.renew(model_, list.size());
        for (std::size_t item = 0; item < list.size(); ++item) {
            const std::string path = name + "." + std::to_string(item);
            const toml::table& table = *list[item].as_table();
            file_.set_line(path, line_of(table));
            read_keys(table, name, item, path);
        }
    }

    void read_keys(const toml::table& table, const std::string& section, std::size_t item,
                   const std::string& path) {
        for (const TomlEntry& entry : in_file_order(table)) {
            const std::string inner = section + "." + std::string(entry.key);
            if (const TableRow<Model>* row = find_row(section, entry.key)) {
                read_value({row, item}, entry);
            } else if (stands_inside(inner)) {
                read_section(entry, inner);
            } else if (!own_.read_key || !own_.read_key(model_, section, item, entry)) {
                refuse_key(path + "." + text::printable(entry.key), entry);
            }
        }
    }

    void read_value(const RefOf<Model>& ref, const TomlEntry& entry) {
        const ParameterValue value = file_.value_for(*ref.info, ref.item, *entry.node);
        file_.set_line(ref.info->path(ref.item), entry.line);
        file_.at_line(entry.line, [&] { assign(model_, ref, value); });
    }

    [[noreturn]] void refuse_key(const std::string& path, const TomlEntry& entry) const {
        const std::string given = path + " = " + shown(*entry.node) + ": ";
        try {
            refuse_name(path, specs_of(table_));
        } catch (const Error& error) {
            throw file_.in_front(error, entry.line, given);
        }
    }

    const Table<Model>& table_;
    OwnParts<Model> own_;
    TableFile file_;
    Model model_;
};

}  // namespace ocean
