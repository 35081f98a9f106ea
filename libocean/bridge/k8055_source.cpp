// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/k8055_source.hpp"

#ifdef OCEAN_HAVE_LIBUSB
#include <libusb.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <list>
#include <mutex>
#include <thread>
#include <utility>

#include "k8055_report.hpp"
#include "ocean/text.hpp"
#endif
#include "ocean/error.hpp"

namespace ocean::bridge {

#ifdef OCEAN_HAVE_LIBUSB
namespace {

constexpr std::uint16_t kVelleman = 0x10cf;
constexpr std::uint16_t kFirstProduct = 0x5500;  // and the address

/// How soon a board that could not be opened is tried again, and USB itself where no board is: a
/// system without udev tells nobody of a new one.
constexpr auto kTryAgain = std::chrono::seconds(2);
constexpr auto kLastWords = std::chrono::milliseconds(200);
constexpr unsigned kOutputTimeout = 1000;  // ms

timeval interval(Clock::duration duration) {
    const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(duration).count();
    return {static_cast<time_t>(whole / 1'000'000), static_cast<suseconds_t>(whole % 1'000'000)};
}

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
    std::string fault;  // why it is to be closed
    std::optional<K8055Inputs> reported;
    std::string complaint;  // last one, said once
};

/// Addresses of the endpoints through which reports come and outputs go: those of the first
/// interface that has both as interrupts, whatever numbers they have.
struct Wiring {
    int interface = 0;
    std::uint8_t in = 0;
    std::uint8_t out = 0;
    std::size_t in_size = 0;
};

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

class K8055Source : public Source {
  public:
    explicit K8055Source(std::vector<K8055Board> boards) {
        for (K8055Board& board : boards) {
            Board& added = boards_.emplace_back();
            added.channels = k8055_channels(board.id);
            added.id = std::move(board.id);
            added.address = board.device.address;
        }
    }
    ~K8055Source() override { stop(); }

    std::vector<Channel> channels() const override {
        const std::lock_guard lock(mutex_);
        std::vector<Channel> channels;
        for (const Board& board : boards_) {
            if (!board.there) continue;
            channels.insert(channels.end(), board.channels.begin(), board.channels.end());
        }
        return channels;
    }

    void start(Listener listener) override {
        listener_ = std::move(listener);
        thread_ = std::thread([this] { run(); });
    }

    void stop() override {
        {
            const std::lock_guard lock(mutex_);
            stopped_ = true;
            if (context_ != nullptr) libusb_interrupt_event_handler(context_);
        }
        stop_asked_.notify_all();
        if (thread_.joinable()) thread_.join();
    }

    void put(const std::string& name, double value) override {
        for (Board& board : boards_) {
            const Channel* channel = find_channel(board.channels, name);
            if (channel == nullptr) continue;
            if (!channel->output) {
                throw Error(ErrorKind::invalid_value, name + ": is an input of the board");
            }
            if (!(value >= channel->lowest && value <= channel->highest)) {
                throw Error(ErrorKind::invalid_value,
                            name + " = " + plain_text(value) +
                                ": allowed: " + plain_text(channel->lowest) + " .. " +
                                plain_text(channel->highest));
            }
            const std::size_t output =
                static_cast<std::size_t>(channel - board.channels.data()) - K8055Inputs{}.size();
            const std::lock_guard lock(mutex_);
            board.told[output] = static_cast<std::uint8_t>(value + 0.5);
            board.to_tell = true;
            if (context_ != nullptr) libusb_interrupt_event_handler(context_);
            return;
        }
        throw Error(ErrorKind::invalid_value, name + ": is of another board");
    }

  private:
    /// A board that could be opened.
    struct Candidate {
        libusb_device* device;  // a reference
        Clock::time_point next_try;
    };

    bool stopped() const {
        const std::lock_guard lock(mutex_);
        return stopped_;
    }

    void run() {
        std::string complaint;
        while (!stopped()) {
            const int error = begin();
            if (error == 0) {
                serve();
            } else if (std::exchange(complaint, why(error)) != why(error)) {
                listener_.event("USB BUSY: " + complaint);
            }
            end();
            if (error != 0) rest();
        }
    }

    void rest() {
        std::unique_lock lock(mutex_);
        stop_asked_.wait_for(lock, kTryAgain, [this] { return stopped_; });
    }

    int begin() {
        libusb_context* context = nullptr;
        int error = libusb_init(&context);
        if (error != 0) return error;
        {
            const std::lock_guard lock(mutex_);
            context_ = context;
        }
        return libusb_hotplug_register_callback(
            context,
            static_cast<libusb_hotplug_event>(LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED |
                                              LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT),
            LIBUSB_HOTPLUG_ENUMERATE, kVelleman, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY,
            plugged, this, &plug_watch_);
    }

    void end() {
        libusb_context* context = nullptr;
        {
            const std::lock_guard lock(mutex_);
            context = std::exchange(context_, nullptr);
        }
        if (context == nullptr) return;
        libusb_hotplug_deregister_callback(context, plug_watch_);
        for (const Candidate& candidate : candidates_) libusb_unref_device(candidate.device);
        candidates_.clear();
        libusb_exit(context);
    }

