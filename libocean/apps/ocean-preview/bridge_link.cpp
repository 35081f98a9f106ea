// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "bridge_link.hpp"

#include <algorithm>
#include <cmath>

#include "ocean/error.hpp"
#include "ocean/internal/bridge/line_protocol.hpp"
#include "ocean/internal/line_reader.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/parameter_table.hpp"

namespace ocean::app {
namespace {

using Kind = bridge::ClientEvent::Kind;
using Clock = std::chrono::steady_clock;

/// The snapshot arrives in one piece, each value before the name of its writer.
constexpr std::chrono::milliseconds kSnapshot{300};
constexpr std::chrono::milliseconds kClockStep{500};
/// Clocks that differ by less run together [s].
constexpr double kSameTime = 0.25;

bool is_of_the_sea(const std::string& name) {
    return !name.starts_with("app.");
}

/// Returns whether values of a parameter may come from or go to a bridge; names of files may not.
bool is_shared(const ParameterInfo& info) {
    return info.key != "file" && info.key != "take" && info.key != "record" && info.key != "seabed";
}

/// Returns the number of the driven hull from 1; 0: none.
std::size_t driven_number(const LiveSea& sea) {
    return sea.drive() != nullptr ? sea.driven_hull() + 1 : 0;
}

}  // namespace

BridgeLink::BridgeLink(const bridge::LineClientOptions& options, BridgeCalls calls)
    : client_(options), calls_(std::move(calls)) {}

bool BridgeLink::apply(LiveSea& sea) {
    return apply_events(sea, client_.events());
}

bool BridgeLink::wait_and_apply(LiveSea& sea, std::chrono::milliseconds longest) {
    return apply_events(sea, client_.wait(longest));
}

bool BridgeLink::apply_events(LiveSea& sea, const std::vector<bridge::ClientEvent>& events) {
    std::map<std::string, std::string> requested;  // by other clients
    for (const bridge::ClientEvent& event : events) {
        switch (event.kind) {
            case Kind::connected:
                add_to_log("joined: " + event.text);
                own_names_ = {own_name(), event.name};
                values_.clear();
                movers_.clear();
                joined_ = Clock::now();
                values_known_ = false;
                break;
            case Kind::lost:
                add_to_log("lost, the sea stays as it is: " + event.text);
                break;
            case Kind::value:
                values_[event.name] = event.text;
                if (is_own(mover(event.name))) {
                    // An echo of our own clock does not cancel an earlier request for another time.
                    if (is_of_the_sea(event.name)) requested.erase(event.name);
                } else if (movers_.contains(event.name)) {
                    requested[event.name] = event.text;
                }
                break;
            case Kind::writer:
                movers_[event.name] = event.text;
                break;
            case Kind::notice:
                note_recording(event.text);
                add_to_log(event.text);
                break;
            case Kind::refused:
                add_to_log(event.text);
                break;
            case Kind::reply:
                break;
        }
    }
    bool changed = false;
    applying_ = true;
    for (const auto& [name, value] : requested) {
        try {
            changed = apply_value(sea, name, value) || changed;
        } catch (const Error& error) {
            add_to_log(error.what());
        }
    }
    applying_ = false;
    if (!values_known_ && !values_.empty() && Clock::now() - joined_ > kSnapshot) {
        values_known_ = true;
        add_to_log("its values have come");
        send_values(sea, false);
    }
    return changed;
}

bool BridgeLink::apply_value(LiveSea& sea, const std::string& name, const std::string& value) {
    const auto number = [&] { return parse_number(value, name, -1e9, 1e9); };
    if (name == "app.pause") {
        const bool paused = number() != 0.0;
        return std::exchange(sea.paused, paused) != paused;
    }
    if (name == "app.speed") {
        sea.speed = number();
        return true;
    }
    if (name == "app.record") {
        const bool record = number() != 0.0;
        if (record != sea.recording() && !another_shows()) calls_.record(record, take_name_);
        return true;
    }
    if (name == "app.time") {
        // A clock of another window runs at the same rate as ours.
        const bool sent_by_shower = another_shows() && mover(name) == mover("app.frame_rate");
        if (sent_by_shower && std::abs(number() - sea.time()) < kSameTime) return false;
        sea.go_to(number());
        return true;
    }
    if (name.starts_with("app.hull.")) return apply_hull_value(sea, name, value);
    if (!is_of_the_sea(name)) return false;
    const ParameterRef parameter = find_parameter(name);
    if (!is_shared(*parameter.info)) return false;
    const bool live = parameter.info->change == ParameterClass::live;
    if (!live && to_text(value_of(sea.sea().parameters, parameter)) == value) return false;
    sea.set(name, value);
    if (!live && !noted_rebuild_) {
        noted_rebuild_ = true;
        add_to_log(name + ": makes another sea; applied, and in no take");
    }
    return true;
}

bool BridgeLink::apply_hull_value(LiveSea& sea, const std::string& name, const std::string& value) {
    const double number = parse_number(value, name, -1e9, 1e9);
    if (name == "app.hull.drive") {
        drive(sea, static_cast<std::size_t>(std::max(number, 0.0)));
        return true;
    }
    HullDrive* const driven = sea.drive();
    if (driven == nullptr) {
        throw Error(ErrorKind::unsupported,
                    name + ": no hull is driven; SET app.hull.drive 1 drives the first one");
    }
    TrackCourse course = driven->wanted();
    (name == "app.hull.speed" ? course.speed : course.heading) = number;
    driven->want(course);
    return true;
}

void BridgeLink::drive(LiveSea& sea, std::size_t number) const {
    if (number == driven_number(sea)) return;
    if (calls_.drive) return calls_.drive(number);
    number == 0 ? sea.stop_drive() : sea.start_drive(number - 1);
}

/// Notes the name of a take: "RECORD START storm.take by ..." and "RECORD STOP -" arrive before
/// app.record does.
void BridgeLink::note_recording(const std::string& event) {
    std::string_view words = event;
    if (next_word(words) != "RECORD") return;
    const std::string_view what = next_word(words);
    const std::string_view name = next_word(words);
    if (what == "START") take_name_.clear();
    if (name != "-" && bridge::is_take_name(name)) take_name_ = name;
}

void BridgeLink::send_values(const LiveSea& sea, bool moved_too) {
    const Parameters& parameters = sea.sea().parameters;
    for (const auto& [name, value] : values_) {
        if (!is_of_the_sea(name) || (movers_.contains(name) && !moved_too)) continue;
        ParameterRef parameter = find_parameter(name);
        if (parameter.item >= parameter.info->member.items(parameters)) continue;
        if (!is_shared(*parameter.info)) continue;
        const std::string ours = to_text(value_of(parameters, parameter));
        if (!ours.empty() && ours != value) send(name, ours);
    }
}

void BridgeLink::send(const std::string& name, const std::string& value) {
    if (applying_) return;
    const auto sent = sent_.find(name);
    const auto theirs = values_.find(name);
    if (sent != sent_.end() && sent->second == value && theirs != values_.end() &&
        theirs->second == value) {
        return;
    }
    sent_[name] = value;
    is_of_the_sea(name) ? client_.set(name, value) : client_.report(name, value);
}

std::string BridgeLink::mover(const std::string& name) const {
    const auto found = movers_.find(name);
    return found == movers_.end() ? "" : found->second;
}

bool BridgeLink::is_own(const std::string& writer) const {
    return !writer.empty() && std::ranges::find(own_names_, writer) != own_names_.end();
}

bool BridgeLink::another_shows() const {
    const std::string shower = mover("app.frame_rate");
    const auto rate = values_.find("app.frame_rate");
    return !shower.empty() && !is_own(shower) && rate != values_.end() && rate->second != "0";
}

void BridgeLink::send_clock(const LiveSea& sea, double frame_rate) {
    if (!joined() || another_shows() || Clock::now() - clock_sent_ < kClockStep) return;
    clock_sent_ = Clock::now();
    send("app.frame_rate", format_text("%.1f", frame_rate));
    send("app.time", format_text("%.3f", sea.time()));
    send("app.pause", sea.paused ? "1" : "0");
    send("app.speed", shortest_text(static_cast<float>(sea.speed)));
    // A window that has never recorded sends no "0": it could cross another client's request to
    // record, and would end that take.
    if (sea.recording() || sent_.contains("app.record")) {
        send("app.record", sea.recording() ? "1" : "0");
    }
    send_hull(sea);
}

void BridgeLink::send_hull(const LiveSea& sea) {
    const std::string number = std::to_string(driven_number(sea));
    const auto theirs = values_.find("app.hull.drive");
    // Also after a drive that was refused here.
    if (theirs != values_.end() && theirs->second != number) send("app.hull.drive", number);
    if (sea.drive() == nullptr) return;
    send("app.hull.speed", plain_text(sea.drive()->wanted().speed));
    send("app.hull.heading", plain_text(sea.drive()->wanted().heading));
}

void BridgeLink::add_to_log(std::string text) {
    if (log_.size() == kMaxLines) log_.erase(log_.begin());
    if (calls_.logged) calls_.logged(text);
    log_.push_back(std::move(text));
}

}  // namespace ocean::app
