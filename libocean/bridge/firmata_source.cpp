// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/firmata_source.hpp"

#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

#include "firmata_protocol.hpp"
#include "ocean/internal/checked_text.hpp"
#include "serial_port.hpp"

namespace ocean::bridge {
namespace {

using namespace std::chrono_literals;

/// How often a board that is not there is looked for: soon after it went, then less often.
constexpr auto kFirstLook = 50ms;
constexpr auto kLook = 1000ms;
/// Opening the line resets most boards, which then take about two seconds.
constexpr auto kAskAgain = 500ms;
constexpr auto kAnswer = 5s;
constexpr int kSamplingInterval = 10;  // ms
/// At the end a board that takes nothing is given up.
constexpr auto kLastWords = 200ms;

/// One input as the messages name it.
struct Input {
    FirmataKind kind;
    int number;  // of the analog input or of the port
    int bit;
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

class FirmataSource : public Source {
  public:
    FirmataSource(const std::string& id, const FirmataDevice& device)
        : id_(id),
          device_(device),
          channels_(firmata_channels(id, device)),
          inputs_(inputs_of(device)),
          outputs_(outputs_of(device)),
          wanted_(outputs_.size()) {}
    ~FirmataSource() override { stop(); }

    std::vector<Channel> channels() const override {
        const std::lock_guard lock(mutex_);
        return there_ ? channels_ : std::vector<Channel>();
    }

    void start(Listener listener) override {
        listener_ = std::move(listener);
        thread_ = std::thread([this] { run(); });
    }

    void stop() override {
        {
            const std::lock_guard lock(mutex_);
            stopped_ = true;
        }
        bell_.ring();
        if (thread_.joinable()) thread_.join();
    }

    void put(const std::string& name, double value) override {
        const std::size_t output = output_index(channels_, name, value) - inputs_.size();
        {
            const std::lock_guard lock(mutex_);
            wanted_[output] = static_cast<int>(value + 0.5);
        }
        bell_.ring();
    }

  private:
    bool stopped() const {
        const std::lock_guard lock(mutex_);
        return stopped_;
    }

    void run() {
        auto wait = kFirstLook;
        while (!stopped()) {
            if (meet()) wait = kFirstLook;
            rest(wait);
            wait = std::min(2 * wait, kLook);
        }
    }

    /// Until the time is over or stop() is called.
    void rest(Clock::duration time) {
        const Clock::time_point end = Clock::now() + time;
        while (!stopped() && Clock::now() < end) {
            pollfd waits{bell_.descriptor(), POLLIN, 0};
            ::poll(&waits, 1, timeout_until(end));
            bell_.quiet();
        }
    }

    /// Talks to the board if it is there until it goes. False if it is not.
    bool meet() {
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
            // It went.
        }
        line.reset();  // nothing of it is open when that is told
        be_there(false);
        if (std::exchange(connected_, false)) listener_.event({BoardEvent::Kind::lost, id_});
        return true;
    }

    void be_there(bool whether) {
        const std::lock_guard lock(mutex_);
        there_ = whether;
    }

    void cannot_open(const std::error_code& why) {
        for (const int absent : {ENOENT, ENODEV, ENXIO, EIO}) {
            if (why.value() == absent) return trouble_.clear();
        }
        std::string hint;
        if (why.value() == EACCES) hint = "; members of the group dialout may";
        if (why.value() == EBUSY) hint = ": another program has it";
        complain(why.message() + hint);
    }

    /// Says what is wrong with the line, once.
    void complain(const std::string& trouble) {
        if (std::exchange(trouble_, trouble) == trouble) return;
        listener_.event(
            {BoardEvent::Kind::busy, id_, text::printable(device_.port) + ": " + trouble});
    }

