// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "k8055_usb.hpp"

#include <span>

#include "k8055_report.hpp"

namespace ocean::bridge {
namespace {

std::optional<Endpoints> endpoints_of(const libusb_interface_descriptor& interface) {
    Endpoints endpoints{.interface = interface.bInterfaceNumber};
    for (const libusb_endpoint_descriptor& end :
         std::span(interface.endpoint, interface.bNumEndpoints)) {
        if ((end.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) != LIBUSB_TRANSFER_TYPE_INTERRUPT ||
            end.wMaxPacketSize < kK8055Bytes) {
            continue;
        }
        if ((end.bEndpointAddress & LIBUSB_ENDPOINT_IN) == 0) {
            endpoints.out = end.bEndpointAddress;
        } else if (endpoints.in == 0) {
            endpoints.in = end.bEndpointAddress;
            endpoints.in_size = end.wMaxPacketSize;
        }
    }
    if (endpoints.in == 0 || endpoints.out == 0) return std::nullopt;
    return endpoints;
}

}  // namespace

std::optional<Endpoints> endpoints_of(libusb_device* device) {
    libusb_config_descriptor* config = nullptr;
    if (libusb_get_active_config_descriptor(device, &config) != 0) return std::nullopt;
    std::optional<Endpoints> found;
    for (const libusb_interface& interface : std::span(config->interface, config->bNumInterfaces)) {
        if (!found && interface.num_altsetting > 0) found = endpoints_of(interface.altsetting[0]);
    }
    libusb_free_config_descriptor(config);
    return found;
}

std::string usb_error_text(int error) {
    if (error == LIBUSB_ERROR_ACCESS) {
        return "may not be opened; the udev rule 60-ocean-bridge.rules allows it";
    }
    if (error == LIBUSB_ERROR_BUSY) return "another program has it";
    return libusb_strerror(static_cast<libusb_error>(error));
}

CloseReason unplugged() {
    return {"unplugged", true};
}
CloseReason close_reason_of(int error) {
    return error == LIBUSB_ERROR_NO_DEVICE ? unplugged() : CloseReason{usb_error_text(error)};
}
std::optional<CloseReason> close_reason_of(const libusb_transfer* transfer) {
    switch (transfer->status) {
        case LIBUSB_TRANSFER_COMPLETED:
            return std::nullopt;
        case LIBUSB_TRANSFER_NO_DEVICE:
            return unplugged();
        case LIBUSB_TRANSFER_STALL:
            return CloseReason{"it refuses the transfer"};
        case LIBUSB_TRANSFER_TIMED_OUT:
            return CloseReason{"it does not answer"};
        default:
            return CloseReason{"a transfer failed"};
    }
}

}  // namespace ocean::bridge
