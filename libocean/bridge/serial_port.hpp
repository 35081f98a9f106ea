// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a source needs of the system to talk to a board at a serial line: the line, and a bell that
// ends a wait.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace ocean::bridge {

/// A file descriptor that is closed once.
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

/// A thread that waits in poll() for `descriptor` is woken by ring(), from any thread.
class Bell {
  public:
    /// Throws std::system_error.
    Bell();
    void ring() const;
    /// What was rung is over.
    void quiet() const;
    int descriptor() const { return ends_[0].number(); }

  private:
    static std::array<Descriptor, 2> make_pipe();
    const std::array<Descriptor, 2> ends_;
};

/// A line of its own, raw, 8N1, that nobody else opens meanwhile.
class SerialPort {
  public:
    /// Throws std::system_error.
    SerialPort(const std::string& path, int baud);
    ~SerialPort();
    SerialPort(const SerialPort&) = delete;
    SerialPort& operator=(const SerialPort&) = delete;

    int descriptor() const { return descriptor_.number(); }
    /// What has come, into `buffer`; nothing if nothing has. Throws std::system_error when the line
    /// is gone.
    std::span<const std::uint8_t> read(std::span<std::uint8_t> buffer) const;
    /// How many bytes the line has taken. Throws likewise.
    std::size_t write(std::span<const std::uint8_t> bytes) const;
    /// Waits until what was written is sent, and no longer than that.
    void drain(std::chrono::milliseconds most) const;

  private:
    bool is_sending() const;

    Descriptor descriptor_;
};

}  // namespace ocean::bridge
