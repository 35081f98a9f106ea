// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "bridge_host.hpp"

#include <utility>

#include "ocean/internal/bridge/devices.hpp"
#include "ocean/internal/bridge/hub.hpp"
#include "ocean/internal/bridge/line_server.hpp"
#include "ocean/internal/bridge/script_sources.hpp"

namespace ocean::app {
namespace {

constexpr std::size_t kMaxLines = 500;

bridge::HubOptions hub_options(const BridgeHostOptions& options, const Sea& sea) {
    bridge::HubOptions hub{.sea = sea, .map = options.map};
    if (options.map.empty()) hub.map_text = bridge::kDefaultMap;
    if (!options.dummy) hub.devices = bridge::default_devices();
    return hub;
}

std::vector<std::unique_ptr<bridge::Source>> sources(const BridgeHostOptions& options) {
    std::vector<std::unique_ptr<bridge::Source>> list;
    if (options.dummy) list.push_back(bridge::make_dummy_source());
    return list;
}

}  // namespace

struct BridgeHost::Running {
    Running(const BridgeHostOptions& options, const Sea& sea, bridge::ServerOptions server_options)
        : hub(hub_options(options, sea), sources(options)),
          server(std::move(server_options), hub) {}

    bridge::Hub hub;
    bridge::LineServer server;
};

BridgeHost::BridgeHost() = default;
BridgeHost::~BridgeHost() {
    stop();
}

void BridgeHost::start(const BridgeHostOptions& options, const Sea& sea) {
    stop();
    bridge::ServerOptions server;
    server.listen = bridge::parse_endpoint(options.listen, "the bridge's address");
    server.token = options.token;
    server.log = [this](std::string line) { add(std::move(line)); };
    running_ = std::make_unique<Running>(options, sea, std::move(server));
}

void BridgeHost::stop() {
    running_.reset();
}

bridge::Endpoint BridgeHost::endpoint() const {
    bridge::Endpoint endpoint = running_->server.endpoint();
    if (endpoint.host == "0.0.0.0") endpoint.host = "127.0.0.1";
    if (endpoint.host == "::") endpoint.host = "::1";
    return endpoint;
}

std::vector<std::string> BridgeHost::log() const {
    const std::lock_guard lock(mutex_);
    return {log_.begin(), log_.end()};
}

void BridgeHost::add(std::string line) {
    const std::lock_guard lock(mutex_);
    if (log_.size() == kMaxLines) log_.pop_front();
    log_.push_back(std::move(line));
}

}  // namespace ocean::app
