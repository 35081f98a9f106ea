// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/k8055_source.hpp"

#include "drivers.hpp"
#ifdef OCEAN_HAVE_LIBUSB
#include <algorithm>
#include <list>
#include <mutex>
#include <utility>

#include "k8055_board.hpp"
#include "k8055_report.hpp"
#include "source_thread.hpp"
#include "usb_bus.hpp"
#endif
#include "ocean/error.hpp"

namespace ocean::bridge {

#ifdef OCEAN_HAVE_LIBUSB
namespace {

constexpr std::uint16_t kVelleman = 0x10cf;
constexpr std::uint16_t kFirstProduct = 0x5500;  // plus the address

/// The interval at which a board that could not be opened is tried again, and after which USB is
/// initialised again while no board is open: without udev a system gives no notice of a new device.
constexpr auto kRetryInterval = std::chrono::seconds(2);
/// The time that boards have at the end to accept their last outputs.
constexpr auto kBoardGrace = std::chrono::milliseconds(200);

class K8055Worker {
  public:
    K8055Worker(BoardHost& host, std::vector<K8055Board> boards)
        : host_(host),
          bus_(
              kVelleman, [this](libusb_device* device) { add_candidate(device, Clock::now()); },
              [this](libusb_device* device) { device_left(device); }) {
        for (K8055Board& board : boards) {
            UsbBoard& added = boards_.emplace_back();
            added.channels = k8055_channels(board.id);
            added.id = std::move(board.id);
            added.address = board.device.address;
        }
    }

    void run() {
        while (!host_.is_stopped()) {
            const int error = bus_.open();
            if (error == 0) {
                serve();
            } else {
                host_.busy("USB", usb_error_text(error));
            }
            bus_.close();
            if (error != 0) host_.wait_until(Clock::now() + kRetryInterval);
        }
    }

    void wake() { bus_.interrupt(); }

    void put(const std::string& name, double value) {
        for (UsbBoard& board : boards_) {
            const Channel* channel = find_channel(board.channels, name);
            if (channel == nullptr) continue;
            if (!channel->output) {
                throw Error(ErrorKind::invalid_value,
                            {.what = "is an input of the board", .parameter = name});
            }
            require_in_range(*channel, value);
            const std::size_t output =
                static_cast<std::size_t>(channel - board.channels.data()) - K8055Inputs{}.size();
            {
                const std::lock_guard lock(mutex_);
                board.pending_outputs[output] = static_cast<std::uint8_t>(value + 0.5);
                board.outputs_dirty = true;
            }
            return bus_.interrupt();
        }
        throw Error(ErrorKind::invalid_value,
                    {.what = "is a channel of another board", .parameter = name});
    }

  private:
    /// Serves the boards until the source stops, or until no board has been open for
    /// kRetryInterval.
    void serve() {
        Clock::time_point idle_since = Clock::now();
        while (!host_.is_stopped()) {
            open_candidates();
            bool any_open = false;
            for (UsbBoard& board : boards_) {
                if (board.close_reason) close(board);
                send_if_dirty(board);
                any_open = any_open || board.is_open();
            }
            const auto now = Clock::now();
            if (any_open) idle_since = now;
            if (now - idle_since >= kRetryInterval) return;
            bus_.handle_events(kRetryInterval);
        }
        switch_outputs_off();
        for (UsbBoard& board : boards_) {
            if (board.is_open()) close(board);
        }
    }

    void add_candidate(libusb_device* device, Clock::time_point next_try) {
        const bool is_open = std::ranges::find(boards_, device, &UsbBoard::device) != boards_.end();
        if (!is_open) bus_.add_candidate(device, next_try);
    }

    void device_left(libusb_device* device) {
        for (UsbBoard& board : boards_) {
            if (board.device == device) fail(board, unplugged());
        }
        bus_.forget_candidate(device);
    }

    void open_candidates() {
        bus_.open_due(kRetryInterval, [this](libusb_device* device) {
            libusb_device_descriptor descriptor{};
            libusb_get_device_descriptor(device, &descriptor);
            const int address = static_cast<int>(descriptor.idProduct) - kFirstProduct;
            const auto board = std::ranges::find(boards_, address, &UsbBoard::address);
            return board == boards_.end() || open(*board, device);
        });
    }

    /// Returns false if the board cannot be opened now.
    bool open(UsbBoard& board, libusb_device* device) {
        const auto refused = [&](const std::string& reason) {
            host_.busy(board.id, reason);
            return false;
        };
        if (board.is_open()) return refused("a second board has its address");
        const std::optional<Endpoints> endpoints = endpoints_of(device);
        if (!endpoints) return refused("it does not have the endpoints of a K8055");
        const int error = open_device(board, *endpoints, device);
        if (error != 0) return refused(usb_error_text(error));
        prepare(board, *endpoints, device, {in_ended, out_ended, this});
        board.outputs_dirty = true;  // the kernel's driver has set all outputs to 0
        host_.connected(board.id,
                        "K8055 on bus " + std::to_string(libusb_get_bus_number(device)) +
                            ", device " + std::to_string(libusb_get_device_address(device)),
                        board.channels);
        receive_report(board);
        return true;
    }

