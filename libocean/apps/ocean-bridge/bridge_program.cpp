// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "bridge_program.hpp"

#include <memory>

#include "command.hpp"
#include "command_line.hpp"
#include "learn.hpp"
#include "ocean/channel.hpp"
#include "ocean/internal/bridge/endpoint.hpp"
#include "ocean/version.hpp"
#include "serve.hpp"
#include "subject_argument.hpp"
#include "terminal_client.hpp"

namespace ocean::app {
namespace {

constexpr char kFooter[] =
    R"(SEA gives the parameters at the start; without it they have their defaults.
The boards are those of the map's [[device]]. Without any, and without --dummy
and --replay, they are all Velleman K8055 that are plugged in: board0 to board3,
by their jumpers.
Without --map the knob a1 of board0 sets wind_speed, a2 choppiness; its button
d1 sets app.pause, d2 app.record. The map is read again when its file changes.
A map's mode = "relative" is for endless MIDI knobs, with code =
"twos_complement", "binary_offset" or "signed_bit": a step changes the value by
step, by default a hundredth of out.
midi0/pair0 .. pair31, nrpn0 .. nrpn16383 and rpn0 .. rpn16383 are values of 14
bits, 0 .. 16383.
--learn >map.toml writes the map of the controls that are moved, on the boards
of --map, or on each K8055 and the first MIDI controller. PROTOCOL.md documents
all keys.
A script or a replay has lines SECONDS CHANNEL VALUE, such as 0.5 board0/a1 128.
Try it: ocean-bridge --dummy, then telnet 127.0.0.1 4747 and HELP.
Exit codes: 0 done, 1 failed at run time, 2 wrong usage or bad file, 130
interrupted.)";

struct Words {
    ServeWords serve;
    std::string client;
};

void run(const Words& words, const Context& context) {
    const std::string token =
        words.serve.token_file.empty() ? "" : bridge::read_token(words.serve.token_file);
    if (words.serve.learn && !words.client.empty()) {
        refuse("--learn is for boards, --client for a bridge: use one of them");
    }
    if (words.serve.learn) return learn(words.serve, context);
    if (words.client.empty()) return serve(words.serve, token, context);
    run_terminal_client(bridge::parse_endpoint(words.client, "--client"), token, context);
}

Command bridge_command() {
    auto words = std::make_shared<Words>();
    ServeWords& serve = words->serve;
    std::vector<OptionGroup> groups = {subject_options(serve.sea, kSeaKind, kOptional)};
    groups.push_back(
        {"Boards",
         {{"--map", &serve.map, "FILE", "Map of controls to values", kOptional, NotEmpty{}},
          {"--dummy", &serve.dummy, "[SCRIPT]",
           "A simulated board, at rest until the script or a client moves it"},
          {"--replay", &serve.replay, "FILE", "A recording of a board", kOptional, NotEmpty{}},
          {"--learn", &serve.learn, "[NAME]",
           "Print the map's lines for each control that is moved, until Ctrl-C; controls set NAME, "
           "by default wind_speed"}}});
    groups.push_back(
        {"Network",
         {{"--listen", &serve.listen, "HOST:PORT",
           "Address for clients; beyond this machine it requires --token-file", kOptional,
           NotEmpty{}},
          {"--token-file", &serve.token_file, "FILE",
           "File of the token that clients must send; only its owner may read it", kOptional,
           NotEmpty{}},
          {"--clients", &serve.clients, "N", "Max number of clients", kOptional, Within{1, 100000}},
          {"--osc", &serve.osc, "HOST:PORT",
           "Address for OSC messages by UDP, such as 127.0.0.1:9100; PORT alone is on this machine",
           kOptional, NotEmpty{}},
          {"--osc-allow", &serve.osc_allow, "ADDRESS",
           "Numeric address that may send to --osc; required beyond this machine; may be repeated",
           kOptional, NotEmpty{}},
          {"--osc-to", &serve.osc_to, "HOST:PORT",
           "Address that gets each change of others by OSC; may be repeated", kOptional,
           NotEmpty{}},
          {"--client", &words->client, "HOST:PORT",
           "Connect to a bridge as a terminal client with live values", kOptional, NotEmpty{}}}});
    groups.push_back(run_options(""));
    return {.name = "ocean-bridge",
            .summary = "A board's knobs set the sea, and every program that shows it follows.",
            .options = std::move(groups),
            .footer = kFooter,
            .run = [words](const Context& context) { run(*words, context); }};
}

}  // namespace

int run_bridge(int argc, char** argv) {
    return run_program(argc, argv,
                       {.main = bridge_command(),
                        .version = "ocean-bridge " OCEAN_VERSION "\n" OCEAN_LIBRARY_VERSIONS});
}

}  // namespace ocean::app
