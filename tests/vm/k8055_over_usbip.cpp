// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A Velleman K8055 plugged into this machine's kernel, without hardware: it speaks the server's
// side of USB/IP (Documentation/usb/usbip_protocol.rst) to vhci_hcd, so that everything above it is
// real. Its descriptors are those of a low-speed device with an interrupt endpoint of 8 bytes each
// way. Standard input: lines of 8 bytes in hexadecimal, which it reports from then on, every 10 ms;
// its end is the unplugging. Standard output: "OUT" and the bytes of each report that it gets.
#include <arpa/inet.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <span>
#include <string>
#include <vector>

namespace {

using Bytes = std::vector<std::uint8_t>;
using Clock = std::chrono::steady_clock;

constexpr auto kInterval = std::chrono::milliseconds(10);

constexpr std::uint32_t kSubmit = 1;
constexpr std::uint32_t kUnlink = 2;
constexpr std::uint32_t kSubmitted = 3;
constexpr std::uint32_t kUnlinked = 4;
constexpr std::uint32_t kDeviceId = 0x10002;
constexpr std::uint32_t kLowSpeed = 1;

/// The 48 bytes before each transfer, as words of the network's order. A submission has flags and
/// length in the first two of `rest` and the setup packet in the last two; its answer has status
/// and length there. An unlinking has the number of the transfer that is meant, its answer the
/// status.
struct Header {
    std::uint32_t command = 0;
    std::uint32_t number = 0;
    std::uint32_t device = 0;
    std::uint32_t is_in = 0;
    std::uint32_t endpoint = 0;
    std::array<std::uint32_t, 7> rest{};
};
static_assert(sizeof(Header) == 48);

const Bytes kDevice = {18,   1,    0x10, 0x01, 0, 0, 0, 8,  // USB 1.1, 8 bytes at endpoint 0
                       0xCF, 0x10, 0x00, 0x55, 0, 1, 1, 2, 0, 1};
const Bytes kHidReport = {0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x19, 0x01, 0x29,
                          0x08, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x08,
                          0x81, 0x02, 0x19, 0x01, 0x29, 0x08, 0x91, 0x02, 0xC0};
const Bytes kConfiguration = {9, 2,    41,   0, 1, 1, 0,    0xA0, 50,  // one interface, 100 mA
                              9, 4,    0,    0, 2, 3, 0,    0,    0,   // HID, two endpoints
                              9, 0x21, 0,    1, 0, 1, 0x22, 29,   0,   // its report's description
                              7, 5,    0x81, 3, 8, 0, 10,              // in, interrupt, 8 bytes
                              7, 5,    0x01, 3, 8, 0, 10};             // out

[[noreturn]] void fail(const char* what) {
    std::perror(what);
    std::exit(1);
}

Bytes string_descriptor(int index) {
    if (index == 0) return {4, 3, 0x09, 0x04};  // American English
    const std::string text = index == 1 ? "Velleman" : "USB K8055";
    Bytes bytes = {static_cast<std::uint8_t>(2 + 2 * text.size()), 3};
    for (const char c : text) {
        bytes.push_back(static_cast<std::uint8_t>(c));
        bytes.push_back(0);
    }
    return bytes;
}

/// What the device says to a request at endpoint 0; empty where it has nothing to say.
Bytes answer_of(std::span<const std::uint8_t, 8> setup) {
    constexpr std::uint8_t kGetDescriptor = 6;
    const bool is_in = (setup[0] & 0x80) != 0;
    Bytes bytes;
    if (is_in && setup[1] != kGetDescriptor) bytes = {0, 0};
    if (setup[1] == kGetDescriptor) {
        switch (setup[3]) {
            case 1:
                bytes = kDevice;
                break;
            case 2:
                bytes = kConfiguration;
                break;
            case 3:
                bytes = string_descriptor(setup[2]);
                break;
            case 0x22:
                bytes = kHidReport;
                break;
        }
    }
    const std::size_t most = setup[6] | static_cast<std::size_t>(setup[7]) << 8;
    bytes.resize(std::min(bytes.size(), most));
    return bytes;
}

class Board {
  public:
    Board() { plug(); }

