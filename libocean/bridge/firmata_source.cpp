// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/firmata_source.hpp"

#include <poll.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "drivers.hpp"
#include "firmata_protocol.hpp"
#include "ocean/internal/checked_text.hpp"
#include "serial_port.hpp"
#include "source_thread.hpp"

namespace ocean::bridge {
namespace {

using namespace std::chrono_literals;

/// The interval at which a board that is away is searched: short after a loss, then doubled up to
/// the maximum.
constexpr auto kMinSearchInterval = 50ms;
constexpr auto kMaxSearchInterval = 1000ms;
/// Opening the line resets most boards, which then need about two seconds.
constexpr auto kVersionRequestInterval = 500ms;
constexpr auto kAnswerTimeout = 5s;
constexpr int kSamplingInterval = 10;  // [ms]
/// The time that a board has at the end to accept its last outputs.
constexpr auto kFirmataGrace = 200ms;

/// An input by the numbers that messages give it.
struct Input {
    FirmataKind kind;
    int number;  // analog input, or port
    int bit;     // in the port
};

struct Output {
    int pin;
    bool pwm;
};

std::vector<Input> inputs_of(const FirmataDevice& device) {
    std::vector<Input> inputs;
    for (const int input : device.analog) inputs.push_back({FirmataKind::analog, input, 0});
    for (const auto* pins : {&device.inputs, &device.pullups}) {
        for (const int pin : *pins) {
            inputs.push_back(
                {FirmataKind::digital, pin / kFirmataPortPins, pin % kFirmataPortPins});
        }
    }
    return inputs;
}

std::vector<Output> outputs_of(const FirmataDevice& device) {
    std::vector<Output> outputs;
    for (const int pin : device.outputs) outputs.push_back({pin, false});
    for (const int pin : device.pwm) outputs.push_back({pin, true});
    return outputs;
}

int timeout_until(Clock::time_point time) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(time - Clock::now());
    return static_cast<int>(std::max<std::chrono::milliseconds::rep>(left.count(), 0));
}

class FirmataWorker {
  public:
    FirmataWorker(BoardHost& host, const std::string& id, const FirmataDevice& device)
        : host_(host),
          id_(id),
          device_(device),
          channels_(firmata_channels(id, device)),
          inputs_(inputs_of(device)),
          outputs_(outputs_of(device)),
          wanted_(outputs_.size()) {}

    void run() {
        auto interval = kMinSearchInterval;
        while (!host_.is_stopped()) {
            if (serve_board()) interval = kMinSearchInterval;
            rest(interval);
            interval = std::min(2 * interval, kMaxSearchInterval);
        }
    }

    void wake() const { bell_.ring(); }

    void put(const std::string& name, double value) {
        const std::size_t output = output_index(channels_, name, value) - inputs_.size();
        {
            const std::lock_guard lock(mutex_);
            wanted_[output] = static_cast<int>(value + 0.5);
        }
        bell_.ring();
    }

  private:
    /// Blocks until the time is over or the source stops.
    void rest(Clock::duration time) const {
        const Clock::time_point end = Clock::now() + time;
        while (!host_.is_stopped() && Clock::now() < end) {
            pollfd waits{bell_.descriptor(), POLLIN, 0};
            ::poll(&waits, 1, timeout_until(end));
            bell_.silence();
        }
    }

    /// Talks to the board until it is lost or the source stops. Returns false if it is away.
    bool serve_board() {
        std::optional<SerialPort> line;
        try {
            line.emplace(device_.port, device_.baud);
        } catch (const std::system_error& error) {
            cannot_open(error.code());
            return false;
        }
        try {
            talk(*line);
        } catch (const std::system_error&) {
            // The line is gone.
        }
        line.reset();  // closed before the loss is reported
        if (std::exchange(connected_, false)) host_.lost(id_);
        return true;
    }

    void cannot_open(const std::error_code& why) {
        for (const int absent : {ENOENT, ENODEV, ENXIO, EIO}) {
            if (why.value() == absent) return host_.no_longer_busy(id_);
        }
        std::string hint;
        if (why.value() == EACCES) hint = "; members of the group dialout may open it";
        if (why.value() == EBUSY) hint = ": another program has it";
        report_busy(why.message() + hint);
    }