    void close(UsbBoard& board) {
        // Cancel pending transfers first: libusb would write into freed buffers.
        while (board.in_transfer_pending || board.out_transfer_pending) {
            if (board.in_transfer_pending) libusb_cancel_transfer(board.in);
            if (board.out_transfer_pending) libusb_cancel_transfer(board.out);
            bus_.handle_events(std::chrono::milliseconds(20));
        }
        release(board);
        libusb_device* device = std::exchange(board.device, nullptr);
        const CloseReason reason = board.close_reason.value_or(CloseReason{});
        board.close_reason.reset();
        host_.lost(board.id, reason.text);
        if (!host_.is_stopped() && !reason.is_unplugged) {
            add_candidate(device, Clock::now() + kRetryInterval);
        }
        libusb_unref_device(device);
    }

    /// Returns the board that has the transfer.
    UsbBoard& owner(const libusb_transfer* transfer) {
        return *std::ranges::find_if(boards_, [&](const UsbBoard& board) {
            return board.in == transfer || board.out == transfer;
        });
    }

    static void LIBUSB_CALL in_ended(libusb_transfer* transfer) {
        auto& worker = *static_cast<K8055Worker*>(transfer->user_data);
        UsbBoard& board = worker.owner(transfer);
        board.in_transfer_pending = false;
        if (auto reason = close_reason_of(transfer)) return fail(board, std::move(*reason));
        worker.report(board, {transfer->buffer, static_cast<std::size_t>(transfer->actual_length)});
        if (!board.close_reason) receive_report(board);
    }

    /// Reports the inputs that have changed since the report before.
    void report(UsbBoard& board, std::span<const std::uint8_t> bytes) {
        const auto now = Clock::now();
        const std::optional<K8055Inputs> inputs = decode_k8055_report(bytes);
        if (!inputs) return;
        for (std::size_t i = 0; i < inputs->size(); ++i) {
            if (board.reported && (*board.reported)[i] == (*inputs)[i]) continue;
            host_.report({now, board.channels[i].name, (*inputs)[i]});
        }
        board.reported = inputs;
    }

    static void LIBUSB_CALL out_ended(libusb_transfer* transfer) {
        UsbBoard& board = static_cast<K8055Worker*>(transfer->user_data)->owner(transfer);
        board.out_transfer_pending = false;
        if (auto reason = close_reason_of(transfer)) fail(board, std::move(*reason));
    }

    /// Sends all outputs in one transfer if put() has changed any since the last one.
    void send_if_dirty(UsbBoard& board) {
        if (!board.is_open() || board.out_transfer_pending || board.close_reason) return;
        {
            const std::lock_guard lock(mutex_);
            if (!board.outputs_dirty.exchange(false)) return;
            board.out_bytes = encode_k8055_outputs(board.pending_outputs);
        }
        send_outputs(board);
    }

    void switch_outputs_off() {
        {
            const std::lock_guard lock(mutex_);
            for (UsbBoard& board : boards_) {
                board.pending_outputs = {};
                board.outputs_dirty = true;
            }
        }
        const auto end = Clock::now() + kBoardGrace;
        const auto is_sending = [](const UsbBoard& board) {
            return board.is_open() && !board.close_reason &&
                   (board.out_transfer_pending || board.outputs_dirty);
        };
        while (std::ranges::any_of(boards_, is_sending) && Clock::now() < end) {
            for (UsbBoard& board : boards_) send_if_dirty(board);
            bus_.handle_events(std::chrono::milliseconds(10));
        }
    }

    BoardHost& host_;
    UsbBus bus_;
    std::list<UsbBoard> boards_;  // elements keep their addresses
    std::mutex mutex_;            // guards the pending outputs
};

}  // namespace

std::unique_ptr<Source> make_k8055_source(std::vector<K8055Board> boards) {
    return std::make_unique<ThreadedSource<K8055Worker>>("USB", std::move(boards));
}

#else

std::unique_ptr<Source> make_k8055_source(std::vector<K8055Board> /*boards*/) {
    throw Error(ErrorKind::unsupported, "this build is without libusb, by which a K8055 is read");
}

#endif

namespace {

K8055Device read_k8055(DeviceSection& section) {
    K8055Device device;
    section.read_keys(
        {{"address", [&] { device.address = section.whole(0, kK8055Addresses - 1); }}});
    return device;
}

/// One thread of libusb serves all boards.
std::unique_ptr<Source> make_all(std::span<const DeviceRule> rules) {
    std::vector<K8055Board> boards;
    for (const DeviceRule& rule : rules)
        boards.push_back({rule.id, *rule.device.get<K8055Device>()});
    return make_k8055_source(std::move(boards));
}

}  // namespace

Driver DriverTable::k8055() {
    return {read_k8055, make_all};
}

}  // namespace ocean::bridge