    void run() {
        for (auto next = Clock::now() + kInterval;;) {
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now());
            pollfd waits[] = {{STDIN_FILENO, POLLIN, 0}, {kernel_, POLLIN, 0}};
            ::poll(waits, std::size(waits), static_cast<int>(std::max<long>(left.count(), 0)));
            if (waits[0].revents != 0 && !read_orders()) return;
            if (waits[1].revents != 0) take_request();
            if (Clock::now() < next) continue;
            next += kInterval;
            report();
        }
    }

  private:
    /// The kernel gets the other end of a connection, and takes it for a device.
    void plug() {
        std::array<int, 2> ends{};
        if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) fail("socketpair");
        kernel_ = ends[0];
        const int attach = ::open("/sys/devices/platform/vhci_hcd.0/attach", O_WRONLY);
        const std::string what = "0 " + std::to_string(ends[1]) + " " + std::to_string(kDeviceId) +
                                 " " + std::to_string(kLowSpeed);
        if (attach < 0 || ::write(attach, what.data(), what.size()) < 0) fail("vhci_hcd");
        ::close(attach);
        ::close(ends[1]);
    }

    bool read_orders() {
        std::array<char, 256> block{};
        const ssize_t count = ::read(STDIN_FILENO, block.data(), block.size());
        if (count <= 0) return false;
        orders_.append(block.data(), static_cast<std::size_t>(count));
        for (std::size_t end; (end = orders_.find('\n')) != std::string::npos;) {
            const char* at = orders_.c_str();
            for (std::uint8_t& byte : state_) {
                char* next = nullptr;
                byte = static_cast<std::uint8_t>(std::strtoul(at, &next, 16));
                at = next;
            }
            orders_.erase(0, end + 1);
        }
        return true;
    }

    void report() {
        if (waiting_.empty()) return;
        answer(waiting_.front(), 0, state_);
        waiting_.pop_front();
    }

    void take_request() {
        Header header;
        receive(&header, sizeof header);
        const std::uint32_t number = ntohl(header.number);
        if (ntohl(header.command) == kUnlink) return unlink(number, ntohl(header.rest[0]));
        const bool is_in = ntohl(header.is_in) != 0;
        Bytes bytes(is_in ? 0 : ntohl(header.rest[1]));
        receive(bytes.data(), bytes.size());
        if (ntohl(header.endpoint) == 0) return control(number, header);
        if (is_in) return waiting_.push_back(number);
        std::printf("OUT");
        for (const std::uint8_t byte : bytes) std::printf(" %02x", byte);
        std::puts("");
        std::fflush(stdout);
        answer(number, static_cast<std::uint32_t>(bytes.size()), {});
    }

    void control(std::uint32_t number, const Header& header) {
        std::array<std::uint8_t, 8> setup{};
        std::memcpy(setup.data(), &header.rest[5], setup.size());
        answer(number, 0, answer_of(setup));
    }

    /// A report that nobody waits for any more.
    void unlink(std::uint32_t number, std::uint32_t meant) {
        const bool waited = std::erase(waiting_, meant) > 0;
        Header header{htonl(kUnlinked), htonl(number)};
        header.rest[0] = htonl(static_cast<std::uint32_t>(waited ? -ECONNRESET : 0));
        send(&header, sizeof header);
    }

    /// Of a transfer in, with its bytes; of one out, how many it took.
    void answer(std::uint32_t number, std::uint32_t taken, std::span<const std::uint8_t> bytes) {
        Header header{htonl(kSubmitted), htonl(number)};
        header.rest[1] = htonl(taken + static_cast<std::uint32_t>(bytes.size()));
        send(&header, sizeof header);
        send(bytes.data(), bytes.size());
    }

    void send(const void* bytes, std::size_t count) const {
        if (count == 0) return;
        if (::send(kernel_, bytes, count, MSG_NOSIGNAL) != static_cast<ssize_t>(count))
            fail("send");
    }
    void receive(void* bytes, std::size_t count) const {
        if (count == 0) return;
        if (::recv(kernel_, bytes, count, MSG_WAITALL) != static_cast<ssize_t>(count)) fail("recv");
    }

    int kernel_ = -1;
    std::string orders_;
    std::array<std::uint8_t, 8> state_ = {0, 1, 0, 0, 0, 0, 0, 0};
    std::deque<std::uint32_t> waiting_;  // transfers that want a report
};

}  // namespace

int main() {
    Board().run();
}
