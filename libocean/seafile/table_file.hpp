// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A file of parameters while it is read, for any model: its name, the lines of its values, and the
// errors that begin with both. TableReader loops over a table.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/table.hpp"
#include "toml_input.hpp"

namespace ocean {

/// The first line of every file of parameters is "libocean = 1".
inline constexpr std::string_view kVersionKey = "libocean";

/// A kind of file, recognised by the sections at its root.
struct FileKind {
    std::string_view kind;  // "sea"
    std::vector<std::string_view> roots;
};
/// Returns the kinds of files that this library or a later one reads.
std::span<const FileKind> file_kinds();
/// Returns the first parts of the sections' names, each once.
std::vector<std::string_view> root_names(std::span<const TableSection> sections);

class TableFile {
  public:
    explicit TableFile(std::string name) : name_(std::move(name)) {}

    const std::string& name() const { return name_; }
    /// Returns an error whose sentence begins with the file's name and the line; 0 is no line.
    Error fail(std::size_t line, const ErrorFields& fields,
               ErrorKind kind = ErrorKind::invalid_value) const;
    /// Returns the error with name, line and `prefix` in front of its sentence.
    Error in_front(const Error& error, std::size_t line, const std::string& prefix = "") const;
    /// Returns the error preceded by name and line of its parameter.
    Error in_front(const Error& error) const;
    /// Returns the error of a file that a parameter names, preceded by the line, the parameter and
    /// the value.
    Error in_line_of_parameter(const Error& error) const;
    /// Returns work(); an error of it is thrown with name and line in front.
    template <typename Work>
    auto at_line(std::size_t line, const Work& work) const {
        try {
            return work();
        } catch (const Error& error) {
            throw in_front(error, line);
        }
    }
    /// Calls read(), which reads a file that a parameter names; throws in_line_of_parameter().
    template <typename Read>
    void at_parameter(const Read& read) const {
        try {
            read();
        } catch (const Error& error) {
            throw in_line_of_parameter(error);
        }
    }

    void set_line(const std::string& path, std::size_t line) { lines_[path] = line; }
    /// Returns the line that gives a parameter, else its list item; 0 if the file has neither.
    std::size_t line_of_parameter(std::string_view path) const;

    /// Throws Error bad_file for a file without the line "libocean = 1".
    void require_version(const toml::table& root, std::string_view kind) const;
    /// Returns the value as the type of the row. A float accepts a whole number; no other type is
    /// converted. Throws Error invalid_value.
    ParameterValue value_for(const ParameterSpec& spec, std::size_t item,
                             const toml::node& node) const;
    /// Throws Error bad_file if the entry is a section of another kind of file.
    void require_kind(const TomlEntry& entry, std::string_view kind) const;
    /// Throws Error invalid_value for an entry of the root that is not a section; `roots` are
    /// allowed.
    [[noreturn]] void refuse_root(const TomlEntry& entry,
                                  std::span<const ParameterSpec* const> specs,
                                  std::span<const std::string_view> sections,
                                  std::span<const std::string_view> roots) const;
    /// Throws Error invalid_value if the entry is not [section].
    const toml::table& section_of(const TomlEntry& entry, std::string_view section) const;
    /// Throws Error invalid_value if the entry is not [[section]] once or more.
    const toml::array& list_of(const TomlEntry& entry, const TableSection& section) const;

  private:
    std::string name_;
    std::map<std::string, std::size_t, std::less<>> lines_;  // lines of the paths in the file
};

}  // namespace ocean