    void talk(const SerialPort& line) {
        parser_ = {};
        writer_ = {};
        connected_ = false;
        const Clock::time_point begin = Clock::now();
        Clock::time_point next_question = begin;
        while (!stopped()) {
            if (!connected_ && Clock::now() >= next_question) {
                if (Clock::now() - begin >= kAnswer) {
                    complain("nothing answers as Firmata at " + std::to_string(device_.baud) +
                             " baud");
                }
                if (writer_.empty()) writer_.request_version();
                next_question = Clock::now() + kAskAgain;
            }
            send(line);
            if (connected_ && writer_.empty()) write_outputs();
            wait_for(line, connected_ ? -1 : timeout_until(next_question));
            read_from(line);
        }
        if (connected_) put_out(line);
        connected_ = false;
    }

    void send(const SerialPort& line) { writer_.drop(line.write(writer_.bytes())); }

    void wait_for(const SerialPort& line, int timeout) const {
        const short writable = writer_.empty() ? 0 : POLLOUT;
        pollfd waits[] = {{bell_.descriptor(), POLLIN, 0},
                          {line.descriptor(), static_cast<short>(POLLIN | writable), 0}};
        ::poll(waits, std::size(waits), timeout);
        bell_.quiet();
    }

    void read_from(const SerialPort& line) {
        std::uint8_t buffer[1024];
        for (const FirmataReport& report : parser_.feed(line.read(buffer))) {
            if (report.kind == FirmataKind::version) {
                if (!connected_) welcome(report);
            } else if (report.kind == FirmataKind::firmware) {
                if (connected_) configure();  // it was reset
            } else if (connected_) {
                tell_of(report);
            }
        }
    }

    void welcome(const FirmataReport& version) {
        connected_ = true;
        trouble_.clear();
        places_.assign(inputs_.size(), std::nullopt);
        be_there(true);
        listener_.event({BoardEvent::Kind::connected, id_,
                         "Firmata " + std::to_string(version.number) + "." +
                             std::to_string(version.value) + " at " +
                             text::printable(device_.port)});
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

    void tell_of(const FirmataReport& report) {
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            const Input& input = inputs_[i];
            if (input.kind != report.kind || input.number != report.number) continue;
            const int value =
                input.kind == FirmataKind::analog ? report.value : report.value >> input.bit & 1;
            if (std::exchange(places_[i], value) == value) continue;
            listener_.report({Clock::now(), channels_[i].name, static_cast<double>(value)});
        }
    }

    /// The latest of each, when the line has taken what was before.
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

    void put_out(const SerialPort& line) {
        for (const Output& output : outputs_) write_output(output, 0);
        const Clock::time_point end = Clock::now() + kLastWords;
        while (!writer_.empty() && Clock::now() < end) {
            send(line);
            pollfd waits{line.descriptor(), POLLOUT, 0};
            if (!writer_.empty()) ::poll(&waits, 1, timeout_until(end));
        }
        line.drain(kLastWords);
    }

    const std::string id_;
    const FirmataDevice device_;
    const std::vector<Channel> channels_;  // inputs, then outputs
    const std::vector<Input> inputs_;
    const std::vector<Output> outputs_;
    const Bell bell_;
    Listener listener_;
    mutable std::mutex mutex_;
    bool stopped_ = false;
    bool there_ = false;
    std::vector<std::optional<int>> wanted_;  // by output
    // Of the thread.
    FirmataParser parser_;
    FirmataWriter writer_;
    bool connected_ = false;
    std::string trouble_;                     // that was said
    std::vector<std::optional<int>> places_;  // by input
    std::vector<std::optional<int>> sent_;    // by output
    std::thread thread_;
};

}  // namespace

std::vector<Channel> firmata_channels(const std::string& board, const FirmataDevice& device) {
    std::vector<Channel> channels;
    const auto add = [&](const std::string& letters, const std::vector<int>& numbers,
                         double highest, bool output) {
        for (const int number : numbers) {
            channels.push_back(
                {board + "/" + letters + std::to_string(number), 0.0, highest, output});
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
    return std::make_unique<FirmataSource>(id, device);
}

}  // namespace ocean::bridge
