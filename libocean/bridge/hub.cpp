// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/hub.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/bridge/devices.hpp"
#include "ocean/internal/bridge/line_protocol.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::bridge {
namespace {

Error refused(const std::string& message) {
    return Error(ErrorKind::invalid_value, message);
}

void require_take_name(const std::string& name) {
    if (is_take_name(name)) return;
    throw refused("'" + text::printable(name) +
                  "' cannot name a take; allowed: letters, digits, '_', '-' and '.', no folder");
}

}  // namespace

bool TakeRecorder::add(const ParameterRef& parameter, const ParameterValue& value,
                       Clock::time_point now) {
    std::vector<TakeEvent>& events = take_.events;
    const double elapsed = std::chrono::duration<double>(now - began_).count();
    TakeEvent event{start_ + std::max(elapsed, 0.0), parameter, value};
    const auto before = std::find_if(events.rbegin(), events.rend(), [&](const TakeEvent& other) {
        return other.parameter.same_as(parameter);
    });
    if (before != events.rend()) {
        if (before->seconds > event.seconds) {  // that event is still to come
            before->value = value;
            return true;
        }
        event.seconds = std::max(event.seconds, before->seconds + kMinEventSpacing);
    }
    const std::size_t bytes = bytes_ + take_line(event).size() + 1;
    if (events.size() >= kMaxTakeEvents || bytes > kMaxTakeBytes) return false;
    bytes_ = bytes;
    events.insert(std::ranges::upper_bound(events, event.seconds, {}, &TakeEvent::seconds), event);
    return true;
}

std::string TakeRecorder::text() const {
    std::string text;
    for (const TakeEvent& event : take_.events) text += take_line(event) + "\n";
    return text;
}

Hub::Hub(HubOptions options, std::vector<std::unique_ptr<Source>> sources)
    : options_(std::move(options)),
      values_(options_.sea.parameters),
      sources_(std::move(sources)),
      record_(values_.find("app.record")),
      frame_rate_(values_.find("app.frame_rate")) {
    if (!options_.map.empty()) options_.map_text = read_map_text(options_.map);
    ControlMapFile file = parse_control_map(
        options_.map_text, options_.map.empty() ? "the map" : options_.map, values_);
    const auto& devices = file.devices.empty() ? options_.devices : file.devices;
    for (const DeviceRule& device : devices) {
        for (const Channel& channel : channels()) {
            if (!channel.name.starts_with(device.id + "/")) continue;
            throw refused("two boards are named " + device.id +
                          ": one of them in the map's [[device]]");
        }
    }
    for (auto& source : make_sources(devices)) {
        sources_.push_back(std::move(source));
    }
    map_devices_ = file.devices;
    control_map_ = std::make_unique<ControlMap>(std::move(file), values_);
}

Hub::~Hub() {
    stop();
}

void Hub::start(const Source::Listener& listener) {
    for (const auto& source : sources_) source->start(listener);
    update_outputs();
}

void Hub::stop() {
    for (const auto& source : sources_) source->stop();
}

std::vector<Channel> Hub::channels() const {
    std::vector<Channel> all;
    for (const auto& source : sources_) {
        const std::vector<Channel> channels = source->channels();
        all.insert(all.end(), channels.begin(), channels.end());
    }
    return all;
}

std::vector<std::string> Hub::events() {
    return std::exchange(events_, {});
}

void Hub::set(std::string_view name, std::string_view value, std::string_view writer) {
    const std::size_t entry = values_.find(name);
    if (values_.set(entry, value, writer)) after_change(entry, Clock::now());
    update_outputs();
}

void Hub::after_change(std::size_t entry, Clock::time_point now) {
    if (entry == record_) return follow_recording(now);
    if (!recorder_) return;
    const ParameterRef ref = values_.ref(entry);
    if (ref.info == nullptr || ref.info->change != ParameterClass::live) return;
    const ParameterValue stored = value_of(values_.parameters(), ref);
    if (to_text(stored).empty() || recorder_->add(ref, stored, now)) return;
    add_event("TAKE is full and ends here");
    values_.set(record_, 0.0, "bridge");
    follow_recording(now);
}

void Hub::out(const std::string& channel, double value) {
    for (const auto& source : sources_) {
        if (find_channel(source->channels(), channel) == nullptr) continue;
        return source->put(channel, value);
    }
    const std::vector<Channel> all = channels();
    throw Error(ErrorKind::not_found, "no board has '" + text::printable(channel) + "'" +
                                          did_you_mean(channel, all, &Channel::name));
}

void Hub::start_recording(const std::string& file, std::string_view writer) {
    if (values_.number(record_) == 1.0) throw refused("a take is being recorded; stop it first");
    require_take_name(file);
    take_name_ = file;
    set("app.record", "1", writer);
}

