// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What libusb says of a K8055: where its reports come from, why it cannot be used, which devices
// wait to be opened.
#pragma once

#include <libusb.h>

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <string>

#include "ocean/bridge/source.hpp"

namespace ocean::bridge {

/// Addresses of the endpoints through which reports come and outputs go: those of the first
/// interface that has both as interrupts, whatever numbers they have.
struct Wiring {
    int interface = 0;
    std::uint8_t in = 0;
    std::uint8_t out = 0;
    std::size_t in_size = 0;
};

/// Nothing of a device without such an interface.
std::optional<Wiring> wiring_of(libusb_device* device);

/// An error of libusb in words.
std::string why(int error);

/// Why a board is to be closed.
struct Fault {
    std::string text;
    bool is_unplugged = false;
};

Fault unplugged();
Fault fault_of(int error);
/// Nothing of a transfer that was completed.
std::optional<Fault> fault_of(const libusb_transfer* transfer);

/// Devices that could be opened, each with a reference: cleared before libusb ends.
class UsbCandidates {
  public:
    /// Once, however often it is told.
    void add(libusb_device* device, Clock::time_point next_try);
    void forget(libusb_device* device);
    void clear();
    /// Calls open(device) for those that are due. One for which it returns true is no candidate any
    /// more; any other is due again after `pause`.
    template <typename Open>
    void open_due(Clock::duration pause, const Open& open) {
        const auto now = Clock::now();
        for (auto candidate = candidates_.begin(); candidate != candidates_.end();) {
            const auto current = candidate++;
            if (current->next_try > now) continue;
            if (!open(current->device)) {
                current->next_try = now + pause;
                continue;
            }
            libusb_unref_device(current->device);
            candidates_.erase(current);
        }
    }

  private:
    struct Candidate {
        libusb_device* device;
        Clock::time_point next_try;
    };
    std::list<Candidate> candidates_;
};

}  // namespace ocean::bridge
