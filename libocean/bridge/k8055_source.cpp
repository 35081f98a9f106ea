// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/k8055_source.hpp"

#ifdef OCEAN_HAVE_LIBUSB
#include <algorithm>
#include <condition_variable>
#include <list>
#include <mutex>
#include <thread>
#include <utility>

#include "k8055_board.hpp"
#include "k8055_report.hpp"
#include "k8055_usb.hpp"
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

timeval interval(Clock::duration duration) {
    const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(duration).count();
    return {static_cast<time_t>(whole / 1'000'000), static_cast<suseconds_t>(whole % 1'000'000)};
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
                throw Error(ErrorKind::invalid_value,
                            {.what = "is an input of the board", .parameter = name});
            }
            require_in_range(*channel, value);
            const std::size_t output =
                static_cast<std::size_t>(channel - board.channels.data()) - K8055Inputs{}.size();
            const std::lock_guard lock(mutex_);
            board.told[output] = static_cast<std::uint8_t>(value + 0.5);
            board.to_tell = true;
            if (context_ != nullptr) libusb_interrupt_event_handler(context_);
            return;
        }
        throw Error(ErrorKind::invalid_value, {.what = "is of another board", .parameter = name});
    }

  private:
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
                listener_.event({BoardEvent::Kind::busy, "USB", complaint});
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
                if (board.fault) close(board);
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
        const bool is_open = std::ranges::find(boards_, device, &Board::device) != boards_.end();
        if (!is_open) candidates_.add(device, next_try);
    }

    void forget(libusb_device* device) {
        for (Board& board : boards_) {
            if (board.device == device) fail(board, unplugged());
        }
        candidates_.forget(device);
    }

    void open_candidates() {
        candidates_.open_due(kTryAgain, [this](libusb_device* device) {
            libusb_device_descriptor descriptor{};
            libusb_get_device_descriptor(device, &descriptor);
            const auto board = std::ranges::find(
                boards_, static_cast<int>(descriptor.idProduct) - kFirstProduct, &Board::address);
            return board == boards_.end() || open(*board, device);
        });
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
            listener_.event({BoardEvent::Kind::busy, board.id, reason});
        }
        return false;
    }

    void begin(Board& board, const Wiring& wiring, libusb_device* device) {
        prepare(board, wiring, device, {reported, taken, this});
        {
            const std::lock_guard lock(mutex_);
            board.there = true;
            board.to_tell = true;  // the kernel's driver has put all out
        }
        listener_.event({BoardEvent::Kind::connected, board.id,
                         "K8055 on bus " + std::to_string(libusb_get_bus_number(device)) +
                             ", device " + std::to_string(libusb_get_device_address(device))});
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
        release(board);
        libusb_device* device = std::exchange(board.device, nullptr);
        if (!stopped()) {
            const Fault fault = board.fault.value_or(Fault{});
            listener_.event({BoardEvent::Kind::lost, board.id, fault.text});
            if (!fault.is_unplugged) add_candidate(device, Clock::now() + kTryAgain);
        }
        board.fault.reset();
        libusb_unref_device(device);
    }

    /// The board whose transfer it is.
    Board& owner(const libusb_transfer* transfer) {
        return *std::ranges::find_if(boards_, [&](const Board& board) {
            return board.in == transfer || board.out == transfer;
        });
    }

    static void LIBUSB_CALL reported(libusb_transfer* transfer) {
        auto& source = *static_cast<K8055Source*>(transfer->user_data);
        Board& board = source.owner(transfer);
        board.in_flies = false;
        if (auto fault = fault_of(transfer)) return fail(board, std::move(*fault));
        source.report(board, {transfer->buffer, static_cast<std::size_t>(transfer->actual_length)});
        if (!board.fault) listen(board);
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
        if (auto fault = fault_of(transfer)) fail(board, std::move(*fault));
    }

    /// What was told since the last time, as one report of all outputs.
    void tell(Board& board) {
        if (board.handle == nullptr || board.out_flies || board.fault) return;
        {
            const std::lock_guard lock(mutex_);
            if (!board.to_tell.exchange(false)) return;
            board.out_bytes = encode_k8055_outputs(board.told);
        }
        send(board);
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
            return board.handle != nullptr && !board.fault && (board.out_flies || board.to_tell);
        };
        while (std::ranges::any_of(boards_, busy) && Clock::now() < end) {
            for (Board& board : boards_) tell(board);
            handle_events(std::chrono::milliseconds(10));
        }
    }

    std::list<Board> boards_;  // their places do not change
    Listener listener_;
    UsbCandidates candidates_;
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