void Hub::stop_recording(const std::string& file, std::string_view writer) {
    if (values_.number(record_) == 0.0) throw refused("nothing is being recorded");
    require_take_name(file);
    if (!file.empty()) take_name_ = file;
    set("app.record", "0", writer);
}

void Hub::follow_recording(Clock::time_point now) {
    const bool wanted = values_.number(record_) == 1.0;
    const std::string name = take_name_.empty() ? "-" : take_name_;
    if (!wanted) {
        add_event("RECORD STOP " + name);
        save_take();
        take_name_.clear();
        return;
    }
    const std::string& shower = values_[frame_rate_].writer;  // the program that shows the sea
    if (shower.empty()) recorder_.emplace(options_.sea.parameters.time.start, now);
    add_event("RECORD START " + name +
              (shower.empty() ? " by the bridge on its own clock"
                              : " by " + shower + " in its sea time"));
}

std::string Hub::free_take_name(const std::string& requested) const {
    const std::filesystem::path folder = utf8_path(options_.take_folder);
    std::error_code ignored;
    std::string name = requested;
    for (int number = 1; name.empty() || std::filesystem::exists(folder / name, ignored);
         ++number) {
        // An existing file is never overwritten.
        const std::string stem =
            requested.empty() ? "take" : requested.substr(0, requested.find('.'));
        name = stem + "_" + std::to_string(number) + ".take";
    }
    return (folder / name).string();
}

void Hub::save_take() {
    if (!recorder_) return;
    const std::string text = std::exchange(recorder_, std::nullopt)->text();
    try {
        const std::string path = free_take_name(take_name_);
        io::write_file_atomically(path, text);
        add_event("TAKE " + path);
    } catch (const Error& error) {
        add_event("TAKE is lost: " + std::string(error.what()));
    }
}

void Hub::finish() {
    save_take();
}

void Hub::report(const Report& report) {
    apply(control_map_->report(report, values_), report.time);
}

void Hub::on_board_event(const BoardEvent& event) {
    add_event(event_text(event));
    switch (event.kind) {
        case BoardEvent::Kind::connected:
            control_map_->board_connected(event.board);
            return update_outputs();
        case BoardEvent::Kind::lost:
            return apply(control_map_->board_lost(event.board), Clock::now());
        case BoardEvent::Kind::busy:
            return;
    }
}

void Hub::advance(Clock::time_point now) {
    apply(control_map_->advance(now, values_), now);
}

void Hub::apply(const std::vector<Setting>& settings, Clock::time_point now) {
    for (const Setting& setting : settings) {
        try {
            if (values_.set(setting.entry, setting.value, setting.writer)) {
                after_change(setting.entry, now);
            }
        } catch (const Error& error) {
            const std::string refusal = setting.writer + ": " + error.what();
            if (std::exchange(last_refusal_, refusal) != refusal) add_event(refusal);
        }
    }
    if (!settings.empty()) update_outputs();
}

void Hub::update_outputs() {
    for (const OutputValue& output : control_map_->changed_outputs(values_)) {
        try {
            out(output.channel, output.value);
        } catch (const Error&) {
            // The board is not connected; board_connected() makes the value new again.
        }
    }
}

void Hub::poll_map_file() {
    if (options_.map.empty()) return;
    std::error_code gone;
    const auto time = std::filesystem::last_write_time(utf8_path(options_.map), gone);
    if (gone || time == map_time_) return;
    // Two writes within one tick of the file system's clock have the same time, so the file is read
    // until its time is old.
    const auto age = std::filesystem::file_time_type::clock::now() - time;
    if (age > std::chrono::seconds(2)) map_time_ = time;
    try {
        std::string text = read_map_text(options_.map);
        if (text == options_.map_text) return;
        options_.map_text = std::move(text);
        ControlMapFile file = parse_control_map(options_.map_text, options_.map, values_);
        add_event("MAP " + options_.map + " is read again" +
                  (file.devices == map_devices_ ? "" : "; its changed boards need a restart"));
        control_map_ = std::make_unique<ControlMap>(std::move(file), values_);
        update_outputs();
    } catch (const Error& error) {
        add_event("MAP stays as it was: " + std::string(error.what()));
    }
}

bool Hub::is_owned_by(std::size_t entry, std::string_view client) const {
    return values_.ref(entry).info == nullptr && values_[frame_rate_].writer == client;
}

bool Hub::is_report(std::string_view name, std::string_view value, std::string_view client) const {
    const auto entry = std::ranges::find(values_.entries(), name, &ValueEntry::name);
    if (!name.starts_with("app.") || entry == values_.entries().end()) return false;
    if (name == values_[frame_rate_].name) return true;
    return values_[frame_rate_].writer == client && (name == "app.time" || entry->text == value);
}

void Hub::client_left(std::string_view writer) {
    if (values_[frame_rate_].writer == writer) values_.set(frame_rate_, "0", "");
}

}  // namespace ocean::bridge
