// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/hub.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "ocean/bridge/devices.hpp"
#include "ocean/bridge/line_protocol.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/text.hpp"

namespace ocean::bridge {
namespace {

Error refused(const std::string& message) {
    return Error(ErrorKind::invalid_value, message);
}

void require_take_name(const std::string& name) {
    if (is_take_name(name)) return;
    throw refused("'" + text::printable(name) +
                  "' is no name for a take; allowed: letters, digits, '_', '-' and '.', no folder");
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
        if (before->seconds > event.seconds) {  // it waits for its turn
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
    MapFile file =
        parse_map(options_.map_text, options_.map.empty() ? "the map" : options_.map, values_);
    const auto& devices = file.devices.empty() ? options_.devices : file.devices;
    for (const DeviceRule& device : devices) {
        for (const Channel& channel : channels()) {
            if (!channel.name.starts_with(device.id + "/")) continue;
            throw refused("two boards are named " + device.id + ": one by the map's [[device]]");
        }
    }
    for (auto& source : make_sources(devices)) {
        sources_.push_back(std::move(source));
    }
    map_devices_ = file.devices;
    mapping_ = std::make_unique<Mapping>(std::move(file), values_);
}

Hub::~Hub() {
    stop();
}

void Hub::start(const Source::Listener& listener) {
    for (const auto& source : sources_) source->start(listener);
    light_lamps();
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
    store(values_.find(name), value, writer, Clock::now());
    light_lamps();
}

void Hub::store(std::size_t entry, std::string_view value, std::string_view writer,
                Clock::time_point now) {
    if (!values_.set(entry, value, writer)) return;
    if (entry == record_) {
        follow_recording(now);
    } else if (recorder_) {
        const ParameterRef ref = values_.ref(entry);
        if (ref.info == nullptr || ref.info->change != ParameterClass::live) return;
        const ParameterValue stored = value_of(values_.parameters(), ref);
        if (to_text(stored).empty() || recorder_->add(ref, stored, now)) return;
        say("TAKE is full and ends here");
        values_.set(record_, "0", "bridge");
        follow_recording(now);
    }
}

void Hub::out(const std::string& channel, double value) {
    for (const auto& source : sources_) {
        if (find_channel(source->channels(), channel) != nullptr)
            return source->put(channel, value);
    }
    throw Error(ErrorKind::not_found, "no board has '" + text::printable(channel) + "'");
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
        say("RECORD STOP " + name);
        save_take();
        take_name_.clear();
        return;
    }
    const std::string& shower = values_[frame_rate_].writer;
    if (shower.empty()) recorder_.emplace(options_.sea.parameters.time.start, now);
    say("RECORD START " + name +
        (shower.empty() ? " by the bridge on its own clock"
                        : " by " + shower + " in its sea time"));
}

std::string Hub::free_take_name(const std::string& asked) const {
    const std::filesystem::path folder = utf8_path(options_.take_folder);
    std::error_code ignored;
    std::string name = asked;
    for (int number = 1; name.empty() || std::filesystem::exists(folder / name, ignored);
         ++number) {
        // What is there is nobody's to write over.
        const std::string stem = asked.empty() ? "take" : asked.substr(0, asked.find('.'));
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
        say("TAKE " + path);
    } catch (const Error& error) {
        say("TAKE is lost: " + std::string(error.what()));
    }
}

void Hub::finish() {
    save_take();
}

void Hub::report(const Report& report) {
    apply(mapping_->report(report, values_), report.time);
}

void Hub::board_event(const BoardEvent& event) {
    say(event_text(event));
    switch (event.kind) {
        case BoardEvent::Kind::connected:
            mapping_->board_connected(event.board);
            return light_lamps();
        case BoardEvent::Kind::lost:
            return apply(mapping_->board_lost(event.board), Clock::now());
        case BoardEvent::Kind::busy:
            return;
    }
}

void Hub::advance(Clock::time_point now) {
    apply(mapping_->advance(now, values_), now);
}

void Hub::apply(const std::vector<Setting>& settings, Clock::time_point now) {
    for (const Setting& setting : settings) {
        try {
            store(setting.entry, plain_text(setting.value), setting.writer, now);
        } catch (const Error& error) {
            const std::string refusal = setting.writer + ": " + error.what();
            if (std::exchange(last_refusal_, refusal) != refusal) say(refusal);
        }
    }
    if (!settings.empty()) light_lamps();
}

void Hub::light_lamps() {
    for (const Lamp& lamp : mapping_->lamps(values_)) {
        try {
            out(lamp.channel, lamp.value);
        } catch (const Error&) {
            // The board is not there now; it is told again when it comes.
        }
    }
}

void Hub::look_around() {
    if (options_.map.empty()) return;
    std::error_code gone;
    const auto time = std::filesystem::last_write_time(utf8_path(options_.map), gone);
    if (gone || time == map_time_) return;
    // Two writes in one tick of the file system's clock have one time: it is read until that is
    // old.
    const auto age = std::filesystem::file_time_type::clock::now() - time;
    if (age > std::chrono::seconds(2)) map_time_ = time;
    try {
        std::string text = read_map_text(options_.map);
        if (text == options_.map_text) return;
        options_.map_text = std::move(text);
        MapFile file = parse_map(options_.map_text, options_.map, values_);
        say("MAP " + options_.map + " is read again" +
            (file.devices == map_devices_ ? "" : "; its boards are others from the next start on"));
        mapping_ = std::make_unique<Mapping>(std::move(file), values_);
        light_lamps();
    } catch (const Error& error) {
        say("MAP stays as it was: " + std::string(error.what()));
    }
}

bool Hub::is_told_by(std::size_t entry, std::string_view client) const {
    return values_.ref(entry).info == nullptr && values_[frame_rate_].writer == client;
}

void Hub::client_left(std::string_view writer) {
    if (values_[frame_rate_].writer == writer) values_.set(frame_rate_, "0", "");
}

}  // namespace ocean::bridge