    /// Until the end, or until no board has been there for a while.
    void serve() {
        Clock::time_point idle_from = Clock::now();
        while (!stopped()) {
            open_candidates();
            bool any = false;
            for (Board& board : boards_) {
                if (!board.fault.empty()) close(board);
                tell(board);
                any = any || board.handle != nullptr;
            }
            const auto now = Clock::now();
            if (any) idle_from = now;
            if (now - idle_from >= kTryAgain) return;
            handle_events(kTryAgain);
        }
        put_out();
        for (Board& board : boards_) {
            if (board.handle != nullptr) close(board);
        }
    }

    void handle_events(Clock::duration longest) {
        timeval timeout = interval(longest);
        libusb_handle_events_timeout_completed(context_, &timeout, nullptr);
    }

    /// Devices must not be opened in here. It may come twice for one device, or not at all.
    static int LIBUSB_CALL plugged(libusb_context* /*context*/, libusb_device* device,
                                   libusb_hotplug_event event, void* self) {
        auto& source = *static_cast<K8055Source*>(self);
        if (event == LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED) {
            source.add_candidate(device, Clock::now());
        } else {
            source.forget(device);
        }
        return 0;
    }

    void add_candidate(libusb_device* device, Clock::time_point next_try) {
        const auto same = [&](const Candidate& other) { return other.device == device; };
        const auto open = [&](const Board& board) { return board.device == device; };
        if (std::ranges::any_of(candidates_, same) || std::ranges::any_of(boards_, open)) return;
        candidates_.push_back({libusb_ref_device(device), next_try});
    }

    void forget(libusb_device* device) {
        for (Board& board : boards_) {
            if (board.device == device && board.fault.empty()) board.fault = "unplugged";
        }
        std::erase_if(candidates_, [&](const Candidate& candidate) {
            if (candidate.device != device) return false;
            libusb_unref_device(device);
            return true;
        });
    }

    void open_candidates() {
        const auto now = Clock::now();
        for (auto candidate = candidates_.begin(); candidate != candidates_.end();) {
            const auto current = candidate++;
            if (current->next_try > now) continue;
            libusb_device_descriptor descriptor{};
            libusb_get_device_descriptor(current->device, &descriptor);
            const auto board = std::ranges::find(
                boards_, static_cast<int>(descriptor.idProduct) - kFirstProduct, &Board::address);
            const bool wanted = board != boards_.end();
            if (wanted && !open(*board, current->device)) {
                current->next_try = now + kTryAgain;
                continue;
            }
            libusb_unref_device(current->device);
            candidates_.erase(current);
        }
    }

    bool open(Board& board, libusb_device* device) {
        if (board.handle != nullptr) {
            return complain(board, "a second board has its address");
        }
        const std::optional<Wiring> wiring = wiring_of(device);
        if (!wiring) return complain(board, "it has not the endpoints of a K8055");
        if (const int error = libusb_open(device, &board.handle); error != 0) {
            board.handle = nullptr;
            return complain(board, why(error));
        }
        libusb_set_auto_detach_kernel_driver(board.handle, 1);  // the kernel's is vmk80xx
        if (const int error = libusb_claim_interface(board.handle, wiring->interface); error != 0) {
            libusb_close(std::exchange(board.handle, nullptr));
            return complain(board, why(error));
        }
        begin(board, *wiring, device);
        return true;
    }

    bool complain(Board& board, const std::string& reason) const {
        if (std::exchange(board.complaint, reason) != reason) {
            listener_.event(board.id + " BUSY: " + reason);
        }
        return false;
    }

    void begin(Board& board, const Wiring& wiring, libusb_device* device) {
        board.device = libusb_ref_device(device);
        board.interface = wiring.interface;
        board.in_bytes.assign(wiring.in_size, 0);
        board.in = libusb_alloc_transfer(0);
        board.out = libusb_alloc_transfer(0);
        libusb_fill_interrupt_transfer(board.in, board.handle, wiring.in, board.in_bytes.data(),
                                       static_cast<int>(board.in_bytes.size()), reported, this, 0);
        libusb_fill_interrupt_transfer(board.out, board.handle, wiring.out, board.out_bytes.data(),
                                       static_cast<int>(board.out_bytes.size()), taken, this,
                                       kOutputTimeout);
        board.fault.clear();
        board.complaint.clear();
        board.reported.reset();
        {
            const std::lock_guard lock(mutex_);
            board.there = true;
            board.to_tell = true;  // the kernel's driver has put all out
        }
        listener_.event(board.id + std::string(kConnected) + ": K8055 on bus " +
                        std::to_string(libusb_get_bus_number(device)) + ", device " +
                        std::to_string(libusb_get_device_address(device)));
        listen(board);
    }

