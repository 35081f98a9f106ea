// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea at a time: its clock, and its take folded into the parameters that the chain begins with.
#include "ocean/sea.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "ocean/domain.hpp"
#include "ocean/error.hpp"
#include "waves/spectrum/wave_system_table.hpp"
#include "waves/state/passage_steps.hpp"

namespace ocean {

namespace {

/// Share of a step below which the step counts as complete: a further glide would rebuild the sea
/// for changes smaller than a float can show.
constexpr double kSettled = 1e-9;

/// Returns the share of a step that remains after some time.
double left_of_step(double seconds, double glide) {
    return glide > 0.0 ? std::exp(-seconds / glide) : 0.0;
}

/// The scale on which a number glides.
enum class Path { value, root, logarithm, direction };

/// Returns the scale on which equal steps change the sea about equally along the whole range. Fetch
/// glides in its root, to which the height is proportional [Hasselmann 1973], so that the height
/// glides along a line. The period stretches the sea at constant height: it glides by factors.
Path path_of(const ParameterInfo& info) {
    if (info.holds<&WaveSystem::wind_direction>()) return Path::direction;
    if (info.holds<&WaveSystem::fetch>()) return Path::root;
    if (info.holds<&WaveSystem::peak_period>()) return Path::logarithm;
    return Path::value;
}

/// Returns the value part way from `from` to `to`; `to` itself once the remainder is negligible.
double glided_value(double from, double to, double left) {
    const double rest = (from - to) * left;
    const bool settled = std::abs(rest) < kSettled * std::max(std::abs(to), std::abs(from - to));
    return settled ? to : to + rest;
}

double glided(Path path, double from, double to, double left) {
    if (left < kSettled) return to;
    switch (path) {
        case Path::root: {
            const double root = glided_value(std::sqrt(from), std::sqrt(to), left);
            return root == std::sqrt(to) ? to : root * root;
        }
        case Path::logarithm: {
            const double rest = std::log(from / to) * left;
            return std::abs(rest) < kSettled ? to : to * std::exp(rest);
        }
        case Path::direction: {
            const double now = glided_value(to + std::remainder(from - to, 360.0), to, left);
            return std::abs(now) > 360.0 ? std::remainder(now, 360.0) : now;
        }
        case Path::value:
            break;
    }
    return glided_value(from, to, left);
}

/// The events of one parameter that still count at a time, in order. An event that settles before
/// the next one comes makes all earlier events irrelevant.
struct Track {
    ParameterRef parameter;
    std::vector<const TakeEvent*> events;
    double until;
    double glide;

