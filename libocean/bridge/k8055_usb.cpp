// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "k8055_usb.hpp"

#include <algorithm>
#include <span>

#include "k8055_report.hpp"

namespace ocean::bridge {
namespace {

std::optional<Wiring> wiring_of(const libusb_interface_descriptor& interface) {
    Wiring wiring{.interface = interface.bInterfaceNumber};
    for (const libusb_endpoint_descriptor& end :
         std::span(interface.endpoint, interface.bNumEndpoints)) {
        if ((end.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) != LIBUSB_TRANSFER_TYPE_INTERRUPT ||
            end.wMaxPacketSize < kK8055Bytes) {
            continue;
        }
        if ((end.bEndpointAddress & LIBUSB_ENDPOINT_IN) == 0) {
            wiring.out = end.bEndpointAddress;
        } else if (wiring.in == 0) {
            wiring.in = end.bEndpointAddress;
            wiring.in_size = end.wMaxPacketSize;
        }
    }
    if (wiring.in == 0 || wiring.out == 0) return std::nullopt;
    return wiring;
}

}  // namespace

std::optional<Wiring> wiring_of(libusb_device* device) {
    libusb_config_descriptor* config = nullptr;
    if (libusb_get_active_config_descriptor(device, &config) != 0) return std::nullopt;
    std::optional<Wiring> found;
    for (const libusb_interface& interface : std::span(config->interface, config->bNumInterfaces)) {
        if (!found && interface.num_altsetting > 0) found = wiring_of(interface.altsetting[0]);
    }
    libusb_free_config_descriptor(config);
    return found;
}

std::string why(int error) {
    if (error == LIBUSB_ERROR_ACCESS) {
        return "may not be opened; the udev rule 60-ocean-bridge.rules allows it";
    }
    if (error == LIBUSB_ERROR_BUSY) return "another program has it";
    return libusb_strerror(static_cast<libusb_error>(error));
}

Fault unplugged() {
    return {"unplugged", true};
}
Fault fault_of(int error) {
    return error == LIBUSB_ERROR_NO_DEVICE ? unplugged() : Fault{why(error)};
}
std::optional<Fault> fault_of(const libusb_transfer* transfer) {
    switch (transfer->status) {
        case LIBUSB_TRANSFER_COMPLETED:
            return std::nullopt;
        case LIBUSB_TRANSFER_NO_DEVICE:
            return unplugged();
        case LIBUSB_TRANSFER_STALL:
            return Fault{"it refuses the transfer"};
        case LIBUSB_TRANSFER_TIMED_OUT:
            return Fault{"it does not answer"};
        default:
            return Fault{"a transfer failed"};
    }
}

void UsbCandidates::add(libusb_device* device, Clock::time_point next_try) {
    if (std::ranges::find(candidates_, device, &Candidate::device) != candidates_.end()) return;
    candidates_.push_back({libusb_ref_device(device), next_try});
}

void UsbCandidates::forget(libusb_device* device) {
    std::erase_if(candidates_, [&](const Candidate& candidate) {
        if (candidate.device != device) return false;
        libusb_unref_device(device);
        return true;
    });
}

void UsbCandidates::clear() {
    for (const Candidate& candidate : candidates_) libusb_unref_device(candidate.device);
    candidates_.clear();
}

}  // namespace ocean::bridge
