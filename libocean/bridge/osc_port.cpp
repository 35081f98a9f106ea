// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "osc_port.hpp"

#include <algorithm>
#include <utility>

#include "address.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::bridge {
namespace {

constexpr std::size_t kMaxPacketBytes = 65536;
constexpr std::size_t kMaxSubscribers = 16;
constexpr std::size_t kMaxFirstAddresses = 64;
constexpr std::string_view kSubscribe = "/ocean/subscribe";
/// 60 bundles per second.
constexpr auto kMinInterval = std::chrono::microseconds(16'667);
/// The pause after a logged problem, doubled after each further one up to the maximum.
constexpr auto kMinQuiet = std::chrono::seconds(1);
constexpr auto kMaxQuiet = std::chrono::seconds(60);

Error refused(const std::string& reason) {
    return Error(ErrorKind::invalid_value, reason);
}

/// Returns an IPv4 address that an IPv6 socket has mapped as the IPv4 address.
asio::ip::address plain(const asio::ip::address& address) {
    if (!address.is_v6() || !address.to_v6().is_v4_mapped()) return address;
    return asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6());
}

/// Returns the name without a port: a tablet sends from another port than it listens at.
std::string writer_name(const asio::ip::address& address) {
    return "osc:" + plain(address).to_string();
}

std::string text_of(const asio::ip::udp::endpoint& endpoint) {
    return Endpoint{plain(endpoint.address()).to_string(), endpoint.port()}.text();
}

asio::ip::udp::endpoint udp_endpoint(const Endpoint& endpoint, const std::string& what) {
    return {parse_address(endpoint.host, what), endpoint.port};
}

std::set<asio::ip::address> addresses_of(const std::vector<std::string>& names) {
    std::set<asio::ip::address> addresses;
    for (const std::string& name : names) {
        addresses.insert(plain(parse_address(name, "--osc-allow")));
    }
    return addresses;
}

}  // namespace

void require_valid(const OscOptions& options) {
    if (options == OscOptions()) return;
    require_osc();
    if (options.listen) udp_endpoint(*options.listen, "--osc");
    for (const Endpoint& to : options.to) udp_endpoint(to, "--osc-to");
    const bool allows_all = addresses_of(options.allow).empty();
    if (!options.listen && !allows_all) {
        throw refused("--osc-allow names senders to --osc; add --osc, or drop --osc-allow");
    }
    if (options.listen && !options.listen->is_loopback() && allows_all) {
        throw refused("--osc " + options.listen->text() +
                      ": other machines may send only with --osc-allow ADDRESS");
    }
}

bool OscPort::FirstAddresses::add(const asio::ip::address& address) {
    return seen_.size() < kMaxFirstAddresses && seen_.insert(address).second;
}

OscPort::OscPort(asio::io_context& io, const OscOptions& options, Host host)
    : io_(io),
      host_(std::move(host)),
      allowed_(addresses_of(options.allow)),
      subscription_(options.subscription),
      in_(io),
      timer_(io) {
    if (options.listen) listen(*options.listen);
    for (const Endpoint& to : options.to) {
        const Udp::endpoint endpoint = udp_endpoint(to, "--osc-to");
        targets_.push_back({endpoint, writer_name(endpoint.address())});
        socket_for(endpoint);
        host_.log("osc to " + text_of(endpoint));
    }
    asio::post(io_, [this] { update(); });
}

void OscPort::listen(const Endpoint& wanted) {
    const Udp::endpoint endpoint = udp_endpoint(wanted, "--osc");
    try {
        in_.open(endpoint.protocol());
        in_.bind(endpoint);
        in_.non_blocking(true);
    } catch (const asio::system_error& error) {
        throw Error(ErrorKind::output,
                    "cannot listen on " + wanted.text() + " for OSC: " + error.code().message());
    }
    endpoint_ = Endpoint{endpoint.address().to_string(), in_.local_endpoint().port()};
    std::string from;
    for (const auto& address : allowed_) from += ' ' + address.to_string();
    host_.log("osc on " + endpoint_->text() + ", from" + (from.empty() ? " this machine" : from));
    packet_.resize(kMaxPacketBytes);
    receive();
}

void OscPort::receive() {
    in_.async_receive_from(asio::buffer(packet_), sender_,
                           [this](asio::error_code error, std::size_t size) {
                               if (!in_.is_open()) return;
                               if (!error) handle_packet({packet_.data(), size});
                               receive();
                           });
}

bool OscPort::is_allowed(const asio::ip::address& address) const {
    return allowed_.empty() || allowed_.contains(address);
}

void OscPort::handle_packet(std::string_view packet) {
    const asio::ip::address from = plain(sender_.address());
    if (!is_allowed(from)) {
        ++dropped_;
        if (!strangers_.add(from)) return;
        return host_.log("osc " + from.to_string() + " is not allowed; its packets are dropped");
    }
    if (senders_.add(from)) host_.log("osc " + text_of(sender_) + " sends");
    writer_ = writer_name(from);
    try {
        const OscPacket parsed = parse_osc_packet(packet);
        for (const OscMessage& message : parsed.messages) handle(message);
        for (const std::string& problem : parsed.left_out) log_problem(problem);
    } catch (const Error& error) {
        log_problem(error.what());
    }
    host_.changed();
}

