// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean-bridge`: boards and networks turn the parameters of a sea.
#include <memory>

#include "command_line.hpp"
#include "learn.hpp"
#include "ocean/bridge/endpoint.hpp"
#include "ocean/error.hpp"
#include "ocean/version.hpp"
#include "sea_argument.hpp"
#include "serve.hpp"
#include "terminal_client.hpp"

namespace ocean::app {
namespace {

constexpr char kFooter[] =
    R"(SEA says what the parameters are at the start; without it they are the defaults.
Boards are those of the map's [[device]]; without any, and without --dummy and --replay,
each Velleman K8055 that is plugged in: board0 to board3, as its jumpers say.
Without --map the knob a1 of board0 is wind_speed, a2 choppiness, its button d1 app.pause
and d2 app.record; the map is read again when its file changes.
A map's mode = "relative" is for endless knobs of MIDI, with code = "twos_complement",
"binary_offset" or "signed_bit": a step is a hundredth of out, or what step says, from what
the value is. midi0/pair0 .. pair31, nrpn0 .. nrpn16383 and rpn0 .. rpn16383 are values of 14
bits, 0 .. 16383. --learn >map.toml writes the map of the controls that are moved: of the
boards of --map, or of each K8055 and the first MIDI controller. PROTOCOL.md has all keys.
A script and a replay are lines SECONDS CHANNEL VALUE, such as 0.5 board0/a1 128.
Try it: ocean-bridge --dummy, then telnet 127.0.0.1 4747 and HELP.
Exit codes: 0 done, 1 failed at run time, 2 wrong usage or bad file, 130 interrupted.)";

struct Words {
    ServeWords serve;
    std::string client;
};

void run(const Words& words, const Context& context) {
    const std::string token =
        words.serve.token_file.empty() ? "" : bridge::read_token(words.serve.token_file);
    if (words.serve.learn && !words.client.empty()) {
        throw Error(ErrorKind::invalid_value, "--learn listens to boards, --client to a bridge");
    }
    if (words.serve.learn) return learn(words.serve, context);
    if (words.client.empty()) return serve(words.serve, token, context);
    run_terminal_client(bridge::parse_endpoint(words.client, "--client"), token, context);
}

Command bridge_command() {
    auto words = std::make_shared<Words>();
    ServeWords& serve = words->serve;
    std::vector<OptionGroup> groups = {sea_options(serve.sea, kOptional)};
    groups.push_back(
        {"Boards",
         {{"--map", &serve.map, "FILE", "Which knob turns what", kOptional, NotEmpty{}},
          {"--dummy", &serve.dummy, "[SCRIPT]",
           "A board that is not there, still until the script or a client says otherwise"},
          {"--replay", &serve.replay, "FILE", "What a board reported", kOptional, NotEmpty{}},
          {"--learn", &serve.learn, "[NAME]",
           "Print the map's lines for each control that is moved, for NAME or wind_speed, until "
           "Ctrl-C"}}});
    groups.push_back(
        {"Network",
         {{"--listen", &serve.listen, "HOST:PORT",
           "Where clients come; beyond this machine only with --token-file", kOptional, NotEmpty{}},
          {"--token-file", &serve.token_file, "FILE",
           "One line that clients must know, in a file of its owner's alone", kOptional,
           NotEmpty{}},
          {"--clients", &serve.clients, "N", "Clients at a time", kOptional, Within{1, 100000}},
          {"--osc", &serve.osc, "HOST:PORT",
           "Where OSC messages come by UDP, such as 127.0.0.1:9100; PORT alone is on this machine",
           kOptional, NotEmpty{}},
          {"--osc-allow", &serve.osc_allow, "ADDRESS",
           "Who may send to --osc, in numbers; needed beyond this machine; may be repeated",
           kOptional, NotEmpty{}},
          {"--osc-to", &serve.osc_to, "HOST:PORT",
           "Who is told each change by OSC, but for its own; may be repeated", kOptional,
           NotEmpty{}},
          {"--client", &words->client, "HOST:PORT", "Be a client: lines typed, values live",
           kOptional, NotEmpty{}}}});
    groups.push_back(run_options(""));
    return {.name = "ocean-bridge",
            .summary = "A board's knobs turn the sea, and every program that shows it follows.",
            .options = std::move(groups),
            .footer = kFooter,
            .run = [words](const Context& context) { run(*words, context); }};
}

}  // namespace
}  // namespace ocean::app

int main(int argc, char** argv) {
    using namespace ocean::app;
    return run_program(argc, argv,
                       {.main = bridge_command(),
                        .version = "ocean-bridge " OCEAN_VERSION "\n" OCEAN_LIBRARY_VERSIONS});
}
