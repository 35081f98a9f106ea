// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "usb_bus.hpp"

#include <algorithm>
#include <ctime>

namespace ocean::bridge {
namespace {

timeval interval(Clock::duration duration) {
    const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(duration).count();
    return {static_cast<time_t>(whole / 1'000'000), static_cast<suseconds_t>(whole % 1'000'000)};
}

}  // namespace

int UsbBus::open() {
    libusb_context* context = nullptr;
    const int error = libusb_init(&context);
    if (error != 0) return error;
    {
        const std::lock_guard lock(mutex_);
        context_ = context;
    }
    return libusb_hotplug_register_callback(
        context,
        static_cast<libusb_hotplug_event>(LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED |
                                          LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT),
        LIBUSB_HOTPLUG_ENUMERATE, vendor_, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY,
        hotplug, this, &hotplug_);
}

void UsbBus::close() {
    libusb_context* context = nullptr;
    {
        const std::lock_guard lock(mutex_);
        context = std::exchange(context_, nullptr);
    }
    if (context == nullptr) return;
    libusb_hotplug_deregister_callback(context, hotplug_);
    for (const Candidate& candidate : candidates_) libusb_unref_device(candidate.device);
    candidates_.clear();
    libusb_exit(context);
}

void UsbBus::interrupt() {
    const std::lock_guard lock(mutex_);
    if (context_ != nullptr) libusb_interrupt_event_handler(context_);
}

void UsbBus::handle_events(Clock::duration limit) {
    timeval timeout = interval(limit);
    libusb_handle_events_timeout_completed(context_, &timeout, nullptr);
}

void UsbBus::add_candidate(libusb_device* device, Clock::time_point next_try) {
    if (std::ranges::find(candidates_, device, &Candidate::device) != candidates_.end()) return;
    candidates_.push_back({libusb_ref_device(device), next_try});
}

void UsbBus::forget_candidate(libusb_device* device) {
    std::erase_if(candidates_, [&](const Candidate& candidate) {
        if (candidate.device != device) return false;
        libusb_unref_device(device);
        return true;
    });
}

int LIBUSB_CALL UsbBus::hotplug(libusb_context* /*context*/, libusb_device* device,
                                libusb_hotplug_event event, void* self) {
    const auto& bus = *static_cast<UsbBus*>(self);
    (event == LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED ? bus.arrived_ : bus.left_)(device);
    return 0;
}

}  // namespace ocean::bridge