void OscPort::handle(const OscMessage& message) {
    try {
        if (message.address == kSubscribe) return subscribe(message);
        const auto name = osc_name(message.address);
        if (!name) throw refused("names of the sea begin with /ocean/");
        const ValueTable& values = host_.hub.values();
        const std::size_t entry = values.find(*name);
        if (message.arguments.empty()) {
            asio::error_code ignored;
            return send(osc_packet({message.address, {argument_of(entry)}}), sender_, ignored);
        }
        if (message.arguments.size() > 1) throw refused("a value must be one argument");
        // Its writer records, and a client's record ends with its connection; UDP has none.
        if (values[entry].name == "app.frame_rate") {
            throw refused("only a program that shows the sea sets it, over TCP");
        }
        host_.hub.set(*name, osc_text(message.arguments[0]), writer_);
    } catch (const Error& error) {
        log_problem(message.address + ": " + error.what());
    }
}

void OscPort::subscribe(const OscMessage& message) {
    Udp::endpoint endpoint = sender_;
    if (!message.arguments.empty()) {
        endpoint.port(static_cast<unsigned short>(
            parse_whole_number(osc_text(message.arguments[0]), "the port", 1, 65535)));
    }
    const auto expires = Clock::now() + subscription_;
    const auto same = std::ranges::find(targets_, endpoint, &Target::endpoint);
    if (same != targets_.end()) {
        if (same->expires) same->expires = expires;
        return;
    }
    const auto subscribers = std::ranges::count_if(
        targets_, [](const Target& target) { return target.expires.has_value(); });
    if (static_cast<std::size_t>(subscribers) >= kMaxSubscribers) {
        throw refused("the max number of subscribers is " + std::to_string(kMaxSubscribers));
    }
    targets_.push_back({endpoint, writer_, expires});
    host_.log("osc " + text_of(endpoint) + " subscribes");
}

void OscPort::log_problem(const std::string& problem) {
    const auto now = Clock::now();
    if (now < quiet_until_) {
        ++unlogged_;
        return;
    }
    quiet_ = now - quiet_until_ > kMaxQuiet
                 ? kMinQuiet
                 : std::clamp<Clock::duration>(2 * quiet_, kMinQuiet, kMaxQuiet);
    quiet_until_ = now + quiet_;
    const std::string more =
        unlogged_ > 0 ? " (and " + std::to_string(unlogged_) + " more before)" : "";
    unlogged_ = 0;
    constexpr std::size_t kMaxProblemBytes = 300;
    host_.log("osc " + text_of(sender_) + ": " + text::printable(problem, kMaxProblemBytes) + more);
}

OscArgument OscPort::argument_of(std::size_t entry) const {
    const ValueTable& values = host_.hub.values();
    const std::string& text = values[entry].text;
    const auto number = values.is_number(entry) ? text::parse_number(text) : std::nullopt;
    if (!number) return text;  // a word, or an unset number
    if (values.is_whole(entry)) return static_cast<std::int64_t>(*number);
    return static_cast<float>(*number);
}

OscPort::Udp::socket& OscPort::socket_for(const Udp::endpoint& to) {
    const auto reaches = [&](const Udp::socket& socket) {
        return socket.is_open() && socket.local_endpoint().protocol() == to.protocol();
    };
    if (reaches(in_)) return in_;
    const auto found = std::ranges::find_if(out_, reaches);
    if (found != out_.end()) return *found;
    try {
        Udp::socket& socket = out_.emplace_back(io_, to.protocol());
        socket.non_blocking(true);
        return socket;
    } catch (const asio::system_error& error) {
        throw Error(ErrorKind::output,
                    "cannot send OSC to " + text_of(to) + ": " + error.code().message());
    }
}

void OscPort::send(std::string_view packet, const Udp::endpoint& to, asio::error_code& error) {
    socket_for(to).send_to(asio::buffer(packet), to, 0, error);
}

bool OscPort::send_changes(Target& target) {
    const ValueTable& values = host_.hub.values();
    std::vector<OscMessage> messages;
    for (std::size_t i = 0; i < values.entries().size(); ++i) {
        const ValueEntry& entry = values[i];
        const bool is_new = entry.changed > target.sent && entry.writer != target.writer;
        if (is_new || !target.has_snapshot) {
            messages.push_back({osc_address(entry.name), {argument_of(i)}});
        }
    }
    asio::error_code error;
    for (const std::string& bundle : osc_bundles(messages)) {
        if (!error) send(bundle, target.endpoint, error);
    }
    if (!messages.empty()) sent_ = Clock::now();
    if (error && !target.fails) {
        host_.log("osc " + text_of(target.endpoint) + " cannot be reached: " + error.message());
    }
    target.fails = static_cast<bool>(error);
    return !error;
}

void OscPort::send_changes() {
    for (Target& target : targets_) {
        if (!send_changes(target)) continue;  // the next call sends all of it again
        target.sent = host_.hub.values().revision();
        target.has_snapshot = true;
    }
}

void OscPort::update() {
    if (is_waiting_ || targets_.empty()) return;
    const auto due = sent_ + kMinInterval;
    if (Clock::now() >= due) return send_changes();
    is_waiting_ = true;
    timer_.expires_at(due);
    timer_.async_wait([this](asio::error_code stopped) {
        is_waiting_ = false;
        if (!stopped) send_changes();
    });
}

void OscPort::end_subscriptions(Clock::time_point now) {
    std::erase_if(targets_, [&](const Target& target) {
        const bool is_over = target.expires && now > *target.expires;
        if (is_over) host_.log("osc " + text_of(target.endpoint) + "'s subscription has ended");
        return is_over;
    });
}

void OscPort::close() {
    asio::error_code ignored;
    in_.close(ignored);
    timer_.cancel();
    if (dropped_ + unlogged_ == 0) return;
    host_.log("osc: " + std::to_string(dropped_) +
              " packets of addresses that are not allowed were dropped, " +
              std::to_string(unlogged_) + " problems were not logged");
}

}  // namespace ocean::bridge