    void close(Board& board) {
        {
            const std::lock_guard lock(mutex_);
            board.there = false;
        }
        // A transfer that flies would write into what is freed here.
        while (board.in_flies || board.out_flies) {
            if (board.in_flies) libusb_cancel_transfer(board.in);
            if (board.out_flies) libusb_cancel_transfer(board.out);
            handle_events(std::chrono::milliseconds(20));
        }
        libusb_free_transfer(std::exchange(board.in, nullptr));
        libusb_free_transfer(std::exchange(board.out, nullptr));
        libusb_release_interface(board.handle, board.interface);  // of a board that left: an error
        libusb_close(std::exchange(board.handle, nullptr));
        libusb_device* device = std::exchange(board.device, nullptr);
        if (!stopped()) {
            listener_.event(board.id + " LOST: " + board.fault);
            if (board.fault != kUnplugged) add_candidate(device, Clock::now() + kTryAgain);
        }
        board.fault.clear();
        libusb_unref_device(device);
    }

    void listen(Board& board) {
        const int error = libusb_submit_transfer(board.in);
        board.in_flies = error == 0;
        if (error != 0) fail(board, error == LIBUSB_ERROR_NO_DEVICE ? kUnplugged : why(error));
    }

    static void fail(Board& board, std::string fault) {
        if (board.fault.empty()) board.fault = std::move(fault);
    }

    /// The board whose transfer it is.
    Board& owner(const libusb_transfer* transfer) {
        return *std::ranges::find_if(boards_, [&](const Board& board) {
            return board.in == transfer || board.out == transfer;
        });
    }

    static std::string fault_of(const libusb_transfer* transfer) {
        switch (transfer->status) {
            case LIBUSB_TRANSFER_COMPLETED:
                return "";
            case LIBUSB_TRANSFER_NO_DEVICE:
                return kUnplugged;
            case LIBUSB_TRANSFER_STALL:
                return "it refuses the transfer";
            case LIBUSB_TRANSFER_TIMED_OUT:
                return "it does not answer";
            default:
                return "a transfer failed";
        }
    }

    static void LIBUSB_CALL reported(libusb_transfer* transfer) {
        auto& source = *static_cast<K8055Source*>(transfer->user_data);
        Board& board = source.owner(transfer);
        board.in_flies = false;
        if (std::string fault = fault_of(transfer); !fault.empty()) {
            return fail(board, std::move(fault));
        }
        source.report(board, {transfer->buffer, static_cast<std::size_t>(transfer->actual_length)});
        if (board.fault.empty()) source.listen(board);
    }

    void report(Board& board, std::span<const std::uint8_t> bytes) {
        const auto now = Clock::now();
        const std::optional<K8055Inputs> inputs = decode_k8055_report(bytes);
        if (!inputs) return;
        for (std::size_t i = 0; i < inputs->size(); ++i) {
            if (board.reported && (*board.reported)[i] == (*inputs)[i]) continue;
            listener_.report({now, board.channels[i].name, (*inputs)[i]});
        }
        board.reported = inputs;
    }

    static void LIBUSB_CALL taken(libusb_transfer* transfer) {
        Board& board = static_cast<K8055Source*>(transfer->user_data)->owner(transfer);
        board.out_flies = false;
        if (std::string fault = fault_of(transfer); !fault.empty()) fail(board, std::move(fault));
    }

    /// What was told since the last time, as one report of all outputs.
    void tell(Board& board) {
        if (board.handle == nullptr || board.out_flies || !board.fault.empty()) return;
        {
            const std::lock_guard lock(mutex_);
            if (!board.to_tell.exchange(false)) return;
            board.out_bytes = encode_k8055_outputs(board.told);
        }
        const int error = libusb_submit_transfer(board.out);
        board.out_flies = error == 0;
        if (error != 0) fail(board, error == LIBUSB_ERROR_NO_DEVICE ? kUnplugged : why(error));
    }

    void put_out() {
        {
            const std::lock_guard lock(mutex_);
            for (Board& board : boards_) {
                board.told = {};
                board.to_tell = true;
            }
        }
        const auto end = Clock::now() + kLastWords;
        const auto busy = [](const Board& board) {
            return board.handle != nullptr && board.fault.empty() &&
                   (board.out_flies || board.to_tell);
        };
        while (std::ranges::any_of(boards_, busy) && Clock::now() < end) {
            for (Board& board : boards_) tell(board);
            handle_events(std::chrono::milliseconds(10));
        }
    }

    static constexpr const char* kUnplugged = "unplugged";

    std::list<Board> boards_;  // their places do not change
    Listener listener_;
    std::list<Candidate> candidates_;
    libusb_hotplug_callback_handle plug_watch_{};

    mutable std::mutex mutex_;
    std::condition_variable stop_asked_;
    libusb_context* context_ = nullptr;  // set and cleared under the lock by the thread
    bool stopped_ = false;
    std::thread thread_;
};

}  // namespace

std::unique_ptr<Source> make_k8055_source(std::vector<K8055Board> boards) {
    return std::make_unique<K8055Source>(std::move(boards));
}

#else

std::unique_ptr<Source> make_k8055_source(std::vector<K8055Board> /*boards*/) {
    throw Error(ErrorKind::unsupported, "this build is without libusb, by which a K8055 is read");
}

#endif

}  // namespace ocean::bridge
