// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "k8055_board.hpp"

#include <span>
#include <utility>

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

constexpr unsigned kOutputTimeout = 1000;  // [ms]

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

int open_device(UsbBoard& board, const Endpoints& endpoints, libusb_device* device) {
    int error = libusb_open(device, &board.handle);
    if (error != 0) {
        board.handle = nullptr;
        return error;
    }
    libusb_set_auto_detach_kernel_driver(board.handle, 1);  // vmk80xx
    error = libusb_claim_interface(board.handle, endpoints.interface);
    if (error != 0) libusb_close(std::exchange(board.handle, nullptr));
    return error;
}

void prepare(UsbBoard& board, const Endpoints& endpoints, libusb_device* device,
             const TransferCallbacks& callbacks) {
    board.device = libusb_ref_device(device);
    board.interface = endpoints.interface;
    board.in_bytes.assign(endpoints.in_size, 0);
    board.in = libusb_alloc_transfer(0);
    board.out = libusb_alloc_transfer(0);
    libusb_fill_interrupt_transfer(board.in, board.handle, endpoints.in, board.in_bytes.data(),
                                   static_cast<int>(board.in_bytes.size()), callbacks.in,
                                   callbacks.user, 0);
    libusb_fill_interrupt_transfer(board.out, board.handle, endpoints.out, board.out_bytes.data(),
                                   static_cast<int>(board.out_bytes.size()), callbacks.out,
                                   callbacks.user, kOutputTimeout);
    board.close_reason.reset();
    board.reported.reset();
}

void release(UsbBoard& board) {
    libusb_free_transfer(std::exchange(board.in, nullptr));
    libusb_free_transfer(std::exchange(board.out, nullptr));
    libusb_release_interface(board.handle, board.interface);  // fails for an unplugged board
    libusb_close(std::exchange(board.handle, nullptr));
}

void fail(UsbBoard& board, CloseReason reason) {
    if (!board.close_reason) board.close_reason = std::move(reason);
}

void receive_report(UsbBoard& board) {
    const int error = libusb_submit_transfer(board.in);
    board.in_transfer_pending = error == 0;
    if (error != 0) fail(board, close_reason_of(error));
}

void send_outputs(UsbBoard& board) {
    const int error = libusb_submit_transfer(board.out);
    board.out_transfer_pending = error == 0;
    if (error != 0) fail(board, close_reason_of(error));
}

}  // namespace ocean::bridge
