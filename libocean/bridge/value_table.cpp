// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/value_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/text.hpp"

namespace ocean::bridge {
namespace {

constexpr std::array kAppValues = {
    AppValue{"app.pause", 0, 1, 0, true, "1 while the sea's clock stands"},
    AppValue{"app.speed", 0, 100, 1, false, "seconds of the sea a second"},
    AppValue{"app.time", -kLatestTime, kLatestTime, 0, false, "time of the sea, s"},
    AppValue{"app.record", 0, 1, 0, true, "1 while a take is recorded"},
    AppValue{"app.frame_rate", 0, 1e6, 0, false, "frames that are shown a second"},
};

/// Names of files are for those who own the machine.
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
    for (const ParameterInfo& info : parameter_table()) {
        if (!info.in_list()) add({&info, 0});
    }
    for (std::size_t wave = 0; wave < parameters_.waves.size(); ++wave) {
        for (const ParameterInfo& info : parameter_table()) {
            if (info.in_list()) add({&info, wave});
        }
    }
    for (const AppValue& value : kAppValues) {
        entries_.push_back({std::string(value.name), plain_text(value.start), "", 0, 0});
        refs_.push_back({});
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
        } catch (const Error& error) {
            throw Error(ErrorKind::not_found, text::printable(error.what(), 300));
        }
    }
    if (found < entries_.size()) return found;
    std::vector<std::string_view> known;
    for (const ValueEntry& entry : entries_) known.push_back(entry.name);
    const std::string_view nearest = nearest_name(name, known);
    throw Error(ErrorKind::not_found,
                "unknown name '" + text::printable(name) + "'" +
                    (nearest.empty() ? "" : "; did you mean " + std::string(nearest) + "?"));
}

/// They stand behind the parameters.
const AppValue& ValueTable::app_value(std::size_t entry) const {
    return kAppValues[entry + kAppValues.size() - entries_.size()];
}

bool ValueTable::is_number(std::size_t entry) const {
    const ParameterInfo* info = refs_[entry].info;
    return info == nullptr || info->type() == "float" || info->type() == "int";
}

bool ValueTable::is_whole(std::size_t entry) const {
    if (refs_[entry].info != nullptr) return refs_[entry].info->type() == "int";
    return app_value(entry).whole;
}

double ValueTable::number(std::size_t entry) const {
    if (const auto number = text::parse_number(entries_[entry].text)) return *number;
    const ParameterInfo& info = *refs_[entry].info;
    return info.key == "wind_speed" ? kDefaultWind : std::max(info.soft_min, 0.0);
}

std::string ValueTable::allowed(std::size_t entry) const {
    if (refs_[entry].info != nullptr) return allowed_values(*refs_[entry].info);
    const AppValue& app = app_value(entry);
    if (app.whole) return plain_text(app.lowest) + " or " + plain_text(app.highest);
    return plain_text(app.lowest) + " .. " + plain_text(app.highest);
}

std::string ValueTable::checked_app_value(std::size_t entry, std::string_view value) const {
    const AppValue& app = app_value(entry);
    const std::optional<double> number = text::parse_number(value);
    if (!number || !(*number >= app.lowest && *number <= app.highest) ||
        (app.whole && *number != std::floor(*number))) {
        throw Error(ErrorKind::invalid_value, std::string(app.name) + " = " +
                                                  text::printable(value) +
                                                  ": allowed: " + allowed(entry));
    }
    return plain_text(*number);
}

bool ValueTable::set(std::size_t entry, std::string_view value, std::string_view writer) {
    ValueEntry& target = entries_[entry];
    const ParameterRef& ref = refs_[entry];
    std::string text;
    if (ref.info == nullptr) {
        text = checked_app_value(entry, value);
    } else {
        if (names_a_file(*ref.info)) {
            throw Error(ErrorKind::unsupported,
                        target.name + ": names of files are not set from outside");
        }
        Parameters changed = parameters_;
        set_parameter(changed, target.name, value == kUnset ? "" : value);
        validate(changed);
        text = wire_text(*ref.info, value_of(changed, ref));
        parameters_ = std::move(changed);
    }
    const bool another_writer = target.writer != writer;
    const bool another_value = target.text != text;
    if (another_writer || another_value) ++revision_;
    if (another_writer) {
        target.writer = writer;
        target.taken = revision_;
    }
    if (another_value) {
        target.text = std::move(text);
        target.changed = revision_;
    }
    return another_value;
}

}  // namespace ocean::bridge
