// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What everything is now: the latest value of each parameter of the sea and of the application, who
// wrote it, and when in the order of all changes. The one thing that boards, clients and recorders
// share. For one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/parameter_table.hpp"

namespace ocean::bridge {

/// A value of the application that shows the sea: no part of the sea, in no take.
struct AppValue {
    std::string_view name;
    double lowest;
    double highest;
    double start;
    bool whole;
    std::string_view help;
};
std::span<const AppValue> app_values();

struct ValueEntry {
    std::string name;           // the parameter's path, or "app.pause"
    std::string text;           // "unset" where a parameter without a default has none
    std::string writer;         // "" before anybody wrote it
    std::uint64_t changed = 0;  // revision at which the text became what it is
    std::uint64_t taken = 0;    // revision at which this writer took it over from another
};

/// What an unset value is called on the wire.
inline constexpr std::string_view kUnset = "unset";
/// Returns a value of any table as VAL and UPD spell it and SET reads it: a number, a word, true or
/// false, [1, 7], or "unset".
std::string wire_text(const ParameterSpec& spec, const ParameterValue& value);

class ValueTable {
  public:
    /// Of a valid sea.
    explicit ValueTable(Parameters parameters = {});

    std::span<const ValueEntry> entries() const { return entries_; }
    const ValueEntry& operator[](std::size_t entry) const { return entries_[entry]; }
    /// By a path or a bare key, as the parameter table finds them. Throws Error not_found.
    std::size_t find(std::string_view name) const;
    /// The table's parameter; nothing of an app value.
    const ParameterInfo* parameter(std::size_t entry) const { return refs_[entry].info; }
    ParameterRef ref(std::size_t entry) const { return refs_[entry]; }
    /// A number that knobs may turn, not a word, text or list.
    bool is_number(std::size_t entry) const;
    /// A number without a fraction.
    bool is_whole(std::size_t entry) const;
    /// Of a number, what is in effect if it is unset.
    double number(std::size_t entry) const;
    /// "0 .. 75 m/s", "one of ...".
    std::string allowed(std::size_t entry) const;

    /// The last writer wins. True if the value is another now. Throws Error invalid_value for one
    /// that the parameter table or a rule between parameters refuses; unsupported for names of
    /// files, which nobody sets from outside.
    bool set(std::size_t entry, std::string_view value, std::string_view writer);

    /// Grows with every change.
    std::uint64_t revision() const { return revision_; }
    const Parameters& parameters() const { return parameters_; }

  private:
    const AppValue& app_value(std::size_t entry) const;
    std::string checked_app_value(std::size_t entry, std::string_view value) const;

    Parameters parameters_;
    std::vector<ValueEntry> entries_;
    std::vector<ParameterRef> refs_;  // without info: an app value
    std::uint64_t revision_ = 0;
};

}  // namespace ocean::bridge