    void report_busy(const std::string& reason) {
        host_.busy(id_, text::printable(device_.port) + ": " + reason);
    }

    void talk(const SerialPort& line) {
        parser_ = {};
        writer_ = {};
        connected_ = false;
        const Clock::time_point begin = Clock::now();
        Clock::time_point next_request = begin;
        while (!host_.is_stopped()) {
            if (!connected_ && Clock::now() >= next_request) {
                if (Clock::now() - begin >= kAnswerTimeout) {
                    report_busy("nothing answers as Firmata at " + std::to_string(device_.baud) +
                                " baud");
                }
                if (writer_.empty()) writer_.request_version();
                next_request = Clock::now() + kVersionRequestInterval;
            }
            send(line);
            if (connected_ && writer_.empty()) write_outputs();
            wait_for(line, connected_ ? -1 : timeout_until(next_request));
            read_from(line);
        }
        if (connected_) switch_outputs_off(line);
        connected_ = false;
    }

    void send(const SerialPort& line) { writer_.drop(line.write(writer_.bytes())); }

    void wait_for(const SerialPort& line, int timeout) const {
        const short writable = writer_.empty() ? 0 : POLLOUT;
        pollfd waits[] = {{bell_.descriptor(), POLLIN, 0},
                          {line.descriptor(), static_cast<short>(POLLIN | writable), 0}};
        ::poll(waits, std::size(waits), timeout);
        bell_.silence();
    }

    void read_from(const SerialPort& line) {
        std::uint8_t buffer[1024];
        for (const FirmataReport& report : parser_.feed(line.read(buffer))) {
            if (report.kind == FirmataKind::version) {
                if (!connected_) connect(report);
            } else if (report.kind == FirmataKind::firmware) {
                if (connected_) configure();  // the board was reset
            } else if (connected_) {
                forward(report);
            }
        }
    }

    void connect(const FirmataReport& version) {
        connected_ = true;
        reported_.assign(inputs_.size(), std::nullopt);
        host_.connected(id_,
                        "Firmata " + std::to_string(version.number) + "." +
                            std::to_string(version.value) + " at " + text::printable(device_.port),
                        channels_);
        configure();
    }

    void configure() {
        for (const int pin : device_.inputs) writer_.set_pin_mode(pin, PinMode::input);
        for (const int pin : device_.pullups) writer_.set_pin_mode(pin, PinMode::pullup);
        for (const int pin : device_.outputs) writer_.set_pin_mode(pin, PinMode::output);
        for (const int pin : device_.pwm) writer_.set_pin_mode(pin, PinMode::pwm);
        sent_.assign(outputs_.size(), std::nullopt);
        writer_.set_sampling_interval(kSamplingInterval);
        std::set<int> ports;
        for (const Input& input : inputs_) {
            if (input.kind == FirmataKind::analog) {
                writer_.report_analog(input.number);
            } else if (ports.insert(input.number).second) {
                writer_.report_digital(input.number);
            }
        }
    }

    void forward(const FirmataReport& report) {
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            const Input& input = inputs_[i];
            if (input.kind != report.kind || input.number != report.number) continue;
            const int value =
                input.kind == FirmataKind::analog ? report.value : report.value >> input.bit & 1;
            if (std::exchange(reported_[i], value) == value) continue;
            host_.report({Clock::now(), channels_[i].name, static_cast<double>(value)});
        }
    }

    /// Sends the latest value of each output. Called when the line has accepted all earlier bytes.
    void write_outputs() {
        const std::lock_guard lock(mutex_);
        for (std::size_t i = 0; i < outputs_.size(); ++i) {
            if (!wanted_[i] || sent_[i] == wanted_[i]) continue;
            sent_[i] = wanted_[i];
            write_output(outputs_[i], *wanted_[i]);
        }
    }
    void write_output(const Output& output, int value) {
        if (output.pwm) {
            writer_.write_pwm(output.pin, value);
        } else {
            writer_.write_digital(output.pin, value != 0);
        }
    }

