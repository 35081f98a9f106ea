// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A K8055 as libusb describes it: its endpoints, and the reasons for which it cannot be used.
#pragma once

#include <libusb.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace ocean::bridge {

/// Addresses of the endpoints for reports (in) and outputs (out): those of the first interface that
/// has both as interrupt endpoints.
struct Endpoints {
    int interface = 0;
    std::uint8_t in = 0;
    std::uint8_t out = 0;
    std::size_t in_size = 0;
};

/// Returns nothing for a device without such an interface.
std::optional<Endpoints> endpoints_of(libusb_device* device);

/// Returns an error of libusb in words.
std::string usb_error_text(int error);

/// The reason for which a board is closed.
struct CloseReason {
    std::string text;
    bool is_unplugged = false;
};

CloseReason unplugged();
CloseReason close_reason_of(int error);
/// Returns nothing for a transfer that was completed.
std::optional<CloseReason> close_reason_of(const libusb_transfer* transfer);

}  // namespace ocean::bridge
