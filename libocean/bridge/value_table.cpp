// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/value_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::bridge {
namespace {

constexpr std::array kAppValues = {
    AppValue{"app.pause", 0, 1, 0, true, "1 while the sea's clock is paused"},
    AppValue{"app.speed", 0, 100, 1, false, "seconds of the sea per second"},
    AppValue{"app.time", -kLatestTime, kLatestTime, 0, false, "time of the sea [s]"},
    AppValue{"app.record", 0, 1, 0, true, "1 while a take is recorded"},
    AppValue{"app.frame_rate", 0, 1e6, 0, false, "frames shown per second"},
    AppValue{"app.hull.drive", 0, kMaxHulls, 0, true, "the driven hull, 1 is the first; 0: none"},
    AppValue{"app.hull.speed", 0, kMaxHullSpeed, 0, false, "speed that it takes up [m/s]"},
    AppValue{"app.hull.heading", -360, 360, 0, false,
             "heading that it turns to [degrees counter-clockwise from +x]"},
};

/// Returns true for a name of a file, which only the owner of the machine may set.
bool names_a_file(const ParameterSpec& spec) {
    return spec.type() == "text";
}

}  // namespace

std::span<const AppValue> app_values() {
    return kAppValues;
}

std::string wire_text(const ParameterSpec& spec, const ParameterValue& value) {
    return spec.is_unset(value) ? std::string(kUnset) : to_text(value);
}

ValueTable::ValueTable(Parameters parameters) : parameters_(std::move(parameters)) {
    const auto add = [this](const ParameterRef& ref) {
        const std::string text = wire_text(*ref.info, value_of(parameters_, ref));
        entries_.push_back({ref.info->path(ref.item), text, "", 0, 0});
        refs_.push_back(ref);
    };
    for (const TableSection& section : sea_table().sections) {
        for (std::size_t item = 0; item < items_of(sea_table(), section.name, parameters_);
             ++item) {
            for (const ParameterInfo& info : parameter_table()) {
                if (info.section == section.name) add({&info, item});
            }
        }
    }
    for (const AppValue& value : kAppValues) {
        entries_.push_back({std::string(value.name), plain_text(value.initial), "", 0, 0});
        refs_.push_back({});
        app_numbers_.push_back(value.initial);
    }
}

std::size_t ValueTable::find(std::string_view name) const {
    const auto entry_of = [this](const auto& is_it) -> std::size_t {
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            if (is_it(i)) return i;
        }
        return entries_.size();
    };
    std::size_t found = entry_of([&](std::size_t i) { return entries_[i].name == name; });
    if (found == entries_.size() && !name.starts_with("app.")) {
        try {
            const ParameterRef ref = find_parameter(name);
            found = entry_of(
                [&](std::size_t i) { return refs_[i].info != nullptr && refs_[i].same_as(ref); });
        } catch (const Error&) {
            // refuse_name() suggests names of app.* too.
        }
    }
    if (found == entries_.size()) refuse_name(name);
    return found;
}

void ValueTable::refuse_name(std::string_view name) const {
    std::deque<std::string> texts;  // its elements stay where they are
    std::vector<KnownName> known;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const std::string_view path = entries_[i].name;
        known.push_back({path, path});
        const ParameterInfo* info = refs_[i].info;
        if (info == nullptr || refs_[i].item != 0) continue;
        known.push_back({info->key, path});
        known.push_back(
            {texts.emplace_back(std::string(info->section) + "." + std::string(info->key)), path});
    }
    const std::string meant = did_you_mean(name, known);
    throw Error(ErrorKind::not_found,
                "unknown name '" + text::printable(name) + "'" +
                    (meant.empty() ? "; `ocean params` lists parameters, LIST all names" : meant));
}

/// The app values are the last entries.
const AppValue& ValueTable::app_value(std::size_t entry) const {
    return kAppValues[entry + kAppValues.size() - entries_.size()];
}

bool ValueTable::is_number(std::size_t entry) const {
    const ParameterInfo* info = refs_[entry].info;
    return info == nullptr || info->type() == "float" || info->type() == "int";
}

bool ValueTable::is_whole(std::size_t entry) const {
    if (refs_[entry].info != nullptr) return refs_[entry].info->type() == "int";
    return app_value(entry).is_whole;
}

double ValueTable::number(std::size_t entry) const {
    const ParameterInfo* info = refs_[entry].info;
    if (info == nullptr) return app_numbers_[entry + kAppValues.size() - entries_.size()];
    const ParameterValue value = value_of(parameters_, refs_[entry]);
    if (const auto* real = std::get_if<double>(&value)) return *real;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    return info->key == "wind_speed" ? kDefaultWind : std::max(info->soft_min, 0.0);
}

std::string ValueTable::allowed(std::size_t entry) const {
    if (refs_[entry].info != nullptr) return allowed_values(*refs_[entry].info);
    const AppValue& app = app_value(entry);
    const bool is_switch = app.is_whole && app.max - app.min == 1.0;
    return plain_text(app.min) + (is_switch ? " or " : " .. ") + plain_text(app.max);
}

void ValueTable::require_app_value(std::size_t entry, std::optional<double> value,
                                   std::string_view text) const {
    const AppValue& app = app_value(entry);
    if (value && *value >= app.min && *value <= app.max &&
        (!app.is_whole || *value == std::floor(*value))) {
        return;
    }
    throw Error(ErrorKind::invalid_value, std::string(app.name) + " = " + text::printable(text) +
                                              ": allowed: " + allowed(entry));
}

bool ValueTable::set(std::size_t entry, std::string_view value, std::string_view writer) {
    const ParameterRef& ref = refs_[entry];
    if (ref.info == nullptr) {
        const std::optional<double> number = text::parse_number(value);
        require_app_value(entry, number, value);
        return set_app_value(entry, *number, writer);
    }
    if (names_a_file(*ref.info)) {
        throw Error(ErrorKind::unsupported,
                    entries_[entry].name + ": names of files cannot be set by clients");
    }
    return set_parameter_value(
        entry, parse_value(*ref.info, ref.item, value == kUnset ? "" : value), writer);
}

bool ValueTable::set(std::size_t entry, double value, std::string_view writer) {
    if (refs_[entry].info != nullptr) return set_parameter_value(entry, value, writer);
    require_app_value(entry, value, plain_text(value));
    return set_app_value(entry, value, writer);
}

bool ValueTable::set_app_value(std::size_t entry, double value, std::string_view writer) {
    app_numbers_[entry + kAppValues.size() - entries_.size()] = value;
    return note_change(entry, plain_text(value), writer);
}

bool ValueTable::set_parameter_value(std::size_t entry, const ParameterValue& value,
                                     std::string_view writer) {
    const ParameterRef& ref = refs_[entry];
    Parameters changed = parameters_;
    assign(changed, ref, value);
    validate(changed);
    std::string text = wire_text(*ref.info, value_of(changed, ref));
    parameters_ = std::move(changed);
    return note_change(entry, std::move(text), writer);
}

bool ValueTable::note_change(std::size_t entry, std::string text, std::string_view writer) {
    ValueEntry& target = entries_[entry];
    const bool is_another_writer = target.writer != writer;
    const bool is_another_value = target.text != text;
    if (is_another_writer || is_another_value) ++revision_;
    if (is_another_writer) {
        target.writer = writer;
        target.taken = revision_;
    }
    if (is_another_value) {
        target.text = std::move(text);
        target.changed = revision_;
    }
    return is_another_value;
}

}  // namespace ocean::bridge