    void switch_outputs_off(const SerialPort& line) {
        for (const Output& output : outputs_) write_output(output, 0);
        const Clock::time_point end = Clock::now() + kFirmataGrace;
        while (!writer_.empty() && Clock::now() < end) {
            send(line);
            pollfd waits{line.descriptor(), POLLOUT, 0};
            if (!writer_.empty()) ::poll(&waits, 1, timeout_until(end));
        }
        line.drain(kFirmataGrace);
    }

    BoardHost& host_;
    const std::string id_;
    const FirmataDevice device_;
    const std::vector<Channel> channels_;  // inputs, then outputs
    const std::vector<Input> inputs_;
    const std::vector<Output> outputs_;
    const Bell bell_;
    std::mutex mutex_;
    std::vector<std::optional<int>> wanted_;  // by output; under the mutex
    // Used by the source's thread alone.
    FirmataParser parser_;
    FirmataWriter writer_;
    bool connected_ = false;
    std::vector<std::optional<int>> reported_;  // by input
    std::vector<std::optional<int>> sent_;      // by output
};

/// Reads the [[device]] of an Arduino.
class FirmataReader {
  public:
    explicit FirmataReader(DeviceSection& section) : section_(section) {}

    FirmataDevice device() {
        FirmataDevice device;
        section_.read_keys({
            {"port", [&] { device.port = section_.text(); }},
            {"baud", [&] { device.baud = baud(); }},
            {"analog", [&] { device.analog = section_.whole_list(0, kFirmataAnalogs - 1); }},
            {"inputs", [&] { device.inputs = pins(); }},
            {"pullups", [&] { device.pullups = pins(); }},
            {"outputs", [&] { device.outputs = pins(); }},
            {"pwm", [&] { device.pwm = pins(); }},
        });
        if (device.port.empty()) {
            throw section_.fail("port is missing; allowed: such as /dev/ttyACM0");
        }
        require_distinct_pins(device);
        return device;
    }

  private:
    std::vector<int> pins() const { return section_.whole_list(0, kFirmataPins - 1); }
    int baud() const {
        const int baud = section_.whole(0, 1'000'000);
        if (std::ranges::find(kFirmataBauds, baud) != kFirmataBauds.end()) return baud;
        throw section_.refused(
            joined(kFirmataBauds, ", ", [](int each) { return std::to_string(each); }));
    }
    void require_distinct_pins(const FirmataDevice& device) const {
        std::set<int> seen;
        for (const auto* pins : {&device.inputs, &device.pullups, &device.outputs, &device.pwm}) {
            for (const int pin : *pins) {
                if (seen.insert(pin).second) continue;
                throw section_.fail("pin " + std::to_string(pin) +
                                    " is used twice; allowed: one of inputs, pullups, outputs and "
                                    "pwm");
            }
        }
    }

    DeviceSection& section_;
};

FirmataDevice read_firmata(DeviceSection& section) {
    return FirmataReader(section).device();
}

}  // namespace

std::vector<Channel> firmata_channels(const std::string& board, const FirmataDevice& device) {
    std::vector<Channel> channels;
    const auto add = [&](const std::string& letters, const std::vector<int>& numbers, double max,
                         bool output) {
        for (const int number : numbers) {
            channels.push_back({board + "/" + letters + std::to_string(number), 0.0, max, output});
        }
    };
    add("a", device.analog, 1023.0, false);
    add("d", device.inputs, 1.0, false);
    add("d", device.pullups, 1.0, false);
    add("o", device.outputs, 1.0, true);
    add("pwm", device.pwm, 255.0, true);
    return channels;
}

std::unique_ptr<Source> make_firmata_source(const std::string& id, const FirmataDevice& device) {
    return std::make_unique<ThreadedSource<FirmataWorker>>(id, id, device);
}

Driver DriverTable::firmata() {
    return {read_firmata, make_firmata_source};
}

}  // namespace ocean::bridge
