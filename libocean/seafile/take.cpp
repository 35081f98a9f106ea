// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes as text: see take.hpp. People and live tools write them, so that every line is checked as
// in a sea file.
#include "take.hpp"

#include <cmath>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/line_reader.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"

namespace ocean {
namespace {

constexpr std::string_view kForm = "; allowed: SECONDS NAME VALUE, such as 12.5 wind_speed 14";

Error refused(const std::string& message) {
    return Error(ErrorKind::invalid_value, message);
}

double checked_seconds(std::string_view word, const std::vector<TakeEvent>& before) {
    const std::string given = text::printable(word) + ": ";
    const std::optional<double> seconds = text::parse_number(word);
    if (!seconds || !(std::abs(*seconds) <= kLatestTime)) {
        throw refused(given + "is not a time in seconds" + std::string(kForm));
    }
    if (!before.empty() && *seconds < before.back().seconds) {
        throw refused(given + "is before the line above, at " + to_text(before.back().seconds) +
                      " s; allowed: lines in order of time");
    }
    return *seconds;
}

}  // namespace

void TakeReader::add(std::string_view line, std::size_t number) {
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) return;
    try {
        if (events_.size() == kMaxTakeEvents) {
            throw refused("is one event too many; allowed: " + std::to_string(kMaxTakeEvents));
        }
        events_.push_back(event_of(line));
    } catch (const Error& error) {
        throw text::error_at(error, name_, number);
    }
}

TakeEvent TakeReader::event_of(std::string_view line) {
    std::string_view rest = line;
    const std::string_view seconds = next_word(rest);
    const std::string name = text::printable(next_word(rest));
    const std::string value = text::printable(next_word(rest));
    TakeEvent event{checked_seconds(seconds, events_), {}, {}};
    if (value.empty())
        throw refused(text::printable(line) + ": is not an event" + std::string(kForm));
    event.parameter = find_parameter(name);
    const ParameterInfo& info = *event.parameter.info;
    const std::string given = info.path(event.parameter.item) + " = " + value + ": ";
    if (info.change != ParameterClass::live) {
        throw refused(
            given + "is not live, so a take cannot change it; allowed: " + live_parameter_names());
    }
    if (const std::string_view more = next_word(rest); !more.empty()) {
        throw refused(given + "is followed by " + text::printable(more) + std::string(kForm));
    }
    set_parameter(checked_, name, value);
    event.value = value_of(checked_, event.parameter);
    return event;
}

Take parse_take(std::string_view content, const std::string& name, const Parameters& parameters) {
    if (content.size() > kMaxTakeBytes) {
        throw text::error_at(ErrorKind::bad_file, name, 0, "is larger than the 2 MiB allowed");
    }
    TakeReader reader(parameters, name);
    LineReader lines(content, name);
    while (lines.next()) reader.add(lines.line(), lines.number());
    return {reader.finish(), parameters.time.take};
}

std::string write_take(const Take& take) {
    std::string out;
    for (const TakeEvent& event : take.events) out += take_line(event) + "\n";
    return out;
}

void resolve_take(Sea& sea, const std::string& base_dir) {
    const std::string& file = sea.parameters.time.take;
    if (sea.take.file == file) return;
    if (file.empty()) {
        sea.take = {};
        return;
    }
    const std::string path = text::to_utf8(utf8_path(base_dir) / utf8_path(file));
    try {
        sea.take = parse_take(text::read_file(path, kMaxTakeBytes), path, sea.parameters);
    } catch (const Error& error) {
        throw text::error_of_text(error, "time.take", file);
    }
}

}  // namespace ocean
