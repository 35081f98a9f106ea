// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "k8055_board.hpp"

#include <utility>

namespace ocean::bridge {
namespace {

constexpr unsigned kOutputTimeout = 1000;  // [ms]

}  // namespace

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
