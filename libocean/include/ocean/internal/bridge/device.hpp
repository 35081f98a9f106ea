// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A board as a control map names it: an id and the settings of its driver. This header knows no
// driver; each driver defines its own settings, such as K8055Device in k8055_source.hpp.
#pragma once

#include <any>
#include <concepts>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <utility>

namespace ocean::bridge {

/// The settings of one board, a value of the type that its driver defines.
class DeviceSettings {
  public:
    template <typename Settings>
    requires(!std::is_same_v<Settings, DeviceSettings> && std::copyable<Settings> &&
             std::equality_comparable<Settings>) DeviceSettings(Settings settings)
        : value_(std::move(settings)), is_equal_([](const std::any& a, const std::any& b) {
              return *std::any_cast<Settings>(&a) == *std::any_cast<Settings>(&b);
          }) {}

    /// Returns the settings if they have this type, else nullptr.
    template <typename Settings>
    const Settings* get() const {
        return std::any_cast<Settings>(&value_);
    }
    const std::type_info& type() const { return value_.type(); }
    bool operator==(const DeviceSettings& other) const {
        return type() == other.type() && is_equal_(value_, other.value_);
    }

  private:
    std::any value_;
    bool (*is_equal_)(const std::any&, const std::any&);
};

/// A board with the name that its channels begin with: board "midi0" has "midi0/cc7".
struct DeviceRule {
    std::string id;
    DeviceSettings device;

    bool operator==(const DeviceRule&) const = default;
};

}  // namespace ocean::bridge
