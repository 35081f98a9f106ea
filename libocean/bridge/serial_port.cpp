// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "serial_port.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <thread>

namespace ocean::bridge {
namespace {

void require(bool done) {
    if (!done) throw std::system_error(errno, std::generic_category());
}

speed_t speed_of(int baud) {
    switch (baud) {
        case 9600:
            return B9600;
        case 19200:
            return B19200;
        case 38400:
            return B38400;
        case 57600:
            return B57600;
        case 115200:
            return B115200;
        case 230400:
            return B230400;
        default:
            throw std::system_error(EINVAL, std::generic_category());
    }
}

/// Blocks while holds() returns true, at most until the time is over.
template <typename Holds>
void wait_while(const Holds& holds, std::chrono::milliseconds limit) {
    constexpr std::chrono::milliseconds kStep{2};
    for (auto waited = kStep; waited <= limit && holds(); waited += kStep) {
        std::this_thread::sleep_for(kStep);
    }
}

}  // namespace

Descriptor::~Descriptor() {
    if (number_ >= 0) ::close(number_);
}

Bell::Bell() : ends_(make_pipe()) {}

std::array<Descriptor, 2> Bell::make_pipe() {
    int ends[2];
    require(::pipe(ends) == 0);
    std::array<Descriptor, 2> pipe{Descriptor(ends[0]), Descriptor(ends[1])};
    for (const int end : ends) {
        require(::fcntl(end, F_SETFL, O_NONBLOCK) == 0 && ::fcntl(end, F_SETFD, FD_CLOEXEC) == 0);
    }
    return pipe;
}

void Bell::ring() const {
    // A full pipe already rings.
    [[maybe_unused]] const ssize_t written = ::write(ends_[1].number(), "", 1);
}

void Bell::silence() const {
    char rings[64];
    while (::read(ends_[0].number(), rings, sizeof rings) > 0) continue;
}

SerialPort::SerialPort(const std::string& path, int baud)
    : descriptor_(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
    require(descriptor() >= 0);
    termios line{};
    require(::tcgetattr(descriptor(), &line) == 0);
    require(::ioctl(descriptor(), TIOCEXCL) == 0);
    line.c_iflag = 0;
    line.c_oflag = 0;
    line.c_lflag = 0;
    line.c_cflag = CS8 | CREAD | CLOCAL | HUPCL;
    line.c_cc[VMIN] = 1;
    line.c_cc[VTIME] = 0;
    require(::cfsetispeed(&line, speed_of(baud)) == 0 &&
            ::cfsetospeed(&line, speed_of(baud)) == 0 &&
            ::tcsetattr(descriptor(), TCSANOW, &line) == 0);
    ::tcflush(descriptor(), TCIOFLUSH);  // bytes that another program left
}

SerialPort::~SerialPort() {
    ::ioctl(descriptor(), TIOCNXCL);  // a pseudo-terminal would stay locked
    if (!is_sending()) return;
    // close() blocks for half a minute while a board accepts nothing, so a thread that only holds
    // the line closes it. A process that ends meanwhile interrupts that, but if it ended before the
    // thread had begun, it would close the line itself and block.
    const int number = descriptor();
    try {
        std::thread([line = std::move(descriptor_)] {}).detach();
    } catch (const std::system_error&) {
        return;  // without a thread the line was closed here
    }
    wait_while([number] { return ::fcntl(number, F_GETFD) >= 0; }, std::chrono::seconds(1));
}

std::span<const std::uint8_t> SerialPort::read(std::span<std::uint8_t> buffer) const {
    const ssize_t count = ::read(descriptor(), buffer.data(), buffer.size());
    if (count > 0) return buffer.first(static_cast<std::size_t>(count));
    if (count == 0) errno = ENODEV;  // hung up
    require(count < 0 && (errno == EAGAIN || errno == EINTR));
    return {};
}

std::size_t SerialPort::write(std::span<const std::uint8_t> bytes) const {
    const ssize_t count = ::write(descriptor(), bytes.data(), bytes.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    require(errno == EAGAIN || errno == EINTR);
    return 0;
}

void SerialPort::drain(std::chrono::milliseconds limit) const {
    wait_while([this] { return is_sending(); }, limit);
}

bool SerialPort::is_sending() const {
    int left = 0;
    return ::ioctl(descriptor(), TIOCOUTQ, &left) == 0 && left > 0;
}

}  // namespace ocean::bridge
