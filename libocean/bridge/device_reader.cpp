// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "device_reader.hpp"

#include <algorithm>

#include "drivers.hpp"
#include "ocean/internal/bridge/source.hpp"
#include "section_reader.hpp"

namespace ocean::bridge {
namespace {

const Driver& driver_named(const SectionReader& section) {
    const auto row = std::ranges::find(drivers(), section.text(), &NamedDriver::name);
    if (row == drivers().end()) {
        std::vector<std::string_view> names;
        for (const NamedDriver& known : drivers()) names.push_back(known.name);
        throw section.refused_word(names);
    }
    return row->driver;
}

const std::string& checked_id(const SectionReader& section) {
    if (is_channel_name(section.text() + "/a1")) return section.text();
    throw section.refused("lower-case letters, digits and '_', such as board0");
}

}  // namespace

DeviceRule read_device(const TomlSection& section, const std::string& file,
                       const std::vector<DeviceRule>& before) {
    SectionReader common(section, file);
    const Driver* driver = nullptr;
    std::string id;
    while (common.next()) {
        if (common.key() == "driver") driver = &driver_named(common);
        if (common.key() == "id") id = checked_id(common);
    }
    if (id.empty()) throw common.fail("id is missing");
    if (driver == nullptr)
        throw common.fail("driver is missing; allowed: " +
                          joined(drivers(), ", ", &NamedDriver::name));
    if (std::ranges::find(before, id, &DeviceRule::id) != before.end()) {
        throw common.fail("id = \"" + id + "\" is used twice");
    }
    DeviceSection settings(section, file);
    return {id, driver->read(settings)};
}

}  // namespace ocean::bridge
