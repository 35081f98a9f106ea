// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A resolved sea file, as a host opens it: the parameters of a sea and its take, a recorded
// performance of its live parameters. Self-contained: it includes the chosen buoy record and the
// take.
//
//     Sea sea = read_sea("storm.toml");
//     const Parameters later = sea.at(30.0);       // with what its take has changed until then
//     const double t = sea.time_of(48);            // of frame 48 [s]
//     add_wave_system(sea, "waves.1");
//     sea.parameters.waves[1].wind_speed = 6.0;
//     validate(sea);
//     for (const TakeEvent& event : sea.take.events) log(take_line(event));
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ocean/parameter_table.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

/// An event: the parameter glides to `value`, a number or a word, from `seconds` [s] on.
struct TakeEvent {
    double seconds = 0.0;
    ParameterRef parameter;
    ParameterValue value;
};

/// Events ordered by time; events of one time stand in the order of the file.
struct Take {
    std::vector<TakeEvent> events;
    /// The value of `time.take` for which the events were read.
    std::string file;

    bool empty() const { return events.empty(); }
};

/// Enough for nine minutes of a knob that moves all the time, at 60 changes a second; inlined, so
/// many events fit a sea file.
inline constexpr std::size_t kMaxTakeEvents = 32768;
inline constexpr std::size_t kMaxTakeBytes = std::size_t{2} << 20;  // size as text
/// Min time between performed events of one parameter [s]. An earlier value is delayed, and the
/// last one replaces the others.
inline constexpr double kMinEventSpacing = 1.0 / 60.0;

/// Returns an event as a line without its end: the full path, and the shortest numbers that read
/// back to the same bits.
std::string take_line(const TakeEvent& event);

/// Two states of a sea whose waves glide, and how far it has come from one to the other.
struct Passage {
    Parameters from;
    Parameters to;
    double share = 0.0;  // 0 .. 1
};

struct Sea {
    Parameters parameters;
    Take take = {};

    /// Returns the parameters at a time t [s]: the file's, with the take's changes up to t, each
    /// gliding to its value by a one-pole filter of time.glide seconds:
    ///   y(t) = v + (y(s) - v) exp(-(t - s) / glide) from the time s of an event with the value v.
    /// peak_period glides in its logarithm, fetch in its root, a direction the short way round.
    /// While its spreading glides, a wave system has both spreadings: copies of it, each with its
    /// energy_share, follow the systems of the file. A wind that the take introduces over waves
    /// without one glides from calm (wind_onset) for the whitecaps, and from the 10 m/s that the
    /// waves were made with for the waves. foam_coverage switches at once. After about 20 glides a
    /// parameter equals its value bit by bit. A pure function of the time, so any frame can be
    /// computed alone.
    Parameters at(double time) const;
    /// Returns the states that the waves pass between at a time [s]: those of the two nearest steps
    /// of the number that glides, e.g. of 1.75 % of a wind speed. The amplitudes of the waves are
    /// interpolated between them, to 1e-3 of the sea's height (3e-3 in light winds), so that a
    /// glide does not make all waves anew in each frame. None where the waves are those of
    /// at(time): while they rest, while a number passes a step in less than a tenth of a
    /// second, while several glide or spreadings mix, and for seas of second order. A pure function
    /// of the time.
    std::optional<Passage> passage(double time) const;
    /// Returns at(time).surface.foam_lifetime [s], cheaply, for foam that is followed over many
    /// ticks.
    double foam_lifetime(double time) const;

    /// Returns the time of a frame, start + (frame - first_frame) / fps [s]. It does not depend on
    /// the requested range of frames and is never summed up.
    double time_of(double frame) const;
};

/// Inserts a wave system with default values at the position that `name` states ("waves.1"). The
/// systems from there on, and their events in the take, move up by one number. Throws Error
/// invalid_value for a name that leaves a gap, and beyond kMaxWaveSystems.
void add_wave_system(Sea& sea, std::string_view name);
/// Removes the wave system `name` and its events in the take. Throws Error invalid_value for an
/// unknown name and for the last remaining system.
void remove_wave_system(Sea& sea, std::string_view name);

/// Throws Error unsupported if no take can play over the parameters: the waves over a bed, and
/// those that make crests, are computed for one sea state.
void require_takes(const Parameters& parameters);

/// Checks the rules of the parameters and of the take: it names live parameters of existing wave
/// systems, its values are in range, its events are ordered by time, and the sea has no loop, since
/// a take does not repeat. Throws Error invalid_value, and as require_takes.
void validate(const Sea& sea);

}  // namespace ocean
