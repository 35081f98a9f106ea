// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>

#include "midi_ports.hpp"
#include "ocean/error.hpp"
#ifdef OCEAN_HAVE_RTMIDI
#include <RtMidi.h>
#endif

namespace ocean::bridge {
#ifdef OCEAN_HAVE_RTMIDI
namespace {

constexpr char kClient[] = "ocean-bridge";

/// Throws Error if the system has no sequencer. Without this check RtMidi and ALSA's library would
/// write to standard error.
void require_sequencer() {
    constexpr char kSequencer[] = "/dev/snd/seq";
    const int descriptor = ::open(kSequencer, O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (descriptor >= 0) {
        ::close(descriptor);
        return;
    }
    const int error = errno;
    throw Error(ErrorKind::not_found,
                std::string("no ALSA sequencer: ") + kSequencer + ": " +
                    std::generic_category().message(error) +
                    (error == EACCES ? "; members of the group audio may open it" : ""));
}

/// Returns the inode of a sound card from the port's name "CLIENT:PORT 20:0", or nothing for the
/// port of a program. ALSA numbers the clients of a card from 16 + 4 * card on, and a card that is
/// plugged in again has another inode.
std::optional<ino_t> card_node(const std::string& port) {
    constexpr int kFirstCard = 16;
    constexpr int kClientsOfCard = 4;
    constexpr int kFirstProgram = 128;
    const int client = std::atoi(port.c_str() + port.rfind(' ') + 1);
    if (client < kFirstCard || client >= kFirstProgram) return std::nullopt;
    const std::string node =
        "/dev/snd/controlC" + std::to_string((client - kFirstCard) / kClientsOfCard);
    struct stat status {};
    if (::stat(node.c_str(), &status) != 0) return std::nullopt;
    return status.st_ino;
}

/// Replaces RtMidi's default, which prints errors and throws some of them. A failure shows in the
/// state of the port.
void ignore_error(RtMidiError::Type, const std::string&, void*) {}

std::vector<std::string> names_of(RtMidi& direction) {
    std::vector<std::string> names;
    for (unsigned port = 0; port < direction.getPortCount(); ++port) {
        names.push_back(direction.getPortName(port));
    }
    return names;
}

bool open_port(RtMidi& direction, const std::string& name) {
    const std::vector<std::string> names = names_of(direction);
    const auto port = std::ranges::find(names, name);
    if (port == names.end()) return false;
    direction.openPort(static_cast<unsigned>(port - names.begin()), kClient);
    return direction.isPortOpen();
}

class RtMidiPorts : public MidiPorts {
  public:
    ~RtMidiPorts() override { close(); }

    std::vector<std::string> inputs() override {
        if (!input_) make_clients();
        return names_of(*input_);
    }

    bool open(const std::string& name, Receiver receiver) override {
        receiver_ = std::move(receiver);
        name_ = name;
        node_ = card_node(name);
        input_->setCallback(&RtMidiPorts::receive, this);
        if (!open_port(*input_, name)) {
            close();
            return false;
        }
        open_port(*output_, name);
        return true;
    }

    bool is_still_connected() override {
        const std::vector<std::string> names = inputs();
        return std::ranges::find(names, name_) != names.end() && card_node(name_) == node_;
    }

    void close() override {
        if (!input_) return;
        input_->closePort();
        input_->cancelCallback();
        output_->closePort();
    }

    void send(std::span<const std::uint8_t> bytes) override {
        if (output_->isPortOpen()) output_->sendMessage(bytes.data(), bytes.size());
    }

  private:
    void make_clients() {
        require_sequencer();
        try {
            auto input = std::make_unique<RtMidiIn>(RtMidi::LINUX_ALSA, kClient);
            output_ = std::make_unique<RtMidiOut>(RtMidi::LINUX_ALSA, kClient);
            input->setErrorCallback(&ignore_error);
            output_->setErrorCallback(&ignore_error);
            input_ = std::move(input);
        } catch (const RtMidiError& error) {
            throw Error(ErrorKind::not_found, "no ALSA sequencer: " + error.getMessage());
        }
    }

    static void receive(double, std::vector<unsigned char>* bytes, void* self) {
        static_cast<RtMidiPorts*>(self)->receiver_(*bytes);
    }

    std::unique_ptr<RtMidiIn> input_;
    std::unique_ptr<RtMidiOut> output_;
    Receiver receiver_;
    std::string name_;
    std::optional<ino_t> node_;
};

}  // namespace

std::unique_ptr<MidiPorts> system_midi_ports() {
    return std::make_unique<RtMidiPorts>();
}
#else
std::unique_ptr<MidiPorts> system_midi_ports() {
    throw Error(ErrorKind::unsupported, "this build is without RtMidi");
}
#endif

}  // namespace ocean::bridge
