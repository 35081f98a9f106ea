// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The current values of the sea's parameters and of the application, with their last writers and
// revisions. Boards, clients and recorders share this table alone. For one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/parameter_table.hpp"

namespace ocean::bridge {

/// A value of the application that shows the sea. It is not a parameter and stands in no take.
struct AppValue {
    std::string_view name;
    double min;
    double max;
    double initial;
    bool is_whole;
    std::string_view help;
};
std::span<const AppValue> app_values();

struct ValueEntry {
    std::string name;           // the parameter's path, or "app.pause"
    std::string text;           // "unset" for an optional parameter without a value
    std::string writer;         // "" until it is written
    std::uint64_t changed = 0;  // revision at which the text changed
    std::uint64_t taken = 0;    // revision at which the writer changed
};

/// The word of an unset value on the wire.
inline constexpr std::string_view kUnset = "unset";
/// Returns a value of any table as VAL and UPD spell it and SET reads it: a number, a word, true or
/// false, [1, 7], or "unset".
std::string wire_text(const ParameterSpec& spec, const ParameterValue& value);

class ValueTable {
  public:
    /// `parameters` must be valid.
    explicit ValueTable(Parameters parameters = {});

    std::span<const ValueEntry> entries() const { return entries_; }
    const ValueEntry& operator[](std::size_t entry) const { return entries_[entry]; }
    /// Finds an entry by its path or its bare key, as the parameter table does. Throws Error
    /// not_found.
    std::size_t find(std::string_view name) const;
    /// Returns the row of the parameter table, or nullptr for an app value.
    const ParameterInfo* parameter(std::size_t entry) const { return refs_[entry].info; }
    ParameterRef ref(std::size_t entry) const { return refs_[entry]; }
    /// Returns true for a number, which controls may set; false for words, texts, booleans and
    /// lists.
    bool is_number(std::size_t entry) const;
    /// Returns true for a number without a fraction.
    bool is_whole(std::size_t entry) const;
    /// Returns the value of a number. For an unset wind speed it is kDefaultWind, for another unset
    /// number the start of its slider, but at least 0.
    double number(std::size_t entry) const;
    /// Returns the values that are allowed: "0 .. 75 m/s", "one of ...".
    std::string allowed(std::size_t entry) const;

    /// Stores a value from its text. The last writer wins. Returns true if the value has changed.
    /// Throws Error invalid_value for a value that the parameter table or a rule between parameters
    /// refuses; unsupported for names of files, which cannot be set here.
    bool set(std::size_t entry, std::string_view value, std::string_view writer);
    /// Stores a number as set(entry, plain_text(value), writer) does, without the text.
    bool set(std::size_t entry, double value, std::string_view writer);

    /// Grows with every change.
    std::uint64_t revision() const { return revision_; }
    const Parameters& parameters() const { return parameters_; }

  private:
    /// Throws Error not_found with the nearest names.
    [[noreturn]] void refuse_name(std::string_view name) const;
    const AppValue& app_value(std::size_t entry) const;
    void require_app_value(std::size_t entry, std::optional<double> value,
                           std::string_view text) const;
    bool set_app_value(std::size_t entry, double value, std::string_view writer);
    bool set_parameter_value(std::size_t entry, const ParameterValue& value,
                             std::string_view writer);
    bool note_change(std::size_t entry, std::string text, std::string_view writer);

    Parameters parameters_;
    std::vector<ValueEntry> entries_;
    std::vector<ParameterRef> refs_;   // without info for an app value
    std::vector<double> app_numbers_;  // in the order of app_values()
    std::uint64_t revision_ = 0;
};

}  // namespace ocean::bridge
