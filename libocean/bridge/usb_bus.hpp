// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// libusb as the K8055's source needs it: the context, the notices of devices that come and go, and
// the devices that wait to be opened.
#pragma once

#include <libusb.h>

#include <cstdint>
#include <functional>
#include <list>
#include <mutex>
#include <utility>

#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge {

class UsbBus {
  public:
    /// Watches devices of one vendor. `arrived` and `left` are called in open() and
    /// handle_events(), where a device must not be opened. A device may arrive twice, or leave
    /// without a notice.
    UsbBus(std::uint16_t vendor, std::function<void(libusb_device*)> arrived,
           std::function<void(libusb_device*)> left)
        : vendor_(vendor), arrived_(std::move(arrived)), left_(std::move(left)) {}
    ~UsbBus() { close(); }
    UsbBus(const UsbBus&) = delete;
    UsbBus& operator=(const UsbBus&) = delete;

    /// Returns 0, or an error of libusb. In either case close() may be called.
    int open();
    void close();
    /// Ends the current handle_events(), or the next one if none is running. Any thread.
    void interrupt();
    /// Handles events of libusb. Blocks until one comes, interrupt(), or the time is over.
    void handle_events(Clock::duration limit);

    /// Adds a device, of which the bus keeps a reference. A device is listed once.
    void add_candidate(libusb_device* device, Clock::time_point next_try);
    void forget_candidate(libusb_device* device);
    /// Calls open(device) for each candidate that is due. If it returns true the device is removed,
    /// else it is due again after `pause`.
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
    static int LIBUSB_CALL hotplug(libusb_context* context, libusb_device* device,
                                   libusb_hotplug_event event, void* self);

    const std::uint16_t vendor_;
    const std::function<void(libusb_device*)> arrived_;
    const std::function<void(libusb_device*)> left_;
    std::list<Candidate> candidates_;
    libusb_hotplug_callback_handle hotplug_{};
    std::mutex mutex_;
    libusb_context* context_ = nullptr;  // the source's thread sets it under the mutex
};

}  // namespace ocean::bridge
