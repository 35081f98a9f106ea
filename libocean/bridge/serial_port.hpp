// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A serial line, and a bell that ends a wait for the line.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace ocean::bridge {

/// Owns a file descriptor and closes it.
class Descriptor {
  public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&&) = delete;
    int number() const { return number_; }

  private:
    int number_;
};

/// Wakes a thread that waits in poll() for descriptor(). ring() may be called from any thread.
class Bell {
  public:
    /// Throws std::system_error.
    Bell();
    void ring() const;
    /// Forgets all rings so far.
    void silence() const;
    int descriptor() const { return ends_[0].number(); }

  private:
    static std::array<Descriptor, 2> make_pipe();
    const std::array<Descriptor, 2> ends_;
};

/// A serial line in raw mode, 8N1, locked against other programs while it is open.
class SerialPort {
  public:
    /// Throws std::system_error.
    SerialPort(const std::string& path, int baud);
    ~SerialPort();
    SerialPort(const SerialPort&) = delete;
    SerialPort& operator=(const SerialPort&) = delete;

    int descriptor() const { return descriptor_.number(); }
    /// Reads the bytes that are available into `buffer` and returns them; empty if there are none.
    /// Throws std::system_error when the line is gone.
    std::span<const std::uint8_t> read(std::span<std::uint8_t> buffer) const;
    /// Returns the number of bytes that the line has accepted. Throws std::system_error when the
    /// line is gone.
    std::size_t write(std::span<const std::uint8_t> bytes) const;
    /// Blocks until all written bytes are sent, or the time is over.
    void drain(std::chrono::milliseconds limit) const;

  private:
    bool is_sending() const;

    Descriptor descriptor_;
};

}  // namespace ocean::bridge
