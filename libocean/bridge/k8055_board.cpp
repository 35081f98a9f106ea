// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "k8055_board.hpp"

#include <utility>

namespace ocean::bridge {
namespace {

constexpr unsigned kOutputTimeout = 1000;  // ms

}  // namespace

void prepare(Board& board, const Wiring& wiring, libusb_device* device, const TransferEnds& ends) {
    board.device = libusb_ref_device(device);
    board.interface = wiring.interface;
    board.in_bytes.assign(wiring.in_size, 0);
    board.in = libusb_alloc_transfer(0);
    board.out = libusb_alloc_transfer(0);
    libusb_fill_interrupt_transfer(board.in, board.handle, wiring.in, board.in_bytes.data(),
                                   static_cast<int>(board.in_bytes.size()), ends.in, ends.user, 0);
    libusb_fill_interrupt_transfer(board.out, board.handle, wiring.out, board.out_bytes.data(),
                                   static_cast<int>(board.out_bytes.size()), ends.out, ends.user,
                                   kOutputTimeout);
    board.fault.reset();
    board.complaint.clear();
    board.reported.reset();
}

void release(Board& board) {
    libusb_free_transfer(std::exchange(board.in, nullptr));
    libusb_free_transfer(std::exchange(board.out, nullptr));
    libusb_release_interface(board.handle, board.interface);  // of a board that left: an error
    libusb_close(std::exchange(board.handle, nullptr));
}

void fail(Board& board, Fault fault) {
    if (!board.fault) board.fault = std::move(fault);
}

void listen(Board& board) {
    const int error = libusb_submit_transfer(board.in);
    board.in_flies = error == 0;
    if (error != 0) fail(board, fault_of(error));
}

void send(Board& board) {
    const int error = libusb_submit_transfer(board.out);
    board.out_flies = error == 0;
    if (error != 0) fail(board, fault_of(error));
}

}  // namespace ocean::bridge
