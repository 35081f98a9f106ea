// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One K8055 with its two USB transfers: reports come in by one, outputs go out by the other.
#pragma once

#include <libusb.h>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "k8055_report.hpp"
#include "ocean/internal/bridge/source.hpp"

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

/// A board of the control map, open or not. Members that are not marked belong to the source's
/// thread.
struct UsbBoard {
    std::string id;
    int address = 0;
    std::vector<Channel> channels;
    K8055Outputs pending_outputs{};           // under the source's mutex
    std::atomic<bool> outputs_dirty = false;  // true until pending_outputs are sent

    libusb_device* device = nullptr;  // a reference, while the board is open
    libusb_device_handle* handle = nullptr;
    int interface = 0;
    libusb_transfer* in = nullptr;
    libusb_transfer* out = nullptr;
    std::vector<std::uint8_t> in_bytes;
    std::array<std::uint8_t, kK8055Bytes> out_bytes{};
    bool in_transfer_pending = false;
    bool out_transfer_pending = false;
    std::optional<CloseReason> close_reason;  // set when the board must be closed
    std::optional<K8055Inputs> reported;

    bool is_open() const { return handle != nullptr; }
};

/// The functions that libusb calls at the end of a transfer, and their user_data.
struct TransferCallbacks {
    libusb_transfer_cb_fn in;
    libusb_transfer_cb_fn out;
    void* user;
};

/// Opens the device and claims its interface. Returns 0, or an error of libusb after which the
/// board is not open.
int open_device(UsbBoard& board, const Endpoints& endpoints, libusb_device* device);

/// Takes a reference of the device and allocates the transfers of an open board. Leaves the members
/// under the source's mutex as they are.
void prepare(UsbBoard& board, const Endpoints& endpoints, libusb_device* device,
             const TransferCallbacks& callbacks);

/// Frees the transfers, neither of which may be pending, and closes the handle. Keeps the reference
/// of the device.
void release(UsbBoard& board);

/// Requests that the board is closed. The first reason is kept: it causes the others.
void fail(UsbBoard& board, CloseReason reason);

/// Submits the transfer of the inputs. Calls fail() if libusb refuses it.
void receive_report(UsbBoard& board);

/// Submits the transfer of `out_bytes`. Calls fail() if libusb refuses it.
void send_outputs(UsbBoard& board);

}  // namespace ocean::bridge
