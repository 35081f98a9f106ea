// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea file, resolved: what a host opens. Self-contained: the chosen buoy record and the take are
// inside.
#pragma once

#include "ocean/parameters.hpp"
#include "ocean/take.hpp"

namespace ocean {

struct Sea {
    Parameters parameters;
    Take take = {};

    /// The parameters at a time: those of the file, and the take's changes up to then, each gliding
    /// to its value by a one-pole filter of time.glide seconds. A pure function: any frame alone.
    ///   y(t) = v + (y(s) - v) exp(-(t - s) / glide) from the time s of an event with the value v.
    /// Of peak_period the logarithm glides, of fetch the root, and directions the short way round.
    /// While its spreading glides, a wave system has both: copies of it, each with its
    /// energy_share, stand behind the systems of the file. A wind that the take brings over waves
    /// that none was given for glides in from calm (wind_onset) for the whitecaps, and for the
    /// waves from the 10 m/s that they were made with. foam_coverage switches at once. After
    /// about 20 glides a parameter is its value in every bit.
    Parameters at(double time) const;
    /// at(time).surface.foam_lifetime, for those who follow foam over many ticks.
    double foam_lifetime(double time) const;

    /// start + (frame - first_frame) / fps, in seconds; never from the asked range, never summed.
    double time_of(double frame) const;
};

/// A wave system with default values becomes "waves.1", or whatever its name says; those from there
/// on have their numbers one higher. What the take plays of them goes along. Throws Error
/// invalid_value for a name that leaves a gap, and beyond kMaxWaveSystems.
void add_wave_system(Sea& sea, std::string_view name);
/// The system of that name goes, with what the take plays of it. The last one stays.
void remove_wave_system(Sea& sea, std::string_view name);

/// The parameters' rules and those of a take: it names live parameters, of wave systems that are
/// there; its values are in range and its events in order of time; the sea has no loop, for a take
/// does not repeat. Throws Error.
void validate(const Sea& sea);

}  // namespace ocean
