// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A K8055 as a source keeps it: its outputs, and the two transfers that libusb has of it.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "k8055_report.hpp"
#include "k8055_usb.hpp"
#include "ocean/bridge/source.hpp"

namespace ocean::bridge {

/// One configured address. What libusb holds of it belongs to the thread of the source.
struct Board {
    std::string id;
    int address = 0;
    std::vector<Channel> channels;
    K8055Outputs told{};  // under the source's lock
    bool there = false;   // so is this
    std::atomic<bool> to_tell = false;

    libusb_device* device = nullptr;  // a reference, while it is open
    libusb_device_handle* handle = nullptr;
    int interface = 0;
    libusb_transfer* in = nullptr;
    libusb_transfer* out = nullptr;
    std::vector<std::uint8_t> in_bytes;
    std::array<std::uint8_t, kK8055Bytes> out_bytes{};
    bool in_flies = false;
    bool out_flies = false;
    std::optional<Fault> fault;  // why it is to be closed
    std::optional<K8055Inputs> reported;
    std::string complaint;  // last one, said once
};

/// The functions that libusb calls when a transfer ends, and their user_data.
struct TransferEnds {
    libusb_transfer_cb_fn in;
    libusb_transfer_cb_fn out;
    void* user;
};

/// Takes a reference of the device, and makes the transfers of a board whose handle is open. Leaves
/// alone what is under the source's lock.
void prepare(Board& board, const Wiring& wiring, libusb_device* device, const TransferEnds& ends);

/// Frees the transfers, none of which flies, and closes the handle. The reference of the device
/// stays.
void release(Board& board);

/// Notes why the board is to be closed: the first fault is the cause of those that follow.
void fail(Board& board, Fault fault);

/// Submits the transfer of the inputs. The board fails where libusb refuses it.
void listen(Board& board);

/// Submits the transfer of `out_bytes`. The board fails where libusb refuses it.
void send(Board& board);

}  // namespace ocean::bridge
