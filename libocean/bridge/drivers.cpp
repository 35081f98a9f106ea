// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "drivers.hpp"

namespace ocean::bridge {

std::span<const NamedDriver> drivers() {
#define OCEAN_BRIDGE_ROW(word) NamedDriver{#word, DriverTable::word()},
    static const NamedDriver kDrivers[] = {OCEAN_BRIDGE_DRIVERS(OCEAN_BRIDGE_ROW)};
#undef OCEAN_BRIDGE_ROW
    return kDrivers;
}

}  // namespace ocean::bridge