    /// Returns the share of an event's step that remains when the next event comes, or at the end.
    double left(std::size_t event) const {
        const double end = event + 1 < events.size() ? events[event + 1]->seconds : until;
        return left_of_step(end - events[event]->seconds, glide);
    }
};

/// Returns the tracks of the parameters for which `wanted` returns true. Walks back from the last
/// event, so that the past of a knob in constant motion costs one comparison an event.
template <typename Wanted>
std::vector<Track> tracks_of(const Sea& sea, double time, const Wanted& wanted) {
    struct Found {
        Track track;  // the last event first
        bool settled;
    };
    std::vector<Found> found;
    const auto& events = sea.take.events;
    const auto end = std::upper_bound(
        events.begin(), events.end(), time,
        [](double seconds, const TakeEvent& event) { return seconds < event.seconds; });
    for (auto event = std::make_reverse_iterator(end); event != events.rend(); ++event) {
        if (!wanted(*event->parameter.info)) continue;
        auto of = std::find_if(found.begin(), found.end(), [&](const Found& f) {
            return f.track.parameter.same_as(event->parameter);
        });
        if (of == found.end()) {
            found.push_back({{event->parameter, {}, time, sea.parameters.time.glide}, false});
            of = found.end() - 1;
        }
        if (of->settled) continue;
        const double next = of->track.events.empty() ? time : of->track.events.back()->seconds;
        of->settled = left_of_step(next - event->seconds, of->track.glide) < kSettled;
        of->track.events.push_back(&*event);
    }
    std::vector<Track> tracks;
    for (Found& f : found) {
        std::reverse(f.track.events.begin(), f.track.events.end());
        tracks.push_back(std::move(f.track));
    }
    // Tracks are sorted, because copies for spreadings are made in the order of the tracks.
    std::sort(tracks.begin(), tracks.end(), [](const Track& a, const Track& b) {
        return std::pair(a.parameter.info, a.parameter.item) <
               std::pair(b.parameter.info, b.parameter.item);
    });
    return tracks;
}

std::vector<Track> tracks_of(const Sea& sea, double time) {
    return tracks_of(sea, time, [](const ParameterInfo&) { return true; });
}

double number_of(const ParameterValue& value) {
    const auto* whole = std::get_if<std::int64_t>(&value);
    return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(value);
}

/// Returns a number of the table after its events. Calls `initial` only if it still matters.
double number_at(const Track& track, const std::function<double()>& initial) {
    const Path path = path_of(*track.parameter.info);
    std::size_t event = track.events.size();
    while (event > 0 && track.left(event - 1) >= kSettled) --event;
    double y = event > 0 ? number_of(track.events[event - 1]->value) : initial();
    for (; event < track.events.size(); ++event) {
        y = glided(path, y, number_of(track.events[event]->value), track.left(event));
    }
    return std::clamp(y, track.parameter.info->min, track.parameter.info->max);
}

bool is_wind_speed(const ParameterInfo& info) {
    return info.holds<&WaveSystem::wind_speed>();
}
bool is_number(const ParameterInfo& info) {
    return info.type() == "float";
}

double number_at(const Sea& sea, const Track& track);

/// Returns the value of an unset height, period, direction or wind at the time of its first event.
double natural_value(const Sea& sea, const Track& track) {
    if (is_wind_speed(*track.parameter.info)) {
        return sea.parameters.waves[track.parameter.item].wind();
    }
    // Only parameters that need no other parameter's value themselves count at that moment.
    Parameters then = sea.parameters;
    for (const Track& other : tracks_of(sea, track.events.front()->seconds)) {
        const ParameterInfo& info = *other.parameter.info;
        if (!info.in_list() || !is_number(info)) continue;
        if (info.member_type.optional && !is_wind_speed(info)) continue;
        assign(then, other.parameter, number_at(sea, other));
    }
    const NaturalScale natural =
        natural_scale(then.waves[track.parameter.item], then.water, highest_frequency(then));
    const ParameterInfo& info = *track.parameter.info;
    double value = natural.direction;
    if (info.holds<&WaveSystem::significant_wave_height>()) value = natural.height;
    if (info.holds<&WaveSystem::peak_period>()) value = natural.period;
    // A flat sea has no period that could glide.
    return std::isfinite(value) ? value : number_of(track.events.front()->value);
}

double number_at(const Sea& sea, const Track& track) {
    return number_at(track, [&] {
        const ParameterValue given = value_of(sea.parameters, track.parameter);
        const bool unset = std::holds_alternative<std::string>(given);
        return unset ? natural_value(sea, track) : number_of(given);
    });
}

std::size_t word_index(const ParameterInfo& info, const ParameterValue& word) {
    const auto words = info.choices();
    const auto found = std::find(words.begin(), words.end(), std::get<std::string>(word));
    return static_cast<std::size_t>(found - words.begin());
}

/// Mixes spreadings: each has an amplitude that glides between 0 and 1, and a share of the energy
/// that is its square. (If the shares themselves glided, each wave that only the new spreading has
/// would begin with a jump, because its amplitude would grow as the square root of the time.)
void mix_spreadings(Parameters& parameters, const ParameterValue& initial, const Track& track) {
    const ParameterInfo& info = *track.parameter.info;
    std::vector<double> amplitude(info.choices().size(), 0.0);
    amplitude[word_index(info, initial)] = 1.0;
    std::size_t target = 0;
    for (std::size_t event = 0; event < track.events.size(); ++event) {
        target = word_index(info, track.events[event]->value);
        const double left = track.left(event);
        for (std::size_t i = 0; i < amplitude.size(); ++i) {
            const double goal = i == target ? 1.0 : 0.0;
            amplitude[i] = goal + (amplitude[i] - goal) * left;
            if (i != target && amplitude[i] < kSettled) amplitude[i] = 0.0;
        }
    }
    double energy = 0.0;
    for (const double a : amplitude) energy += a * a;
    const std::size_t wave = track.parameter.item;
    for (std::size_t i = 0; i < amplitude.size(); ++i) {
        if (i == target || amplitude[i] == 0.0) continue;
        WaveSystem copy = parameters.waves[wave];
        copy.spreading = static_cast<SpreadingKind>(i);
        copy.energy_share = amplitude[i] * amplitude[i] / energy;
        parameters.waves.push_back(std::move(copy));
    }
    parameters.waves[wave].spreading = static_cast<SpreadingKind>(target);
    parameters.waves[wave].energy_share = amplitude[target] * amplitude[target] / energy;
}

/// Returns the parameters with the winds that are unset but known: the wind of a wind sea, which
/// must not become calm when a take sets height and period, and a wind that a take introduces,
/// before its onset.
Parameters with_winds(const Sea& sea) {
    Parameters parameters = sea.parameters;
    for (std::size_t wave = 0; wave < parameters.waves.size(); ++wave) {
        WaveSystem& system = parameters.waves[wave];
        if (system.wind_speed) continue;
        const auto brings_wind = [&](const TakeEvent& event) {
            return event.parameter.item == wave && is_wind_speed(*event.parameter.info);
        };
        const auto& events = sea.take.events;
        const bool blows = system.is_wind_sea();
        if (!blows && std::none_of(events.begin(), events.end(), brings_wind)) continue;
        system.wind_onset = blows ? 1.0 : 0.0;
        system.wind_speed = system.wind();
    }
    return parameters;
}

}  // namespace

Parameters Sea::at(double time) const {
    Parameters now = with_winds(*this);
    const std::vector<Track> tracks = tracks_of(*this, time);
    for (const Track& track : tracks) {
        double& onset = now.waves[track.parameter.item].wind_onset;
        if (is_wind_speed(*track.parameter.info) && onset < 1.0) {
            const double left = left_of_step(time - track.events.front()->seconds, track.glide);
            onset = left < kSettled ? 1.0 : 1.0 - left;
        }
        const bool number = is_number(*track.parameter.info);
        assign(now, track.parameter,
               number ? ParameterValue(number_at(*this, track)) : track.events.back()->value);
    }
    // This follows the numbers, which the copies share.
    for (const Track& track : tracks) {
        if (track.parameter.info->holds<&WaveSystem::spreading>()) {
            mix_spreadings(now, value_of(parameters, track.parameter), track);
        }
    }
    return now;
}

std::optional<Passage> Sea::passage(double time) const {
    if (take.empty() || parameters.surface.second_order) return std::nullopt;
    const std::vector<Track> tracks = tracks_of(
        *this, time, [](const ParameterInfo& info) { return info.dirties == Stage::spectrum; });
    const Track* gliding = nullptr;
    double now = 0.0;
    for (const Track& track : tracks) {
        if (!is_number(*track.parameter.info)) continue;
        const double value = number_at(*this, track);
        if (value == number_of(track.events.back()->value)) continue;
        if (gliding != nullptr) return std::nullopt;
        gliding = &track;
        now = value;
    }
    if (gliding == nullptr) return std::nullopt;
    const ParameterInfo& info = *gliding->parameter.info;
    const std::optional<PassageSteps> steps = PassageSteps::of(info);
    if (!steps) return std::nullopt;
    const double next = glided(path_of(info), now, number_of(gliding->events.back()->value),
                               left_of_step(PassageSteps::kShortest, gliding->glide));
    if (steps->between(now, next) > 1.0) return std::nullopt;
    const PassageSteps::Around around = steps->around(now, info.min, info.max);
    if (!(around.low < around.high)) return std::nullopt;
    Passage passage{at(time), {}, (now - around.low) / (around.high - around.low)};
    const bool mixes_spreadings = passage.from.waves.size() > parameters.waves.size();
    if (mixes_spreadings) return std::nullopt;
    for (const WaveSystem& system : passage.from.waves) {
        if (system.wind_onset > 0.0 && system.wind_onset < 1.0) return std::nullopt;
    }
    passage.to = passage.from;
    assign(passage.from, gliding->parameter, around.low);
    assign(passage.to, gliding->parameter, around.high);
    return passage;
}

double Sea::foam_lifetime(double time) const {
    const std::vector<Track> tracks = tracks_of(*this, time, [](const ParameterInfo& info) {
        return info.holds<&SurfaceSettings::foam_lifetime>();
    });
    return tracks.empty() ? parameters.surface.foam_lifetime : number_at(*this, tracks.front());
}

double Sea::time_of(double frame) const {
    return timeline_of(*this).time_of(frame);
}

Timeline timeline_of(const Sea& sea) {
    return {.moves = true,
            .start = sea.parameters.time.start,
            .first_frame = sea.parameters.time.first_frame,
            .frame_rate = sea.parameters.time.fps,
            .plays_take = !sea.take.empty()};
}

std::string take_line(const TakeEvent& event) {
    return to_text(event.seconds) + " " + event.parameter.info->path(event.parameter.item) + " " +
           to_text(event.value);
}

void require_takes(const Parameters& parameters) {
    if (!parameters.crests.empty()) {
        throw Error(
            ErrorKind::unsupported,
            {.what = "a sea with crests plays no take: its waves meet at each crest as they "
                     "are when the sea is opened",
             .parameter = "crests.0",
             .allowed = "none with a take"});
    }
    const Water& water = parameters.water;
    if (water.bed == nullptr && water.seabed.empty()) return;
    throw Error(ErrorKind::unsupported,
                {.what = "a sea with a bed plays no take: its waves are computed for one sea state",
                 .parameter = "water.seabed",
                 .value = "\"" + water.seabed + "\"",
                 .allowed = "none with a take"});
}

void validate(const Sea& sea) {
    validate(sea.parameters);
    if (sea.take.empty()) return;
    require_takes(sea.parameters);
    if (sea.parameters.time.loop_period > 0.0) {
        throw Error(ErrorKind::invalid_value,
                    {.what = "a loop repeats and the take does not",
                     .parameter = "time.loop_period",
                     .value = to_text(sea.parameters.time.loop_period) + " s",
                     .allowed = "0 with a take"});
    }
    Parameters any = sea.parameters;
    double last = -std::numeric_limits<double>::infinity();
    for (const TakeEvent& event : sea.take.events) {
        const auto refuse = [&](const std::string& what) {
            throw Error(ErrorKind::invalid_value,
                        "take at " + to_text(event.seconds) + " s: " + what);
        };
        if (!(std::abs(event.seconds) <= kLatestTime)) {
            refuse("is not a time; allowed: -1e9 .. 1e9 s");
        }
        if (event.seconds < last)
            refuse("follows an event at " + to_text(last) + " s; allowed: events in order of time");
        last = event.seconds;
        if (event.parameter.info->change != ParameterClass::live) {
            refuse(event.parameter.info->path(event.parameter.item) + ": is not live");
        }
        assign(any, event.parameter, event.value);
        if (is_number(*event.parameter.info) && std::holds_alternative<std::string>(event.value)) {
            refuse(event.parameter.info->path(event.parameter.item) + ": has no value");
        }
    }
}

}  // namespace ocean
